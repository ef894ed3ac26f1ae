// The deck's sound, rendered without a loudspeaker and listened to by arithmetic.

import assert from "node:assert/strict";
import { type Server, createServer } from "node:http";
import type { AddressInfo } from "node:net";
import { join } from "node:path";
import { after, before, test } from "node:test";

import { build } from "esbuild";

import { found, root } from "../../station/web/tools/web.mjs";
import { type TestPage, closeBrowser, openPage } from "./browser";

const kRate = 44100; // Hz
const kFrame = 0.005; // s, of which a recorder keeps the power
let page: TestPage;
let server: Server;

const src = join(root, "station/web/src/sound");
const bundled = async (contents: string, more: object): Promise<string> => {
  const stdin = { contents, resolveDir: src, loader: "ts" as const };
  const { outputFiles } = await build({ ...found, stdin, bundle: true, write: false, ...more });
  return outputFiles[0].text;
};

/** A module of the audio's own thread that keeps the power of each kFrame of what goes through it, in order. */
const kRecorder = `registerProcessor("recorder", class extends AudioWorkletProcessor {
  powers = []; sum = 0; count = 0;
  constructor() { super(); this.port.onmessage = () => this.port.postMessage(this.powers); }
  process([[heard]], [[out]]) {
    for (let i = 0; i < out.length; ++i) {
      out[i] = heard ? heard[i] : 0;
      this.sum += out[i] ** 2;
      if (++this.count < ${kFrame} * sampleRate) continue;
      this.powers.push(this.sum / this.count);
      this.sum = this.count = 0;
    }
    return true;
  }
});`;

before(async () => {
  const sound = await bundled(
    `export { ChainSound } from "./chain"; export { AlarmSound } from "./alarm"; export { DeckSound } from "./deck";
      export { whiteNoise } from "./samples"; export { loadStrikes } from "./strikes";
      export { limiter } from "./voices";`,
    { format: "iife", globalName: "sound" },
  );
  const modules: Record<string, string> = {
    "/assets/strikes_processor.js": await bundled('import "./strikes_processor";', { format: "esm" }),
    "/recorder.js": kRecorder,
  };
  // A browser has audio's own thread for pages that come from somewhere.
  server = createServer(({ url }, answer) => {
    const module = modules[url];
    answer.setHeader("Content-Type", module ? "text/javascript" : "text/html");
    answer.end(module ?? '<!doctype html><link rel="icon" href="data:,">');
  });
  await new Promise<void>((listening) => server.listen(0, "127.0.0.1", listening));
  page = await openPage(`http://127.0.0.1:${(server.address() as AddressInfo).port}/`);
  await page.evaluate(`${sound}; window.sound = sound;`);
});
after(async () => {
  await closeBrowser();
  server.close();
});

/**
 * Times, s, of the blows in 3 s of chain at that speed, m/s. A blow is where the power of what changes fast, over 4 ms,
 * stands out of what was before it.
 */
const blows = (speed: number, stall = 0) =>
  page.evaluate(
    async ({ speed, stall, rate }) => {
      const context = new OfflineAudioContext(1, 3 * rate, rate);
      const { ChainSound, loadStrikes, whiteNoise } = window.sound;
      await loadStrikes(context);
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

for (const stall of [0, 1.9])
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
      const { AlarmSound, DeckSound, limiter, loadStrikes } = window.sound;
      await loadStrikes(context);
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
        alarm.play(changes.alarm, t);
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

/** What is listened to while the page is held up. */
type Through = "deck" | "links" | "alarm" | "muted for 60 ms";
/**
 * The longest time, s, for which it was more than 20 dB below its median while the page was held up for so many s, and
 * that median, dB of full scale. Of a context that runs: "deck" and "links" in a runaway of 9 m/s.
 */
const heldUp = (through: Through, seconds: number) =>
  page.evaluate(
    async ({ through, seconds, places, stand, frame }) => {
      const { AlarmSound, ChainSound, DeckSound, loadStrikes, whiteNoise } = window.sound;
      const context = new AudioContext();
      await context.resume();
      await loadStrikes(context);
      await context.audioWorklet.addModule("/recorder.js");
      const recorder = new AudioWorkletNode(context, "recorder", {
        channelCount: 1,
        channelCountMode: "explicit",
        outputChannelCount: [1],
      });
      recorder.connect(new GainNode(context, { gain: 0 })).connect(context.destination);
      let mute = (): void => undefined;
      const play = ((): ((time: number) => void) => {
        if (through === "alarm") {
          const alarm = new AlarmSound(context, recorder);
          return (time) => alarm.play(3, time); // ALERT_EMERGENCY, which never pauses
        }
        if (through === "links") {
          const ear = { gypsy: recorder, pipe: new GainNode(context, { gain: 0 }) };
          const chain = new ChainSound(context, ear, whiteNoise(context), 0.078);
          return (time) => chain.play(9, 0.1, false, time);
        }
        const gain = new GainNode(context);
        gain.connect(recorder);
        if (through !== "deck")
          mute = () => {
            const begin = context.currentTime + 0.5;
            gain.gain.setValueAtTime(0, begin);
            gain.gain.setValueAtTime(1, begin + 0.06);
          };
        const deck = new DeckSound(context, gain);
        deck.fit(0, places, 0.078, false);
        const drive = { speed: 0, load: 0, power: true, tripped: false };
        const heard = { cableSpeed: 9, load: 0, jumping: false, brakeNoise: 0, heat: 0, clutch: 0, drive };
        return (time) => {
          deck.listen(stand, time);
          deck.windlass(0, heard, time);
        };
      })();
      const wait = (ms: number): Promise<void> => new Promise((done) => setTimeout(done, ms));
      const asked = (): Promise<number[]> =>
        new Promise((told) => {
          recorder.port.onmessage = ({ data }: MessageEvent<number[]>) => told(data);
          recorder.port.postMessage("tell", []);
        });
      const timer = setInterval(() => play(context.currentTime), 50);
      await wait(1000);
      const from = (await asked()).length;
      mute(); // from what is listened to on: a busy machine may have taken any time to come here
      const until = performance.now() + 1000 * seconds;
      while (performance.now() < until); // the page does nothing else
      const powers = (await asked()).slice(from);
      clearInterval(timer);
      await context.close();
      const median = [...powers].sort((a, b) => a - b)[powers.length >> 1];
      let longest = 0;
      for (let i = 0, run = 0; i < powers.length; ++i) {
        run = powers[i] < median / 100 ? run + 1 : 0;
        longest = Math.max(longest, run);
      }
      return { gap: longest * frame, level: 10 * Math.log10(median + 1e-12), seconds: powers.length * frame };
    },
    { through, seconds, places, stand, frame: kFrame },
  );

const kSilent = process.env.WINDLASS_BROWSER === "firefox" && "its contexts do not run without a loudspeaker";
for (const through of ["deck", "links", "alarm"] as const)
  test(`a page that is held up for 2 s is heard through it: ${through}`, { skip: kSilent }, async (context) => {
    const { gap, level, seconds } = await heldUp(through, 2);
    const words = `${level.toFixed(1)} dB over ${seconds.toFixed(2)} s, longest gap ${(1000 * gap).toFixed(0)} ms`;
    context.diagnostic(words);
    assert.ok(seconds > 1.8 && level > -60, words);
    assert.ok(gap <= 0.05, words);
  });

test("a gap of 60 ms would be found", { skip: kSilent }, async () => {
  const { gap } = await heldUp("muted for 60 ms", 2);
  assert.ok(gap > 0.05 && gap < 0.1, `${gap} s`);
});
