// What the keys do, over the page.

import { h } from "../kit/dom";
import { keyTable } from "./keyboard";
import { t } from "../kit/language";

const kPad: readonly (readonly [string, string])[] = [
  ["RT, LT", t("brake on, off: the farther the faster")],
  [t("right stick"), t("brake on, off, finely")],
  [t("left stick"), t("heave, lower")],
  [t("X, Y (hold)"), t("clutch, stopper")],
  ["Back", t("emergency stop")],
  ["LB, RB", t("the other windlass")],
  [t("d-pad, A"), t("choose and make a report; A alone repeats the order back")],
  ["B, Start", t("acknowledge, help")],
];

function table(title: string, rows: readonly (readonly [string, string])[]): HTMLElement {
  return h(
    "table",
    {},
    h("caption", {}, title),
    h("tbody", {}, ...rows.map(([key, does]) => h("tr", {}, h("th", { scope: "row" }, key), h("td", {}, does)))),
  );
}

export class Help {
  readonly element: HTMLDialogElement;

  /** teach: opens the dialog of controllers; explain: shows the four pictures of a first visit. */
  constructor(teach: () => void, explain: () => void) {
    const leadsTo = (open: () => void) => (): void => {
      this.element.close();
      open();
    };
    this.element = h(
      "dialog",
      { class: "help panel" },
      h(
        "div",
        { class: "row" },
        h("h2", {}, t("Keys and gamepad")),
        h("button", { class: "plain", onclick: leadsTo(explain) }, t("First steps")),
        h("button", { class: "plain", onclick: leadsTo(teach) }, t("Controllers \u2026")),
        h("button", { class: "plain", onclick: () => this.element.close() }, t("Close")),
      ),
      h("div", { class: "tables" }, table(t("Keyboard"), keyTable), table("Gamepad", kPad)),
      h(
        "p",
        { class: "quiet" },
        t(
          "The first lever that you touch takes the windlass, with every lever as it was found. " +
            "The brake's hand-wheel turns by dragging round its hub, clockwise on, or by the mouse's wheel; with " +
            "Shift a fifth of it. Two fingers move two controls. The speed lever springs back when you let go, " +
            "unless you let the mouse go with Shift held: then it stays until it is touched again.",
        ),
      ),
      h(
        "p",
        { class: "quiet" },
        h("a", { href: "/licences.txt", target: "_blank" }, t("Licences of what this page is made of")),
      ),
    );
    this.element.setAttribute("aria-label", t("keys and gamepad"));
  }

  toggle(): void {
    if (this.element.open) this.element.close();
    else this.element.showModal();
  }
}
