// How well a hand holds a let-go by each of the page's controls: the wheel of the mouse, a finger on the rim, keys, a
// gamepad. A hand of 0.3 s that errs by a fifth in what it does sees the counter as the page shows it, and is to hold the
// fall between 2.5 and 4 m/s and to stop at a mark. Prints a table; not a test.
//
// usage: WINDLASS_DOMAIN=N node station/web/tools/ts.mjs bench/hands.ts [TRIES]   (after a build; a machine at rest)

import { cpus, loadavg } from "node:os";

import { type TestPage, closeBrowser, openPage } from "../tests/browser/browser";
import { Rig, eventually, sleep } from "../tests/browser/rig";

const [tries = "10"] = process.argv.slice(2);
const kReaction = 300; // ms
const kDecides = 200; // ms from one correction to the next
const kAim = 3.2; // m/s
const kHeld = [2.5, 4]; // m/s
const kFrom = 9; // m of cable out, from which the fall is to be held: before, it gathers way
const kMark = 24; // m out, before the anchor reaches the bottom
const kPerSpeed = 14; // degrees of the wheel for each m/s that it is too fast or too slow, as a hand learns it
const kErrs = 0.2; // of an angle

/** What the counter shows. */
interface Seen {
  at: number; // ms
  out: number; // m
  speed: number; // m/s
}

/** Turns the page's hand-wheel by about so many degrees, on positive. */
type Turn = (page: TestPage, degrees: number) => Promise<void>;

const wheel = (page: TestPage) => page.getByRole("slider", { name: "brake hand-wheel" });

async function byMouse(page: TestPage, degrees: number): Promise<void> {
  const notches = Math.min(8, Math.round(Math.abs(degrees) / 5));
  for (let notch = 0; notch < notches; ++notch) await page.mouse.wheel(0, degrees > 0 ? -100 : 100);
}
async function byKeys(page: TestPage, degrees: number): Promise<void> {
  const key = degrees > 0 ? "ArrowUp" : "ArrowDown";
  for (let tap = 0; tap < Math.min(4, Math.round(Math.abs(degrees) / 10)); ++tap) await page.keyboard.press(key);
}
/** The finger of a drag, round the hub: where it is, degrees from the top. */
let finger = 0;
const at = (box: { x: number; y: number; width: number; height: number }): [number, number] => [
  box.x + box.width / 2 + 0.32 * Math.min(box.width, box.height) * Math.sin((finger * Math.PI) / 180),
  box.y + box.height / 2 - 0.32 * Math.min(box.width, box.height) * Math.cos((finger * Math.PI) / 180),
];
async function byFinger(page: TestPage, degrees: number): Promise<void> {
  const box = await wheel(page).boundingBox();
  const touch = await page.context().newCDPSession(page);
  const send = (type: "touchStart" | "touchMove" | "touchEnd", points: [number, number][]) =>
    touch.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y]) => ({ x, y })) });
  await send("touchStart", [at(box)]);
  const steps = Math.max(1, Math.ceil(Math.abs(degrees) / 15));
  for (let step = 0; step < steps; ++step) {
    finger += degrees / steps;
    await send("touchMove", [at(box)]);
  }
  await sleep(60); // the wheel follows
  await send("touchEnd", []);
}
/** The right stick for as long as it takes: it turns the wheel finely, at a tenth of its rate. */
async function byGamepad(page: TestPage, degrees: number): Promise<void> {
  await page.evaluate(
    ({ way, turns }) => {
      const travel = window.windlass.link.latest("SceneDescription").tackle[0].brake_travel_time;
      const buttons = Array.from({ length: 16 }, () => ({ value: 0, pressed: false }));
      const stick = (axis: number) =>
        (window.pads = [{ connected: true, index: 0, id: "pad", mapping: "standard", axes: [0, 0, axis, 0], buttons }]);
      stick(way);
      setTimeout(() => stick(0), (1000 * turns * travel) / 5 / 0.1);
    },
    { way: Math.sign(degrees), turns: Math.min(0.2, Math.abs(degrees) / 360) },
  );
}
const hands: Record<string, Turn> = {
  "mouse's wheel": byMouse,
  "finger on the rim": byFinger,
  keys: byKeys,
  gamepad: byGamepad,
};

