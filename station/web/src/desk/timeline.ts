// The whole exercise on one line: faults, talk, alerts, events, bookmarks; in a replay the scrubber under it.

import { alertTopics } from "../kit/alert_panels";
import { h, setAttribute, setText, setVariable } from "../kit/dom";
import { everySecond } from "../kit/page";
import { colour, onPalette } from "../kit/palette";
import { clock, measures } from "../kit/units";
import { AlertPriority, type Event, EventSeverity } from "../wire/generated";
import type { Desk } from "./desk";
import { eventWords, isMark } from "./events";
import { t, translated } from "../kit/language";
import { alertWords } from "../kit/words";

interface Mark {
  time: number; // s of exercise time
  position?: number; // s from a recording's beginning, where it is known
  lane: number;
  colour: string;
  text: string;
  /** Whether plots flag it, too. */
  flag: boolean;
}

interface AlertMark extends Mark {
  written: number; // ms since 1970, by the server's clock
}

const lanes = [t("faults"), t("talk"), t("alerts"), t("events"), t("bookmarks")] as const;
const kLane = 13; // px, as the others at the usual size
const kAxis = 16;
const kFont = 11;
const kRoom = 40; // px between two marks, from which on words have room
const kLabels = 76;
const kRight = 16;
const kNear = 7; // px, of the pointer from a mark
const kAlert = t("alert:");
const kGiven = translated("order {0} given: {order}").replace("{0}", "\\d+").replace(" {order}", "");
const kWhich = new RegExp(`^(?:${kGiven}|${kAlert}) `); // its lane and its place say that
const kLead = 0.5; // s before an event, so that it is seen to happen

const severityColour = (severity: EventSeverity): string =>
  severity >= EventSeverity.EVENT_ALARM
    ? "alert-alarm-color"
    : severity === EventSeverity.EVENT_WARNING
      ? "alert-warning-color"
      : severity === EventSeverity.EVENT_CAUTION
        ? "alert-caution-color"
        : "element-neutral-color";
const priorityColour = (priority: AlertPriority): string =>
  priority >= AlertPriority.ALERT_ALARM
    ? "alert-alarm-color"
    : priority === AlertPriority.ALERT_WARNING
      ? "alert-warning-color"
      : "alert-caution-color";

/** The lane of an event by its code. */
function laneOf(code: string): number {
  if (code.startsWith("fault.")) return 0;
  if (code.startsWith("order.") || code.startsWith("report.")) return 1;
  if (code === "exercise.bookmark") return 4;
  return 3;
}

/** As much of a text as has room, px, with three dots where some is left out; empty: none has. */
function fitted(ctx: CanvasRenderingContext2D, text: string, room: number): string {
  if (ctx.measureText(text).width <= room) return text;
  let [fits, most] = [0, text.length]; // characters
  while (fits < most) {
    const tried = Math.ceil((fits + most) / 2);
    if (ctx.measureText(`${text.slice(0, tried)}\u2026`).width <= room) fits = tried;
    else most = tried - 1;
  }
  return fits > 2 ? `${text.slice(0, fits).trimEnd()}\u2026` : "";
}

export interface TimelineWishes {
  /** A moment was picked, s of exercise time. */
  pick: (time: number) => void;
  /** In a replay: to a position, s from the recording's beginning. */
  seek: (position: number) => void;
  /** In a replay: where an exercise time lies in the recording. */
  positionOf: (time: number) => number;
}

export class Timeline {
  readonly element: HTMLElement;
  private readonly canvas = h("canvas", { role: "img" });
  private readonly tip = h("div", { class: "tip", hidden: true });
  private readonly scrubber = h("input", {
    type: "range",
    min: "0",
    max: "1",
    step: "0.1",
    class: "scrubber",
    "data-gives": "ReplayCommand",
    "aria-label": t("position in the recording, s"),
  });
  private readonly alerts = new Map<string, AlertMark>();
  private marks: Mark[] = [];
  private run: number | undefined;
  private cursor: number | null = null;
  private scrubbing = false;
  private stale = true;
  private large = 1;

