// What stands round the anchorage, for window and chart alike, as the topic Landmarks has it: one world. World frame:
// x east, y north, m; z up from the water.

import { type Landmark, LandmarkKind, LightColour } from "../wire/generated";

/** Of a light: what one sees of it. */
type Rhythm = Pick<Landmark, "light" | "period" | "flashes">;

const kVeryQuick = 0.75; // s from flash to flash, at most: 80 flashes a minute (IALA, rhythmic characters)
const kQuick = 1.2; // s, the same: 50 a minute
const kLong = 2; // s that a long flash lasts at least

const kLetters: Record<LightColour, string> = {
  [LightColour.LIGHT_NONE]: "",
  [LightColour.LIGHT_WHITE]: "", // a chart writes W only where there are other colours beside it
  [LightColour.LIGHT_RED]: "R",
  [LightColour.LIGHT_GREEN]: "G",
  [LightColour.LIGHT_YELLOW]: "Y",
};

/** Points x, y, z one behind the other, each for itself. */
export function points(flat: Float32Array): [x: number, y: number, z: number][] {
  return Array.from({ length: Math.floor(flat.length / 3) }, (_, k) => [
    flat[3 * k]!,
    flat[3 * k + 1]!,
    flat[3 * k + 2]!,
  ]);
}

export const isBuoy = (kind: LandmarkKind): boolean => kind >= LandmarkKind.LANDMARK_BUOY_PORT;

const isLit = ({ light }: Rhythm): boolean => light !== LightColour.LIGHT_NONE;
const isFixed = ({ period, flashes }: Rhythm): boolean => !(period > 0) || flashes.length === 0;

/** Whether a light is seen at that time, s. */
export function flashes(of: Rhythm, time: number): boolean {
  if (!isLit(of) || isFixed(of)) return isLit(of);
  const since = time - of.period * Math.floor(time / of.period);
  return of.flashes.some(({ begin, duration }) => since >= begin && since < begin + duration);
}

/** As the chart writes it: "Fl(2) 10s 52m", "Q(6)+LFl 15s"; a buoy has no height; empty: unlit. */
export function character(landmark: Landmark): string {
  if (!isLit(landmark)) return "";
  const { kind, light, period, height } = landmark;
  const height_ = isBuoy(kind) ? "" : `${Math.round(height)}m`;
  if (isFixed(landmark)) return ["F", kLetters[light], height_].filter(Boolean).join(" ");
  const name = rhythm(landmark);
  const period_ = name === "Q" || name === "VQ" ? "" : `${Math.round(10 * period) / 10}s`; // they go on without a break
  return [name, kLetters[light], period_, height_].filter(Boolean).join(" ");
}

/** The class of its rhythm and how many are in a group: "Fl(2)". */
function rhythm({ period, flashes }: Rhythm): string {
  const lit = flashes.reduce((sum, { duration }) => sum + duration, 0);
  const group = (name: string, n = flashes.length): string => (n > 1 ? `${name}(${n})` : name);
  if (flashes.length === 1 && Math.abs(2 * lit - period) < 0.1 * period) return "Iso";
  if (2 * lit > period) return group("Oc");
  const last = flashes.at(-1)!;
  const endsLong = flashes.length > 1 && last.duration >= kLong; // a south cardinal's
  const short = endsLong ? flashes.slice(0, -1) : flashes;
  // From the first flash to the next one, which is the next period's where there is one only.
  const apart = (short.length > 1 ? short[1]!.begin : short[0]!.begin + period) - short[0]!.begin;
  const name = apart <= kVeryQuick ? "VQ" : apart <= kQuick ? "Q" : short[0]!.duration >= kLong ? "LFl" : "Fl";
  return group(name, short.length) + (endsLong ? "+LFl" : "");
}
