// Back to a checkpoint: what came after it is lost, so one is asked first, and told where it goes.

import { h, setText } from "../kit/dom";
import { clock } from "../kit/units";
import type { Event } from "../wire/generated";
import type { Desk } from "./desk";
import { seconds } from "./time_field";
import { t } from "../kit/language";

// s of exercise time from one checkpoint to the next, kCheckpointPeriod of server/run/session_checkpoints.cpp
const kPeriod = 10;

/** The time (s) of the last checkpoint up to that time; events: of the branch that runs, which have the others. */
export function checkpointUpTo(time: number, events: readonly Pick<Event, "code" | "time">[]): number {
  const others = events.filter((event) => /^exercise\.(checkpoint|restored)$/.test(event.code) && event.time <= time);
  return Math.max(Math.floor(time / kPeriod) * kPeriod, ...others.map((event) => event.time));
}

export class Restore {
  readonly element: HTMLElement;
  private readonly field = h("input", {
    class: "time",
    "aria-label": t("restore to, exercise time"),
    placeholder: t("m:ss"),
  });
  private readonly question = h("p", { class: "text" });
  private readonly yes = h("button", { class: "primary", value: "back" });
  private readonly dialog = h(
    "dialog",
    { class: "question panel", "aria-label": t("restore"), onclose: () => this.answered() },
    h(
      "form",
      { method: "dialog" },
      this.question,
      h("div", { class: "row" }, h("button", { value: "" }, t("Stay here")), this.yes),
    ),
  );
  private asked = 0; // s

  constructor(private readonly desk: Desk) {
    const ask = (event: SubmitEvent): void => {
      event.preventDefault();
      this.ask();
    };
    const form = h(
      "form",
      { class: "group", onsubmit: ask },
      this.field,
      h("button", { class: "plain" }, t("Restore")),
    );
    this.element = h("span", {}, form, this.dialog);
  }

  /** Puts a time (s) into the field. */
  suggest(time: number): void {
    this.field.value = clock(time);
  }

  private ask(): void {
    const now = this.desk.link.latest("ExerciseStatus")?.time ?? 0;
    const time = seconds(this.field.value);
    const typed = this.field.value || t("nothing|typed");
    if (Number.isNaN(time)) return this.desk.say(t("Restore to: {typed} is no time; m:ss is allowed", { typed }));
    if (time > now)
      return this.desk.say(
        t("Restore to: {typed} is yet to come; 0:00 to {now}, which is now, is allowed", { typed, now: clock(now) }),
      );
    this.asked = time;
    const there = clock(checkpointUpTo(time, this.desk.events.current()));
    setText(
      this.question,

      t("Back to the checkpoint at {there}, paused? What happened from there to now, {now}, is dropped.", {
        there,
        now: clock(now),
      }),
    );
    setText(this.yes, t("Back to {there}", { there }));
    this.dialog.returnValue = "";
    this.dialog.showModal();
  }

  private answered(): void {
    if (this.dialog.returnValue === "back")
      void this.desk.give("ExerciseCommand", { action: "EXERCISE_RESTORE", restore_time: this.asked });
  }
}
