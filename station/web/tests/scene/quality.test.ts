// How much is drawn falls where frames take too long, rises again when they do not, and does not flap.

import assert from "node:assert/strict";
import { test } from "node:test";

import { type QualityName, QualityWatch } from "../../src/scene/quality";

const kFast = 1000 / 60; // ms
const kSlow = 80;

/** Frames of that length for so many s; how often preset or pixels change in them. */
function run(watch: QualityWatch, ms: number, seconds: number): number {
  let changes = 0;
  let before = "";
  for (let t = 0; t < 1000 * seconds; t += ms) {
    const now = `${watch.after(ms)} ${watch.scale}`;
    if (before && now !== before) ++changes;
    before = now;
  }
  return changes;
}
// a hidden page's frame changes nothing
const shown = (watch: QualityWatch): [QualityName, number] => [watch.after(600), watch.scale];

test("a hiccup lowers the picture, and a calm time gives it back", () => {
  const watch = new QualityWatch("high");
  run(watch, kFast, 30);
  assert.deepEqual(shown(watch), ["high", 1]);
  run(watch, kSlow, 16); // three times sixty frames
  assert.deepEqual(shown(watch), ["low", 0.64]);
  run(watch, kFast, 19);
  assert.deepEqual(shown(watch), ["low", 0.64]);
  run(watch, kFast, 2);
  assert.deepEqual(shown(watch), ["low", 0.8]);
  run(watch, kFast, 45);
  assert.deepEqual(shown(watch), ["high", 1]);
});

test("a slow frame now and then does not keep it down", () => {
  const watch = new QualityWatch("high");
  run(watch, kSlow, 6);
  for (let k = 0; k < 6; ++k) {
    run(watch, kFast, 5);
    watch.after(120);
  }
  run(watch, kFast, 5);
  assert.deepEqual(shown(watch), ["high", 1]);
});

test("it never rises above what the machine was given", () => {
  const watch = new QualityWatch("software");
  run(watch, kSlow, 6);
  assert.deepEqual(shown(watch), ["software", 0.8]);
  run(watch, kFast, 600);
  assert.deepEqual(shown(watch), ["software", 1]);
});

test("a machine that is just too slow for more is not tried again and again", () => {
  const watch = new QualityWatch("high");
  let changes = 0;
  let before = "";
  for (let t = 0; t < 3600e3;) {
    const ms = watch.scale === 1 ? 60 : 30; // it bears 0.8 and no more
    t += ms;
    const now = `${watch.after(ms)} ${watch.scale}`;
    if (now !== before) ++changes;
    before = now;
  }
  assert.ok(changes < 24, `${changes} changes in an hour`);
});

test("between easy and slow nothing changes", () => {
  const watch = new QualityWatch("high");
  run(watch, kSlow, 6);
  assert.deepEqual(shown(watch), ["low", 1]);
  assert.equal(run(watch, 42, 600), 0);
});