  constructor(
    private readonly desk: Desk,
    private readonly wishes: TimelineWishes,
  ) {
    this.element = h(
      "section",
      { class: "timeline", "aria-label": t("timeline") },
      this.canvas,
      this.scrubber,
      this.tip,
    );
    desk.events.onChange(() => (this.stale = true));
    for (const topic of alertTopics)
      desk.link.on(topic, (alert, _, written) => {
        if (alert.raised_time > alert.time) return; // raised in an attempt that a reset has undone, rectified since
        const mark = {
          written,
          time: alert.raised_time,
          lane: 2,
          colour: priorityColour(alert.priority),
          text: `${kAlert} ${alertWords(alert).text}`,
          flag: true,
        };
        this.alerts.set(`${alert.code}/${alert.side}/${alert.raised_time}`, mark);
        this.stale = true;
      });
    desk.link.onAnotherServer((until) => this.forgetAlerts((mark) => mark.written < until));
    desk.link.on("ExerciseStatus", ({ run, time }) => {
      // A reset or restore: what was raised after the moment to which it goes has not happened.
      if (this.run !== undefined && run !== this.run && !this.replay) this.forgetAlerts((mark) => mark.time > time);
      this.run = run;
    });
    this.canvas.addEventListener("pointermove", (event) => this.point(event));
    this.canvas.addEventListener("pointerleave", () => (this.tip.hidden = true));
    this.canvas.addEventListener("click", (event) => this.click(event));
    this.scrubber.addEventListener("input", () => {
      this.scrubbing = true;
      this.wishes.seek(Number(this.scrubber.value));
    });
    this.scrubber.addEventListener("change", () => (this.scrubbing = false));
    onPalette(() => this.draw());
    for (const measure of measures) measure.onChoice(() => (this.stale = true));
    new ResizeObserver(() => this.draw()).observe(this.element);
    everySecond(4, () => this.draw());
  }

  /** The exercise time (s) that the plots' cursor is at. */
  showCursor(time: number | null): void {
    this.cursor = time;
    this.draw();
  }

  /** Moments that the plots flag. */
  flags(): { time: number; colour: string }[] {
    this.gather();
    return this.marks.filter((mark) => mark.flag);
  }

  /** Draws and writes so many times as large as usual. */
  enlarge(times: number): void {
    this.large = times;
    this.draw();
  }

  private get lane(): number {
    return kLane * this.large;
  }
  private get labels(): number {
    return kLabels * this.large;
  }

  private get right(): number {
    return kRight * this.large;
  }

  private forgetAlerts(which: (mark: AlertMark) => boolean): void {
    for (const [name, mark] of this.alerts) if (which(mark)) this.alerts.delete(name);
    this.stale = true;
  }

  private gather(): void {
    if (!this.stale) return;
    this.stale = false;
    const { recorded } = this.desk.events;
    const events: (Event & { position?: number })[] = recorded.length > 0 ? [...recorded] : this.desk.events.current();
    this.marks = events.filter(isMark).map((event) => {
      const lane = laneOf(event.code);
      const name =
        lane === 4 ? "element-active-color" : lane === 0 ? "alert-warning-color" : severityColour(event.severity);
      const flag =
        lane === 0 || lane === 4 || (lane === 3 && /^(anchor|exercise\.(restored|taken_up))/.test(event.code));
      return { time: event.time, position: event.position, lane, colour: name, text: eventWords(event), flag };
    });
    this.marks.push(...this.alerts.values());
    // Where two stand at one place, the one that plots flag is over the other and has the words.
    const place = ({ position, time }: Mark): number => position ?? time;
    this.marks.sort((a, b) => place(a) - place(b) || Number(a.flag) - Number(b.flag));
  }

