// How much is typed of what a field takes: nothing is cut without a word.

import { h, setAttribute, setText } from "./dom";
import { t } from "./language";

/** What is taken, bytes: a note as long as the wire has it, of what is spoken what a sentence of the log holds. */
export const kMostWords = { note: 256, order: 200, report: 120 } as const;

/** As the wire counts: in UTF-8, in which an umlaut is two. */
export const wireLength = (text: string): number => new TextEncoder().encode(text.trim()).length;

export class TypedCount {
  /** Stands beside the field; empty while nothing is typed. */
  readonly element = h("small", { class: "quiet typed-count" });

  /** most: bytes; beyond them the field is not valid, and says so. */
  constructor(
    private readonly field: HTMLInputElement,
    private readonly most: number,
  ) {
    setAttribute(field, "title", t("{most} characters at most", { most }));
    field.addEventListener("input", () => this.show());
  }

  /** What was typed; undefined: it is more than fits, which the field has said. */
  text(): string | undefined {
    return this.field.reportValidity() ? this.field.value.trim() : undefined;
  }

  /** It has gone out: the field is empty again. */
  clear(): void {
    this.field.value = "";
    this.show();
  }

  private show(): void {
    const typed = wireLength(this.field.value);
    const over = typed > this.most;
    const count = t("{typed} of {most} characters", { typed, most: this.most });
    const words = over ? t("too long: {count}", { count }) : count;
    setText(this.element, typed === 0 ? "" : words);
    setAttribute(this.element, "data-over", over ? "" : undefined);
    this.field.setCustomValidity(over ? words : "");
  }
}
