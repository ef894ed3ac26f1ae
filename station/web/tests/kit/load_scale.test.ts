// The load's dial can be read where the load is, and does not jump.

import assert from "node:assert/strict";
import { test } from "node:test";

import { LoadScale, loadScales } from "../../src/kit/load_scale";

test("the scales of a ship go up to her own by threes", () => {
  assert.deepEqual(loadScales(300, 10), [10, 30, 100, 300]);
  assert.deepEqual(loadScales(150, 10), [10, 30, 100, 150]);
  assert.deepEqual(loadScales(3000, 100), [100, 300, 1000, 3000]);
  assert.deepEqual(loadScales(8, 10), [8]);
});

test("a lesson's 5 t are read on a scale of 10 t, and a rising load widens it at once", () => {
  const scale = new LoadScale();
  const ends = loadScales(300, 10);
  const now = 0;
  assert.equal(scale.at(5, ends, now), 10);
  assert.equal(scale.at(12, ends, now + 1), 30);
  assert.equal(scale.at(150, ends, now + 2), 300);
  assert.equal(scale.at(900, ends, now + 3), 300, "beyond the last the needle stands at its stop");
});

test("it stays where waves take the load up and down, and narrows only when it is calm", () => {
  const scale = new LoadScale();
  const ends = loadScales(300, 10);
  let now = 0;
  scale.at(6, ends, now);
  const seen = new Set<number>();
  for (; now < 80000; now += 50) seen.add(scale.at(8 + 5 * Math.sin((2 * Math.PI * now) / 8000), ends, now));
  assert.deepEqual(
    [...seen].filter((end) => end !== 10),
    [30],
    "one change, to 30 t, in a swell of 3 to 13 t",
  );
  assert.equal(scale.at(8 + 5, ends, now), 30);
  for (const load of [8.1, 9, 10])
    for (let k = 0; k < 200; ++k) assert.equal(scale.at(load, ends, (now += 50)), 30, "near the smaller scale's end");
  for (let k = 0; k < 99; ++k) assert.equal(scale.at(7.9, ends, (now += 50)), 30);
  for (let k = 0; k < 3; ++k) scale.at(7.9, ends, (now += 50));
  assert.equal(scale.at(7.9, ends, now), 10);
});
