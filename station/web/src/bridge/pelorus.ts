// The pelorus: a hair line in the middle of the view, and the bearing of what stands behind it. It reads the gyro's
// repeater, and the ship's head alone where the gyro has failed.

import { h, setAttribute, setText } from "../kit/dom";
import { bearingToTenth, radians } from "../kit/units";
import type { BridgeView } from "../wire/generated";
import { t } from "../kit/language";

const kTurn = radians(1); // by an arrow key; a tenth of it with Shift

const reading = (angle: number): string => `${bearingToTenth(angle)}\u00b0`;

export class Pelorus {
  readonly button = h(
    "button",
    {
      class: "plain",
      type: "button",
      title: t("takes bearings: turn the view until the mark stands behind the line"),
      onclick: () => this.set(!this.on),
    },
    t("Pelorus"),
  );
  private readonly reads = h("output", { class: "pelorus-reads" });
  private readonly take = h(
    "button",
    {
      class: "plain",
      type: "button",
      title: t("lays this bearing on the plan from the bridge, as EBL 1; arrow keys turn the view"),
      onclick: () => this.bearing !== undefined && this.lay(this.bearing),
    },
    t("Lay on plan"),
  );
  readonly element = h(
    "div",
    { class: "pelorus", role: "group", "aria-label": t("pelorus") },
    h("div", { class: "hair" }),
    h("div", { class: "row" }, this.reads, this.take),
  );
  private on = false;
  private stands_ = true;
  private bearing: number | undefined; // rad, true

  /** lay: takes a bearing, rad clockwise from north; turn: turns the view, rad clockwise. */
  constructor(
    private readonly lay: (bearing: number) => void,
    turn: (by: number) => void,
  ) {
    this.take.addEventListener("keydown", (event) => {
      const way = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
      if (!way) return;
      turn(way * kTurn * (event.shiftKey ? 0.1 : 1));
      event.preventDefault();
      event.stopPropagation(); // the page's own keys do not act as well
    });
    this.set(false);
  }

  /** Whether one looks out at all: no camera has a pelorus. */
  set stands(stands: boolean) {
    this.stands_ = stands;
    this.set(this.on);
  }

  /** turned: rad clockwise from ahead, where the view looks. */
  show(turned: number, view: BridgeView | undefined): void {
    if (this.element.hidden) return;
    this.bearing = view?.gyro_works ? view.heading + turned : undefined;
    const ahead = t("R {bearing}", { bearing: reading(turned) });
    const north = this.bearing;
    setText(
      this.reads,
      north === undefined
        ? t("{bearing}, no gyro", { bearing: ahead })
        : `${t("{bearing} T", { bearing: reading(north) })}, ${ahead}`,
    );
    this.take.disabled = this.bearing === undefined;
  }

  private set(on: boolean): void {
    this.on = on;
    this.button.hidden = !this.stands_;
    this.element.hidden = !on || !this.stands_;
    setAttribute(this.button, "aria-pressed", `${on}`);
  }
}