  private get now(): number {
    return this.desk.link.latest("ExerciseStatus")?.time ?? 0;
  }
  private get replay(): boolean {
    return this.desk.replay && this.desk.link.latest("ReplayStatus") !== undefined;
  }
  /** What the line's end stands for: s of exercise time, of the recording in a replay. */
  private get span(): number {
    const longest = this.desk.events.current().at(-1)?.time ?? 0;
    return this.replay ? Math.max(1, this.desk.link.latest("ReplayStatus")!.duration) : Math.max(60, this.now, longest);
  }
  private get width(): number {
    return this.canvas.clientWidth - this.labels - this.right;
  }
  private x(time: number, position = this.replay ? this.wishes.positionOf(time) : time): number {
    return this.labels + (this.width * position) / this.span;
  }
  private xOf(mark: Mark): number {
    return this.x(mark.time, mark.position);
  }

  private near(event: PointerEvent | MouseEvent): Mark | undefined {
    const lane = Math.floor(event.offsetY / this.lane);
    let best: Mark | undefined;
    for (const mark of this.marks)
      if (mark.lane === lane && Math.abs(this.xOf(mark) - event.offsetX) < kNear)
        if (!best || Math.abs(this.xOf(mark) - event.offsetX) <= Math.abs(this.xOf(best) - event.offsetX)) best = mark;
    return best;
  }
  private point(event: PointerEvent): void {
    const mark = this.near(event);
    this.tip.hidden = !mark;
    this.canvas.style.cursor = mark ? "pointer" : "crosshair";
    if (!mark) return;
    const when = this.replay ? `${t("exercise time")} ${clock(mark.time)}` : clock(mark.time);
    setText(this.tip, `${when}  ${mark.text}`);
    this.tip.style.left = `${Math.min(event.offsetX + 10, this.canvas.clientWidth - 320)}px`;
  }
  private click(event: MouseEvent): void {
    const mark = this.near(event);
    if (mark?.position !== undefined) return this.wishes.seek(mark.position - kLead);
    if (mark) return this.wishes.pick(mark.time);
    const place = (Math.max(0, event.offsetX - this.labels) / this.width) * this.span;
    if (this.replay) this.wishes.seek(place);
    else this.wishes.pick(Math.min(place, this.now));
  }

  private draw(): void {
    this.gather();
    const status = this.desk.link.latest("ReplayStatus");
    this.scrubber.hidden = !this.replay;
    if (this.replay && status && !this.scrubbing) {
      this.scrubber.max = `${status.duration}`;
      this.scrubber.value = `${status.position}`;
      setAttribute(
        this.scrubber,
        "aria-valuetext",
        t("{position} of {duration}", { position: clock(status.position), duration: clock(status.duration) }),
      );
    }
    const ratio = devicePixelRatio;
    const width = this.canvas.clientWidth;
    const height = Math.round(lanes.length * this.lane + kAxis * this.large);
    setVariable(this.element, "--labels", `${this.labels}px`);
    setVariable(this.element, "--right", `${this.right}px`);
    setVariable(this.element, "--height", `${height}px`);
    if (width === 0) return;
    if (this.canvas.width !== Math.round(width * ratio) || this.canvas.height !== Math.round(height * ratio)) {
      this.canvas.width = Math.round(width * ratio);
      this.canvas.height = Math.round(height * ratio);
    }
    const marks = t("timeline with {count} marks; the log lists them", { count: this.marks.length });
    const whose = this.replay ? `, ${t("in the time of the recording")}` : "";
    setAttribute(this.canvas, "aria-label", `${marks}${whose}`);
    const ctx = this.canvas.getContext("2d")!;
    ctx.setTransform(ratio, 0, 0, ratio, 0, 0);
    ctx.clearRect(0, 0, width, height);
    ctx.font = `${kFont * this.large}px "Noto Sans", sans-serif`;
    ctx.textBaseline = "middle";
    this.drawLanes(ctx);
    this.drawTimes(ctx, lanes.length * this.lane);
    for (const mark of this.marks) this.drawMark(ctx, mark);
    this.drawWords(ctx);
    this.drawLine(ctx, this.x(this.now), colour("element-active-color"), 2);
    if (this.cursor !== null) this.drawLine(ctx, this.x(this.cursor), colour("element-neutral-color"), 1);
  }

