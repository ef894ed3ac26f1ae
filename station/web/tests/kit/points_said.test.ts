// What a lesson has come to so far, in the figures and words of desk and class alike.

import assert from "node:assert/strict";
import { test } from "node:test";
import { pointsFigure, pointsSaid, rowSaid, shareSaid, soFar } from "../../src/kit/points_said";
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

const limit = { kind: CriterionKind.CRITERION_LIMIT };

test("what is lost for good of a limit is told before it is decided, and nothing of what may still come", () => {
  const criteria = [
    criterion(15, { ...limit, counted: 0, milli: 0 }),
    criterion(10, { kind: CriterionKind.CRITERION_STATE_AT, counted: 700, milli: 700 }),
    criterion(75, { kind: CriterionKind.CRITERION_FINAL, counted: 0, milli: 0 }),
  ];
  assert.deepEqual(soFar({ criteria }), { points: 0, lost: 18 });
});

test("rows stand in points of the 100 that their sum is of, and one that is open with what it can give", () => {
  const met = { state: CriterionState.CRITERION_MET, tick: 50 };
  const criteria = [
    criterion(20, { ...met, counted: 600, milli: 600 }),
    criterion(15, { ...limit, counted: 900, milli: 900 }),
    criterion(5, { state: CriterionState.CRITERION_NOT_IN_PLAY, counts: false }),
    criterion(30, { kind: CriterionKind.CRITERION_RUBRIC, state: CriterionState.CRITERION_NOT_IN_PLAY, counts: false }),
  ];
  const rows = (finished: boolean): string[] => criteria.map((one) => rowSaid(one, { criteria, finished }));
  assert.deepEqual(rows(false), ["30.0 of 50.0", "\u2013 of 37.5", "\u2013 of 12.5", "\u2013"]);
  assert.equal(soFar({ criteria }).points, 30);
  Object.assign(criteria[1]!, met);
  assert.deepEqual(rows(true), ["34.3 of 57.1", "38.6 of 42.9", "\u2013", "\u2013"], "as the debriefing has them");
  assert.equal(shareSaid(criteria[0]!, 1000, { criteria, finished: true }), "57.1 of 57.1");
  const eighty = [criterion(5, met), criterion(75, met)];
  assert.equal(shareSaid(eighty[0]!, 1000, { criteria: eighty, finished: true }), "6.3 of 6.3", "of 6.25, as there");
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
