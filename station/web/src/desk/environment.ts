// Wind, sea, stream, tide, sight and light: what is, what shall be, and in what time it comes so.

import { h, setText } from "../kit/dom";
import { showsTopic } from "../kit/live";
import { bearing, degrees, figure, kKnot, kNauticalMile, knots, radians, timeOfDay } from "../kit/units";
import type { Weather } from "../wire/generated";
import { type Typed, inMinutes, inUnit } from "./as_typed";
import type { Desk } from "./desk";
import { seconds } from "./time_field";
import { language, t, typedFigure } from "../kit/language";

const kDeep = 1000; // m, until the depth is known

type Figure = { [K in keyof Weather]: Weather[K] extends number ? K : never }[keyof Weather];

interface Row {
  field: Figure;
  label: string;
  unit: string;
  /** As it is typed and shown, from SI, and back; NaN for what is no such figure. */
  show: (value: number) => string;
  read: (text: string) => number;
  /** SI of one of its unit; undefined: it is typed as a time. */
  si?: number;
}

const scaled = (unit: string, si: number, decimals: number): Omit<Row, "field" | "label"> => ({
  unit,
  si,
  show: (value) => figure(value / si, decimals),
  read: (text) => (text.trim() ? Number(typedFigure(text).replace("\u2212", "-")) * si : NaN),
});
const direction: Omit<Row, "field" | "label"> = {
  unit: "\u00b0",
  si: radians(1),
  show: bearing,
  read: (text) => (text.trim() ? radians(Number(typedFigure(text))) : NaN),
};

const kWindSea = t("Wind sea");
const groups: readonly [string, readonly Row[]][] = [
  [
    t("Wind"),
    [
      { field: "wind_speed", label: t("speed|of the wind"), ...scaled("kn", kKnot, 0) },
      { field: "wind_from", label: t("from|direction"), ...direction },
      { field: "gust_factor", label: t("gusts over mean"), ...scaled("\u00d7", 1, 2) },
      { field: "gust_period", label: t("gust period"), ...scaled("s", 1, 0) },
      { field: "veering", label: t("veers"), ...scaled("\u00b0/min", radians(1) / 60, 1) },
    ],
  ],
  [
    kWindSea,
    [
      { field: "wave_height", label: t("height"), ...scaled("m", 1, 1) },
      { field: "wave_period", label: t("period"), ...scaled("s", 1, 1) },
      { field: "wave_from", label: t("from|direction"), ...direction },
    ],
  ],
  [
    t("Swell"),
    [
      { field: "swell_height", label: t("height"), ...scaled("m", 1, 1) },
      { field: "swell_period", label: t("period"), ...scaled("s", 1, 1) },
      { field: "swell_from", label: t("from|direction"), ...direction },
    ],
  ],
  [
    t("Stream and tide"),
    [
      { field: "current_speed", label: t("rate"), ...scaled("kn", kKnot, 1) },
      { field: "current_towards", label: t("sets"), ...direction },
      { field: "tide_height", label: t("tide"), ...scaled("m", 1, 1) },
    ],
  ],
  [
    t("Sight and light"),
    [
      { field: "visibility", label: t("visibility"), ...scaled(t("nm"), kNauticalMile, 2) },
      {
        field: "time_of_day",
        label: t("time of day"),
        unit: "h",
        show: timeOfDay,
        read: (text) => seconds(`${text}:0`),
      },
    ],
  ],
];
const gives = { "data-gives": "EnvironmentCommand" };
const rows = groups.flatMap(([, of]) => of);

/** How the fields of an EnvironmentCommand are typed here. */
const typedFields = new Map<string, Typed>([["ramp", inMinutes(t("within"))]]);
for (const [title, of] of groups)
  for (const { field, label, unit, si } of of) {
    const name = `${language === "en" ? title.toLowerCase() : title}, ${label}`;
    typedFields.set(field, si === undefined ? inMinutes(name) : inUnit(name, unit, si));
  }

export class EnvironmentPanel {
  readonly element: HTMLElement;
  private readonly inputs = new Map<Figure, HTMLInputElement>();
  private readonly nows = new Map<Figure, HTMLElement>();
  private readonly ramp = h("input", { value: "0:00", "aria-label": t("comes so within, m:ss"), class: "time" });
  private readonly fetch = h("input", {
    value: "20",
    inputMode: "decimal",
    "aria-label": t("Wind sea, fetch of the wind, nm"),
  });
  private readonly state = h("span", { class: "quiet", role: "status" });
  private readonly edited = new Set<Figure>();

  constructor(private readonly desk: Desk) {
    this.element = h(
      "form",
      { class: "environment", "aria-label": t("environment"), onsubmit: (event: Event) => this.send(event) },
      h("div", { class: "scroll" }, this.table()),
      h(
        "footer",
        {},
        h("label", gives, t("within"), this.ramp, h("span", { class: "quiet" }, t("m:ss"))),
        h("button", { class: "plain", type: "button", ...gives, onclick: () => this.drop() }, t("Undo")),
        h("button", { class: "plain primary", ...gives }, t("Set")),
        this.state,
      ),
    );
    showsTopic(this.element, desk.link, "EnvironmentState");
    desk.link.on("EnvironmentState", () => this.update());
    desk.link.onMessage("wind_sea", ({ height, period }) => {
      this.fill("wave_height", figure(Number(height), 1));
      if (Number(height) > 0) this.fill("wave_period", figure(Number(period), 1));
      this.fill("wave_from", this.inputs.get("wind_from")!.value);
    });
  }

