// The dog clutch: a lever that must be held, and the window in which its teeth are seen to pass each other. Its button
// offers what can be done with the clutch as it stands: one that seeks can be taken out again.

import type { WindlassLevers } from "../wire/connection";
import { ClutchState, type ForecastleView } from "../wire/generated";
import { h, setAttribute, setText, svg } from "../kit/dom";
import { HoldGuard } from "../kit/hold_button";
import { t } from "../kit/language";
import { Refusals } from "./refusals";

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

/** Why the clutch is not where it was wanted; empty: it is. refused: it was tried, and has not moved since. */
export function clutchReason(
  levers: WindlassLevers,
  view: ForecastleView,
  gypsyTurns: boolean,
  refused: boolean,
): string {
  if (view.clutch === ClutchState.CLUTCH_IN)
    return refused || !levers.clutch_in ? t("under load: take the load with the brake") : "";
  if (!refused && !levers.clutch_in) return "";
  if (gypsyTurns) return t("does not go in: the gypsy turns");
  if (Math.abs(view.motor_speed_heard) > 5 * kTurning) return t("does not go in: the motor turns too fast");
  return view.clutch === ClutchState.CLUTCH_ENGAGING
    ? t("teeth not in line: turn the motor dead slow")
    : t("does not go in");
}

export class Clutch {
  readonly element: HTMLElement;
  readonly guard: HoldGuard;
  private readonly button: HTMLButtonElement;
  private readonly state = h("strong", {});
  private readonly reason = h("p", { class: "reason", role: "status" });
  private readonly gypsySide: SVGGElement;
  private readonly shaftSide: SVGGElement;
  private readonly refusals = new Refusals();
  private in = false; // what the button offers to change

  /** put: in or out. */
  constructor(put: (in_: boolean) => void) {
    this.gypsySide = svg("g", {}, svg("path", { d: teeth(1), class: "gypsy-teeth" }));
    this.shaftSide = svg("g", {}, svg("path", { d: teeth(-1), class: "shaft-teeth" }));
    this.button = h("button", { class: "guarded", role: "switch", "aria-label": t("clutch"), title: t("key c, held") });
    this.guard = new HoldGuard(
      this.button,
      () => kHoldTime,
      () => put(!this.in),
    );
    this.element = h(
      "section",
      { class: "control clutch", "aria-label": t("clutch") },
      h("div", { class: "row" }, h("h2", {}, t("Clutch")), this.state),
      svg("svg", { viewBox: "0 -36 104 72", class: "window", "aria-hidden": "true" }, this.gypsySide, this.shaftSide),
      this.button,
      this.reason,
    );
  }

  /** That of this side did not move when it was tried, and stands so. */
  refuse(side: number, stands: boolean): void {
    this.refusals.add(side, stands);
  }

  /** runs: the exercise; else the clutch goes where it is wanted as soon as it does, as the stopper's bar. */
  show(levers: WindlassLevers, view: ForecastleView, gypsyTurns: boolean, movable: boolean, runs: boolean): void {
    const engaged = view.clutch === ClutchState.CLUTCH_IN;
    const seeking = view.clutch === ClutchState.CLUTCH_ENGAGING;
    this.in = runs ? engaged || seeking : levers.clutch_in;
    // In line (offset 0) a tooth stands before a gap: half a pitch from tooth on tooth.
    const offset = engaged ? 0.5 : (view.clutch_offset + 0.5) % 1;
    const gap = engaged ? 0 : seeking ? 8 : 16;
    setAttribute(this.gypsySide, "transform", `translate(0 ${-7 - gap / 2})`);
    setAttribute(this.shaftSide, "transform", `translate(${(offset * kPitch).toFixed(1)} ${7 + gap / 2})`);
    setText(this.state, engaged ? t("IN") : seeking ? t("SEEKING") : t("OUT"));
    setText(this.button, this.in ? t("Hold: take out") : t("Hold: put in"));
    setAttribute(this.button, "aria-checked", `${this.in}`);
    const refused = this.refusals.lately(view.side, engaged);
    setText(this.reason, runs ? clutchReason(levers, view, gypsyTurns, refused) : "");
    this.button.disabled = !movable;
  }
}
