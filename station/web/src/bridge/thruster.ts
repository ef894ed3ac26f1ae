// A thruster's lever: across the ship, as she goes. Set point beside what the thruster does.

import { h, setAttribute, setText, svg } from "../kit/dom";
import { figure, sideWord } from "../kit/units";
import type { HelmHand } from "./helm_hand";
import { t } from "../kit/language";

const kHalf = 100; // units of the drawing from the middle to full
const kStep = 0.1; // by key
const kDetent = 0.05; // round zero, in which a hand finds it

/** "starboard 40 %", "port 100 %", "stop". */
export function thrustWords(share: number): string {
  const percent = Math.round(100 * share);
  return percent === 0 ? t("stop") : `${sideWord(percent > 0 ? 1 : 0)} ${figure(Math.abs(percent))} %`;
}

/** What it does: "does port 40 %", "at rest". */
export const doesWords = (share: number): string =>
  Math.round(100 * share) === 0 ? t("at rest") : t("does {thrust}", { thrust: thrustWords(share) });

export class Thruster {
  readonly element: HTMLElement;
  private readonly picture: SVGSVGElement;
  private readonly handle: SVGGElement;
  private readonly bar = svg("rect", { class: "answer", y: 32, height: 10 });
  private readonly reads = h("strong", {});
  private readonly answer = h("span", { class: "quiet" });
  private by: number | "key" | undefined; // the finger or mouse that has it, or a key

  constructor(
    private readonly helm: HelmHand,
    private readonly lever: "bow_thruster" | "stern_thruster",
    name: string,
  ) {
    this.handle = svg(
      "g",
      { class: "handle" },
      svg("rect", { x: -11, y: 0, width: 22, height: 26, rx: 5 }),
      svg("line", { x1: 0, x2: 0, y1: 5, y2: 21 }),
    );
    this.picture = svg(
      "svg",
      {
        viewBox: "-116 -2 232 48",
        class: "thruster",
        role: "slider",
        tabindex: 0,
        "aria-label": t("{name} thruster", { name }),
        "aria-valuenow": 0, // until more is known
        "aria-valuemin": -100,
        "aria-valuemax": 100,
        onpointerdown: (event: PointerEvent) => {
          if (!this.helm.movable() || typeof this.by === "number") return;
          this.picture.setPointerCapture(event.pointerId);
          this.by = event.pointerId;
          this.pull(event);
        },
        onpointermove: (event: PointerEvent) => this.by === event.pointerId && this.pull(event),
        onpointerup: (event: PointerEvent) => this.releaseBy(event.pointerId),
        onlostpointercapture: (event: PointerEvent) => this.releaseBy(event.pointerId),
        onblur: () => this.releaseBy("key"), // another finger may be on another control
        onkeydown: (event: KeyboardEvent) => this.key(event),
        onkeyup: (event: KeyboardEvent) => event.key.startsWith("Arrow") && this.releaseBy("key"),
      },
      svg("rect", { class: "slot", x: -kHalf - 10, y: 5, width: 2 * kHalf + 20, height: 16, rx: 8 }),
      svg("rect", { class: "scale", x: -kHalf, y: 32, width: 2 * kHalf, height: 10 }),
      this.bar,
      ...[-1, -0.5, 0, 0.5, 1].map((share) =>
        svg("line", { class: "tick", x1: share * kHalf, x2: share * kHalf, y1: 29, y2: 43 }),
      ),
      this.handle,
    );
    this.element = h(
      "div",
      { class: "thruster-row" },
      h(
        "div",
        { class: "row" },
        h("h3", {}, name),
        h("span", { class: "reads", "aria-hidden": "true" }, this.reads, this.answer),
      ),
      this.picture,
    );
    addEventListener("blur", () => this.release());
    document.addEventListener("visibilitychange", () => this.release());
  }

  /** thrust: -1..1, what it does, to starboard positive. */
  update(thrust: number | undefined): void {
    setAttribute(this.picture, "aria-disabled", this.helm.movable() ? undefined : "true");
    const order = this.helm.levers()?.[this.lever];
    if (order === undefined) return;
    const does = thrust === undefined ? "" : doesWords(thrust);
    setAttribute(this.handle, "transform", `translate(${(order * kHalf).toFixed(1)} 0)`);
    setAttribute(this.picture, "aria-valuenow", (100 * order).toFixed(0));
    setAttribute(this.picture, "aria-valuetext", `${t("ordered {order}", { order: thrustWords(order) })}, ${does}`);
    setText(this.reads, thrustWords(order));
    setText(this.answer, does);
    if (thrust === undefined) return;
    setAttribute(this.bar, "x", (Math.min(0, thrust) * kHalf).toFixed(1));
    setAttribute(this.bar, "width", Math.max(1, Math.abs(thrust) * kHalf).toFixed(1));
  }

  private pull(event: PointerEvent): void {
    const box = this.picture.getBoundingClientRect();
    const unit = Math.min(box.width / 232, box.height / 48);
    const share = (event.clientX - (box.left + box.width / 2)) / unit / kHalf;
    this.helm.put({ [this.lever]: Math.abs(share) < kDetent ? 0 : Math.round(share * 20) / 20 });
  }

  private releaseBy(whom: number | "key"): void {
    if (this.by === whom) this.release();
  }

  /** The hand leaves it. */
  private release(): void {
    if (this.by === undefined) return;
    this.by = undefined;
    if (this.helm.thrustersSpring) this.helm.put({ [this.lever]: 0 });
  }

  private key(event: KeyboardEvent): void {
    const steps: Record<string, number> = { ArrowLeft: -1, ArrowRight: 1, ArrowDown: -1, ArrowUp: 1 };
    const step = steps[event.key];
    if (step === undefined && event.key !== "Home") return;
    event.preventDefault();
    if (step !== undefined) this.by ??= "key";
    const now = this.helm.levers()?.[this.lever] ?? 0;
    this.helm.put({ [this.lever]: step === undefined ? 0 : Math.round((now + step * kStep) * 10) / 10 });
  }
}