  private table(): HTMLElement {
    const body = groups.map(([title, of]) =>
      h(
        "tbody",
        {},
        h("tr", { class: "head" }, h("th", { colSpan: 4, scope: "rowgroup" }, title)),
        ...of.map((row) => {
          const input = h("input", {
            "aria-label": `${title}, ${row.label}, ${row.unit}`,
            oninput: () => this.edit(row),
          });
          const now = h("td", { class: "now" });
          this.inputs.set(row.field, input);
          this.nows.set(row.field, now);
          return h(
            "tr",
            {},
            h("th", { scope: "row" }, row.label),
            now,
            h("td", {}, input),
            h("td", { class: "unit" }, row.unit),
          );
        }),
        title === kWindSea && this.byWind(),
      ),
    );
    const head = h(
      "thead",
      {},
      h(
        "tr",
        {},
        h("th", {}),
        h("th", { scope: "col" }, t("now")),
        h("th", { scope: "col" }, t("shall be")),
        h("th", {}),
      ),
    );
    return h("table", {}, head, ...body);
  }

  /** Fills in the sea that belongs to the wind and a fetch; it is set with the rest. */
  private byWind(): HTMLElement {
    const button = h("button", { class: "plain", type: "button", onclick: () => this.askForSea() }, t("By wind"));
    return h(
      "tr",
      gives,
      h("th", { scope: "row" }, t("fetch")),
      h("td", { class: "now" }, button),
      h("td", {}, this.fetch),
      h("td", { class: "unit" }, t("nm")),
    );
  }
  private askForSea(): void {
    const of = (field: Figure): Row => rows.find((row) => row.field === field)!;
    const wind = of("wind_speed").read(this.inputs.get("wind_speed")!.value);
    const fetch = kNauticalMile * Number(typedFigure(this.fetch.value));
    const depth = this.desk.link.latest("ExerciseTruth")?.depth;
    if (!(wind > 0) || !(fetch > 0))
      return this.desk.say(t("Sea by wind: give the wind's speed and the fetch, above 0"));
    void this.desk.ask(() => this.desk.link.ask({ op: "wind_sea", wind_speed: wind, fetch, depth: depth || kDeep }));
  }
  private fill(field: Figure, text: string): void {
    this.inputs.get(field)!.value = text;
    this.edit(rows.find((row) => row.field === field)!);
  }

  private edit(row: Row): void {
    this.edited.add(row.field);
    const input = this.inputs.get(row.field)!;
    input.classList.add("edited");
    input.setAttribute("aria-invalid", `${Number.isNaN(row.read(input.value))}`);
  }
  private drop(): void {
    this.edited.clear();
    for (const input of this.inputs.values()) {
      input.classList.remove("edited");
      input.removeAttribute("aria-invalid");
    }
    this.update();
  }

  private async send(event: Event): Promise<void> {
    event.preventDefault();
    const state = this.desk.link.latest("EnvironmentState");
    if (!state) return;
    const weather = { ...state.after };
    for (const row of rows.filter((r) => this.edited.has(r.field))) {
      const text = this.inputs.get(row.field)!.value;
      const value = row.read(text);
      if (!Number.isFinite(value))
        return this.desk.say(
          t("Environment: {what}: {typed} is not allowed: a figure in {unit}", {
            what: row.label,
            typed: text || t("nothing|typed"),
            unit: row.unit,
          }),
        );
      weather[row.field] = value;
    }
    const ramp = seconds(this.ramp.value);
    if (Number.isNaN(ramp))
      return this.desk.say(
        t("Environment: within {typed} is no time; m:ss is allowed", { typed: this.ramp.value || t("nothing|typed") }),
      );
    if (await this.desk.give("EnvironmentCommand", { weather, ramp }, (field) => typedFields.get(field))) this.drop();
  }

  private update(): void {
    const state = this.desk.link.latest("EnvironmentState");
    if (!state) return;
    const readOnly = !this.desk.may("EnvironmentCommand");
    for (const row of rows) {
      setText(this.nows.get(row.field)!, row.show(state.now[row.field]));
      const input = this.inputs.get(row.field)!;
      if (input.readOnly !== readOnly) input.readOnly = readOnly;
      if (!this.edited.has(row.field) && document.activeElement !== input)
        input.value = row.show(state.after[row.field]);
    }
    setText(this.state, state.ramp_left > 0 ? t("changing, {left} s left", { left: figure(state.ramp_left) }) : "");
  }
}

/** "16 kn from 010", for a title line. */
export function windWords(weather: Weather): string {
  const speed = figure(knots(weather.wind_speed));
  const wind = t("{speed} kn from {bearing}", { speed, bearing: bearing(weather.wind_from) });
  return degrees(weather.veering) !== 0 ? t("{wind}, veering", { wind }) : wind;
}
