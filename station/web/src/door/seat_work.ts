// What the instructor is told of who sits where in a class: away, at the page, at work, or silent for how long.

import { clock } from "../kit/units";
import { t } from "../kit/language";
import { RunState } from "../wire/generated";
import type { ClassExercise, Seat, TrainingClass } from "./ask";

const kSilent = 60; // s, from which it is told for how long a hand has done nothing
const kSilentStep = 10; // s, in which it is told

/** Its lesson is over: the ship may sail on, and nobody is marked for it any more. */
export const isOver = ({ state, outcome }: ClassExercise): boolean =>
  state === RunState.RUN_FINISHED || (outcome !== "" && state !== RunState.RUN_READY);

/** How many there are. */
export function standing({ exercises }: TrainingClass): string {
  const seats = exercises.flatMap((each) => each.seats);
  return t("{taken} of {seats} seats taken, {here} at the page", {
    taken: seats.filter(({ name }) => name !== null).length,
    seats: seats.length,
    here: seats.filter(({ here }) => here).length,
  });
}

/** What is known of who sits there; of who only watches, no more than that. */
export function doing(each: ClassExercise, { place, here, silent, acted }: Seat): string {
  if (!here) return t("away");
  if (isOver(each)) return t("here|seat");
  const goesOn = each.heard && each.state === RunState.RUN_RUNNING && place !== "watch";
  if (goesOn && silent !== null && silent >= kSilent)
    return t("silent {time}", { time: clock(kSilentStep * Math.floor(silent / kSilentStep)) });
  return acted ? t("at work") : t("at the page");
}
