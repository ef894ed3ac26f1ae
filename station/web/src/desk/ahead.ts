// A minute ahead, if nobody does anything: the switch, and what there is to say of the newest prediction. What it shows
// is dotted in plots and plan, for the instructor alone: nothing of it is put before a room.

import { h, setAttribute, setText } from "../kit/dom";
import { t } from "../kit/language";
import { everySecond } from "../kit/page";
import type { Prediction } from "../wire/generated";
import type { Desk } from "./desk";
import { aheadOf, aheadWords, isOn } from "./prediction";

export class Ahead {
  readonly element: HTMLElement;
  private readonly button = h(
    "button",
    {
      class: "chip",
      "aria-pressed": "false",
      onclick: () => this.toggle(),
    },
    t("Ahead: if nobody does anything"),
  );
  private readonly note = h("span", { class: "quiet note" });

  constructor(
    private readonly desk: Desk,
    private readonly root: HTMLElement,
  ) {
    this.element = h(
      "div",
      { class: "ahead", role: "group", "aria-label": t("a minute ahead") },
      this.button,
      this.note,
    );
    everySecond(4, () => this.update());
  }

  /** What is to be drawn; nothing before a room. */
  get shown(): Prediction | undefined {
    return this.root.classList.contains("projecting") ? undefined : aheadOf(this.desk.link);
  }

  private toggle(): void {
    void this.desk.give("ExerciseCommand", { action: "EXERCISE_PREDICT", predict: !isOn(this.desk.link) });
  }

  private update(): void {
    const { link } = this.desk;
    this.button.hidden = this.desk.replay; // there it is what the instructor saw
    // Who may not switch it reads by it what is dotted.
    this.button.disabled = !this.desk.may("ExerciseCommand");
    this.button.title = this.button.disabled
      ? t("This seat may not order that.")
      : t("a minute ahead, dotted in plots and plan: every lever stays where it is and nobody speaks");
    setAttribute(this.button, "aria-pressed", `${isOn(link)}`);
    const words = aheadWords(link);
    setText(this.note, words);
    this.note.title = words;
  }
}
