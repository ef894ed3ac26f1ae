// What the windlass's stand shows: the gauges that this ship has, and no others.

import type { ForecastleView, SceneTackle } from "../wire/generated";
import { h, setAttribute, setShown, setText, svg } from "../kit/dom";
import { LoadScale, loadScales } from "../kit/load_scale";
import { gaugeMeasured } from "../kit/measured";
import {
  cableSpeeds,
  celsius,
  figure,
  kTonne,
  loads,
  measures,
  scaleEnd,
  scaleStep,
  shackles,
  unitWritten,
} from "../kit/units";
import { t } from "../kit/language";

const kBeginning = -210; // degrees clockwise from the right, where a dial's scale begins
const kSweep = 240;
const kStands = 1 / 120; // m/s, below which the counter shows no way
const kNewScale = 3000; // ms for which a new scale stands out
const kSmallestScale = 10 * kTonne; // N: a chain that hangs in 25 m pulls some 3 t

function at(share: number, radius: number): [number, number] {
  const angle = ((kBeginning + kSweep * share) * Math.PI) / 180;
  return [radius * Math.cos(angle), radius * Math.sin(angle)];
}
function arc(from: number, to: number, radius: number): string {
  const [x0, y0] = at(from, radius);
  const [x1, y1] = at(to, radius);
  const large = (to - from) * kSweep > 180 ? 1 : 0;
  return `M ${x0.toFixed(2)} ${y0.toFixed(2)} A ${radius} ${radius} 0 ${large} 1 ${x1.toFixed(2)} ${y1.toFixed(2)}`;
}

/** A round gauge with a needle, a band from a limit on, a red line, and its figure with unit below. */
export class Dial {
  readonly element: HTMLElement;
  private readonly needle = svg("path", { d: "M -4 0 L -1.2 -36 L 1.2 -36 L 4 0 Z", class: "needle" });
  private readonly scale = svg("g", {});
  private readonly value = h("strong", {});
  private readonly unit = h("span", { class: "unit" });
  private readonly range = h("span", { class: "range" });
  private drawn = "";
  private settled: ReturnType<typeof setTimeout> | undefined;

  /** onclick: what a touch does, if anything. */
  constructor(label: string, onclick?: () => void) {
    const picture = svg(
      "svg",
      { viewBox: "-50 -50 100 86", "aria-hidden": "true" },
      this.scale,
      this.needle,
      svg("circle", { r: 5, class: "pin" }),
    );
    this.element = h("div", { class: "dial", role: "meter", "aria-label": label }, picture);
    this.element.append(
      h("div", { class: "reading" }, this.value, " ", this.unit),
      h("span", { class: "label" }, label, this.range),
    );
    if (onclick) {
      this.element.addEventListener("click", onclick);
      this.element.classList.add("touchable");
    }
  }

  /** Says to what the scale goes, plainly when that has just changed: for a dial of more than one scale. */
  showRange(end: number, unit: string): void {
    const text = t(", scale to {end} {unit}", { end: figure(end, end % 1 ? 1 : 0), unit });
    if (this.range.textContent === text) return;
    if (this.range.textContent) {
      setAttribute(this.element, "data-changed", "");
      clearTimeout(this.settled);
      this.settled = setTimeout(() => setAttribute(this.element, "data-changed", undefined), kNewScale);
    }
    setText(this.range, text);
  }

  /** value, end of the scale, limit and red line (undefined: none) in that unit. */
  show(value: number, end: number, unit: string, decimals: number, limit?: number, redLine?: number): void {
    this.draw(end, limit, redLine);
    setAttribute(this.element, "data-unmeasured", undefined);
    const share = Math.min(1.02, Math.max(0, value / end));
    setAttribute(this.needle, "transform", `rotate(${(kBeginning + kSweep * share + 90).toFixed(1)})`);
    const shown = figure(value, decimals);
    setText(this.value, shown);
    setText(this.unit, unit);
    setAttribute(this.element, "aria-valuenow", value.toFixed(decimals));
    setAttribute(this.element, "aria-valuetext", `${shown} ${unit}`);
    setAttribute(this.element, "data-over", limit !== undefined && value >= limit ? "" : undefined);
  }

