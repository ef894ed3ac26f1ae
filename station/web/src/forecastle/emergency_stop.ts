// The emergency stop: one touch latches it, releasing it must be held; then it says what the windlass still waits for.

import type { WindlassLevers } from "../wire/connection";
import type { ForecastleView } from "../wire/generated";
import { h, setAttribute, setText } from "../kit/dom";
import { HoldGuard } from "../kit/hold_button";
import { t } from "../kit/language";

const kReleaseTime = 1500; // ms
const kHardOn = 0.99; // as the model takes it

/** Whether a motor that was cut off waits for its lever to go to zero. */
export const waitsForLever = (view: Pick<ForecastleView, "tripped" | "emergency_stop" | "speed_lever">): boolean =>
  view.tripped && !view.emergency_stop && view.speed_lever !== 0;

export class EmergencyStop {
  readonly element: HTMLElement;
  readonly guard: HoldGuard;
  private readonly button: HTMLButtonElement;
  private readonly label = h("span", {}, t("STOP"));
  private readonly reason = h("p", { class: "reason", role: "status" });
  private latched = false;
  private wheelWaits = false; // released, and the hand-wheel has not been hard on since

  /** put: latches or releases it. */
  constructor(put: (on: boolean) => void) {
    this.button = h("button", {
      class: "emergency",
      role: "switch",
      "aria-label": t("emergency stop"),
      title: t("key e"),
    });
    this.button.append(this.label);
    this.guard = new HoldGuard(
      this.button,
      () => (this.latched ? kReleaseTime : 0),
      () => put(!this.latched),
    );
    this.element = h("section", { class: "control stop", "aria-label": t("emergency stop") }, this.button, this.reason);
  }

  show(levers: WindlassLevers, view: ForecastleView, movable: boolean): void {
    this.wheelWaits = levers.emergency_stop || (this.wheelWaits && levers.brake < kHardOn);
    this.latched = levers.emergency_stop;
    setAttribute(this.button, "aria-checked", `${this.latched}`);
    setText(this.label, this.latched ? t("hold to release") : t("STOP"));
    const asks = [
      waitsForLever(view) ? t("lever to zero") : "",
      this.wheelWaits && view.brake_position > levers.brake + 0.02 ? t("brake hard on") : "",
    ].filter(Boolean);
    setText(
      this.reason,
      this.latched
        ? t("stopped: motor off, brake on")
        : asks.length
          ? t("first {what}", { what: asks.join(", ") })
          : "",
    );
    this.button.disabled = !movable;
  }
}
