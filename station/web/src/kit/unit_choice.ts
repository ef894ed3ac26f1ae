// In which units loads and the cable's speed are read: a button that says it, and a dialog to choose.

import { h, setAttribute, setText } from "./dom";
import { t, translated } from "./language";
import { LanguageChoice } from "./language_choice";
import { type Measure, measures, unitWritten } from "./units";
import { capital } from "./words";

let groups = 0;

function choiceOf(measure: Measure): HTMLElement {
  const name = `unit-${++groups}`;
  const boxes = measure.options.map((unit) =>
    h("input", { type: "radio", name, checked: unit === measure.unit, onchange: () => measure.choose(unit) }),
  );
  measure.onChoice(() => measure.options.forEach((unit, i) => (boxes[i]!.checked = unit === measure.unit)));
  return h(
    "fieldset",
    {},
    h("legend", {}, capital(translated(measure.kind))),
    ...measure.options.map((unit, i) =>
      h("label", {}, boxes[i], h("b", {}, unitWritten(unit)), h("span", { class: "quiet" }, translated(unit.many))),
    ),
  );
}

export class UnitChoice {
  readonly button: HTMLButtonElement;
  readonly element: HTMLDialogElement;

  /** inHand: whether a hand of this page is on levers. */
  constructor(inHand: () => boolean) {
    this.element = h(
      "dialog",
      { class: "units panel", "aria-label": t("units") },
      h(
        "div",
        { class: "row" },
        h("h2", {}, t("Units")),
        h("button", { class: "plain", onclick: () => this.element.close() }, t("Close")),
      ),
      h(
        "p",
        { class: "quiet" },
        t("Kept in this browser. Ship, wind and stream are in knots, cable out in metres and shackles."),
      ),
      ...measures.map(choiceOf),
      new LanguageChoice(inHand).element,
    );
    this.button = h("button", { class: "plain", onclick: () => this.element.showModal() });
    for (const measure of measures) measure.onChoice(() => this.show());
    this.show();
  }

  private show(): void {
    const written = measures.map(({ unit }) => unitWritten(unit)).join(", ");
    setText(this.button, written);
    setAttribute(this.button, "aria-label", t("units: {written}", { written }));
  }
}
