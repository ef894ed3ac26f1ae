// Back to a checkpoint: what came after it is lost, so one is asked first, and told where it goes.

import { h, setText } from "../kit/dom";
import { clock } from "../kit/units";
import type { Event } from "../wire/generated";
import type { Desk } from "./desk";
import { seconds } from "./time_field";

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
    "aria-label": "restore to, exercise time",
    placeholder: "m:ss",
  });
  private readonly question = h("p", { class: "text" });
  private readonly yes = h("button", { class: "primary", value: "back" });
  private readonly dialog = h(
    "dialog",
    { class: "question panel", "aria-label": "restore", onclose: () => this.answered() },
    h(
      "form",
      { method: "dialog" },
      this.question,
      h("div", { class: "row" }, h("button", { value: "" }, "Stay here"), this.yes),
    ),
  );
  private asked = 0; // s

  constructor(private readonly desk: Desk) {
    const ask = (event: SubmitEvent): void => {
      event.preventDefault();
      this.ask();
    };
    const form = h("form", { class: "group", onsubmit: ask }, this.field, h("button", { class: "plain" }, "Restore"));
    this.element = h("span", {}, form, this.dialog);
  }

  /** Puts a time (s) into the field. */
  suggest(time: number): void {
    this.field.value = clock(time);
  }

  private ask(): void {
    const now = this.desk.link.latest("ExerciseStatus")?.time ?? 0;
    const time = seconds(this.field.value);
    const refuse = (why: string): void => this.desk.say(`Restore to: ${this.field.value || "nothing"} ${why}`);
    if (Number.isNaN(time)) return refuse("is no time; m:ss is allowed");
    if (time > now) return refuse(`is yet to come; 0:00 to ${clock(now)}, which is now, is allowed`);
    this.asked = time;
    const there = clock(checkpointUpTo(time, this.desk.events.current()));
    setText(
      this.question,
      `Back to the checkpoint at ${there}, paused? What happened from there to now, ${clock(now)}, is dropped.`,
    );
    setText(this.yes, `Back to ${there}`);
    this.dialog.returnValue = "";
    this.dialog.showModal();
  }

  private answered(): void {
    if (this.dialog.returnValue === "back")
      void this.desk.give("ExerciseCommand", { action: "EXERCISE_RESTORE", restore_time: this.asked });
  }
}
