// In which units loads and the cable's speed are read: a button that says it, and a dialog to choose.

import { h, setAttribute, setText } from "./dom";
import { type Measure, measures } from "./units";
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
    h("legend", {}, capital(measure.kind)),
    ...measure.options.map(({ written, many }, i) =>
      h("label", {}, boxes[i], h("b", {}, written), h("span", { class: "quiet" }, many)),
    ),
  );
}

export class UnitChoice {
  readonly button: HTMLButtonElement;
  readonly element: HTMLDialogElement;

  constructor() {
    this.element = h(
      "dialog",
      { class: "units panel", "aria-label": "units" },
      h(
        "div",
        { class: "row" },
        h("h2", {}, "Units"),
        h("button", { class: "plain", onclick: () => this.element.close() }, "Close"),
      ),
      h(
        "p",
        { class: "quiet" },
        "Kept in this browser. Ship, wind and stream are in knots, cable out in metres and shackles.",
      ),
      ...measures.map(choiceOf),
    );
    this.button = h("button", { class: "plain", onclick: () => this.element.showModal() });
    for (const measure of measures) measure.onChoice(() => this.show());
    this.show();
  }

  private show(): void {
    const written = measures.map(({ unit }) => unit.written).join(", ");
    setText(this.button, written);
    setAttribute(this.button, "aria-label", `units: ${written}`);
  }
}
