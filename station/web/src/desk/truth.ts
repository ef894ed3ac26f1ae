// What is, beside what a gauge shows: both sides in two columns each; and how the model itself is doing.

import { limits } from "../../../../words/words.json";
import { h, setText } from "../kit/dom";
import { showsTopic } from "../kit/live";
import { loadsMeasured } from "../kit/measured";
import { LightsAndShapesPanel } from "../kit/lights_and_shapes";
import { everySecond } from "../kit/page";
import {
  type Measure,
  cableSpeeds,
  celsius,
  clockHour,
  degrees,
  figure,
  loads,
  measures,
  shackles,
  shacklesFigure,
  sideWord,
  unitWritten,
} from "../kit/units";
import { saidOf } from "../kit/words";
import type { Connection } from "../wire/connection";
import { AnchorPhase } from "../wire/generated";
import type { Desk } from "./desk";
import { t } from "../kit/language";

export interface Row {
  label: string;
  /** A measure: the unit that is chosen of it. */
  unit: string | Measure;
  /** What the gauge shows; empty where there is none. */
  shown?: (link: Connection, side: number) => string;
  is: (link: Connection, side: number) => string;
  /** Also shown to a room. */
  projected?: true;
  /** Whether to draw the eye: gauge and truth differ, or a limit is near. */
  warns?: (link: Connection, side: number) => boolean;
}

const load = (link: Connection, side: number) => link.latest("WindlassLoad", side);
/** Once there are loads. */
const loaded = (link: Connection, side: number) => {
  const found = load(link, side);
  return found && loadsMeasured(found) ? found : undefined;
};
const chain = (link: Connection, side: number) => link.latest("ChainState", side);
const anchor = (link: Connection, side: number) => link.latest("AnchorState", side);
const ofForce = (force: number | undefined): string => loads.figure(force ?? NaN);
const c = (temperature: number | undefined): string => figure(celsius(temperature ?? NaN));
const onBottom = (link: Connection, side: number): boolean => {
  const phase = anchor(link, side)?.phase ?? AnchorPhase.ANCHOR_HOUSED;
  return phase >= AnchorPhase.ANCHOR_ON_BOTTOM && phase <= AnchorPhase.ANCHOR_DRAGGING;
};

