// The thrusters' panel: bow and stern, levers that spring back or stay.

import { h, setAttribute } from "../kit/dom";
import type { BridgeView } from "../wire/generated";
import type { HelmHand } from "./helm_hand";
import { Thruster } from "./thruster";
import { t } from "../kit/language";

export class Thrusters {
  readonly element: HTMLElement;
  private readonly bow: Thruster;
  private readonly stern: Thruster;
  private readonly springs: HTMLButtonElement;

  constructor(private readonly helm: HelmHand) {
    this.bow = new Thruster(helm, "bow_thruster", t("Bow"));
    this.stern = new Thruster(helm, "stern_thruster", t("Stern"));
    this.springs = h("button", { class: "plain", type: "button", onclick: () => this.toggle() }, t("Spring back"));
    this.element = h(
      "section",
      { class: "panel thrusters-panel", "aria-label": t("thrusters") },
      h("div", { class: "row" }, h("h2", {}, t("Thrusters")), this.springs),
      this.bow.element,
      this.stern.element,
    );
  }

  update(view: BridgeView | undefined): void {
    this.bow.update(view?.bow_thruster);
    this.stern.update(view?.stern_thruster);
    setAttribute(this.springs, "aria-pressed", `${this.helm.thrustersSpring}`);
  }

  private toggle(): void {
    this.helm.thrustersSpring = !this.helm.thrustersSpring;
  }
}
