// What the lesson asks a seat at a freeze: of whom, what, and that the exercise may go on without an answer.

import { h, setShown } from "../kit/dom";
import { t } from "../kit/language";
import { type Question, RunState } from "../wire/generated";
import type { Desk } from "./desk";

export class AskedBar {
  readonly element: HTMLElement;
  private readonly words = h("div", { class: "words" });

  constructor(private readonly desk: Desk) {
    this.element = h(
      "div",
      { class: "asked-bar", role: "status", hidden: true },
      this.words,
      h(
        "button",
        {
          class: "plain",
          "data-gives": "ExerciseCommand",
          onclick: () => void desk.give("ExerciseCommand", { action: "EXERCISE_START" }),
        },
        t("Go on without an answer"),
      ),
    );
    for (const topic of ["ForecastleQuestion", "BridgeQuestion", "ExerciseStatus"] as const)
      desk.link.on(topic, () => this.show());
  }

  private show(): void {
    const { link } = this.desk;
    const status = link.latest("ExerciseStatus");
    const open = (question: Question | undefined): string =>
      question?.id && question.run === status?.run ? question.text : "";
    const lines = [
      [t("The exercise holds for a question to the forecastle:"), open(link.latest("ForecastleQuestion"))],
      [t("The exercise holds for a question to the bridge:"), open(link.latest("BridgeQuestion"))],
    ].filter(([, text]) => text);
    const paused = status?.state === RunState.RUN_PAUSED;
    setShown(this.element, lines.length > 0 && paused);
    const said = lines.map(([to, text]) => `${to} ${text}`).join("\n");
    if (this.words.dataset.said === said) return;
    this.words.dataset.said = said;
    this.words.replaceChildren(
      ...lines.map(([to, text]) => h("p", {}, h("strong", {}, to), " ", h("span", { lang: "en" }, text))),
    );
  }
}
