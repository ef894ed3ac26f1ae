// A figure in SI as a seaman says it: files have SI, and a description begins with its unit.

import { cableSpeeds, celsius, clock, figure, knots, loads, shackles } from "../kit/units";
import { t } from "../kit/language";

const kinds: readonly [unit: RegExp, words: (value: number) => string][] = [
  [/^m\/s,? (cable's|paying|by the chain)|^m\/s (with an empty gypsy|at rated pull)/, (v) => cableSpeeds.text(v)],
  [/^m\/s\b/, (v) => `${figure(knots(v), 1)} kn`],
  [/^N[,:]/, (v) => loads.text(v)],
  [/^K[,:]/, (v) => `${figure(celsius(v))} \u00b0C`],
  [/^s\b/, (v) => (v >= 60 ? clock(v) : "")],
  [/^m, cable|^m of cable/, (v) => `${figure(shackles(v), 1)} ${t("shackles")}`],
];

/** "10.7 kn" for 5.5 of a field "m/s, ..."; empty: as it stands. */
export function inTrade(description: string, value: number): string {
  return kinds.find(([unit]) => unit.test(description))?.[1](value) ?? "";
}
