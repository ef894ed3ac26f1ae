// What is said beside the clutch's button.

import assert from "node:assert/strict";
import { test } from "node:test";

import { clutchReason } from "../../src/forecastle/clutch";
import type { WindlassLevers } from "../../src/wire/connection";
import { ClutchState, type ForecastleView } from "../../src/wire/generated";

const { CLUTCH_OUT, CLUTCH_ENGAGING, CLUTCH_IN } = ClutchState;
const reason = (
  wanted: boolean,
  clutch: ClutchState,
  { refused = false, gypsyTurns = false, motor = 0 } = {},
): string =>
  clutchReason(
    { clutch_in: wanted } as WindlassLevers,
    { clutch, motor_speed_heard: motor } as ForecastleView,
    gypsyTurns,
    refused,
  );

test("a clutch that waits for its claws says what it waits for", () => {
  assert.equal(reason(true, CLUTCH_ENGAGING), "teeth not in line: turn the motor dead slow");
  assert.equal(reason(true, CLUTCH_ENGAGING, { motor: 0.3 }), "does not go in: the motor turns too fast");
  assert.equal(reason(true, CLUTCH_ENGAGING, { gypsyTurns: true }), "does not go in: the gypsy turns");
  assert.equal(reason(false, CLUTCH_ENGAGING), "", "it is on its way out");
});

test("why it did not move is said for a while after it was left", () => {
  for (const at of [CLUTCH_OUT, CLUTCH_IN]) assert.equal(reason(at === CLUTCH_IN, at), "");
  assert.equal(reason(false, CLUTCH_IN), "under load: take the load with the brake");
  assert.equal(reason(true, CLUTCH_IN, { refused: true }), "under load: take the load with the brake");
  assert.equal(reason(false, CLUTCH_OUT, { refused: true }), "does not go in", "broken or seized: no teeth to line up");
});