export const truthRows: readonly Row[] = [
  {
    label: t("cable out"),
    projected: true,
    unit: "m",
    shown: (l, s) => figure(load(l, s)?.cable_out_indicated ?? NaN, 1),
    is: (l, s) => figure(load(l, s)?.cable_out ?? NaN, 1),
    warns: (l, s) => Math.abs((load(l, s)?.cable_out ?? 0) - (load(l, s)?.cable_out_indicated ?? 0)) > 5,
  },
  {
    label: "",
    unit: t("shackles|a unit"),
    shown: (l, s) => figure(shackles(load(l, s)?.cable_out_indicated ?? NaN), 1),
    is: (l, s) => shacklesFigure(load(l, s)?.cable_out ?? NaN),
  },
  {
    label: t("cable speed|a row"),
    projected: true,
    unit: cableSpeeds,
    is: (l, s) => cableSpeeds.figure(load(l, s)?.cable_speed ?? NaN),
    warns: (l, s) => Math.abs(load(l, s)?.cable_speed ?? 0) > limits.cable_fast.value,
  },
  {
    label: t("load, gypsy"),
    projected: true,
    unit: loads,
    shown: (l, s) => ofForce(loaded(l, s)?.gypsy_load_indicated),
    is: (l, s) => ofForce(loaded(l, s)?.gypsy_load),
    warns: (l, s) => Math.abs((load(l, s)?.gypsy_load ?? 0) - (load(l, s)?.gypsy_load_indicated ?? 0)) > 30000,
  },
  {
    label: t("tension, hawse"),
    projected: true,
    unit: loads,
    is: (l, s) => ofForce(loaded(l, s)?.hawse_tension),
    warns: (l, s) => (load(l, s)?.utilisation ?? 0) > limits.load_allowed.value,
  },
  {
    label: t("of breaking load"),
    projected: true,
    unit: "%",
    is: (l, s) => figure(100 * (loaded(l, s)?.utilisation ?? NaN)),
    warns: (l, s) => (load(l, s)?.utilisation ?? 0) > limits.load_allowed.value,
  },
  { label: t("brake bears"), projected: true, unit: loads, is: (l, s) => ofForce(loaded(l, s)?.brake_load) },
  {
    label: t("brake could hold"),
    projected: true,
    unit: loads,
    is: (l, s) => ofForce(loaded(l, s)?.brake_capacity),
  },
  { label: t("stopper bears"), projected: true, unit: loads, is: (l, s) => ofForce(loaded(l, s)?.stopper_load) },
  { label: t("motor bears"), projected: true, unit: loads, is: (l, s) => ofForce(loaded(l, s)?.motor_load) },
  {
    label: t("lining"),
    unit: "\u00b0C",
    is: (l, s) => c(load(l, s)?.lining_temperature),
    warns: (l, s) => (load(l, s)?.lining_temperature ?? 0) > limits.lining_smokes.value,
  },
  { label: t("drum"), unit: "\u00b0C", is: (l, s) => c(load(l, s)?.drum_temperature) },
  { label: t("lining friction"), unit: "", is: (l, s) => figure(load(l, s)?.lining_friction ?? NaN, 2) },
  { label: t("lining worn"), unit: "%", is: (l, s) => figure(100 * (load(l, s)?.brake_wear ?? NaN)) },
  {
    label: t("anchor"),
    projected: true,
    unit: "",
    is: (l, s) => {
      const phase = anchor(l, s)?.phase;
      return phase === undefined ? "-" : saidOf("AnchorPhase", phase);
    },
    warns: (l, s) =>
      [AnchorPhase.ANCHOR_DRAGGING, AnchorPhase.ANCHOR_FOULED, AnchorPhase.ANCHOR_LOST].includes(
        anchor(l, s)?.phase ?? 0,
      ),
  },
  {
    label: t("holds"),
    projected: true,
    unit: loads,
    is: (l, s) => (onBottom(l, s) ? ofForce(anchor(l, s)?.holding_used) : "\u2013"),
  },
  {
    label: t("could hold"),
    projected: true,
    unit: loads,
    is: (l, s) => (onBottom(l, s) ? ofForce(anchor(l, s)?.holding_capacity) : "\u2013"),
  },
  {
    label: t("dug in"),
    unit: "%",
    is: (l, s) => (onBottom(l, s) ? figure(100 * (anchor(l, s)?.embedment ?? NaN)) : "\u2013"),
  },
  {
    label: t("dragged"),
    unit: "m",
    is: (l, s) => figure(anchor(l, s)?.dragged ?? NaN, 1),
  },
  {
    label: t("uplift"),
    unit: "\u00b0",
    is: (l, s) => (onBottom(l, s) ? figure(degrees(anchor(l, s)?.uplift ?? NaN), 1) : "\u2013"),
  },
  { label: t("leads"), unit: t("o'clock"), is: (l, s) => clockHour(chain(l, s)?.lead_clock ?? NaN) },
  {
    label: t("stay"),
    projected: true,
    unit: "",
    is: (l, s) => (chain(l, s) ? saidOf("Stay", chain(l, s)!.stay) : "-"),
  },
  // By which alone the stay goes: a cable may be at short stay with much of it on the bottom.
  {
    label: t("below the horizontal, at the lip"),
    unit: "\u00b0",
    is: (l, s) => figure(degrees(chain(l, s)?.top_angle ?? NaN)),
  },
  { label: t("on the bottom"), unit: "m", is: (l, s) => figure(chain(l, s)?.on_bottom ?? NaN) },
  {
    label: t("turns"),
    unit: "",
    is: (l, s) => figure(chain(l, s)?.turns ?? NaN, 1),
    warns: (l, s) => Math.abs(chain(l, s)?.turns ?? 0) > 0.9,
  },
  { label: t("soil"), unit: "", is: (l, s) => (anchor(l, s) ? saidOf("Soil", anchor(l, s)!.soil) : "-") },
];

export class TruthPanel {
  readonly element: HTMLElement;
  private readonly model = h("dl", { class: "model" });
  private readonly figures = new Map<string, HTMLElement>();
  private readonly noLoads = h(
    "p",
    { class: "quiet", hidden: true },
    t("No loads yet: they come with the first tick."),
  );

