// What a lesson has come to so far, in the figures and words of desk and class alike.

import assert from "node:assert/strict";
import { test } from "node:test";
import { pointsFigure, pointsSaid, soFar } from "../../src/kit/points_said";
import { type Criterion, CriterionKind, CriterionState } from "../../src/wire/generated";

const criterion = (weight: number, more: Partial<Criterion> = {}): Criterion =>
  ({
    kind: CriterionKind.CRITERION_ORDER,
    state: CriterionState.CRITERION_OPEN,
    weight,
    milli: 1000,
    counted: 1000,
    counts: true,
    tick: 0,
    ...more,
  }) as Criterion;

test("what is open is neither kept nor lost, and what is decided has its share of the whole lesson's 100", () => {
  const criteria = [
    criterion(10, { tick: 50, counted: 600, milli: 600 }),
    criterion(20), // nobody has offended against it yet
    criterion(20, { state: CriterionState.CRITERION_NOT_IN_PLAY, counts: false, milli: 0, counted: 0 }),
    criterion(30, { kind: CriterionKind.CRITERION_RUBRIC }),
  ];
  assert.deepEqual(soFar({ criteria }), { points: 12, lost: 8 });
  assert.deepEqual(soFar({ criteria: [] }), { points: 0, lost: 0 });
});

test("an assessor's word counts as soon as it is said, beside what was computed", () => {
  const set = { state: CriterionState.CRITERION_OVERRIDDEN };
  const criteria = [criterion(10, { ...set, milli: 0 }), criterion(10, { tick: 50, milli: 0, counted: 0 })];
  assert.deepEqual(soFar({ criteria }), { points: 50, lost: 50 });
  assert.deepEqual(soFar({ criteria }, true), { points: 0, lost: 50 });
  const excused = criterion(80, { ...set, counts: false, counted: 0 });
  assert.deepEqual(soFar({ criteria: [...criteria, excused] }), { points: 50, lost: 50 }, "not applicable");
});

test("points are told of 100, with what is lost while it runs and with the outcome once it is over", () => {
  assert.equal(pointsSaid(28, 12.46, ""), "28.0 of 100 points, 12.5 lost so far");
  assert.equal(pointsSaid(69.6, 0, "not yet"), "69.6 of 100 points, not yet");
  assert.equal(pointsSaid(69.96, 0, "not yet"), "69.9 of 100 points, not yet", "what an assessor gave finer");
  for (let tenths = 0; tenths <= 1000; ++tenths) assert.equal(pointsFigure(0.1 * tenths), (tenths / 10).toFixed(1));
});