  private drawLanes(ctx: CanvasRenderingContext2D): void {
    lanes.forEach((lane, i) => {
      ctx.fillStyle = colour("container-background-color");
      ctx.fillRect(this.labels, i * this.lane + 1, this.width, this.lane - 2);
      ctx.fillStyle = colour("element-neutral-color");
      ctx.textAlign = "right";
      ctx.fillText(lane, this.labels - 8, i * this.lane + this.lane / 2);
    });
  }

  private drawTimes(ctx: CanvasRenderingContext2D, y: number): void {
    const steps = [1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200];
    const step = steps.find((s) => (s / this.span) * this.width > 70) ?? 14400;
    ctx.fillStyle = colour("element-neutral-color");
    ctx.textAlign = "right";
    // Its figures are not those of the clock on top, which is the exercise's.
    if (this.replay) ctx.fillText(t("recording"), this.labels - 8, y + (kAxis * this.large) / 2);
    for (let time = 0; time <= this.span; time += step) {
      ctx.textAlign = time === 0 ? "left" : "center"; // the first is clear of the words before it
      ctx.fillText(clock(time), this.labels + (this.width * time) / this.span, y + (kAxis * this.large) / 2);
    }
  }

  private drawMark(ctx: CanvasRenderingContext2D, mark: Mark): void {
    const x = this.xOf(mark);
    if (x < this.labels - 1 || x > this.labels + this.width + 1) return;
    const top = mark.lane * this.lane;
    const middle = top + this.lane / 2;
    ctx.fillStyle = colour(mark.colour);
    ctx.beginPath();
    if (mark.lane === 0) ctx.rect(x - 2, top + 2, 4, this.lane - 4);
    else if (mark.lane === 2) {
      ctx.moveTo(x, top + 2);
      ctx.lineTo(x + 5, top + this.lane - 2);
      ctx.lineTo(x - 5, top + this.lane - 2);
    } else if (mark.lane === 4) {
      ctx.moveTo(x, top + 1);
      ctx.lineTo(x + 5, middle);
      ctx.lineTo(x, top + this.lane - 1);
      ctx.lineTo(x - 5, middle);
    } else ctx.arc(x, middle, 3, 0, 2 * Math.PI);
    ctx.fill();
  }

  /** What a mark is of, beside it as far as there is room before the next one. */
  private drawWords(ctx: CanvasRenderingContext2D): void {
    ctx.textAlign = "left";
    ctx.fillStyle = colour("element-active-color");
    const beside = 8 * this.large;
    lanes.forEach((_, lane) => {
      const marks = this.marks.filter((mark) => mark.lane === lane).map((mark) => ({ mark, x: this.xOf(mark) }));
      marks.sort((a, b) => a.x - b.x);
      marks.forEach(({ mark, x }, i) => {
        const room = (marks[i + 1]?.x ?? this.labels + this.width) - x - 2 * beside;
        if (x < this.labels || room < kRoom * this.large) return;
        const words = fitted(ctx, mark.text.replace(kWhich, ""), room);
        if (words) ctx.fillText(words, x + beside, (lane + 0.5) * this.lane);
      });
    });
  }

  private drawLine(ctx: CanvasRenderingContext2D, x: number, stroke: string, width: number): void {
    ctx.strokeStyle = stroke;
    ctx.lineWidth = width;
    ctx.beginPath();
    ctx.moveTo(x, 0);
    ctx.lineTo(x, lanes.length * this.lane);
    ctx.stroke();
  }
}
