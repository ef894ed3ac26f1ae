// The plots of the desk: which are shown, of which side, how far back; one cursor through all of them.

import uPlot from "uplot";

import { h, setAttribute, setText } from "../kit/dom";
import { everySecond } from "../kit/page";
import { onPalette } from "../kit/palette";
import { clock, measures } from "../kit/units";
import type { Connection } from "../wire/connection";
import type { Prediction, TopicName, TopicTypes, WindlassLoad } from "../wire/generated";
import { type Latest, type PaneSpec, panes, placeOf, places } from "./channels";
import { History } from "./history";
import { type AheadLines, type Flag, Pane } from "./pane";
import { t } from "../kit/language";

const kInterval = 0.05; // s
const kSpan = 7200; // s
const kFromBegin = 5; // s, in which the first sample of an exercise that was heard from its beginning has come
const kBuckets = 400; // more stretches than a pane has pixels pairs would not show
const kShown = "windlass.plots";
const spans: readonly [string, number][] = [
  ["1 min", 60],
  ["5 min", 300],
  ["20 min", 1200],
  ["2 h", 7200],
];
const kAhead = 60; // s, of the room to the right that a prediction is given
const kFirst = ["loads", "speed", "out", "temperature"];

export class PlotBoard {
  readonly element: HTMLElement;
  readonly history = new History(places.length, kInterval, kSpan);
  private readonly grid = h("div", { class: "panes" });
  private readonly chosen = h("summary", {});
  private readonly since = h("span", { class: "quiet", role: "status" });
  private readonly shown = new Map<string, Pane>();
  private readonly cursorListeners = new Set<(time: number | null) => void>();
  private readonly group = uPlot.sync("desk");
  private side_ = 0;
  private large = 1;
  private span = 300;
  private drawn = 0; // ms of performance.now()
  /** What the plots mark; set by the desk. */
  flags: readonly Flag[] = [];
  /** What is to come, dotted, where the desk has it. */
  ahead: () => Prediction | undefined = () => undefined;

  constructor(private readonly link: Connection) {
    const chips = panes.map((pane) =>
      h(
        "button",
        { class: "chip", "data-pane": pane.id, title: pane.title, onclick: () => this.toggle(pane.id) },
        pane.short,
      ),
    );
    const widths = spans.map(([name, span]) =>
      h("button", { class: "chip", "data-span": span, onclick: () => this.setSpan(span) }, name),
    );
    this.element = h(
      "section",
      { class: "plots", "aria-label": t("plots") },
      h(
        "div",
        { class: "plot-bar" },
        h(
          "details",
          { class: "plot-menu" },
          this.chosen,
          h("div", { class: "chips", role: "group", "aria-label": t("plots shown") }, ...chips),
        ),
        h("div", { class: "chips", role: "group", "aria-label": t("time shown") }, ...widths),
        this.since,
      ),
      this.grid,
    );
    for (const id of remembered()) this.toggle(id);
    this.setSpan(this.span);
    places.forEach((_, place) => this.read(place, link)); // all that is read below comes with its past together
    link.on("WindlassLoad", (load) => this.hear("WindlassLoad", load, link));
    for (const measure of measures) measure.onChoice(() => (this.drawn = 0));
    onPalette(() => this.shown.forEach((pane) => pane.repaint()));
    everySecond(5, (now) => this.draw(now));
  }

  get side(): number {
    return this.side_;
  }
  set side(side: number) {
    this.side_ = side;
    this.drawn = 0;
  }

  /** Calls back with the exercise time (s) under the cursor, null when it left. */
  onCursor(listener: (time: number | null) => void): void {
    this.cursorListeners.add(listener);
  }

  /** Nothing of what is plotted has been. */
  forget(): void {
    this.history.clear();
    this.drawn = 0;
  }

  /** A sample, and what was heard last when it came. */
  hear<T extends TopicName>(topic: T, sample: TopicTypes[T], then: Latest): void {
    if (topic === "WindlassLoad") this.history.add((sample as WindlassLoad).time, (place) => this.read(place, then));
  }

