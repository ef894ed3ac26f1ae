// Figures as the trade reads them; what a unit is in SI says words.json.

import { units } from "../../../../words/words.json";

/** m */
export const kShackle = units.shackle.si;
/** m/s */
export const kKnot = units.knot.si;
/** m */
export const kNauticalMile = units.nautical_mile.si;
/** N */
export const kTonne = units.tonne.si;

export const knots = (speed: number): number => speed / kKnot;
export const degrees = (angle: number): number => (angle * 180) / Math.PI;
export const radians = (angle: number): number => (angle * Math.PI) / 180;
/** Tonnes-force of a load in N. */
export const tonnes = (force: number): number => force / kTonne;
export const shackles = (length: number): number => length / kShackle;
export const celsius = (temperature: number): number => temperature - 273.15;

/** Three figures of a heading or bearing in rad: "007". */
export function bearing(angle: number): string {
  const whole = Math.round(degrees(angle));
  return String(((whole % 360) + 360) % 360).padStart(3, "0");
}

/** Exercise time, s: "7:32", "1:07:32". */
export function clock(time: number): string {
  const s = Math.max(0, Math.floor(time));
  const two = (n: number): string => String(n).padStart(2, "0");
  const hours = Math.floor(s / 3600);
  const minutes = Math.floor(s / 60) % 60;
  return hours > 0 ? `${hours}:${two(minutes)}:${two(s % 60)}` : `${minutes}:${two(s % 60)}`;
}

/** Time of day, s since midnight: "06:30". */
export function timeOfDay(time: number): string {
  const minutes = Math.floor(time / 60);
  return `${String(Math.floor(minutes / 60) % 24).padStart(2, "0")}:${String(minutes % 60).padStart(2, "0")}`;
}

/** A figure with that many decimals and a true minus; "-" for what is no number. */
export function figure(value: number, decimals = 0): string {
  if (!Number.isFinite(value)) return "-";
  const text = value.toFixed(decimals);
  return (Number(text) === 0 ? text.replace("-", "") : text).replace("-", "\u2212");
}

export const sideName = (side: number): string => (side === 0 ? "port" : side === 1 ? "starboard" : "both");
