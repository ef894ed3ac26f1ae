// The dog clutch: a lever that must be held, and the window in which its teeth are seen to pass each other.

import type { WindlassLevers } from "../wire/connection";
import { ClutchState, type ForecastleView } from "../wire/generated";
import { h, setAttribute, setText, svg } from "../kit/dom";
import { HoldGuard } from "../kit/hold_button";
import { t } from "../kit/language";

/** ms that clutch and stopper are held before they act. */
export const kHoldTime = 600;

const kTeeth = 4; // seen in the window
const kPitch = 26; // of the window's 104 units
const kTurning = 0.02; // of full speed, below which a motor is heard to stand

/** A row of teeth of which the gaps are as wide as the teeth; they point up (-1) or down (1). */
function teeth(way: number): string {
  let path = `M ${-kPitch} ${-60 * way}`;
  for (let i = -1; i <= kTeeth; ++i) {
    const x = i * kPitch;
    path += ` L ${x} 0 L ${x + 2} ${14 * way} L ${x + 11} ${14 * way} L ${x + 13} 0`;
  }
  return `${path} L ${(kTeeth + 1) * kPitch} ${-60 * way} Z`;
}

/** Why the clutch is not where its lever is; empty: it is. */
export function clutchReason(levers: WindlassLevers, view: ForecastleView, gypsyTurns: boolean): string {
  if (levers.clutch_in && view.clutch !== ClutchState.CLUTCH_IN) {
    if (gypsyTurns) return t("does not go in: the gypsy turns");
    if (Math.abs(view.motor_speed_heard) > 5 * kTurning) return t("does not go in: the motor turns too fast");
    return t("teeth not in line: turn the motor dead slow");
  }
  if (!levers.clutch_in && view.clutch === ClutchState.CLUTCH_IN) return t("under load: take the load with the brake");
  return "";
}

export class Clutch {
  readonly element: HTMLElement;
  readonly guard: HoldGuard;
  private readonly button: HTMLButtonElement;
  private readonly state = h("strong", {});
  private readonly reason = h("p", { class: "reason", role: "status" });
  private readonly gypsySide: SVGGElement;
  private readonly shaftSide: SVGGElement;

  /** toggle: moves the lever to its other place. */
  constructor(toggle: () => void) {
    this.gypsySide = svg("g", {}, svg("path", { d: teeth(1), class: "gypsy-teeth" }));
    this.shaftSide = svg("g", {}, svg("path", { d: teeth(-1), class: "shaft-teeth" }));
    this.button = h("button", { class: "guarded", role: "switch", "aria-label": t("clutch"), title: t("key c, held") });
    this.guard = new HoldGuard(this.button, () => kHoldTime, toggle);
    this.element = h(
      "section",
      { class: "control clutch", "aria-label": t("clutch") },
      h("div", { class: "row" }, h("h2", {}, t("Clutch")), this.state),
      svg("svg", { viewBox: "0 -36 104 72", class: "window", "aria-hidden": "true" }, this.gypsySide, this.shaftSide),
      this.button,
      this.reason,
    );
  }

  show(levers: WindlassLevers, view: ForecastleView, gypsyTurns: boolean, movable: boolean): void {
    const engaged = view.clutch === ClutchState.CLUTCH_IN;
    const seeking = levers.clutch_in && !engaged;
    // In line (offset 0) a tooth stands before a gap: half a pitch from tooth on tooth.
    const offset = engaged ? 0.5 : (view.clutch_offset + 0.5) % 1;
    const gap = engaged ? 0 : seeking ? 8 : 16;
    setAttribute(this.gypsySide, "transform", `translate(0 ${-7 - gap / 2})`);
    setAttribute(this.shaftSide, "transform", `translate(${(offset * kPitch).toFixed(1)} ${7 + gap / 2})`);
    setText(this.state, engaged ? t("IN") : seeking ? t("SEEKING") : t("OUT"));
    setText(this.button, levers.clutch_in ? t("Hold: take out") : t("Hold: put in"));
    setAttribute(this.button, "aria-checked", `${levers.clutch_in}`);
    setText(this.reason, clutchReason(levers, view, gypsyTurns));
    this.button.disabled = !movable;
  }
}
