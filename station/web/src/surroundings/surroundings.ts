// What stands round the anchorage, for window and chart alike, as the topic Landmarks has it: one world. World frame:
// x east, y north, m; z up from the water.

import { type Landmark, LandmarkKind, LightColour } from "../wire/generated";

/** Of a light: what one sees of it. */
type Rhythm = Pick<Landmark, "light" | "period" | "flashes">;

const kTurn = 2 * Math.PI;

const kVeryQuick = 0.75; // s from flash to flash, at most: 80 flashes a minute (IALA, rhythmic characters)
const kQuick = 1.2; // s, the same: 50 a minute
const kLong = 2; // s that a long flash lasts at least
const kDash = [2.5, 4] as const; // times a dot, of Morse code: three as it is sent
const kGroupsApart = 1.5; // times what flashes of one group lie apart, from where groups do

/** Letters by dots and dashes, of lights that send one: a safe water mark A, what stands off the shore U. */
const kMorse: Readonly<Record<string, string>> = {
  ".-": "A", "-...": "B", "-.-.": "C", "-..": "D", "..-.": "F", "--.": "G", "-.-": "K", ".-..": "L", "-.": "N",
  ".--.": "P", "--.-": "Q", ".-.": "R", "..-": "U", "...-": "V", ".--": "W", "-..-": "X", "-.--": "Y", "--..": "Z",
}; // prettier-ignore

const kLetters: Record<LightColour, string> = {
  [LightColour.LIGHT_NONE]: "",
  [LightColour.LIGHT_WHITE]: "W", // a chart writes it only where there are other colours beside it
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

/** rad clockwise from one direction to another, 0 to a turn. */
const clockwise = (from: number, to: number): number => (((to - from) % kTurn) + kTurn) % kTurn;

/** Its colour for an eye at that place, m, world: a sector's, where the eye is in one. */
export function colourSeen(
  { x, y, light, sectors }: Pick<Landmark, "x" | "y" | "light" | "sectors">,
  eye: readonly [x: number, y: number],
): LightColour {
  const bearing = Math.atan2(x - eye[0], y - eye[1]); // of the light, from seaward
  return sectors.find(({ from, to }) => clockwise(from, bearing) < clockwise(from, to))?.light ?? light;
}

/** Its colours as the chart has them: none if it is white all round, "R", "WR". */
function letters({ light, sectors }: Pick<Landmark, "light" | "sectors">): string {
  const all = [...new Set([light, ...sectors.map((one) => one.light)])].sort((a, b) => a - b);
  const written = all.map((one) => kLetters[one]).join("");
  return written === "W" ? "" : written;
}

/** As the chart writes it: "Fl(2) WR 10s 52m", "Q(6)+LFl 15s"; a buoy has no height; empty: unlit. */
export function character(landmark: Landmark): string {
  if (!isLit(landmark)) return "";
  const { kind, period, height } = landmark;
  const height_ = isBuoy(kind) ? "" : `${Math.round(height)}m`;
  const colours = letters(landmark);
  if (isFixed(landmark)) return ["F", colours, height_].filter(Boolean).join(" ");
  const name = rhythm(landmark);
  const period_ = name === "Q" || name === "VQ" ? "" : `${Math.round(10 * period) / 10}s`; // they go on without a break
  return [name, colours, period_, height_].filter(Boolean).join(" ");
}

/** The class of its rhythm and how many are in a group: "Fl(2)". */
function rhythm({ period, flashes }: Rhythm): string {
  const lit = flashes.reduce((sum, { duration }) => sum + duration, 0);
  const group = (name: string, n = flashes.length): string => (n > 1 ? `${name}(${n})` : name);
  if (flashes.length === 1 && Math.abs(2 * lit - period) < 0.1 * period) return "Iso";
  if (2 * lit > period) return group("Oc");
  const letter = morse(flashes);
  if (letter) return `Mo(${letter})`;
  const last = flashes.at(-1)!;
  const endsLong = flashes.length > 1 && last.duration >= kLong; // a south cardinal's
  const short = endsLong ? flashes.slice(0, -1) : flashes;
  // From the first flash to the next one, which is the next period's where there is one only.
  const apart = (short.length > 1 ? short[1]!.begin : short[0]!.begin + period) - short[0]!.begin;
  const name = apart <= kVeryQuick ? "VQ" : apart <= kQuick ? "Q" : short[0]!.duration >= kLong ? "LFl" : "Fl";
  const groups = endsLong ? [] : groupsOf(short);
  if (groups.length > 1) return `${name}(${groups.join("+")})`;
  return group(name, short.length) + (endsLong ? "+LFl" : "");
}

/** The letter that its dots and dashes are; undefined: they are none. */
function morse(flashes: Rhythm["flashes"]): string | undefined {
  const dot = Math.min(...flashes.map(({ duration }) => duration));
  const dash = Math.max(...flashes.map(({ duration }) => duration));
  if (dash < kDash[0] * dot || dash > kDash[1] * dot) return undefined;
  return kMorse[flashes.map(({ duration }) => (duration > 0.5 * (dot + dash) ? "-" : ".")).join("")];
}

/** How many flashes each group of a period has: 2 and 1 of a composite group. */
function groupsOf(flashes: Rhythm["flashes"]): number[] {
  const apart = flashes.slice(1).map(({ begin }, k) => begin - flashes[k]!.begin);
  const within = Math.min(...apart);
  const groups = [1];
  for (const gap of apart)
    if (gap > kGroupsApart * within) groups.push(1);
    else ++groups[groups.length - 1]!;
  return groups;
}
