// The points of a lesson in words, the same wherever they are read.

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

const kBinary = 1e-6; // of a tenth, by which 10 * 69.6 may be short of 696

/**
 * "69.9": in tenths, in which a lesson decides, and rounded down: what has not reached the pass does not read as if it
 * had (points_text of common/figure_text.hpp is the same).
 */
export const pointsFigure = (points: number): string => figure(Math.floor(10 * points + kBinary) / 10, 1);

/** "28.0 of 100 points, 12.5 lost so far"; once it is over "28.0 of 100 points, not yet". outcome: in words. */
export function pointsSaid(points: number, lost: number, outcome: string): string {
  const all = pointsFigure(points);
  return outcome
    ? t("{points} of 100 points, {outcome}", { points: all, outcome })
    : t("{points} of 100 points, {lost} lost so far", { points: all, lost: figure(lost, 1) });
}
