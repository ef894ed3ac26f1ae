// The engine telegraph: nine orders, and beside the order what the engine does.

import { h, setAttribute, setText, svg } from "../kit/dom";
import { figure } from "../kit/units";
import { type HelmHand, detentOf, kTelegraph, kTelegraphWords } from "./helm_hand";
import { t } from "../kit/language";

const kRow = 26; // units of the drawing, one order
const kRows = kTelegraph.length;
const kHeight = kRow * kRows;
const kWidth = 196;
const kTrack = 118; // left edge of the lever's slot
const kScale = 158; // left edge of the engine's scale

const short = [
  t("Full"),
  t("Half"),
  t("Slow"),
  t("Dead slow"),
  t("Stop"),
  t("Dead slow"),
  t("Slow"),
  t("Half"),
  t("Full"),
];

export class Telegraph {
  readonly element: HTMLElement;
  private readonly handle = svg("g", { class: "handle" });
  private readonly bar = svg("rect", { class: "answer", x: kScale, width: 18 });
  private readonly ghost = svg("path", { class: "ghost", d: "M 0 0 l 16 -8 v 16 z" });
  private readonly words: SVGTextElement[] = [];
  private readonly picture: SVGSVGElement;
  private readonly reads = h("strong", {});
  private readonly answer = h("span", { class: "quiet" });

  constructor(private readonly helm: HelmHand) {
    this.picture = svg("svg", {
      viewBox: `0 0 ${kWidth} ${kHeight}`,
      class: "telegraph",
      role: "slider",
      tabindex: 0,
      "aria-label": t("engine telegraph"),
      "aria-valuenow": 4, // until more is known
      "aria-orientation": "vertical",
      "aria-valuemin": 0,
      "aria-valuemax": kRows - 1,
      onpointerdown: (event: PointerEvent) => {
        this.picture.setPointerCapture(event.pointerId);
        this.point(event);
      },
      onpointermove: (event: PointerEvent) => event.buttons && this.point(event),
      onkeydown: (event: KeyboardEvent) => this.key(event),
    });
    this.picture.append(
      svg("rect", { class: "slot", x: kTrack, y: kRow / 2, width: 18, height: kHeight - kRow, rx: 9 }),
    );
    short.forEach((text, k) => {
      const y = this.row(k);
      const word = svg("text", { x: kTrack - 14, y: y + 5, "text-anchor": "end" }, text);
      this.words.push(word);
      this.picture.append(word, svg("line", { class: "tick", x1: kTrack - 9, x2: kTrack, y1: y, y2: y }));
    });
    for (const [text, k] of [
      [t("ahead"), 6.5],
      [t("astern"), 1.5],
    ] as const) {
      const y = this.row(k);
      this.picture.append(
        svg("text", { class: "way", x: 16, y, "text-anchor": "middle", transform: `rotate(-90 16 ${y})` }, text),
      );
    }
    this.handle.append(
      svg("rect", { x: kTrack - 7, y: -11, width: 32, height: 22, rx: 5 }),
      svg("line", { x1: kTrack - 1, x2: kTrack + 19, y1: 0, y2: 0 }),
    );
    this.picture.append(
      svg("rect", { class: "scale", x: kScale, y: kRow / 2, width: 18, height: kHeight - kRow }),
      this.bar,
      ...[-1, 0, 1].map((share) =>
        svg("line", { class: "tick", x1: kScale, x2: kScale + 24, y1: this.place(share), y2: this.place(share) }),
      ),
      this.handle,
      this.ghost,
    );
    this.showGhost(undefined);
    this.element = h(
      "section",
      { class: "panel telegraph-panel", "aria-label": t("engine") },
      h("div", { class: "row" }, h("h2", {}, t("Engine"))),
      this.picture,
      h("div", { class: "reads", "aria-hidden": "true" }, this.reads, this.answer),
    );
  }

  /** engine: -1..1, what it does. */
  update(engine: number | undefined): void {
    const order = this.helm.levers()?.engine;
    const movable = this.helm.movable();
    setAttribute(this.picture, "aria-disabled", movable ? undefined : "true");
    if (order === undefined) return;
    const detent = detentOf(order);
    const exact = Math.abs(order - kTelegraph[detent]!) < 0.005;
    const said = exact ? kTelegraphWords[detent]! : `${figure(100 * order)} %`;
    const does = engine === undefined ? "" : t("engine {percent} %", { percent: figure(100 * engine) });
    setAttribute(this.handle, "transform", `translate(0 ${exact ? this.row(detent) : this.place(order)})`);
    setAttribute(this.picture, "aria-valuenow", `${detent}`);
    setAttribute(this.picture, "aria-valuetext", `${t("ordered {order}", { order: said })}, ${does}`);
    this.words.forEach((word, k) => setAttribute(word, "class", exact && k === detent ? "ordered" : undefined));
    setText(this.reads, said);
    setText(this.answer, does);
    if (engine === undefined) return;
    const zero = this.place(0);
    const now = this.place(engine);
    setAttribute(this.bar, "y", Math.min(zero, now).toFixed(1));
    setAttribute(this.bar, "height", Math.max(1, Math.abs(zero - now)).toFixed(1));
  }

  /** What the model's engine does, -1..1; undefined: they are not shown. */
  showGhost(engine: number | undefined): void {
    setAttribute(this.ghost, "display", engine === undefined ? "none" : undefined);
    setAttribute(this.ghost, "transform", `translate(${kScale + 20} ${this.place(engine ?? 0).toFixed(1)})`);
  }

  /** Where a detent lies; ahead is up. */
  private row(detent: number): number {
    return kHeight - (detent + 0.5) * kRow;
  }

  /** Where a share of thrust lies among the detents, straight between them. */
  private place(share: number): number {
    const above = Math.max(
      1,
      kTelegraph.findIndex((order) => order >= Math.min(1, share)),
    );
    const low = kTelegraph[above - 1]!;
    const high = kTelegraph[above]!;
    return this.row(above - 1 + (Math.max(-1, share) - low) / (high - low));
  }

  private point(event: PointerEvent): void {
    const box = this.picture.getBoundingClientRect();
    const detent = Math.floor(((box.bottom - event.clientY) / box.height) * kRows);
    this.helm.put({ engine: kTelegraph[Math.min(kRows - 1, Math.max(0, detent))]! });
  }

  private key(event: KeyboardEvent): void {
    const steps: Record<string, number> = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1 };
    const step = steps[event.key];
    if (step === undefined) return;
    event.preventDefault();
    this.helm.stepTelegraph(step);
  }
}
