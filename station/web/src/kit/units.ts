// Figures as the trade reads them; what a unit is in SI says words.json.

import { units } from "../../../../words/words.json";
import { t, translated, writtenFigure } from "./language";

/** What a figure counts, and what one of it is in SI. */
export type Unit = (typeof units)[keyof typeof units];

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
export const shackles = (length: number): number => length / kShackle;
export const celsius = (temperature: number): number => temperature - 273.15;

/** Three figures of a heading or bearing in rad: "007". */
export function bearing(angle: number): string {
  const whole = Math.round(degrees(angle));
  return String(((whole % 360) + 360) % 360).padStart(3, "0");
}

/** A heading or bearing in rad to a tenth of a degree: "007.2". */
export function bearingToTenth(angle: number): string {
  const tenths = Math.round(10 * degrees(angle));
  return figure((((tenths % 3600) + 3600) % 3600) / 10, 1).padStart(5, "0");
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

/** A figure with that many decimals, a true minus and the language's comma; "-" for what is no number. */
export function figure(value: number, decimals = 0): string {
  if (!Number.isFinite(value)) return "-";
  const text = value.toFixed(decimals);
  return writtenFigure((Number(text) === 0 ? text.replace("-", "") : text).replace("-", "\u2212"));
}

/** "1½" for 1.5, "½" for 0.5, "2" for 2. */
export const inHalves = (value: number): string => (value % 1 === 0 ? `${value}` : `${Math.floor(value) || ""}\u00bd`);

/** m of cable in shackles, two decimals at most, as the judge tells them (shackles_figure of common/): "6.97", "4". */
export function shacklesFigure(length: number): string {
  const hundredths = Number(shackles(length).toFixed(2));
  const decimals = [0, 1].find((most) => Number(hundredths.toFixed(most)) === hundredths);
  return figure(hundredths, decimals ?? 2);
}

/** An hour of the clock to which a cable leads, 12 ahead, in halves: nobody makes out more. */
export function clockHour(hours: number): string {
  const half = (Math.round(2 * hours) / 2 + 12) % 12;
  return figure(half < 1 ? half + 12 : half, half % 1 === 0 ? 0 : 1);
}

/** As orders and reports name it, in English. */
export const sideName = (side: number): string => (side === 0 ? "port" : side === 1 ? "starboard" : "both");

/** In the person's language. */
export const sideWord = (side: number): string => (side === 0 ? t("port") : side === 1 ? t("starboard") : t("both"));

/**
 * A kind of figure that people read in different units: whoever looks chooses one, and the browser keeps it. Figures
 * come in SI, and nowhere else are they turned into what is chosen.
 */
export class Measure {
  private chosen: Unit;
  private readonly listeners = new Set<() => void>();

  /** kind: in words; options: the usual one first; decimals: of a figure in a unit. */
  constructor(
    readonly kind: string,
    readonly options: readonly [Unit, ...Unit[]],
    private readonly decimals: (value: number, unit: Unit) => number,
  ) {
    this.chosen = options.find(({ one }) => one === kept(this.key)) ?? options[0];
  }

  get unit(): Unit {
    return this.chosen;
  }

  choose(unit: Unit): void {
    if (unit === this.chosen) return;
    this.chosen = unit;
    keep(this.key, unit.one);
    for (const listener of this.listeners) listener();
  }

  /** To the next of the options: for a gauge that is touched. */
  next(): void {
    this.choose(this.options[(this.options.indexOf(this.chosen) + 1) % this.options.length]!);
  }

  /** Calls back when another unit was chosen. */
  onChoice(listener: () => void): void {
    this.listeners.add(listener);
  }

  /** si in the unit that is chosen. */
  of(si: number): number {
    return si / this.chosen.si;
  }

  /** The decimals with which si is shown. */
  decimalsOf(si: number): number {
    return this.decimals(this.of(si), this.chosen);
  }

  /** "4.6", without its unit; "-" for what is no number. */
  figure(si: number): string {
    return figure(this.of(si), this.decimalsOf(si));
  }

  /** "4.6 t". */
  text(si: number): string {
    return `${this.figure(si)} ${unitWritten(this.chosen)}`;
  }

  private get key(): string {
    return `windlass.unit.${this.kind}`;
  }
}

function kept(key: string): string | null {
  try {
    return localStorage.getItem(key);
  } catch {
    return null; // a browser that keeps nothing has the usual ones
  }
}

function keep(key: string, value: string): void {
  try {
    localStorage.setItem(key, value);
  } catch {
    // it holds for this page
  }
}

/** Of a load, N: a load cell's tenths of a tonne are worth reading below 10 t only. */
export const loads = new Measure("load", [units.tonne, units.kilonewton], (value, unit) =>
  unit === units.tonne && Math.abs(value) < 9.95 ? 1 : 0,
);

/** Of the cable, m/s, in steps of some hundredths. Ship, wind and stream are in knots, whatever is chosen. */
export const cableSpeeds = new Measure(
  "cable speed",
  [units.metre_a_minute, units.knot, units.metre_a_second],
  (_, unit) => (unit === units.metre_a_minute ? 0 : unit === units.knot ? 1 : 2),
);

/** As it stands behind a figure: "t"; of an order or report: Unit.written. */
export const unitWritten = (unit: Unit): string => translated(unit.written);

/** All of them. */
export const measures: readonly Measure[] = [loads, cableSpeeds];

/** A figure above value that a scale may end with: 1, 1.5, 2, 2.5, 3, 4, 5, 6, 8 times a power of ten. */
export function scaleEnd(value: number): number {
  const power = 10 ** Math.floor(Math.log10(Math.max(value, 1e-9)));
  return power * ([1, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10].find((step) => step * power >= value) ?? 10);
}

/** What lies between two figures of a scale that ends there, as scaleEnd() gives it: some three to five of them. */
export function scaleStep(end: number): number {
  const power = 10 ** Math.floor(Math.log10(end / 5) + 1e-9);
  return power * ([1, 2, 5, 10].find((step) => step * power >= end / 5 - 1e-9 * end) ?? 10);
}
