// One plot over time: its figures, limits and flags, with uPlot; a header names them with their values.

import uPlot from "uplot";

import { h, setAttribute, setText } from "../kit/dom";
import { colour } from "../kit/palette";
import { Measure, clock, figure, unitWritten } from "../kit/units";
import type { Limit, PaneSpec } from "./channels";
import { t, writtenFigure } from "../kit/language";

/** A moment that all plots mark. */
export interface Flag {
  time: number;
  /** CSS variable of its colour, without the dashes. */
  colour: string;
}

/** What is to come of its channels, as they read; none of a channel: nobody can say. */
export interface AheadLines {
  times: number[];
  series: number[][];
}

const kFont = 11; // px
const kAxis = 40; // px, of the figures on the left, at that size
const kTimes = 18; // px, of the times below

export class Pane {
  readonly element: HTMLElement;
  private readonly plot: uPlot;
  private readonly values: HTMLElement[];
  private readonly unit = h("small", {});
  private limits: Limit[] = [];
  private flags: readonly Flag[] = [];
  /** Drawn with the next show(). */
  ahead: AheadLines | undefined;
  private data: uPlot.AlignedData;

  /**
   * onCursor: called with s of exercise time, or null when the pointer left. large: times the usual size of what it
   * writes.
   */
  constructor(
    readonly spec: PaneSpec,
    group: uPlot.SyncPubSub,
    onCursor: (time: number | null) => void,
    private readonly large = 1,
  ) {
    this.values = spec.channels.map(() => h("b", {}, "-"));
    const holder = h("div", { class: "holder" });
    this.element = h(
      "section",
      { class: "pane", "data-pane": spec.id },
      h(
        "header",
        {},
        h("h3", {}, spec.title, " ", this.unit),
        ...spec.channels.map((channel, i) =>
          h(
            "button",
            {
              class: "legend",
              "aria-pressed": "true",
              onclick: (e: Event) => this.toggle(i, e.currentTarget as Element),
            },
            h("i", { class: channel.dashed ? "dashed" : "", style: `--line: var(--plot-${i + 1})` }),
            channel.label,
            this.values[i],
          ),
        ),
      ),
      holder,
    );
    this.data = [[], ...spec.channels.map(() => [])];
    this.plot = new uPlot(this.options(group, onCursor), this.data, holder);
    new ResizeObserver(() => this.plot.setSize({ width: holder.clientWidth, height: holder.clientHeight })).observe(
      holder,
    );
  }

  /** times in s; series as the channels of the pane read them. */
  show(
    times: number[],
    series: readonly (number | null)[][],
    from: number,
    to: number,
    limits: Limit[],
    flags: readonly Flag[],
  ): void {
    const data: uPlot.AlignedData = [times, ...series.map((of) => of.map((value) => value && value / this.si))];
    this.limits = limits.map(({ label, value }) => ({ label, value: value / this.si }));
    this.showUnit();
    this.flags = flags;
    this.data = data;
    this.plot.batch(() => {
      this.plot.setData(data, false);
      this.plot.setScale("x", { min: from, max: to });
    });
    this.showValues();
  }

  /** It is shown no more. */
  end(): void {
    this.plot.destroy();
  }

  /** After the palette changed. */
  repaint(): void {
    this.plot.redraw(false, true);
  }

  private get si(): number {
    return this.spec.unit instanceof Measure ? this.spec.unit.unit.si : 1;
  }

  /** A figure as it is drawn; decimals: where no measure says how many. */
  private figure(value: number, decimals = 0): string {
    const { unit } = this.spec;
    return figure(value, unit instanceof Measure ? unit.decimalsOf(value * unit.unit.si) : decimals);
  }

  private showUnit(): void {
    const { title, unit } = this.spec;
    const written = unit instanceof Measure ? unitWritten(unit.unit) : unit;
    setText(this.unit, written);
    setAttribute(this.element, "aria-label", t("{title} over time, {unit}", { title, unit: written }));
  }

  private toggle(channel: number, button: Element): void {
    const shown = !this.plot.series[channel + 1]!.show;
    this.plot.setSeries(channel + 1, { show: shown });
    button.setAttribute("aria-pressed", `${shown}`);
  }

  /** At the cursor, else the newest. */
  private showValues(): void {
    const at = this.plot.cursor.idx ?? this.data[0].length - 1;
    this.spec.channels.forEach((channel, i) => {
      const value = at >= 0 ? (this.data[i + 1]?.[at] ?? NaN) : NaN;
      setText(this.values[i]!, this.figure(value, channel.decimals));
    });
  }

  private options(group: uPlot.SyncPubSub, onCursor: (time: number | null) => void): uPlot.Options {
    const axis = (): string => colour("element-neutral-color");
    const grid = { stroke: () => colour("plot-grid"), width: 1 };
    const font = `${kFont * this.large}px "Noto Sans", sans-serif`;
    return {
      width: 300,
      height: 100,
      pxAlign: 0,
      legend: { show: false },
      padding: [6 * this.large, 14 * this.large, 0, 0],
      cursor: {
        sync: { key: group.key, scales: ["x", null] },
        drag: { x: false, y: false },
        points: { size: 6 },
        y: false,
      },
      scales: { x: { time: false }, y: { range: (_, low, high) => this.range(low, high) } },
      axes: [
        {
          stroke: axis,
          grid,
          font,
          size: kTimes * this.large,
          gap: 4,
          ticks: { show: false },
          space: 70 * this.large,
          incrs: [1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600],
          values: (_, splits) => splits.map((s) => (s < 0 ? "" : clock(s))),
        },
        {
          stroke: axis,
          grid,
          font,
          size: kAxis * this.large,
          gap: 2,
          ticks: { show: false },
          space: 22 * this.large,
          values: (_, splits) => splits.map((s) => writtenFigure(`${Number(s.toPrecision(6))}`).replace("-", "\u2212")),
        },
      ],
      series: [
        {},
        ...this.spec.channels.map((channel, i) => ({
          stroke: () => colour(`plot-${i + 1}`),
          width: 1.5,
          ...(channel.dashed ? { dash: [5, 4] } : {}),
          points: { show: false },
          auto: !channel.leaves,
        })),
      ],
      hooks: {
        setCursor: [
          (plot) => {
            const { idx, left } = plot.cursor;
            const inside = left !== undefined && left >= 0 && idx !== null && idx !== undefined;
            onCursor(inside ? plot.posToVal(left, "x") : null);
            this.showValues();
          },
        ],
        drawClear: [(plot) => this.drawFlags(plot)],
        draw: [(plot) => this.drawAhead(plot), (plot) => this.drawLimits(plot)],
      },
    };
  }

