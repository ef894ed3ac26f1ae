// The points of a lesson in words, the same wherever they are read.

import { type Assessment, type Criterion, CriterionKind, CriterionState } from "../wire/generated";
import { t } from "./language";
import { figure } from "./units";

/** Whether what an open criterion has lost is lost for good: its mark only falls. */
const onlyFalls = ({ kind, state, counts }: Criterion): boolean =>
  state === CriterionState.CRITERION_OPEN &&
  counts &&
  (kind === CriterionKind.CRITERION_LIMIT || kind === CriterionKind.CRITERION_STATE_AT);

/** Whether the lesson can come to it; not what is an assessor's alone, or not applicable by his word. */
const isOfTheWhole = ({ kind, state, counts }: Criterion, computed = false): boolean =>
  !computed && state === CriterionState.CRITERION_OVERRIDDEN ? counts : kind !== CriterionKind.CRITERION_RUBRIC;

/**
 * What is kept of what is decided, and what is lost for good, in points of 100 that the whole lesson has; the door
 * tells the page of a class the same (door/marks_so_far.hpp). In the score of a lesson that runs, what nobody has
 * offended against yet counts as kept.
 * computed: without what an assessor has said.
 */
export function soFar({ criteria }: Pick<Assessment, "criteria">, computed = false): { points: number; lost: number } {
  let [kept, lost, whole] = [0, 0, 0];
  for (const criterion of criteria) {
    if (!isOfTheWhole(criterion, computed)) continue;
    const { state, weight, tick, counts, counted, milli } = criterion;
    const set = !computed && state === CriterionState.CRITERION_OVERRIDDEN;
    const decided = set || (tick !== 0 && (counts || computed));
    const mark = computed ? milli : counted;
    whole += weight;
    if (decided) kept += (weight * mark) / 1000;
    if (decided || onlyFalls(criterion)) lost += (weight * (1000 - mark)) / 1000;
  }
  return whole > 0 ? { points: (100 * kept) / whole, lost: (100 * lost) / whole } : { points: 0, lost: 0 };
}

const kBinary = 1e-6; // of a tenth, by which 10 * 69.6 may be short of 696

/**
 * "69.9": in tenths, in which a lesson decides, and rounded down: what has not reached the pass does not read as if it
 * had (points_text of common/figure_text.hpp is the same).
 */
export const pointsFigure = (points: number): string => figure(Math.floor(10 * points + kBinary) / 10, 1);

type Judged = Pick<Assessment, "criteria" | "finished">;

/**
 * Points of 100 that a weight is worth: while the lesson runs of all that it can come to, once it is over of what came
 * into play, as the debriefing has them (recorder/debrief/judgement.cpp).
 */
function worth(weight: number, { criteria, finished }: Judged): number {
  const its = criteria.filter((one) => (finished ? one.counts : isOfTheWhole(one)));
  const whole = its.reduce((sum, one) => sum + one.weight, 0);
  return whole > 0 ? (100 * weight) / whole : 0;
}

/**
 * "6.3" of 6.25: the part that one criterion has of the 100 decides nothing, and is rounded to the nearest tenth, a
 * half up (share_text of common/figure_text.hpp is the same).
 */
const shareFigure = (points: number): string => pointsFigure(points + 0.05);

/** Points of 100 that a criterion has with such a mark, 0..1000: "5.0". */
export const earnedSaid = ({ weight }: Criterion, milli: number, of: Judged): string =>
  shareFigure(worth((weight * milli) / 1000, of));

/** The same, of what it can have: "5.0 of 10.9". */
export const shareSaid = (criterion: Criterion, milli: number, of: Judged): string =>
  t("{points} of {most}", { points: earnedSaid(criterion, milli, of), most: earnedSaid(criterion, 1000, of) });

/**
 * What stands in the row of a criterion, so that the rows come to what soFar() has: "5.0 of 10.9"; of one that is not
 * decided "\u2013 of 10.9", of one that has no points "\u2013".
 */
export function rowSaid(criterion: Criterion, of: Judged): string {
  if (criterion.counts && criterion.state !== CriterionState.CRITERION_OPEN)
    return shareSaid(criterion, criterion.counted, of);
  if (of.finished ? !criterion.counts : !isOfTheWhole(criterion)) return "\u2013";
  return t("{points} of {most}", { points: "\u2013", most: earnedSaid(criterion, 1000, of) });
}

/** "28.0 of 100 points, 12.5 lost so far"; once it is over "28.0 of 100 points, not yet". outcome: in words. */
export function pointsSaid(points: number, lost: number, outcome: string): string {
  const all = pointsFigure(points);
  return outcome
    ? t("{points} of 100 points, {outcome}", { points: all, outcome })
    : t("{points} of 100 points, {lost} lost so far", { points: all, lost: shareFigure(lost) });
}