  private read(place: number, then: Latest): number {
    const { channel, side } = places[place]!;
    return channel.read(then, side);
  }

  private pane(spec: PaneSpec): Pane {
    const onCursor = (time: number | null): void => this.cursorListeners.forEach((listener) => listener(time));
    return new Pane(spec, this.group, onCursor, this.large);
  }

  /** Draws all figures so many times as large as usual: for those who sit far off. */
  enlarge(times: number): void {
    if (times === this.large) return;
    this.large = times;
    for (const [id, before] of this.shown) {
      const pane = this.pane(before.spec);
      before.element.replaceWith(pane.element);
      before.end();
      this.shown.set(id, pane);
    }
    this.drawn = 0;
  }

  private toggle(id: string): void {
    const there = this.shown.get(id);
    if (there) {
      there.element.remove();
      there.end();
      this.shown.delete(id);
    } else {
      const spec = panes.find((pane) => pane.id === id);
      if (!spec) return;
      const pane = this.pane(spec);
      this.shown.set(id, pane);
      const later = panes.slice(panes.indexOf(spec) + 1).find((p) => this.shown.has(p.id));
      this.grid.insertBefore(pane.element, later ? this.shown.get(later.id)!.element : null);
    }
    for (const chip of this.element.querySelectorAll(".chip[data-pane]"))
      setAttribute(chip, "aria-pressed", `${this.shown.has((chip as HTMLElement).dataset.pane!)}`);
    this.grid.dataset.count = `${this.shown.size}`;
    this.chosen.textContent = t("Plots: {shown} of {all}", { shown: this.shown.size, all: panes.length });
    try {
      localStorage.setItem(kShown, [...this.shown.keys()].join());
    } catch {
      // a browser that keeps nothing shows the first ones again
    }
    this.drawn = 0;
  }

  private setSpan(span: number): void {
    this.span = span;
    for (const chip of this.element.querySelectorAll(".chip[data-span]"))
      setAttribute(chip, "aria-pressed", `${Number((chip as HTMLElement).dataset.span) === span}`);
    this.drawn = 0;
  }

  /** Long stretches change little from one drawing to the next: once a second is enough. */
  private draw(now: number): void {
    if (now - this.drawn < (this.span > 600 ? 1000 : 150) && this.drawn > 0) return;
    this.drawn = now;
    const end = Number.isNaN(this.history.end) ? 0 : this.history.end;
    const to = Math.max(end, this.span);
    const from = to - this.span;
    const ahead = this.ahead();
    const until = ahead ? to + kAhead : to;
    const { begin } = this.history;
    // The station tells what it has heard, and was perhaps not there from the beginning.
    setText(this.since, begin > Math.max(from, kFromBegin) ? t("heard since {time}", { time: clock(begin) }) : "");
    for (const pane of this.shown.values()) {
      const which = pane.spec.channels.map((channel) => placeOf(pane.spec, channel, this.side_));
      const { times, series } = this.history.window(from, until, kBuckets, which);
      pane.ahead = ahead && aheadIn(pane.spec, ahead, this.side_);
      pane.show(times, series, from, until, pane.spec.limits?.(this.link, this.side_) ?? [], this.flags);
    }
  }
}

/** What a prediction says of a pane's channels. */
function aheadIn({ channels }: PaneSpec, { moments }: Prediction, side: number): AheadLines {
  const known = moments.flatMap(({ time, cables }) => {
    const cable = cables.find((each) => each.side === side);
    return cable ? [{ time, cable }] : [];
  });
  return {
    times: known.map(({ time }) => time),
    series: channels.map(({ ahead }) => (ahead ? known.map(({ cable }) => ahead(cable)) : [])),
  };
}

function remembered(): string[] {
  try {
    const kept = localStorage
      .getItem(kShown)
      ?.split(",")
      .filter((id) => panes.some((pane) => pane.id === id));
    return kept?.length ? kept : kFirst;
  } catch {
    return kFirst;
  }
}
