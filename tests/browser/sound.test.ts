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
        export { DeckSound } from "./deck"; export { kAhead } from "./player"; export { whiteNoise } from "./samples";
        export { limiter } from "./voices";`,
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
const blows = (speed: number, stall = 0) =>
  page.evaluate(
    async ({ speed, stall, rate }) => {
      const context = new OfflineAudioContext(1, 3 * rate, rate);
      const { ChainSound, whiteNoise } = window.sound;
      const ear = { gypsy: context.destination, pipe: new GainNode(context, { gain: 0 }) };
      const chain = new ChainSound(context, ear, whiteNoise(context), 0.078);
      const heldUp = (t: number) => t > 1 && t < 1 + stall;
      for (let t = 0; t < 3; t += 0.05) if (!heldUp(t)) chain.play(speed, 0.1, false, t);
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
    { speed, stall, rate: kRate },
  );

for (const stall of [0, 0.9])
  test(`one blow is heard for each link that passes the gypsy, a page held up for ${stall} s`, async () => {
    for (const speed of [1, 3, 5.8]) {
      const expected = (3 * speed) / (4 * 0.078);
      const found = await blows(speed, stall);
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

/** m, body frame: a windlass to port, and who stands inboard of it and looks across and forward. */
const places = { gypsy: [100, 4, 15], pipe: [104, 6, 13.8], water: [108, 8, 0] } as const;
const stand = { at: [98.5, 1.5, 15.5], ahead: [0.6, 0.8, 0] } as const;
type V3 = readonly [number, number, number];

/** Levels (dB of full scale) of a second of the deck, after half a second to settle: of both ears, of each. */
interface Heard {
  ears?: { at: V3; ahead: V3 };
  cableSpeed?: number;
  brakeNoise?: number;
  hydraulic?: boolean;
  drive?: { speed?: number; load?: number; tripped?: boolean };
  force?: number;
  alarm?: number; // AlertPriority
}
const level = (changes: Heard) =>
  page.evaluate(
    async ({ changes, places, stand, rate }) => {
      const context = new OfflineAudioContext(2, 1.5 * rate, rate);
      const { AlarmSound, DeckSound, kAhead, limiter } = window.sound;
      const out = limiter(context, context.destination);
      const deck = new DeckSound(context, out);
      const alarm = new AlarmSound(context, out);
      deck.fit(0, places, 0.078, changes.hydraulic ?? false);
      deck.listen(changes.ears ?? stand, 0);
      const drive = { speed: 0, load: 0, power: true, tripped: false, ...changes.drive };
      const quiet = { cableSpeed: 0, load: 0, jumping: false, brakeNoise: 0, heat: 0, clutch: 0 };
      for (let t = 0; t < 1.5; t += 0.05) {
        deck.windlass(0, { ...quiet, ...changes, drive }, t);
        deck.wind(changes.force ?? 0, t);
        alarm.play(changes.alarm, t, t + kAhead);
      }
      const heard = await context.startRendering();
      const power = (ear: number): number => {
        const data = heard.getChannelData(ear).subarray(0.5 * rate);
        return data.reduce((sum, value) => sum + value * value, 0) / data.length;
      };
      const decibel = (of: number): number => 10 * Math.log10(of + 1e-12);
      const [left, right] = [power(0), power(1)];
      return { level: decibel(left + right), left: decibel(left), right: decibel(right) };
    },
    { changes, places, stand, rate: kRate },
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

const kUnexplained = process.env.WINDLASS_BROWSER === "firefox" && "13 dB in Firefox, and it is not known why";
test(
  "a runaway is 20 dB louder than a let-go that is held, and every machine at its work quieter than that",
  { skip: kUnexplained },
  async (context) => {
    const of = async (heard: Heard) => (await level(heard)).level;
    const held = await of({ cableSpeed: 3, brakeNoise: 1 });
    const runaway = await of({ cableSpeed: 9 });
    const motor = await of({ drive: { speed: 1, load: 0.6 } });
    const pump = await of({ hydraulic: true, drive: { speed: 1, load: 0.6 } });
    const words = `held ${held.toFixed(1)}, runaway ${runaway.toFixed(1)}, motor ${motor.toFixed(1)}, pump ${pump.toFixed(1)} dB`;
    context.diagnostic(words);
    assert.ok(runaway > held + 19, words); // 1 dB, the least that an ear tells apart
    assert.ok(motor < held && pump < held, words);
  },
);

test("the windlass is heard from its side, and over the bow it is farther than the pipe", async () => {
  const heard: Heard = { cableSpeed: 3, brakeNoise: 3 };
  const facing = await level({ ...heard, ears: { at: [98, 4, 15.5], ahead: [1, 0, 0] } });
  assert.ok(Math.abs(facing.left - facing.right) < 3, `ahead: ${facing.left} and ${facing.right} dB`);
  const toPort = await level({ ...heard, ears: { at: [100, 1, 15.5], ahead: [1, 0, 0] } });
  assert.ok(toPort.left > toPort.right + 6, `to port: ${toPort.left} and ${toPort.right} dB`);
  const turned = await level({ ...heard, ears: { at: [100, 1, 15.5], ahead: [-1, 0, 0] } });
  assert.ok(turned.right > turned.left + 6, `looking aft: ${turned.left} and ${turned.right} dB`);
  const bow: Heard["ears"] = { at: [105.5, 8, 16], ahead: [0.6, 0, -0.8] };
  const near = await level({ brakeNoise: 3 });
  const overTheBow = await level({ brakeNoise: 3, ears: bow });
  assert.ok(overTheBow.level < near.level - 5, `the brake: ${near.level}, over the bow ${overTheBow.level} dB`);
});
