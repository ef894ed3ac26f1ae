// At which seat an alert is shown.

import assert from "node:assert/strict";
import { test } from "node:test";

import { hasPanel } from "../../src/kit/alert_panels";
import type { Seat } from "../../src/wire/connection";

const runaway = { deck_panel: true, bridge_panel: false };
const circle = { deck_panel: false, bridge_panel: true };
const inDoubt = { deck_panel: false, bridge_panel: false };

test("a seat's panel has the alerts of its place, and who has the truth all", () => {
  const shown = (seat: Seat): boolean[] => [runaway, circle, inDoubt].map((alert) => hasPanel(seat, alert));
  assert.deepEqual(shown("forecastle"), [true, false, false]);
  assert.deepEqual(shown("conning"), [false, true, false]);
  for (const both of ["trainee", "watcher"] as const) assert.deepEqual(shown(both), [true, true, false]);
  for (const truth of ["observer", "assessor", "instructor"] as const)
    assert.deepEqual(shown(truth), [true, true, true]);
});
