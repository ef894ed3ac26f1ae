// What is said of a thruster.

import assert from "node:assert/strict";
import { test } from "node:test";

import { doesWords, thrustWords } from "../../src/bridge/thruster";

test("a thruster whose lever is at stop is at rest, and else does what it does", () => {
  assert.deepEqual([0, 0.004, -1, 0.4].map(doesWords), [
    "at rest",
    "at rest",
    "does port 100 %",
    "does starboard 40 %",
  ]);
  assert.deepEqual([0, -1].map(thrustWords), ["stop", "port 100 %"]);
});
