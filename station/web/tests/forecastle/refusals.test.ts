// How long it is said why a lever did not move.

import assert from "node:assert/strict";
import { test } from "node:test";

import { Refusals } from "../../src/forecastle/refusals";

test("a refusal is told for ten seconds, of its own side, and no longer than the lever stands so", (t) => {
  let now = 0;
  t.mock.method(performance, "now", () => now);
  const refusals = new Refusals();
  assert.equal(refusals.lately(0, true), false);
  refusals.add(0, true);
  assert.equal(refusals.lately(0, true), true);
  assert.equal(refusals.lately(0, false), false, "it has moved");
  assert.equal(refusals.lately(1, true), false);
  now = 10_000;
  assert.equal(refusals.lately(0, true), false);
});
