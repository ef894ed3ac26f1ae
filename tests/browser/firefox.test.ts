// Firefox: a trainee joins by code through the door, lets go by mouse, and is back in the seat after a reload; at the
// desk's, the tablet's and the phone's size.

import assert from "node:assert/strict";
import { mkdtemp, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";

import { type TestPage, closeBrowser, inFirefox, openPage } from "./browser";
import { firstOwner, hadNoProblems, openClass, passesAxe } from "./pages";
import { Rig, eventually, sleep } from "./rig";

inFirefox();
const rig = new Rig();
const picture = process.env.WINDLASS_FIREFOX_PICTURES; // a folder, to look at the pages
const tls = { ignoreHTTPSErrors: true }; // its authority is nobody's yet
let folder: string, code: string;
let door: Awaited<ReturnType<Rig["door"]>>;
let owner: TestPage, deck: TestPage;
let exercise: Rig; // that of the class

const on = (page: TestPage, name: string) => page.getByRole("button", { name, exact: true });
const look = async (page: TestPage, name: string) => {
  if (picture) await page.screenshot({ path: join(picture, `${name}.png`) });
};
const wheel = () => deck.getByRole("slider", { name: "brake hand-wheel" });
const lever = () => deck.getByRole("slider", { name: "speed lever" });
const setBrake = async () => Number(await wheel().getAttribute("aria-valuenow")) / 100;
/** What the instructor's page says of the class's one exercise. */
const row = () => owner.locator("[data-exercise]").first().textContent();
/** The order comes, and is repeated back by its button. */
async function repeats(order: string) {
  const given = deck.locator(".orders li", { hasText: order }).first();
  await given.getByRole("button", { name: /^repeat back/ }).click();
  await eventually(`${order} is repeated`, async () => (await given.getAttribute("data-state")) === "ORDER_REPEATED");
}

before(
  async () => {
    folder = await mkdtemp(join(tmpdir(), "windlass-firefox-"));
    rig.server("L01_let_go_25m", "--wait");
    door = await rig.door(join(folder, "door"));
  },
  { timeout: 180000 },
);
after(async () => {
  await closeBrowser();
  await exercise?.end();
  await rig.end();
  await rm(folder, { recursive: true, force: true });
});

test("a class is opened in it", async () => {
  owner = await firstOwner(door.setup);
  code = await openClass(owner, 1, 2);
  await eventually("its exercise is there", async () => /ready/.test(await row()));
  exercise = new Rig(await owner.locator("[data-exercise]").first().getAttribute("data-exercise"));
});

test("a trainee joins by its code, sits on the forecastle, and sees it drawn or why it is not", async () => {
  deck = await openPage(`${door.url}?code=${code}`, tls);
  await deck.locator("input[name=name]").fill("ben");
  await on(deck, "Take a seat").click();
  await deck.waitForURL(/\/forecastle$/);
  await eventually("the instructor sees it", async () => /ben.*at the page/s.test(await row()));
  await deck.getByRole("dialog", { name: "briefing" }).getByRole("button").last().click();
  // By software Firefox has no WebGL 2 without a display; a page without it says so and works on.
  await eventually(
    "links, deck and sea are drawn, or why not",
    async () =>
      (await deck.evaluate(() => window.windlass.stats()?.triangles > 10000)) ||
      (await deck.getByText("This browser draws no WebGL picture; the stand works without it.").isVisible()),
  );
  await look(deck, "forecastle_1280");
  await passesAxe(deck);
});

test("orders are repeated back, the anchor is let go with the hand-wheel by mouse, and reports are heard", async () => {
  await on(owner, "Start all").click();
  await repeats("stand by");
  await on(deck, "Standing by").click();
  await repeats("let go");
  const { x, y, width, height } = await wheel().boundingBox();
  const at = (turns: number): [number, number] => [
    x + width / 2 + 0.4 * width * Math.sin(2 * Math.PI * turns),
    y + height / 2 - 0.4 * width * Math.cos(2 * Math.PI * turns),
  ];
  const before = await setBrake();
  await deck.mouse.move(...at(0));
  await deck.mouse.down();
  for (let step = 1; step <= 60; ++step) {
    await deck.mouse.move(...at(-step / 24));
    await sleep(60); // slower than the wheel may be turned
  }
  await deck.mouse.up();
  const set = await setBrake();
  assert.ok(set < before - 0.2, `the wheel is turned off, from ${before} to ${set}`);
  await exercise.truly("the brake follows", ({ port }) => Math.abs(port.windlass.brake_position - set) < 0.02);
  await exercise.truly("the anchor falls", ({ port }) => port.chain.cable_out > 20);
  await on(deck, "Let go").click();
  await on(deck, "Hard on").click();
  await exercise.truly("she is checked", ({ port }) => port.windlass.brake_position > 0.99);
  await look(deck, "forecastle_let_go");
  await eventually("the report was heard", async () =>
    /reported: port anchor is let go/.test(await deck.locator(".log").textContent()),
  );
});

test("the speed lever follows the mouse, and springs back", async () => {
  const { x, y, width, height } = await lever().boundingBox();
  const middle = y + height / 2;
  await deck.mouse.move(x + width / 2, middle);
  await deck.mouse.down();
  await deck.mouse.move(x + width / 2, middle - 0.52 * (height / 2 - 22), { steps: 4 });
  await exercise.truly("half speed", ({ port }) => Math.abs(port.windlass.speed_lever - 0.5) < 0.02);
  await deck.mouse.up();
  await exercise.truly("zero", ({ port }) => port.windlass.speed_lever === 0);
});

test("loaded anew it is in its seat again, with what it had set", async () => {
  await deck.reload();
  await eventually("the exercise is heard", async () => /running/.test(await deck.locator(".top-bar").textContent()));
  assert.match(deck.url(), /\/forecastle$/);
  await eventually("the rim is hard on", async () => (await setBrake()) > 0.99);
});

test("nothing lies beside the screen of a tablet or a phone", async () => {
  for (const [width, height] of [
    [1024, 768],
    [390, 844],
  ]) {
    await deck.setViewportSize({ width, height });
    await look(deck, `forecastle_${width}`);
    await owner.setViewportSize({ width, height });
    await look(owner, `class_${width}`);
    for (const page of [deck, owner])
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth), 0, page.url());
  }
  hadNoProblems(deck);
  hadNoProblems(owner);
});
