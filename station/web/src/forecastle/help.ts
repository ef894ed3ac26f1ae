// What the keys do, over the page.

import { h } from "../kit/dom";
import { keyTable } from "./keyboard";

const kPad: readonly (readonly [string, string])[] = [
  ["RT, LT", "brake on, off: the farther the faster"],
  ["right stick", "brake on, off, finely"],
  ["left stick", "heave, lower"],
  ["X, Y (hold)", "clutch, stopper"],
  ["Back", "emergency stop"],
  ["LB, RB", "the other windlass"],
  ["d-pad, A", "choose and make a report; A alone repeats the order back"],
  ["B, Start", "acknowledge, help"],
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
        h("h2", {}, "Keys and gamepad"),
        h("button", { class: "plain", onclick: leadsTo(explain) }, "First steps"),
        h("button", { class: "plain", onclick: leadsTo(teach) }, "Controllers \u2026"),
        h("button", { class: "plain", onclick: () => this.element.close() }, "Close"),
      ),
      h("div", { class: "tables" }, table("Keyboard", keyTable), table("Gamepad", kPad)),
      h(
        "p",
        { class: "quiet" },
        "The first lever that you touch takes the windlass, with every lever as it was found. ",
        "The brake's hand-wheel turns by dragging round its hub, clockwise on, or by the mouse's wheel; with Shift a ",
        "fifth of it. Two fingers move two controls. The speed lever springs back ",
        "when you let go, ",
        "unless you let the mouse go with Shift held: then it stays until it is touched again.",
      ),
      h(
        "p",
        { class: "quiet" },
        h("a", { href: "/licences.txt", target: "_blank" }, "Licences of what this page is made of"),
      ),
    );
    this.element.setAttribute("aria-label", "keys and gamepad");
  }

  toggle(): void {
    if (this.element.open) this.element.close();
    else this.element.showModal();
  }
}
