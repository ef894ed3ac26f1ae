// The windlass's speed lever: follows the finger, springs back to zero. Up heaves, down lowers. Let go with Shift held
// it is latched, for who has one mouse and two levers: the next touch, x, and whatever takes the hand off releases it.

import { h, setAttribute, setText, setVariable } from "../kit/dom";
import { figure } from "../kit/units";
import { t } from "../kit/language";

const kSnap = 0.035; // of the way to full, within which a detent catches
/** Where a stepless drive's lever catches. */
export const kSteplessDetents = [0.1, 0.5, 1];
/** The three windings of a pole-changing motor. */
export const kPoleDetents = [1 / 3, 2 / 3, 1];

export interface SpeedHand {
  move(to: number): void;
  latch(): void;
  push(to: number): void;
  release(): void;
}

export class SpeedLever {
  readonly element: HTMLElement;
  private readonly slot: HTMLElement;
  private readonly knob = h("div", { class: "knob" });
  private readonly real = h("div", { class: "real", "aria-hidden": "true" });
  private readonly ghost = h("div", { class: "ghost", "aria-hidden": "true", hidden: true });
  private readonly ticks = h("div", { class: "ticks", "aria-hidden": "true" });
  private readonly words = h("output", { class: "figures" });
  private detents: readonly number[] = [];
  private pointer: number | undefined;
  private latched = false;

  constructor(private readonly hand: SpeedHand) {
    this.slot = h("div", { class: "slot", role: "slider", tabindex: 0, "aria-label": t("speed lever") });
    setAttribute(this.slot, "aria-orientation", "vertical");
    setAttribute(this.slot, "aria-valuemin", "-100");
    setAttribute(this.slot, "aria-valuemax", "100");
    this.slot.append(this.ticks, this.real, this.ghost, this.knob);
    this.element = h(
      "section",
      { class: "control speed", "aria-label": t("speed lever") },
      h("h2", {}, t("Speed|lever")),
      h("span", { class: "end", "aria-hidden": "true" }, `\u25b2 ${t("heave")}`),
      this.slot,
      h("span", { class: "end", "aria-hidden": "true" }, `\u25bc ${t("lower")}`),
      this.words,
    );
    this.setDetents(kSteplessDetents);
    this.listen();
  }

  /** Where it catches, shares of full, the same both ways. */
  setDetents(detents: readonly number[]): void {
    if (detents === this.detents) return;
    this.detents = detents;
    const all = [0, ...detents, ...detents.map((d) => -d)];
    this.ticks.replaceChildren(
      ...all.map((d) =>
        h(
          "span",
          { class: d === 0 ? "tick zero" : "tick", style: `--at: ${d}` },
          d === 0 ? "" : figure(100 * Math.abs(d)),
        ),
      ),
    );
  }

  /** set: where the hand has it, -1..1; real: what the windlass has taken; latched: no hand is on it, and it stays. */
  show(set: number, real: number, movable: boolean, latched = false): void {
    this.latched = latched;
    setAttribute(this.element, "data-latched", latched ? "" : undefined);
    setAttribute(this.slot, "style", `--set: ${set.toFixed(3)}; --real: ${real.toFixed(3)}`);
    const percent = figure(Math.abs(100 * set));
    const way = set > 0 ? t("heave {percent} %", { percent }) : t("lower {percent} %", { percent });
    const words = Math.abs(set) < 0.005 ? "0 %" : latched ? t("{way}, latched", { way }) : way;
    setText(this.words, words);
    setAttribute(this.slot, "aria-valuenow", String(Math.round(100 * set)));
    setAttribute(this.slot, "aria-valuetext", words);
    setAttribute(this.slot, "aria-disabled", movable ? undefined : "true");
  }

  /** Where the model's hands have it, -1..1; undefined: they are not shown. */
  showGhost(at: number | undefined): void {
    this.ghost.hidden = at === undefined;
    setVariable(this.ghost, "--ghost", (at ?? 0).toFixed(3));
  }

  private listen(): void {
    const slot = this.slot;
    slot.addEventListener("pointerdown", (event) => {
      if (event.button !== 0 || this.pointer !== undefined) return;
      slot.setPointerCapture(event.pointerId);
      slot.focus({ preventScroll: true });
      this.pointer = event.pointerId;
      setAttribute(slot, "data-held", "");
      this.hand.move(this.valueAt(event));
    });
    slot.addEventListener("pointermove", (event) => {
      if (event.pointerId === this.pointer) this.hand.move(this.valueAt(event));
    });
    const leave = (event: PointerEvent): void => {
      if (event.pointerId !== this.pointer) return;
      this.pointer = undefined;
      setAttribute(slot, "data-held", undefined);
      this.latched = event.type === "pointerup" && event.shiftKey;
      if (this.latched) this.hand.latch();
      else this.hand.release();
      slot.blur(); // else Up and Down, which are the brake's, would go on moving it
    };
    slot.addEventListener("pointerup", leave);
    slot.addEventListener("pointercancel", leave);
    slot.addEventListener("lostpointercapture", leave);
    // A slider that has the focus moves by the upright arrows, as everywhere; elsewhere those turn the brake.
    slot.addEventListener("keydown", (event) => {
      if (event.key !== "ArrowUp" && event.key !== "ArrowDown") return;
      event.preventDefault();
      event.stopPropagation();
      if (!event.repeat) this.hand.push((event.key === "ArrowUp" ? 1 : -1) * (event.shiftKey ? 0.1 : 1));
    });
    slot.addEventListener("keyup", (event) => {
      if (event.key === "ArrowUp" || event.key === "ArrowDown") this.hand.release();
    });
    slot.addEventListener("blur", () => this.pointer === undefined && !this.latched && this.hand.release());
  }

  private valueAt(event: PointerEvent): number {
    const box = this.slot.getBoundingClientRect();
    const half = box.height / 2 - this.knob.offsetHeight / 2;
    const value = Math.min(1, Math.max(-1, (box.top + box.height / 2 - event.clientY) / half));
    for (const detent of [0, ...this.detents])
      if (Math.abs(Math.abs(value) - detent) < kSnap) return Math.sign(value) * detent;
    return value;
  }
}
