// The anchor watch: anchors plotted, cable as reported, the circle that the server keeps an eye on, and the book of
// her position every five minutes.

import { h, setAttribute, setText } from "../kit/dom";
import { bearing, clock, figure, kShackle, knots, sideWord } from "../kit/units";
import { directionTo, distance, ofShip } from "../plan/projection";
import type { PlanCircle } from "../plan/picture";
import { originOf, placeAt } from "../surroundings/position";
import type { Connection } from "../wire/connection";
import { AlertCondition, type BridgeView } from "../wire/generated";
import { type AnchorPlot, shipOf } from "./anchor_plot";
import { windOf } from "./instruments";
import { Kept } from "./kept";
import { t } from "../kit/language";

const kBetweenEntries = 300; // s of exercise time
const kEntries = 200;
const kMargin = 30; // m, that a circle is wider than her swinging circle unless told; tuned
const kLeast = 10; // m, of the radius, as the server takes it
const kMost = 2000;

interface Watch {
  x: number;
  y: number;
  radius: number; // m
}
/** A line of the book. From: of the watch circle's centre, or the anchor's. */
interface Entry {
  time: number;
  text: string[];
}
type Side = 0 | 1;

export class WatchPanel {
  readonly element: HTMLElement;
  private readonly kept: Kept<Watch | null>;
  private readonly book: Kept<Entry[]>;
  private readonly anchors: {
    mark: HTMLButtonElement;
    clear: HTMLButtonElement;
    text: HTMLElement;
    row: HTMLElement;
    cable: HTMLInputElement;
    there: HTMLInputElement;
  }[];
  private readonly centre = h("select", { "aria-label": t("centre of the circle") });
  private readonly radius = h("input", {
    type: "number",
    min: `${kLeast}`,
    max: `${kMost}`,
    step: "5",
    value: "300",
    "aria-label": t("radius, m"),
  });
  private readonly keep: HTMLButtonElement;
  private readonly end: HTMLButtonElement;
  private readonly state = h("p", { class: "watch-state", role: "status" });
  private readonly rows = h("tbody", {});
  private radiusTouched = false;
  /** Why the last order was not carried out; stands until the next one. */
  private notSet = "";

  constructor(
    private readonly link: Connection,
    private readonly plot: AnchorPlot,
  ) {
    this.kept = new Kept<Watch | null>(
      link,
      "watch",
      () => null,
      () => null,
    );
    this.book = new Kept<Entry[]>(
      link,
      "book",
      () => [],
      (book, time) => book.filter((entry) => entry.time <= time),
    );
    this.anchors = ([0, 1] as const).map((side) => this.anchorRow(side));
    this.keep = h(
      "button",
      { class: "primary", type: "button", onclick: () => void this.order(true) },
      t("Keep watch"),
    );
    this.end = h("button", { type: "button", onclick: () => void this.order(false) }, t("End"));
    this.radius.addEventListener("input", () => (this.radiusTouched = true));
    this.centre.append(
      h("option", { value: "0" }, t("port anchor")),
      h("option", { value: "1" }, t("starboard anchor")),
      h("option", { value: "ship" }, t("ship, as she lies")),
    );
    this.centre.addEventListener("change", () => this.propose());
    this.element = h(
      "section",
      { class: "watch", "aria-label": t("anchor watch") },
      h("h2", {}, t("Anchors, as plotted")),
      ...this.anchors.map((a) => a.row),
      h("h2", {}, t("Anchor watch")),
      h(
        "div",
        { class: "row circle" },
        this.centre,
        this.radius,
        h("span", {}, "m"),
        h("div", { class: "act" }, this.keep, this.end),
      ),
      this.state,
      h(
        "div",
        { class: "row" },
        h("h2", {}, t("Book")),
        h("button", { class: "plain", type: "button", onclick: () => this.enter() }, t("Enter now")),
      ),
      h(
        "div",
        { class: "book", tabIndex: 0, role: "region", "aria-label": t("book of the watch") },
        h(
          "table",
          {},
          h(
            "thead",
            {},
            h(
              "tr",
              {},
              ...[t("Time"), t("From centre"), "HDG", t("Keel"), t("Wind")].map((t) => h("th", { scope: "col" }, t)),
            ),
          ),
          this.rows,
        ),
      ),
    );
    plot.onChange(() => this.propose());
    this.kept.onChange(() => this.update());
    this.book.onChange(() => this.showBook());
    link.on("SceneDescription", ({ tackle }) =>
      this.anchors.forEach((a, side) => (a.row.hidden = !tackle.some((t) => t.side === side))),
    );
    link.on("BridgeView", (view) => {
      const last = this.book.value.at(-1)?.time;
      if (this.kept.value && (last === undefined || view.time >= last + kBetweenEntries)) this.enter();
    });
    this.showBook();
  }