  /** Nothing has been measured yet. end, unit and limit as of show(). */
  showNothing(end: number, unit: string, limit?: number): void {
    this.show(0, end, unit, 0, limit);
    setAttribute(this.element, "data-unmeasured", "");
    setText(this.value, "");
    setText(this.unit, t("not measured yet"));
    setAttribute(this.element, "aria-valuetext", t("not measured yet"));
    setAttribute(this.element, "data-over", undefined);
  }

  private draw(end: number, limit: number | undefined, redLine: number | undefined): void {
    const kind = `${end}/${limit}/${redLine}`;
    if (this.drawn === kind) return;
    this.drawn = kind;
    setAttribute(this.element, "aria-valuemin", "0");
    setAttribute(this.element, "aria-valuemax", `${end}`);
    const step = scaleStep(end);
    const steps = Math.round(end / step);
    const ticks = Array.from({ length: 2 * steps + 1 }, (_, i) => {
      const [x0, y0] = at(i / (2 * steps), i % 2 ? 40.5 : 37);
      const [x1, y1] = at(i / (2 * steps), 43);
      return svg("line", { x1: x0, y1: y0, x2: x1, y2: y1, class: "tick" });
    });
    const across = (share: number): SVGElement => {
      const [[x0, y0], [x1, y1]] = [at(share, 36), at(share, 49)];
      return svg("line", { x1: x0, y1: y0, x2: x1, y2: y1, class: "red-line" });
    };
    const labels = Array.from({ length: steps + 1 }, (_, i) => {
      const last = i === 0 || i === steps; // those at the ends stand below the arc
      const [x, y] = at(i / steps, last ? 41 : 29);
      return svg("text", { x, y: y + (last ? 11 : 3) }, figure(i * step, step % 1 ? 1 : 0));
    });
    this.scale.replaceChildren(
      svg("path", { d: arc(0, 1, 43), class: "track" }),
      ...(limit !== undefined && limit < end ? [svg("path", { d: arc(limit / end, 1, 46), class: "band" })] : []),
      ...ticks,
      ...labels,
      ...(redLine !== undefined ? [across(redLine / end)] : []),
    );
  }
}

const kLamps = ["power", "ready", "trip", "e-stop"] as const;
const lampWords: Record<Lamp, string> = {
  power: t("power|lamp"),
  ready: t("ready|lamp"),
  trip: t("trip|lamp"),
  "e-stop": t("e-stop|lamp"),
};
type Lamp = (typeof kLamps)[number];

/** What the counter's figure counts: zero is the lip, and an anchor that is home has its shackle up the pipe. */
export const countedFrom = (metres: number): string =>
  Number(metres.toFixed(1)) < 0 ? t("inboard of the lip") : t("from the lip");

export class Gauges {
  readonly element: HTMLElement;
  private readonly from = h("span", { class: "label" }, t("from the lip"));
  private readonly metres = h("strong", {});
  private readonly lengths = h("strong", {});
  private readonly rate = h("strong", {});
  private readonly counter: HTMLElement;
  private readonly load: Dial;
  private loadScale = new LoadScale();
  private readonly motor = new Dial(t("motor"));
  private readonly lamps = new Map<Lamp, HTMLElement>();
  private readonly aid = h("p", { class: "quiet aid", hidden: true });
  private lastDigits = -Infinity;
  private readonly rateUnit = h("span", {}, unitWritten(cableSpeeds.unit));

  constructor() {
    const reading = (value: HTMLElement, unit: Node | string): HTMLElement =>
      h("div", { class: "reading" }, value, h("span", { class: "unit" }, unit));
    this.counter = h(
      "div",
      { class: "counter", role: "group", "aria-label": t("chain counter") },
      h("h2", {}, t("Counter"), " ", this.from),
      reading(this.metres, "m"),
      reading(this.lengths, t("shackles")),
      reading(this.rate, this.rateUnit),
    );
    this.load = new Dial(t("gypsy load"), () => loads.next());
    this.load.element.title = t("touch: another unit");
    for (const measure of measures) measure.onChoice(() => this.begin());
    for (const lamp of kLamps)
      this.lamps.set(lamp, h("span", { class: "lamp", "data-lamp": lamp, role: "img" }, lampWords[lamp].toUpperCase()));
    this.element = h(
      "section",
      { class: "gauges", "aria-label": t("gauges") },
      this.counter,
      h("div", { class: "dials" }, this.load.element, this.motor.element),
      h("div", { class: "lamps" }, ...this.lamps.values()),
      this.aid,
    );
  }

