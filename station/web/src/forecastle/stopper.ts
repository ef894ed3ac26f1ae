// The chain stopper: a bar across the cable, seen to bear, to hang, or to be sprung. Its button offers what can be done
// with the bar as it stands.

import type { WindlassLevers } from "../wire/connection";
import type { ForecastleView } from "../wire/generated";
import { h, setAttribute, setText, svg } from "../kit/dom";
import { kHoldTime } from "./clutch";
import { HoldGuard } from "../kit/hold_button";
import { t } from "../kit/language";
import { Refusals } from "./refusals";

/** Why the bar is not where it was wanted; empty: it is. refused: it was tried, and has not moved since. */
export function stopperReason(levers: WindlassLevers, view: ForecastleView, refused: boolean): string {
  if (view.stopper_sprung) return t("the pin is out: the bar has sprung open");
  if (!refused && levers.stopper_closed === view.stopper_closed) return "";
  return view.stopper_closed ? t("under load: does not lift") : t("does not close on running chain");
}

export class Stopper {
  readonly element: HTMLElement;
  readonly guard: HoldGuard;
  private readonly button: HTMLButtonElement;
  private readonly state = h("strong", {});
  private readonly reason = h("p", { class: "reason", role: "status" });
  private readonly bar: SVGGElement;
  private closed = false; // what the button offers to change
  private readonly refusals = new Refusals();

  /** put: closes or opens it. */
  constructor(put: (closed: boolean) => void) {
    this.bar = svg(
      "g",
      { class: "bar" },
      svg("rect", { x: -2, y: -5, width: 62, height: 10, rx: 3 }),
      svg("circle", { cx: 0, cy: 0, r: 6, class: "pin" }),
    );
    this.button = h("button", {
      class: "guarded",
      role: "switch",
      "aria-label": t("chain stopper"),
      title: t("key t, held"),
    });
    this.guard = new HoldGuard(
      this.button,
      () => kHoldTime,
      () => put(!this.closed),
    );
    this.element = h(
      "section",
      { class: "control stopper", "aria-label": t("chain stopper") },
      h("div", { class: "row" }, h("h2", {}, t("Stopper")), this.state),
      svg(
        "svg",
        { viewBox: "-12 -38 104 60", class: "window", "aria-hidden": "true" },
        svg("path", { d: "M -4 10 H 16 V 20 H -4 Z M 52 4 H 62 V 20 H 44 V 10 H 52 Z", class: "frame" }),
        svg("ellipse", { cx: 30, cy: 12, rx: 12, ry: 7, class: "link" }),
        svg("ellipse", { cx: 30, cy: 12, rx: 5, ry: 2.5, class: "hole" }),
        this.bar,
      ),
      this.button,
      this.reason,
    );
  }

  /** The bar of that side did not move when it was tried, and stands so. */
  refuse(side: number, closed: boolean): void {
    this.refusals.add(side, closed);
  }

  /** runs: the exercise; else the bar goes where it is wanted as soon as it does, and until then may be wanted back. */
  show(levers: WindlassLevers, view: ForecastleView, movable: boolean, runs: boolean): void {
    const closed = view.stopper_closed;
    this.closed = runs ? closed : levers.stopper_closed;
    setAttribute(
      this.bar,
      "transform",
      closed ? "translate(2 -1)" : `translate(2 -1) rotate(${view.stopper_sprung ? -75 : -48})`,
    );
    setText(this.state, view.stopper_sprung ? t("SPRUNG") : closed ? t("ON") : t("OFF"));
    setText(this.button, this.closed ? t("Hold: lift") : t("Hold: close"));
    setAttribute(this.button, "aria-checked", `${this.closed}`);
    setText(this.reason, runs ? stopperReason(levers, view, this.refusals.lately(view.side, closed)) : "");
    this.button.disabled = !movable;
  }
}
