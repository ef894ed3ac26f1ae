// One figure with its name and unit, or a mark that its instrument has failed.

import { h, setAttribute, setText } from "../kit/dom";
import { t } from "../kit/language";

export class Readout {
  readonly element: HTMLElement;
  private readonly value = h("strong", {});
  private readonly unit_ = h("span", { class: "unit" });
  private readonly more = h("span", { class: "more" });

  /** most: of the scale, for those who hear it. */
  constructor(
    name: string,
    private readonly unit: string,
    most = 360,
  ) {
    this.element = h(
      "div",
      { class: "readout", role: "meter", "aria-label": name, "aria-valuemin": -most, "aria-valuemax": most },
      h("span", { class: "name", "aria-hidden": "true" }, name),
      h("span", { class: "figure", "aria-hidden": "true" }, this.value, this.unit_),
      this.more,
    );
    this.fail();
  }

  /** value: as a number; text: as it is read; more: a second line. */
  show(value: number, text: string, more = ""): void {
    setAttribute(this.element, "data-failed", undefined);
    setAttribute(this.element, "aria-valuenow", Number.isFinite(value) ? value.toFixed(1) : "0");
    setAttribute(this.element, "aria-valuetext", [`${text} ${this.unit}`.trim(), more].filter(Boolean).join(", "));
    setText(this.value, text);
    setText(this.unit_, this.unit);
    setText(this.more, more);
  }

  /** Its instrument gives nothing. */
  fail(): void {
    setAttribute(this.element, "data-failed", "");
    setAttribute(this.element, "aria-valuenow", "0");
    setAttribute(this.element, "aria-valuetext", t("failed, no signal"));
    setText(this.value, "\u26a0");
    setText(this.unit_, t("failed"));
    setText(this.more, "");
  }
}
