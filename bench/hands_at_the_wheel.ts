// How the brake takes a hand at the page: ten tries each by mouse, finger, keys and gamepad at a fall of 40 m in 60 m of
// water, through the page's own controls. Writes a table as Markdown on stdout; not a test. The same hand at the model
// alone: brake_stops.cpp.
//
// The hand: looks at counter and wheel every 0.3 s, acts on what it saw 0.3 s later, and is unsteady. It opens the wheel
// to where it knows that the cable runs, and then nudges it: off where the cable runs too slowly and does not gather
// speed, on where it runs too fast and goes on gathering. Some way before the mark it screws the brake on. It learns from
// try to try where the wheel stood at last and how far the cable ran on; the first try of each, which begins from the
// middle of the band's grip and 2 m before the mark, is practice and not counted. Held: nine tenths of the fall, from 6 s
// after the cable began to run, between 2.5 and 4 m/s. Stopped: within 2 m of the mark.
//
// usage: build/release/bin/own_domain node station/web/tools/ts.mjs bench/hands_at_the_wheel.ts [TRIES [DEVICE]]   (after a build; a machine at rest; about 40 min)

import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { cpus, loadavg, tmpdir } from "node:os";
import { join } from "node:path";

import type { CDPSession } from "playwright-core";

import { type TestPage, closeBrowser, closePage, openPage, root } from "../tests/browser/browser";
import { Rig, eventually, sleep } from "../tests/browser/rig";

const kLook = 300; // ms from one look to the next, and from a look to what the hand does about it
const kMark = 45; // m of cable out; 5 at the beginning
const [kSlow, kFast] = [2.5, 4]; // m/s
const kMargin = 0.4; // m/s, within those, at which the hand begins to correct
const kBegins = 6; // s of the fall, after which it is to be held
const kHeld = 0.9; // of the time
const kNear = 2; // m
const kLongest = 90; // s of a try
const tries = Number(process.argv[2] ?? 10);
const only = process.argv[3] ?? ""; // of the devices below, by the beginning of its name

/** A hand's noise: the same tries in each run. */
function normal(seed: number): () => number {
  let state = seed;
  const uniform = (): number => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0; // Numerical Recipes' generator
    return (state + 1) / 4294967297;
  };
  return () => Math.sqrt(-2 * Math.log(uniform())) * Math.cos(2 * Math.PI * uniform());
}

/** What a look at the page tells. */
interface Seen {
  /** m/s. */
  speed: number;
  /** m. */
  out: number;
  /** Degrees of the wheel from open, as set. */
  wheel: number;
}
const look = (page: TestPage): Promise<Seen> =>
  page.evaluate(() => {
    const view = window.windlass.link.latest("ForecastleView", 0);
    const wheel = document.querySelector("[aria-label='brake hand-wheel']").getAttribute("aria-valuenow");
    return {
      speed: view.cable_speed_indicated,
      out: view.cable_out_indicated,
      wheel: (Number(wheel) / 100) * 5 * 360,
    };
  });

/** A way to turn the wheel. */
interface Device {
  name: string;
  touch?: boolean;
  /** Takes hold. */
  begin?: (page: TestPage) => Promise<void>;
  /** Turns the wheel by about so many degrees, on positive. */
  turn: (page: TestPage, degrees: number) => Promise<void>;
  /** Screws it on as fast as the page lets one. */
  hardOn: (page: TestPage) => Promise<void>;
}

const kDrag = 8; // degrees between two moves of a pointer that is dragged
const kRate = 300; // degrees a second, at which it is: a little less than the wheel can be turned

/** Round the hub, from wherever the pointer is. */
class Rim {
  private angle = 0; // degrees from the top, clockwise
  private x = 0;
  private y = 0;
  private radius = 0;
  async find(page: TestPage): Promise<[number, number]> {
    const box = await page.getByRole("slider", { name: "brake hand-wheel" }).boundingBox();
    [this.x, this.y, this.radius] = [box.x + box.width / 2, box.y + box.height / 2, 0.4 * box.width];
    this.angle = 0;
    return this.at();
  }
  at(): [number, number] {
    const angle = (this.angle * Math.PI) / 180;
    return [this.x + this.radius * Math.sin(angle), this.y - this.radius * Math.cos(angle)];
  }
  async drag(degrees: number, move: (to: [number, number]) => Promise<unknown>): Promise<void> {
    const steps = Math.max(1, Math.ceil(Math.abs(degrees) / kDrag));
    for (let step = 0; step < steps; ++step) {
      this.angle += degrees / steps;
      await move(this.at());
      if (steps > 1) await sleep((1000 * kDrag) / kRate);
    }
  }
}

