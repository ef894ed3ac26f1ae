// What was noticed on the forecastle, a line for each act.

import assert from "node:assert/strict";
import { test } from "node:test";

import { tellsOf } from "../../src/forecastle/log";
import type { SeatEvent } from "../../src/wire/generated";

const event = (code: string, text: string, value = 0, tick = 900): SeatEvent =>
  ({ code, text, value, tick, time: tick / 60, side: 0 }) as SeatEvent;

test("an order that was repeated back tells of its repeat, and of no other report", () => {
  const repeated = event("order.repeated", "order 1 repeated: heave up port anchor", 1);
  const repeat = "reported: repeats: heave up port anchor, to order 1";
  assert.ok(tellsOf(repeated, event("report.made", repeat)));
  assert.ok(!tellsOf(repeated, event("report.made", repeat, 0, 840)), "said before, and not heard so");
  assert.ok(!tellsOf(repeated, event("report.made", repeat.replace("order 1", "order 11"))));
  assert.ok(!tellsOf(repeated, event("report.made", "reported: heaving, to order 1")));
  const wrong = event("order.misrepeated", "order 1 repeated wrongly: heave up port anchor", 1);
  assert.ok(!tellsOf(wrong, event("report.made", repeat)), "what was said instead stands there");
});
