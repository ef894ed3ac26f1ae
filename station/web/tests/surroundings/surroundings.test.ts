// What lies round the anchorage, for window and chart alike.

import assert from "node:assert/strict";
import { test } from "node:test";

import { character, flashes, kRoadstead, shiftFor } from "../../src/surroundings/surroundings";

const light = kRoadstead.lights[0]!;

test("a light burns when its character says, however long the exercise runs", () => {
  assert.equal(character(light), "Fl(2) 10s 52m");
  const seen = (from: number): boolean[] => [0, 0.4, 0.6, 2.6, 3.1, 9.9].map((t) => flashes(light, from + t));
  assert.deepEqual(seen(0), [true, true, false, true, false, false]);
  assert.deepEqual(seen(36000), seen(0));
  assert.deepEqual(seen(-10), seen(0)); // what comes before the start of an exercise
});

test("each shore runs along its ridge, and nothing that is lit stands in the sea behind it", () => {
  for (const { shore, ridge } of kRoadstead.coasts) {
    assert.equal(shore.length, ridge.length);
    shore.forEach(([x, y], k) => assert.ok(Math.hypot(x!, y!) < Math.hypot(ridge[k]![0]!, ridge[k]![1]!)));
  }
  const nearest = Math.min(...kRoadstead.coasts.flatMap(({ shore }) => shore.map(([x, y]) => Math.hypot(x!, y!))));
  for (const [x, y, z] of kRoadstead.lamps) assert.ok(Math.hypot(x!, y!) >= nearest && z! > 0);
});

test("an exercise far from the origin has the same roadstead round it", () => {
  assert.deepEqual(shiftFor(900, 1200), { x: 0, y: 0 });
  assert.deepEqual(shiftFor(40300, -19000), { x: 40000, y: -20000 });
});
