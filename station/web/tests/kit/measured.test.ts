// Before the first tick there are no loads, and 0 is none of them.

import assert from "node:assert/strict";
import { test } from "node:test";

import { gaugeMeasured, loadsMeasured } from "../../src/kit/measured";
import { type Latest, panes } from "../../src/plots/channels";
import type { WindlassLoad } from "../../src/wire/generated";

const none = { time: 0, hawse_tension: 0, gypsy_load: 0, brake_load: 0, stopper_load: 0, motor_load: 0 };

test("loads that are all 0 at the time 0 were not measured", () => assert.ok(!loadsMeasured(none)));

test("one that bears the cable at the time 0 was: she lies at anchor", () =>
  assert.ok(loadsMeasured({ ...none, stopper_load: 4e5 })));

test("after the first tick 0 is what is so", () => {
  assert.ok(loadsMeasured({ ...none, time: 0.05 }));
  assert.ok(gaugeMeasured({ time: 0.05, gypsy_load_indicated: 0 }));
});

test("a gauge tells nothing before the first tick, unless it bears", () => {
  assert.ok(!gaugeMeasured({ time: 0, gypsy_load_indicated: 0 }));
  assert.ok(gaugeMeasured({ time: 0, gypsy_load_indicated: 30000 }));
});

test("plots begin with the first load that was measured", () => {
  const loads = panes.find(({ id }) => id === "loads")!;
  const read = (load: Partial<WindlassLoad>): number[] => {
    const heard = { ...none, brake_capacity: 0, ...load } as WindlassLoad;
    const link = { latest: (topic: string) => (topic === "WindlassLoad" ? heard : undefined) } as Latest;
    return loads.channels.map((channel) => channel.read(link, 0)); // N
  };
  assert.deepEqual(read({}), [NaN, NaN, NaN, NaN]);
  assert.deepEqual(read({ time: 0.05, hawse_tension: 9806.65, brake_capacity: 98066.5 }), [9806.65, 0, 0, 98066.5]);
});
