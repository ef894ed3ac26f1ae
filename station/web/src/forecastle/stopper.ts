// The chain stopper: a bar across the cable, seen to bear, to hang, or to be sprung.

import type { WindlassLevers } from "../wire/connection";
import type { ForecastleView } from "../wire/generated";
import { h, setAttribute, setText, svg } from "../kit/dom";
import { kHoldTime } from "./clutch";
import { HoldGuard } from "../kit/hold_button";
import { t } from "../kit/language";

export class Stopper {
  readonly element: HTMLElement;
  readonly guard: HoldGuard;
  private readonly button: HTMLButtonElement;
  private readonly state = h("strong", {});
  private readonly reason = h("p", { class: "reason", role: "status" });
  private readonly bar: SVGGElement;

  /** toggle: closes or opens it. */
  constructor(toggle: () => void) {
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
    this.guard = new HoldGuard(this.button, () => kHoldTime, toggle);
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

  show(levers: WindlassLevers, view: ForecastleView, movable: boolean): void {
    const closed = view.stopper_closed;
    setAttribute(
      this.bar,
      "transform",
      closed ? "translate(2 -1)" : `translate(2 -1) rotate(${view.stopper_sprung ? -75 : -48})`,
    );
    setText(this.state, view.stopper_sprung ? t("SPRUNG") : closed ? t("ON") : t("OFF"));
    setText(this.button, levers.stopper_closed ? t("Hold: lift") : t("Hold: close"));
    setAttribute(this.button, "aria-checked", `${levers.stopper_closed}`);
    const refuses = levers.stopper_closed !== closed;
    setText(
      this.reason,
      view.stopper_sprung && levers.stopper_closed
        ? t("the pin is out: the bar has sprung open")
        : !refuses
          ? ""
          : closed
            ? t("under load: does not lift")
            : t("does not close on running chain"),
    );
    this.button.disabled = !movable;
  }
}