  constructor(private readonly desk: Desk) {
    const units: { cell: HTMLElement; measure: Measure }[] = [];
    const unitCell = ({ unit }: Row): HTMLElement => {
      const cell = h("td", { class: "unit" }, typeof unit === "string" ? unit : "");
      if (typeof unit !== "string") units.push({ cell, measure: unit });
      return cell;
    };
    const cells = truthRows.map((row) => ({
      row,
      cells: [0, 1].map((side) => ({
        side,
        shown: h("td", { class: "shown", "data-side": side }),
        is: h("td", { "data-side": side }),
      })),
    }));
    const table = h(
      "table",
      { class: "truth" },
      h(
        "thead",
        {},
        h(
          "tr",
          {},
          h("td", {}),
          ...[0, 1].map((side) => h("th", { colSpan: 2, scope: "colgroup", "data-side": side }, sideWord(side))),
          h("td", {}),
        ),
        h(
          "tr",
          { class: "sub" },
          h("td", {}),
          ...[0, 1].flatMap((side) =>
            [t("gauge"), t("truth")].map((what) => h("th", { scope: "col", "data-side": side }, what)),
          ),
          h("td", {}),
        ),
      ),
      h(
        "tbody",
        {},
        ...cells.map(({ row, cells: of }) =>
          h(
            "tr",
            {},
            h("th", { scope: "row" }, row.label),
            ...of.flatMap(({ shown, is }) => [shown, is]),
            unitCell(row),
          ),
        ),
      ),
    );
    this.element = h(
      "div",
      { class: "truth-panel scroll", tabIndex: 0, role: "region", "aria-label": t("truth beside gauges") },
      this.noLoads,
      table,
      h("h3", {}, t("She shows")),
      new LightsAndShapesPanel(desk.link).element,
      h("h3", {}, t("Simulation")),
      this.model,
    );
    const names: readonly (readonly [name: string, said: string, unit: string])[] = [
      ["level", t("level"), ""],
      ["nodes", t("nodes"), ""],
      ["substeps", t("substeps"), ""],
      ["load", t("error of load"), "%"],
      ["shape", t("error of shape"), "m"],
      ["late", t("late"), "ms"],
      ["overruns", t("overruns"), ""],
      ["refused", t("orders refused"), ""],
      ["dropped", t("samples dropped"), ""],
    ];
    for (const [name, said, unit] of names) {
      const value = h("span", {});
      this.figures.set(name, value);
      this.model.append(
        h("div", {}, h("dt", {}, said), h("dd", {}, value, unit ? h("span", { class: "unit" }, ` ${unit}`) : "")),
      );
    }
    const showUnits = (): void => {
      for (const { cell, measure } of units) setText(cell, unitWritten(measure.unit));
    };
    for (const measure of measures) measure.onChoice(showUnits);
    showUnits();
    desk.onSides((sides) =>
      this.element
        .querySelectorAll<HTMLElement>("[data-side]")
        .forEach((cell) => (cell.hidden = !sides.includes(Number(cell.dataset.side)))),
    );
    showsTopic(table, desk.link, "WindlassLoad");
    showsTopic(this.model, desk.link, "ExerciseTruth");
    everySecond(4, () => {
      for (const { row, cells: of } of cells)
        for (const { side, shown, is } of of) {
          const there = load(desk.link, side) !== undefined;
          setText(shown, there && row.shown ? row.shown(desk.link, side) : "");
          setText(is, there ? row.is(desk.link, side) : "");
          const warns = there && (row.warns?.(desk.link, side) ?? false);
          is.classList.toggle("warns", warns);
        }
      const heard = [0, 1].flatMap((side) => load(desk.link, side) ?? []);
      this.noLoads.hidden = heard.length === 0 || heard.some(loadsMeasured);
      this.showModel();
    });
  }

  private showModel(): void {
    const truth = this.desk.link.latest("ExerciseTruth");
    if (!truth) return;
    const set = (name: string, text: string): void => setText(this.figures.get(name)!, text);
    set("level", saidOf("ModelLevel", truth.model_level));
    set("nodes", figure(truth.model_nodes));
    set("substeps", figure(truth.model_substeps));
    set("load", truth.model_error_load < 0 ? "\u2013" : figure(100 * truth.model_error_load, 2));
    set("shape", truth.model_error_shape < 0 ? "\u2013" : figure(truth.model_error_shape, 3));
    set("late", figure(1000 * truth.lateness, 1));
    set("overruns", figure(truth.overruns));
    set("refused", figure(truth.commands_refused));
    set("dropped", figure(truth.samples_dropped));
  }
}
