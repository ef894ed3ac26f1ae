// The place where an anchor was let go, however event and samples come.

import assert from "node:assert/strict";
import { test } from "node:test";

import { LetGoPlace } from "../../src/desk/let_go_place";

const told = (steps: (number | { letGo: number })[]) => {
  const place = new LetGoPlace();
  for (const step of steps)
    if (typeof step === "number") place.passed({ time: step, x: 10 * step, y: 0 });
    else place.at(step.letGo);
  return place;
};

test("the sample nearest in time says where, before or after the event", () => {
  assert.equal(told([1, 2, 3, { letGo: 3.2 }, 4, 5]).asOf(9)!.x, 30);
  assert.equal(told([{ letGo: 3.2 }, 1, 2, 3, 4, 5]).asOf(9)!.x, 30);
  assert.equal(told([1, 2, 3, 4, 5, 6, 7, { letGo: 3.2 }, 8]).asOf(9)!.x, 30);
});

test("a recorder's gap of some seconds around it leaves a mark; nothing near it leaves none", () => {
  assert.equal(told([1, { letGo: 4.5 }, 9]).asOf(9)!.x, 10);
  assert.equal(told([1, { letGo: 14.5 }, 29]).asOf(29), undefined);
});

test("before that moment there is none, and what a restore left does not say where the next one was", () => {
  assert.equal(told([3, { letGo: 3.2 }]).asOf(3), undefined);
  const place = told([20, 21, 22]);
  place.passed({ time: 18, x: 0, y: 5 });
  place.at(21);
  assert.deepEqual(place.asOf(21), { time: 18, x: 0, y: 5 });
});

test("heard once more when its samples are long gone, it stays where it was", () => {
  const place = told([3, { letGo: 3.2 }]);
  for (let time = 4; time < 60; ++time) place.passed({ time, x: 0, y: 0 });
  place.at(3.2);
  assert.equal(place.asOf(60)!.x, 30);
});