  /** Zero is always in sight; a limit comes into it when the figure is past half of it. */
  private range(low: number | null, high: number | null): uPlot.Range.MinMax {
    const ahead = this.spec.channels.flatMap(({ leaves }, i) => (leaves ? [] : this.aheadOf(i)));
    const least = Math.min(0, low ?? 0, ...ahead);
    const floor = this.spec.least / this.si;
    let most = Math.max(floor, high ?? 0, ...ahead);
    for (const { value } of this.limits) if (most > 0.5 * value) most = Math.max(most, value);
    const space = most - least || 1;
    return [least < 0 ? least - 0.06 * space : 0, most + (most > floor ? 0.08 * space : 0)];
  }

  /** Of a channel that is shown, as it is drawn. */
  private aheadOf(channel: number): number[] {
    const shown = this.plot?.series[channel + 1]?.show;
    return shown ? (this.ahead?.series[channel] ?? []).map((value) => value / this.si) : [];
  }

  /** As dots in the channel's colour, over what has come since. */
  private drawAhead(plot: uPlot): void {
    if (!this.ahead) return;
    const { times } = this.ahead;
    const { ctx, bbox } = plot;
    const ratio = devicePixelRatio * this.large;
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
    ctx.clip();
    ctx.lineWidth = 2.5 * ratio;
    ctx.lineCap = ctx.lineJoin = "round";
    ctx.setLineDash([0.1 * ratio, 5 * ratio]);
    this.spec.channels.forEach((_, channel) => {
      ctx.strokeStyle = colour(`plot-${channel + 1}`);
      ctx.beginPath();
      this.aheadOf(channel).forEach((value, i) =>
        ctx.lineTo(plot.valToPos(times[i]!, "x", true), plot.valToPos(value, "y", true)),
      );
      ctx.stroke();
    });
    ctx.restore();
  }

  private drawLimits(plot: uPlot): void {
    const { ctx, bbox } = plot;
    const ratio = devicePixelRatio * this.large;
    const top = plot.scales.y!.max ?? 0;
    ctx.save();
    ctx.font = `${kFont * ratio}px "Noto Sans", sans-serif`;
    ctx.fillStyle = ctx.strokeStyle = colour("alert-alarm-color");
    ctx.lineWidth = ratio;
    ctx.setLineDash([2 * ratio, 3 * ratio]);
    ctx.textAlign = "right";
    const above: string[] = [];
    let right = bbox.left + bbox.width - 4 * ratio;
    let last = -Infinity; // where the label before stands
    for (const { label, value } of this.limits) {
      const words = `${label} ${this.figure(value)}`;
      if (value > top) {
        above.push(words);
        continue;
      }
      const y = plot.valToPos(value, "y", true);
      ctx.beginPath();
      ctx.moveTo(bbox.left, y);
      ctx.lineTo(bbox.left + bbox.width, y);
      ctx.stroke();
      const below = y - bbox.top < 14 * ratio;
      ctx.textBaseline = below ? "top" : "bottom";
      const middle = y + (below ? 6 : -6) * ratio;
      if (Math.abs(middle - last) > 13 * ratio) right = bbox.left + bbox.width - 4 * ratio;
      ctx.fillText(words, right, y);
      right -= ctx.measureText(words).width + 12 * ratio; // another at its height stands left of it
      last = middle;
    }
    if (above.length > 0) {
      ctx.fillStyle = colour("element-neutral-color");
      ctx.textBaseline = "top";
      ctx.fillText(`\u2191 ${above[0]}`, bbox.left + bbox.width - 4 * ratio, bbox.top + ratio);
    }
    ctx.restore();
  }

  private drawFlags(plot: uPlot): void {
    const { ctx, bbox } = plot;
    const ratio = devicePixelRatio;
    const { min = 0, max = 0 } = plot.scales.x as { min?: number; max?: number };
    ctx.save();
    ctx.lineWidth = ratio;
    ctx.setLineDash([]);
    for (const { time, colour: name } of this.flags) {
      if (time < min || time > max) continue;
      const x = Math.round(plot.valToPos(time, "x", true));
      ctx.strokeStyle = ctx.fillStyle = colour(name);
      ctx.globalAlpha = 0.35;
      ctx.beginPath();
      ctx.moveTo(x, bbox.top);
      ctx.lineTo(x, bbox.top + bbox.height);
      ctx.stroke();
      ctx.globalAlpha = 1;
      ctx.beginPath(); // its flag
      ctx.moveTo(x, bbox.top);
      ctx.lineTo(x + 6 * ratio, bbox.top + 3 * ratio);
      ctx.lineTo(x, bbox.top + 6 * ratio);
      ctx.fill();
    }
    ctx.restore();
  }
}