const look = (page: TestPage): Promise<Seen> =>
  page.evaluate(() => {
    const { cable_out_indicated, cable_speed_indicated } = window.windlass.link.latest("ForecastleView", 0);
    return { at: performance.now(), out: cable_out_indicated, speed: cable_speed_indicated };
  });
const brake = async (page: TestPage) => Number(await wheel(page).getAttribute("aria-valuenow")) / 100;
const erring = (degrees: number) => degrees * (1 + kErrs * (Math.random() + Math.random() + Math.random() - 1.5));

/** What came of a let-go: share of the fall that was held, top speed (m/s), metres beyond the mark. */
interface LetGo {
  held: number;
  top: number;
  off: number;
}

let gives = 0; // of the wheel's way, where the brake was found to give way: a hand remembers it
/** One let-go. */
async function letGo(rig: Rig, page: TestPage, turn: Turn): Promise<LetGo> {
  await rig.say("reset", "--timeout", "20");
  await rig.say("start", "--timeout", "20");
  await eventually("hard on", async () => (await brake(page)) > 0.99);
  await wheel(page).hover();
  // Open at a run to where the band is known to bear, or until the cable moves.
  await page.keyboard.down("ArrowDown");
  while ((await brake(page)) > gives && (await look(page)).speed < 0.3) await sleep(20);
  await page.keyboard.up("ArrowDown");
  gives = Math.max(gives, (await brake(page)) + 0.01);
  const seen: Seen[] = [];
  const all: Seen[] = [];
  let decided = -Infinity;
  for (const end = Date.now() + 60000; Date.now() < end; await sleep(30)) {
    const now = await look(page);
    seen.push(now);
    if (now.out > kFrom) all.push(now);
    const then = seen.findLast((one) => one.at <= now.at - kReaction);
    if (!then) continue;
    if (then.out + then.speed * 0.6 >= kMark) break; // it takes a while to stand
    if (now.at - decided < kDecides) continue;
    decided = now.at;
    const before = seen.findLast((one) => one.at <= then.at - 150) ?? then;
    const trend = then.at > before.at ? (1000 * (then.speed - before.speed)) / (then.at - before.at) : 0;
    const error = then.speed + 0.3 * trend - kAim;
    if (Math.abs(error) > 0.3) await turn(page, erring(Math.max(-40, Math.min(40, kPerSpeed * error))));
  }
  await page.keyboard.press("b");
  let stood = await look(page);
  await eventually("she stands", async () => Math.abs((stood = await look(page)).speed) < 0.02);
  const within = all.filter(({ speed }) => speed >= kHeld[0] && speed <= kHeld[1]);
  return {
    held: within.length / Math.max(1, all.length),
    top: Math.max(0, ...all.map(({ speed }) => speed)),
    off: stood.out - kMark,
  };
}

const rig = new Rig();
rig.server("let_go_port_25m");
const station = await rig.station("forecastle");
const page = await openPage(station.url.replace("#", "?picture=off#"), {
  hasTouch: true,
  init: () => {
    window.pads = [null];
    navigator.getGamepads = () => window.pads as unknown as Gamepad[];
  },
});
await eventually("the stand shows the windlass", () => page.locator(".counter strong").first().textContent());
console.log(`${cpus()[0].model}, ${cpus().length} cores, load ${loadavg()[0].toFixed(1)} at the start`);
console.log(
  "hand                tries  fall held  stopped at the mark  share of the fall held  top speed  off the mark",
);
for (const [name, turn] of Object.entries(hands)) {
  gives = 0;
  const came: LetGo[] = [];
  for (let k = 0; k < Number(tries); ++k) came.push(await letGo(rig, page, turn));
  const median = (of: (one: LetGo) => number): number =>
    came.map(of).sort((a, b) => a - b)[Math.floor(came.length / 2)];
  const held = came.filter((one) => one.held >= 0.8).length;
  const stopped = came.filter((one) => Math.abs(one.off) <= 2).length;
  console.log(
    `${name.padEnd(20)}${`${came.length}`.padEnd(7)}${`${held}`.padEnd(11)}${`${stopped}`.padEnd(21)}` +
      `${median((one) => one.held)
        .toFixed(2)
        .padEnd(24)}${median((one) => one.top).toFixed(1)} m/s    ` +
      `${median((one) => one.off).toFixed(1)} m`,
  );
}
await closeBrowser();
await rig.end();
