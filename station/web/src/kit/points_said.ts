// The points of a lesson in words, the same at the desk and on the page of a class.

import { type Assessment, CriterionKind, CriterionState } from "../wire/generated";
import { t } from "./language";
import { figure } from "./units";

/**
 * What is decided, in points of 100 that the whole lesson has; the door tells the page of a class the same
 * (door/marks_so_far.hpp). In the score of a lesson that runs, what nobody has offended against yet counts as kept.
 * computed: without what an assessor has said.
 */
export function soFar({ criteria }: Pick<Assessment, "criteria">, computed = false): { points: number; lost: number } {
  let [kept, lost, whole] = [0, 0, 0];
  for (const { kind, state, weight, tick, counts, counted, milli } of criteria) {
    const set = !computed && state === CriterionState.CRITERION_OVERRIDDEN;
    if (set ? !counts : kind === CriterionKind.CRITERION_RUBRIC) continue; // not applicable; an assessor's alone
    whole += weight;
    if (!set && (tick === 0 || (!counts && !computed))) continue;
    const mark = computed ? milli : counted;
    kept += (weight * mark) / 1000;
    lost += (weight * (1000 - mark)) / 1000;
  }
  return whole > 0 ? { points: (100 * kept) / whole, lost: (100 * lost) / whole } : { points: 0, lost: 0 };
}

/** "28.0 of 100 points, 12.5 lost so far"; once it is over "28.0 of 100 points, not yet". outcome: in words. */
export function pointsSaid(points: number, lost: number, outcome: string): string {
  const all = figure(points, 1);
  return outcome
    ? t("{points} of 100 points, {outcome}", { points: all, outcome })
    : t("{points} of 100 points, {lost} lost so far", { points: all, lost: figure(lost, 1) });
}