function mouse(): Device {
  const rim = new Rim();
  return {
    name: "mouse, dragged round the hub",
    begin: async (page) => {
      await page.mouse.move(...(await rim.find(page)));
      await page.mouse.down();
    },
    turn: (page, degrees) => rim.drag(degrees, (to) => page.mouse.move(...to)),
    hardOn: async (page) => {
      await page.mouse.up();
      await page.getByRole("button", { name: "Hard on" }).click();
    },
  };
}

function finger(): Device {
  const rim = new Rim();
  let hand: CDPSession;
  const touches = (type: "touchStart" | "touchMove" | "touchEnd", points: [number, number][]): Promise<unknown> =>
    hand.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y]) => ({ x, y, id: 1 })) });
  return {
    name: "finger on the rim",
    touch: true,
    begin: async (page) => {
      hand = await page.context().newCDPSession(page);
      await touches("touchStart", [await rim.find(page)]);
    },
    turn: (_, degrees) => rim.drag(degrees, (to) => touches("touchMove", [to])),
    hardOn: async (page) => {
      await touches("touchEnd", []);
      await page.getByRole("button", { name: "Hard on" }).tap();
    },
  };
}

function keys(): Device {
  return {
    name: "keys: Up and Down, tapped or held",
    turn: async (page, degrees) => {
      const key = degrees > 0 ? "ArrowUp" : "ArrowDown";
      if (Math.abs(degrees) < 90) {
        for (let taps = Math.round(Math.abs(degrees) / 10); taps > 0; --taps) {
          await page.keyboard.press(key);
          await sleep(120);
        }
        return;
      }
      const to = (await look(page)).wheel + degrees;
      await page.keyboard.down(key);
      await eventually("the wheel is there", async () => ((await look(page)).wheel - to) * Math.sign(degrees) > 0);
      await page.keyboard.up(key);
    },
    hardOn: (page) => page.keyboard.press("b"),
  };
}

function gamepad(): Device {
  const kOn = 7,
    kOff = 6; // triggers
  const kSoftly = 0.5; // of a trigger's way, which turns the wheel at a quarter of its rate: 18 degrees in 0.2 s
  const pull = (page: TestPage, trigger: number, by: number): Promise<void> =>
    page.evaluate(
      ([trigger, by]) => {
        window.pads = [
          {
            connected: true,
            index: 0,
            mapping: "standard",
            axes: [0, 0, 0, 0],
            buttons: Array.from({ length: 16 }, (_, i) => ({ value: i === trigger ? by : 0, pressed: i === trigger })),
          },
        ];
      },
      [trigger, by],
    );
  const full = 360; // degrees a second of a trigger that is pulled home
  return {
    name: "gamepad: triggers",
    turn: async (page, degrees) => {
      const by = Math.abs(degrees) > 90 ? 1 : kSoftly;
      await pull(page, degrees > 0 ? kOn : kOff, by);
      await sleep((1000 * Math.abs(degrees)) / (full * by ** 2));
      await pull(page, -1, 0);
    },
    hardOn: (page) => pull(page, kOn, 1),
  };
}

/** What came of a try. */
interface Fall {
  held: boolean;
  /** m beyond the mark, at which the cable stood. */
  off: number;
  fastest: number;
}

/** What a hand has learnt: to which degree of the wheel it opens, and how many m before the mark it closes. */
interface Learnt {
  place: number;
  before: number;
}