  /** The circle for the plan; none is kept: undefined. */
  circle(): PlanCircle | undefined {
    const watch = this.kept.value;
    if (!watch) return undefined;
    return { id: "watch", kind: "watch", label: t("watch"), ...watch, left: this.left(), editable: this.granted() };
  }

  /** Puts another radius on the circle that is kept, m. */
  setRadius(radius: number): void {
    this.radius.value = `${Math.min(kMost, Math.max(kLeast, radius))}`;
    this.radiusTouched = true;
    const watch = this.kept.value;
    if (watch) this.kept.value = { ...watch, radius: Number(this.radius.value) };
    clearTimeout(this.sending);
    this.sending = window.setTimeout(() => void this.tell(this.kept.value), 300); // not each step of a finger
  }
  private sending: number | undefined;

  /** Follows anchors and ship; a few times a second. */
  update(): void {
    const origin = originOf(this.link.latest("Landmarks"));
    this.anchors.forEach(({ mark, clear, text, cable, there }, k) => {
      there.hidden = !origin;
      const side = k as Side;
      const { place, time, reported } = this.plot.of(side);
      const out = this.plot.cable(side);
      const swing = this.plot.swing(side);
      setAttribute(mark, "data-asked", reported ? "" : undefined);
      const does = reported
        ? t("Plot: let go at {time}", { time: clock(reported.time) })
        : place
          ? t("Plot anew: hawse now")
          : t("Plot: hawse now");
      setText(mark, does);
      setAttribute(mark, "aria-label", t("{does}; plot the {side} anchor", { does, side: sideWord(side) }));
      mark.disabled = !reported && !this.plot.hawse(side);
      clear.disabled = !place && !reported;
      const lies = place
        ? swing
          ? t("plotted at {time}; swings {swing} m", { time: clock(time ?? 0), swing: figure(swing) })
          : t("plotted at {time}; cable not reported", { time: clock(time ?? 0) })
        : reported
          ? t("let go reported, not plotted")
          : t("not plotted");
      setText(text, lies);
      if (document.activeElement !== cable) {
        const shackles = out === undefined ? "" : String(Math.round((out / kShackle) * 10) / 10);
        if (cable.value !== shackles) cable.value = shackles;
      }
    });
    const granted = this.granted();
    this.keep.disabled = !granted || !this.centrePlace();
    this.end.disabled = !granted || !this.kept.value;
    setText(this.keep, this.kept.value ? t("Set anew") : t("Keep watch"));
    this.showState();
  }

  private anchorRow(side: Side): WatchPanel["anchors"][number] {
    const name = sideWord(side);
    const mark = h("button", {
      class: "plain mark",
      type: "button",
      onclick: () => this.plot.mark(side),
    });
    const clear = h(
      "button",
      {
        class: "plain",
        type: "button",
        "aria-label": t("Clear: take the {side} anchor off the plan", { side: name }),
        onclick: () => this.plot.clear(side),
      },
      t("Clear"),
    );
    const cable = h("input", {
      type: "number",
      min: "0",
      max: "14",
      step: "0.5",
      "aria-label": t("{side} cable out, shackles", { side: name }),
    });
    cable.addEventListener("change", () => {
      const shackles = Number(cable.value);
      this.plot.setCable(side, cable.value !== "" && shackles > 0 ? shackles * kShackle : undefined);
    });
    const there = h("input", {
      class: "there",
      type: "text",
      placeholder: `${t("or its place:")} 48\u00b000.000'N 020\u00b000.000'W`,
      "aria-label": t("{side} anchor's place, latitude and longitude", { side: name }),
    });
    there.addEventListener("change", () => {
      const origin = originOf(this.link.latest("Landmarks"));
      const place = origin && placeAt(origin, there.value);
      setAttribute(there, "aria-invalid", place || there.value.trim() === "" ? undefined : "true");
      if (place) this.plot.lay(side, place);
    });
    const text = h("small", {});
    const row = h(
      "div",
      { class: "anchor-row", role: "group", "aria-label": t("{side} anchor", { side: name }) },
      h("strong", {}, name),
      mark,
      clear,
      h("label", {}, cable, ` ${t("sh.")}`),
      there,
      text,
    );
    return { mark, clear, text, row, cable, there };
  }

