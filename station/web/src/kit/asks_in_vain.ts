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
  /** Whether it was told what is not so since. */
  misled: boolean;
}

/** As the exercise's log has it; undefined: it waits for no answer. log: of the branch that runs, by time. */
export function askingOf(log: readonly { code: string; time: number; value: number }[]): Asking | undefined {
  let asking: Asking | undefined;
  for (const { code, time, value } of log) {
    const misled = code === "assessment.misled";
    if (misled || code === "assessment.unanswered")
      asking = { since: asking?.since ?? time, gives_up: value, misled: misled || (asking?.misled ?? false) };
    else if (code === "assessment.answered" || code === "lesson.over") asking = undefined;
  }
  return asking;
}

/**
 * "the bridge has been asking for 0:10, and has no answer: at 1:03 it gives up, and the lesson ends". It counts from
 * its asking and not from the order, which had its own time to be repeated and carried out in. Where answers were given
 * that are not so, it has "no true answer". time: s, of now.
 */
export function asksInVain({ since, gives_up, misled }: Asking, time: number): string {
  const lasts = clock(kStep * Math.floor(Math.max(0, time - since) / kStep));
  const at = clock(gives_up);
  if (misled)
    return time < gives_up
      ? t(
          "the bridge has been asking for {lasts}, and has no true answer: at {time} it gives up, and the lesson ends",
          {
            lasts,
            time: at,
          },
        )
      : t("the bridge has been asking for {lasts}, and has no true answer: it gives up, and the lesson ends", {
          lasts,
        });
  return time < gives_up
    ? t("the bridge has been asking for {lasts}, and has no answer: at {time} it gives up, and the lesson ends", {
        lasts,
        time: at,
      })
    : t("the bridge has been asking for {lasts}, and has no answer: it gives up, and the lesson ends", { lasts });
}