async function fall(page: TestPage, device: Device, learnt: Learnt, noise: () => number): Promise<Fall> {
  // The record of it is the page's own, ten times a second, by the exercise's time.
  await page.evaluate(() => {
    window.fall = [];
    const { link } = window.windlass;
    link.on("ForecastleView", (view) => {
      if (view.side !== 0) return;
      const last = window.fall.at(-1);
      if (!last || Math.abs(view.time - last.time) > 0.099)
        window.fall.push({ time: view.time, speed: view.cable_speed_indicated, out: view.cable_out_indicated });
    });
  });
  await device.begin?.(page);
  const start = (await look(page)).wheel;
  await device.turn(page, learnt.place - start + 5 * noise());
  let last: Seen = { speed: 0, out: 0, wheel: learnt.place };
  const end = Date.now() + 1000 * kLongest;
  for (let seen = await look(page); seen.out < kMark - learnt.before && Date.now() < end; seen = await look(page)) {
    const faster = seen.speed > last.speed + 0.02;
    const slower = seen.speed < last.speed - 0.02;
    last = seen;
    await sleep(kLook);
    const nudge = Math.max(2, 10 + 5 * noise());
    if (seen.speed > kFast - kMargin && !slower) await device.turn(page, nudge);
    else if (seen.speed < kSlow + kMargin && !faster) await device.turn(page, -nudge);
  }
  await sleep(kLook);
  await device.hardOn(page);
  await eventually("the cable stands", async () => Math.abs((await look(page)).speed) < 0.02);
  const record = await page.evaluate(() => window.fall);
  const ran = record.find(({ speed }) => speed > 0.3)?.time ?? NaN;
  const judged = record.filter(({ time, out }) => time > ran + kBegins && out < kMark - learnt.before);
  const off = record.at(-1).out - kMark;
  learnt.before += off;
  if (last.speed > kSlow) learnt.place = last.wheel;
  const good = judged.filter(({ speed }) => speed > kSlow && speed < kFast).length;
  return {
    held: judged.length > 0 && good >= kHeld * judged.length,
    off,
    fastest: Math.max(...record.map(({ speed }) => speed)),
  };
}

declare global {
  interface Window {
    fall: { time: number; speed: number; out: number }[];
  }
}

const folder = mkdtempSync(join(tmpdir(), "windlass-hands-"));
cpSync(join(root, "config"), join(folder, "config"), { recursive: true });
const exercise = join(folder, "config/exercises/hands_at_the_wheel.json");

/** What the brake is, and where its grip is about the half of what hangs on it: degrees of the wheel from open. */
const laws = [
  { name: "with free play and stiffness, 5 s", grips: 1100, windlass: {} },
  {
    name: "in proportion to the wheel, 2 s from open to hard on",
    grips: 60,
    windlass: { brake_free_play: 0, brake_stiffening: 1, brake_travel_time: 2 },
  },
];

console.log("| brake | by | held | stopped | farthest off | fastest |\n|---|---|---|---|---|---|");
for (const { name, grips, windlass } of laws) {
  const read = JSON.parse(readFileSync(join(root, "config/exercises/L13_runaway.json"), "utf8")) as {
    lesson?: unknown;
    tackle: { windlass: object }[];
  };
  delete read.lesson;
  Object.assign(read.tackle[0].windlass, windlass);
  writeFileSync(exercise, JSON.stringify(read));
  const rig = new Rig();
  rig.server(exercise);
  const station = await rig.station("forecastle");
  for (const device of [mouse(), finger(), keys(), gamepad()].filter(({ name }) => name.startsWith(only))) {
    const falls: Fall[] = [];
    const learnt: Learnt = { place: grips, before: 2 };
    for (let seed = 0; seed <= tries; ++seed) {
      await rig.say("reset");
      await rig.say("start");
      const page = await openPage(station.url.replace("#", "?picture=off#"), {
        hasTouch: device.touch,
        init: () => {
          window.pads = [null];
          navigator.getGamepads = () => window.pads as unknown as Gamepad[];
        },
      });
      await eventually("the levers may be moved", () => page.getByRole("switch", { name: "clutch" }).isEnabled());
      await eventually("the windlass is seen", () => look(page));
      const came = await fall(page, device, learnt, normal(seed + 1));
      if (seed > 0) falls.push(came);
      await closePage(page);
      if (process.env.WINDLASS_VERBOSE)
        console.error(name, device.name, seed, JSON.stringify(came), JSON.stringify(learnt));
    }
    const count = (is: (fall: Fall) => boolean): string => `${falls.filter(is).length} of ${tries}`;
    const worst = (figures: number[]): string => Math.max(...figures).toFixed(1);
    console.log(
      `| ${name} | ${device.name} | ${count(({ held }) => held)} | ${count(({ off }) => Math.abs(off) <= kNear)} | ` +
        `${worst(falls.map(({ off }) => Math.abs(off)))} m | ${worst(falls.map(({ fastest }) => fastest))} m/s |`,
    );
  }
  await rig.end();
}
await closeBrowser();
rmSync(folder, { recursive: true });
console.log(`\n${cpus()[0].model}, ${cpus().length} cores, load ${loadavg()[0].toFixed(1)} at the end.`);
