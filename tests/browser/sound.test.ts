// The deck's sound, rendered without a loudspeaker and listened to by arithmetic.

import assert from "node:assert/strict";
import { join } from "node:path";
import { after, before, test } from "node:test";

import { build } from "esbuild";

import { found, root } from "../../station/web/tools/web.mjs";
import { type TestPage, closeBrowser, openPage } from "./browser";

const kRate = 44100; // Hz
let page: TestPage;

before(async () => {
  const { outputFiles } = await build({
    ...found,
    stdin: {
      contents: `export { ChainSound } from "./chain"; export { AlarmSound } from "./alarm";
        export { DeckSound } from "./deck"; export { kAhead } from "./player"; export { whiteNoise } from "./samples";`,
      resolveDir: join(root, "station/web/src/sound"),
      loader: "ts",
    },
    bundle: true,
    write: false,
    format: "iife",
    globalName: "sound",
  });
  page = await openPage("about:blank");
  await page.evaluate(`${outputFiles[0].text}; window.sound = sound;`);
});
after(closeBrowser);

/**
 * Times, s, of the blows in 3 s of chain at that speed, m/s. A blow is where the power of what changes fast, over 4 ms,
 * stands out of what was before it.
 */
const blows = (speed: number) =>
  page.evaluate(
    async ({ speed, rate }) => {
      const context = new OfflineAudioContext(1, 3 * rate, rate);
      const { ChainSound, whiteNoise } = window.sound;
      const chain = new ChainSound(context, context.destination, whiteNoise(context), 0.078);
      for (let t = 0; t < 3; t += 0.05) chain.play(speed, 0.1, false, t, t + 0.15);
      const data = (await context.startRendering()).getChannelData(0);
      const frame = Math.round(0.004 * rate);
      const power: number[] = [];
      for (let i = frame; i + frame < data.length; i += frame) {
        let sum = 0;
        for (let k = i; k < i + frame; ++k) sum += (data[k] - data[k - 1]) ** 2;
        power.push(sum);
      }
      const found: number[] = [];
      for (let i = 4; i < power.length; ++i) {
        const before = (power[i - 2] + power[i - 3] + power[i - 4]) / 3;
        const last = found.at(-1) ?? -1;
        if (power[i] > 2 * before && power[i] > 1e-4 && i * 0.004 - last > 0.025) found.push(i * 0.004);
      }
      return found;
    },
    { speed, rate: kRate },
  );

test("one blow is heard for each link that passes the gypsy", async () => {
  for (const speed of [1, 3, 5.8]) {
    const expected = (3 * speed) / (4 * 0.078);
    const found = await blows(speed);
    // One link more or less at the ends, and 1 in 20 that falls into the ring of the one before it.
    assert.ok(
      Math.abs(found.length - expected) <= 1 + expected / 20,
      `${found.length} blows at ${speed} m/s, ${expected} links`,
    );
  }
});

test("chain that stands is silent", async () => {
  assert.deepEqual(await blows(0), []);
});

/** Level (dB of full scale) of a second of the deck, after half a second to settle. */
interface Heard {
  cableSpeed?: number;
  brakeNoise?: number;
  hydraulic?: boolean;
  drive?: { speed?: number; load?: number; tripped?: boolean };
  force?: number;
  alarm?: number; // AlertPriority
}
const level = (changes: Heard) =>
  page.evaluate(
    async ({ changes, rate }) => {
      const context = new OfflineAudioContext(1, 1.5 * rate, rate);
      const { AlarmSound, DeckSound, kAhead } = window.sound;
      const deck = new DeckSound(context, context.destination);
      const alarm = new AlarmSound(context, context.destination);
      deck.fit(0, 0.078, changes.hydraulic ?? false);
      const drive = { speed: 0, load: 0, power: true, tripped: false, ...changes.drive };
      const quiet = { cableSpeed: 0, load: 0, jumping: false, brakeNoise: 0, heat: 0, clutch: 0 };
      for (let t = 0; t < 1.5; t += 0.05) {
        deck.windlass(0, { ...quiet, ...changes, drive }, true, t);
        deck.wind(changes.force ?? 0, t);
        alarm.play(changes.alarm, t, t + kAhead);
      }
      const data = (await context.startRendering()).getChannelData(0).subarray(0.5 * rate);
      let sum = 0,
        peak = 0;
      for (const value of data) {
        sum += value * value;
        peak = Math.max(peak, Math.abs(value));
      }
      return { level: 10 * Math.log10(sum / data.length + 1e-12), peak };
    },
    { changes, rate: kRate },
  );

test("what is told apart by its loudness rises step by step", async () => {
  const rising: Record<string, Heard[]> = {
    "the chain's speed": [{ cableSpeed: 0 }, { cableSpeed: 0.5 }, { cableSpeed: 2 }, { cableSpeed: 6 }],
    "the brake's noise": [0, 1, 2, 3].map((brakeNoise) => ({ brakeNoise, cableSpeed: 1 })),
    "the motor's load": [{}, { drive: { speed: 0.5, load: 0.2 } }, { drive: { speed: 0.5, load: 1 } }],
    "the pump's load": [{ hydraulic: true }, { hydraulic: true, drive: { speed: 0.5, load: 0.9 } }],
    "the wind's force": [{ force: 2 }, { force: 6 }, { force: 10 }],
    "what sounds of alerts": [{}, { alarm: 2 }],
  };
  for (const [what, steps] of Object.entries(rising)) {
    const levels: number[] = [];
    for (const step of steps) levels.push((await level(step)).level);
    // 1 dB is the least that an ear tells apart
    for (let i = 1; i < levels.length; ++i)
      assert.ok(levels[i] > levels[i - 1] + 1, `${what}: ${levels.map((l) => l.toFixed(1))} dB`);
  }
});

test("a motor that has tripped is silent at once", async () => {
  const running = await level({ drive: { speed: 0, load: 1 } });
  const tripped = await level({ drive: { speed: 0, load: 1, tripped: true } });
  assert.ok(tripped.level < running.level - 10, `${tripped.level} dB, ${running.level} dB before`);
});