  /** Needles and lamps at once, digits four times a second. now: ms. */
  show(view: ForecastleView, tackle: SceneTackle | undefined, now: number): void {
    setShown(this.counter, view.counter_fitted);
    if (now - this.lastDigits > 240) {
      this.lastDigits = now;
      setText(this.from, countedFrom(view.cable_out_indicated));
      setText(this.metres, figure(view.cable_out_indicated, 1));
      setText(this.lengths, figure(shackles(view.cable_out_indicated), 1));
      const rate = view.cable_speed_indicated;
      const arrow = rate > kStands ? "\u25bc " : rate < -kStands ? "\u25b2 " : "";
      setText(this.rate, `${arrow}${cableSpeeds.figure(Math.abs(rate))}`);
    }
    setShown(this.load.element, view.load_cell_fitted);
    this.showLoad(view, now);
    this.showMotor(view, tackle);
    setShown(this.aid, view.lining_temperature_shown);
    if (view.lining_temperature_shown)
      setText(
        this.aid,
        t("aid of this exercise: brake lining {degrees} °C", { degrees: figure(celsius(view.lining_temperature)) }),
      );
    const lit = lampsLit(view);
    for (const lamp of kLamps) this.light(lamp, lit[lamp], lamp === "trip" || lamp === "e-stop");
  }

  /** In other units than before. */
  private begin(): void {
    this.loadScale = new LoadScale();
    this.lastDigits = -Infinity;
    setText(this.rateUnit, unitWritten(cableSpeeds.unit));
  }

  private showLoad(view: ForecastleView, now: number): void {
    const unit = unitWritten(loads.unit);
    const rating = loads.of(view.brake_rating);
    const load = loads.of(view.gypsy_load_indicated);
    const ends = loadScales(scaleEnd(1.2 * rating), scaleEnd(loads.of(kSmallestScale)));
    const end = this.loadScale.at(load, ends, now);
    if (!gaugeMeasured(view)) {
      this.load.showNothing(end, unit, rating);
      return;
    }
    this.load.show(load, end, unit, loads.decimalsOf(view.gypsy_load_indicated), rating);
    this.load.showRange(end, unit);
  }

  private showMotor(view: ForecastleView, tackle: SceneTackle | undefined): void {
    const { unit, end, redLine } = motorFace(tackle);
    const value = unit === "bar" ? view.motor_pressure / 1e5 : view.motor_current;
    this.motor.show(value, end, unit, 0, undefined, redLine);
    const said =
      redLine === undefined ? undefined : t("red line: rated current, {amperes} A", { amperes: figure(redLine) });
    setAttribute(this.motor.element, "title", said);
  }

  private light(name: Lamp, on: boolean, warns: boolean): void {
    const lamp = this.lamps.get(name)!;
    setAttribute(lamp, "data-on", on ? (warns ? "warning" : "yes") : undefined);
    setAttribute(
      lamp,
      "aria-label",
      on ? t("{name} lamp lit", { name: lampWords[name] }) : t("{name} lamp dark", { name: lampWords[name] }),
    );
  }
}

/** Which lamps of the panel are lit: none without supply, though the drive is cut off then. */
export const lampsLit = ({
  power,
  tripped,
  emergency_stop,
}: Pick<ForecastleView, "power" | "tripped" | "emergency_stop">): Record<Lamp, boolean> => ({
  power,
  ready: power && !tripped && !emergency_stop,
  trip: power && tripped,
  "e-stop": power && emergency_stop,
});

const kPressureEnd = 200; // bar: the face of the gauge; relief valves of low-pressure hydraulics open at 130
const kUnknownEnd = 500; // A, until the page is told of its windlass
const kCurrentAtStall = 2; // of rated current, that an ammeter's face must show

/** The face of a motor's gauge; redLine: where it has one. */
export interface MotorFace {
  unit: "A" | "bar";
  end: number;
  redLine?: number;
}

/**
 * An ammeter goes as far as a motor draws that stalls, with the red line of a starter's panel at the rated current; a
 * hydraulic drive has a pressure gauge in its place.
 */
export function motorFace(tackle: Pick<SceneTackle, "drive" | "rated_current"> | undefined): MotorFace {
  if (tackle?.drive === "hydraulic") return { unit: "bar", end: kPressureEnd };
  if (!tackle) return { unit: "A", end: kUnknownEnd };
  return { unit: "A", end: scaleEnd(kCurrentAtStall * tackle.rated_current), redLine: tackle.rated_current };
}