  private granted(): boolean {
    return this.link.hello?.commands.includes("WatchCircle") ?? false;
  }

  /** Where the chosen centre is. */
  private centrePlace(): { x: number; y: number } | undefined {
    if (this.centre.value !== "ship") return this.plot.of(Number(this.centre.value) as Side).place;
    const view = this.link.latest("BridgeView");
    return view?.gps_works ? { x: view.position.x, y: view.position.y } : undefined;
  }

  /** The radius that suits the chosen anchor's cable, until a hand has set one. */
  private propose(): void {
    const plotted = ([0, 1] as const).find((side) => this.plot.of(side).place);
    if (!this.centrePlace() && plotted !== undefined && this.centre.value !== "ship") this.centre.value = `${plotted}`;
    const swing = this.centre.value === "ship" ? undefined : this.plot.swing(Number(this.centre.value) as Side);
    if (swing && !this.radiusTouched) this.radius.value = `${Math.ceil((swing + kMargin) / 5) * 5}`;
    this.update();
  }

  private async order(kept: boolean): Promise<void> {
    const centre = this.centrePlace();
    const radius = Number(this.radius.value);
    if (!kept) await this.tell(null);
    else if (!centre) return;
    else if (!(radius >= kLeast && radius <= kMost))
      this.refuse(t("the radius is {least} to {most} m", { least: kLeast, most: kMost }));
    else await this.tell({ ...centre, radius });
  }

  private refuse(why: string): void {
    this.notSet = `${t("Not set: {why}.", { why })} `;
    this.showState();
  }

  private async tell(watch: Watch | null): Promise<void> {
    this.notSet = "";
    this.showState();
    try {
      await this.link.order("WatchCircle", watch ? { kept: true, ...watch } : { kept: false });
      this.kept.value = watch;
      this.radiusTouched = false;
    } catch (why) {
      this.refuse((why as Error).message);
    }
  }

  /** m from the centre to the corner of her outline that is farthest, by GPS and gyro. */
  private farthest(watch: Watch): number | undefined {
    const view = this.link.latest("BridgeView");
    const scene = this.link.latest("SceneDescription");
    if (!view?.gps_works || !view.gyro_works || !scene) return undefined;
    const corners = [-0.5, 0.5].flatMap((ahead) =>
      [-0.5, 0.5].map((abeam) => ofShip(shipOf(view), ahead * scene.length_overall, abeam * scene.beam)),
    );
    return Math.max(...corners.map((corner) => distance(watch, corner)));
  }

  private left(): boolean {
    return this.link
      .all("Alert")
      .some((a) => a.code === "watch.circle" && a.condition <= AlertCondition.ALERT_ACTIVE_ACKNOWLEDGED);
  }

  private showState(): void {
    const watch = this.kept.value;
    const farthest = watch ? this.farthest(watch) : undefined;
    setAttribute(this.state, "data-left", watch && this.left() ? "" : undefined);
    const stands = !watch
      ? t("No watch is kept.")
      : farthest === undefined
        ? t("Circle of {radius} m: no GPS or gyro.", { radius: figure(watch.radius) })
        : this.left()
          ? `\u26a0 ${t("LEFT: {far} of {radius} m", { far: figure(farthest), radius: figure(watch.radius) })}`
          : t("Inside: {far} of {radius} m", { far: figure(farthest), radius: figure(watch.radius) });
    setText(this.state, this.notSet + stands);
  }

  private enter(): void {
    const view = this.link.latest("BridgeView");
    if (!view) return;
    this.book.value = [...this.book.value, { time: view.time, text: this.entry(view) }].slice(-kEntries);
  }

  private entry(view: BridgeView): string[] {
    const centre = this.kept.value ?? this.plot.of(0).place ?? this.plot.of(1).place;
    const wind = windOf(view);
    return [
      centre && view.gps_works
        ? `${bearing(directionTo(centre, view.position))}\u00b0 ${figure(distance(centre, view.position))} m`
        : "-",
      view.gyro_works ? `${bearing(view.heading)}\u00b0` : "-",
      view.echo_sounder_works ? `${figure(view.depth_below_keel, 1)} m` : "-",
      wind ? `${bearing(wind.from)}\u00b0 ${figure(knots(wind.speed))} kn` : "-",
    ];
  }

  private showBook(): void {
    this.rows.replaceChildren(
      ...this.book.value
        .slice()
        .reverse()
        .map(({ time, text }) =>
          h("tr", {}, h("th", { scope: "row" }, clock(time)), ...text.map((t) => h("td", {}, t))),
        ),
    );
  }
}
