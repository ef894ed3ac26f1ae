// Figures in a sentence, as in a lesson's briefing: they are written in SI, and read in the units of the gauges.

import { cableSpeeds, figure, knots, loads } from "./units";

/** "5.5 m/s", "between 2 and 4 m/s": the figures, what stands between them, and their unit. */
const kFigures = /(?<![\d.])(\d+(?:\.\d+)?)(?:( and | to )(\d+(?:\.\d+)?))? (m\/s|kN)(?![\w/])/g;
/** Briefings and reasons are English sentences, and so are their figures. */
const inEnglish = (figure: string): string => figure.replace(",", ".");
/** Where a sentence ends; not within a figure. */
const kEnd = /[.;!?](?=\s|$)/g;
/** Whose speed it is: the cable's, or what the bridge has in knots. */
const kWhose = /\b(?:(cables?|chains?|gypsy)|winds?|streams?|currents?|ship|she|ahead|astern|ground|water)\b/gi;

/** Whose speed stands at that place of a text: nearest before it in its sentence, else after it. */
function whose(text: string, from: number, to: number): "cable" | "ship" | undefined {
  const ends = [...text.matchAll(kEnd)].map(({ index }) => index);
  const begin = Math.max(-1, ...ends.filter((end) => end < from));
  const end = ends.find((at) => at >= to) ?? text.length;
  const found =
    [...text.slice(begin + 1, from).matchAll(kWhose)].at(-1) ?? [...text.slice(to, end).matchAll(kWhose)][0];
  return found && (found[1] ? "cable" : "ship");
}

/**
 * The text with its loads, and speeds of which it says whose they are, in the units that are chosen; ship, wind and
 * stream in knots. The rest stands as it was written.
 */
export function inChosenUnits(text: string): string {
  return text.replace(
    kFigures,
    (written, one: string, between: string | undefined, other: string, unit, at: number) => {
      const of = unit === "kN" ? "load" : whose(text, at, at + written.length);
      if (!of) return written;
      const measure = of === "load" ? loads : of === "cable" ? cableSpeeds : undefined;
      if (measure?.unit.written === unit) return written;
      const si = (value: string): number => Number(value) * (unit === "kN" ? 1000 : 1);
      /** Of small figures a tenth: what was 7.3 m/min, and 7.2 at most, is not "7, at most 7". */
      const tenths = (value: number): string => figure(value, value < 9.95 ? 1 : 0);
      const shown = (value: string): string => {
        if (!measure) return inEnglish(tenths(knots(si(value))));
        return inEnglish(measure.unit.written === "m/min" ? tenths(60 * si(value)) : measure.figure(si(value)));
      };
      return `${shown(one)}${between ? between + shown(other) : ""} ${measure?.unit.written ?? "kn"}`;
    },
  );
}
