// How many trainees a new class has to each exercise.

import assert from "node:assert/strict";
import { test } from "node:test";

import { crewFor } from "../../src/door/new_class";

test("the crew is what suits the lesson, unless the person has chosen one that can play it", () => {
  assert.deepEqual([crewFor(false), crewFor(true)], [1, 2]);
  assert.deepEqual([crewFor(false, 2), crewFor(true, 3)], [2, 3]);
  assert.equal(crewFor(true, 1), 2, "a judged bridge is none for one alone");
});
