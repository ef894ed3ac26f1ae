// What the newest prediction says: whether it is of now, how old it is, how far it goes, what comes.

import { t } from "../kit/language";
import { clock, figure } from "../kit/units";
import { eventLine } from "../kit/words";
import type { Connection } from "../wire/connection";
import { EventSeverity, type Prediction, PredictionState } from "../wire/generated";

const kSaid = 2; // of what comes, as many as there is room for

/** The newest prediction, where it is of this run and of now. */
export function aheadOf(link: Pick<Connection, "latest">): Prediction | undefined {
  const status = link.latest("ExerciseStatus");
  const made = link.latest("Prediction");
  const last = made?.moments.at(-1);
  if (!status || !last || made?.run !== status.run) return undefined;
  return made.time <= status.time && status.time <= last.time ? made : undefined;
}

/** Whether predictions are made of this run. */
export function isOn(link: Pick<Connection, "latest">): boolean {
  const made = link.latest("Prediction");
  return made?.run === link.latest("ExerciseStatus")?.run && (made?.state ?? 0) !== PredictionState.PREDICTION_OFF;
}

/** One line: how old the prediction is, how far it goes and what comes; empty: predictions are off. */
export function aheadWords(link: Pick<Connection, "latest">): string {
  const made = link.latest("Prediction");
  const now = link.latest("ExerciseStatus")?.time;
  if (!made || now === undefined || !isOn(link)) return "";
  if (made.state === PredictionState.PREDICTION_AWAITED) return t("being made");
  if (made.state === PredictionState.PREDICTION_FOREIGN) return t("none: another simulator sails her");
  const shown = aheadOf(link);
  if (!shown) return t("none of now: the computer is too slow");
  const reach = figure(shown.moments.at(-1)!.time - shown.time);
  const words = [t("made {age} s ago", { age: figure(now - shown.time) })];
  if (shown.state === PredictionState.PREDICTION_ASKED) words.push(t("{reach} s, then the lesson asks", { reach }));
  if (shown.state === PredictionState.PREDICTION_DEAR) words.push(t("{reach} s: more costs too much", { reach }));
  if (shown.state === PredictionState.PREDICTION_STOPPED)
    words.push(t("{reach} s, then a fault of the simulation", { reach }));
  const comes = shown.events.filter(
    ({ severity, time }) => severity >= EventSeverity.EVENT_WARNING && time > now && time > shown.time,
  );
  for (const event of comes.slice(0, kSaid)) words.push(`${clock(event.time)} ${eventLine(event)}`);
  return words.join("; ");
}
