// Who has the helm, in the top bar: to be taken as it is found, and left. "Let go" is said of anchors only.

import { ownerWords } from "../kit/authority";
import { h, setAttribute, setText } from "../kit/dom";
import type { HelmHand } from "./helm_hand";
import { t } from "../kit/language";

export class HelmBar {
  readonly element: HTMLElement;
  private readonly who = h("strong", {});
  private readonly act: HTMLButtonElement;

  constructor(private readonly helm: HelmHand) {
    this.act = h("button", { class: "plain", type: "button", onclick: () => this.toggle() });
    this.element = h("div", { class: "helm-bar", role: "status" }, h("span", {}, `${t("helm:")} `, this.who), this.act);
  }

  update(): void {
    const authority = this.helm.authority();
    setAttribute(this.element, "data-owner", authority.owner);
    const owner = this.helm.granted() ? ownerWords(authority) : t("not this seat's");
    setText(this.who, this.helm.known() ? owner : t("waiting …"));
    this.act.hidden = !this.helm.granted();
    this.act.disabled = authority.owner !== "mine" && !this.helm.movable();
    setText(this.act, authority.owner === "mine" ? t("Leave helm") : t("Take helm"));
  }

  private toggle(): void {
    if (this.helm.authority().owner === "mine") this.helm.letGo();
    else this.helm.take();
  }
}
