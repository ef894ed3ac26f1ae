// The bridge of a lesson that asks, has no answer and is about to give up, which ends the lesson: said to those who may
// still help. Its trainee is asked, and not told how long.

import { clock } from "./units";
import { t } from "./language";

const kStep = 5; // s, in which it is told for how long: a screen reader says it each time

/** s of exercise. */
export interface Asking {
  /** When it was told first that it asks in vain. */
  since: number;
  /** When it gives up, unless it hears something. */
  gives_up: number;
}

/** As the exercise's log has it; undefined: it waits for no answer. log: of the branch that runs, by time. */
export function askingOf(log: readonly { code: string; time: number; value: number }[]): Asking | undefined {
  let asking: Asking | undefined;
  for (const { code, time, value } of log) {
    if (code === "assessment.unanswered") asking = { since: asking?.since ?? time, gives_up: value };
    else if (code === "assessment.answered" || code === "lesson.over") asking = undefined;
  }
  return asking;
}

/** "the bridge asks, and has had no answer for 0:10: at 1:03 it gives up, and the lesson ends". time: s, of now. */
export function asksInVain({ since, gives_up }: Asking, time: number): string {
  const lasts = clock(kStep * Math.floor(Math.max(0, time - since) / kStep));
  return time < gives_up
    ? t("the bridge asks, and has had no answer for {lasts}: at {time} it gives up, and the lesson ends", {
        lasts,
        time: clock(gives_up),
      })
    : t("the bridge asks, and has had no answer for {lasts}: it gives up, and the lesson ends", { lasts });
}
