// What the forecastle's page makes of the gypsy's turn, without a browser: the speed by which chain is heard to run.

import assert from "node:assert/strict";
import { join } from "node:path";
import { before, test } from "node:test";

import { found, need, web } from "./browser.mjs";

const kDiameter = 0.078; // m
const kTurn = 40 * kDiameter; // m of cable to a turn of the gypsy
let cableSpeed;

before(async () => {
  const { outputFiles } = await need("esbuild").build({
    ...found,
    entryPoints: [join(web, "src/forecastle/heard.ts")],
    bundle: true,
    write: false,
    format: "esm",
  });
  ({ cableSpeed } = await import(`data:text/javascript,${encodeURIComponent(outputFiles[0].text)}`));
});

/** Views of a cable that runs at that speed, m/s: at 30 Hz, as a seat hears them, the speed seen in steps of 0.25. */
const track = (speed, change = {}) =>
  Array.from({ length: 30 }, (_, i) => {
    const time = i / 30;
    const turn = (2 * Math.PI * speed * time) / kTurn;
    const sample = {
      time,
      gypsy_turn: ((turn % (2 * Math.PI)) + 2 * Math.PI) % (2 * Math.PI),
      cable_speed_seen: Math.round(speed / 0.25) * 0.25,
      gypsy_jumping: false,
      ...change,
    };
    return { sample, at: 1000 * time };
  });
const heard = (samples) => cableSpeed(samples, kDiameter, 967);

test("chain that creeps is heard to creep, either way, where the eye sees none move", () => {
  for (const speed of [0.05, 0.1, 0.15, -0.1, 0.8])
    assert.ok(Math.abs(heard(track(speed)) - speed) < 1e-9, `${speed}: ${heard(track(speed))}`);
});

test("chain that runs is heard as fast as it is seen", () => {
  assert.equal(heard(track(5.8)), 5.75);
});

test("chain that jumps over a gypsy that stands is heard as it is seen", () => {
  assert.equal(heard(track(0, { gypsy_jumping: true, cable_speed_seen: 0.75 })), 0.75);
});

test("nothing runs while exercise time stands still, or nothing was heard", () => {
  const paused = track(0.5).map(({ sample, at }) => ({ sample: { ...sample, time: 3, gypsy_turn: 1 }, at }));
  assert.equal(heard(paused), 0);
  assert.equal(heard([]), 0);
});
