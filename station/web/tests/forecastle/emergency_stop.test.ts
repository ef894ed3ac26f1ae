// What a windlass that was cut off still waits for.

import assert from "node:assert/strict";
import { test } from "node:test";

import { waitsForLever } from "../../src/forecastle/emergency_stop";

test("the lever is wanted at zero only while it is not there", () => {
  const waits = (speed_lever: number, more: object = {}): boolean =>
    waitsForLever({ tripped: true, emergency_stop: false, speed_lever, ...more });
  assert.ok(waits(-0.4));
  assert.ok(!waits(0), "in a blackout, or hot: no lever mends that");
  assert.ok(!waits(-0.4, { tripped: false }));
  assert.ok(!waits(-0.4, { emergency_stop: true }), "the stop is released first");
});
