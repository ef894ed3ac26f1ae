// The seats on a tablet, in both directions, and on a phone: nothing is cut off, every target is large enough for a finger,
// and two fingers work two controls at once.

import assert from "node:assert/strict";
import { mkdtemp, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { setTimeout as delay } from "node:timers/promises";
import { isDeepStrictEqual } from "node:util";

import { type TestPage, closeBrowser, closePage, openPage } from "./browser";
import { cutOff, hadNoProblems, passesAxe, smallTargets, unreachable } from "./pages";
import { Rig, eventually } from "./rig";

const kSizes: [number, number][] = [
  [1280, 800],
  [1180, 820],
  [1024, 768],
  [820, 1180],
  [768, 1024],
  [390, 844],
];

const rig = new Rig();
const urls: Record<string, string> = {};
const picture = process.env.WINDLASS_TOUCH_PICTURES; // a folder, to look at the pages

before(
  async () => {
    rig.server("L05_standing_moor"); // both windlasses
    const [forecastle, bridge] = [await rig.station("forecastle"), await rig.station("bridge")];
    await eventually("all pages are told", () => bridge.urls().length >= 2);
    for (const url of [...forecastle.urls(), ...bridge.urls()]) urls[new URL(url).pathname.slice(1)] = url;
  },
  { timeout: 180000 },
);
after(async () => {
  await closeBrowser();
  await rig.end();
});

async function open(name: string, [width, height] = kSizes[0]): Promise<TestPage> {
  const page = await openPage(urls[name].replace("#", "?picture=off#"), {
    viewport: { width, height },
    hasTouch: true,
    isMobile: true,
  });
  await eventually("it has heard of the exercise", async () => /\d/.test(await page.locator("main").textContent()));
  return page;
}

for (const name of ["forecastle", "bridge", "watch"])
  test(`the page ${name} is whole on a tablet and on a phone, and made for fingers`, async () => {
    const page = await open(name);
    const wrong: string[] = [];
    const look = async (where: string) => {
      for (const found of [unreachable, cutOff, smallTargets])
        wrong.push(...(await found(page)).map((what) => `${where}: ${what}`));
    };
    for (const [width, height] of kSizes) {
      const where = `${width}x${height}`;
      await page.setViewportSize({ width, height });
      const beyond = await page.evaluate(() => [
        document.documentElement.scrollWidth - innerWidth,
        document.querySelector("main").scrollWidth - document.querySelector("main").clientWidth,
      ]);
      assert.deepEqual(beyond, [0, 0], `${where}: nothing lies beside the screen`);
      await look(where);
      if (picture) await page.screenshot({ path: `${picture}/${name}_${where}.png` });
      for (const tab of await page.getByRole("tab", { selected: false }).all()) {
        await tab.evaluate((el: HTMLElement) => el.click());
        await look(`${where}, ${await tab.textContent()}`);
      }
    }
    assert.deepEqual([...new Set(wrong)], []);
    await passesAxe(page);
    hadNoProblems(page);
    await closePage(page);
  });

test("the door's pages are whole on a phone, and made for fingers", async () => {
  const folder = await mkdtemp(join(tmpdir(), "windlass-touch-"));
  const door = await rig.door(join(folder, "door"));
  const phone = { ignoreHTTPSErrors: true, viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };
  const page = await openPage(door.setup, phone);
  const wrong: string[] = [];
  const look = async (of: TestPage, where: string) => {
    for (const found of [unreachable, cutOff, smallTargets])
      wrong.push(...(await found(of)).map((what) => `${where}: ${what}`));
    assert.equal(await of.evaluate(() => document.documentElement.scrollWidth - innerWidth), 0, where);
    if (picture) await of.screenshot({ path: `${picture}/door_${where}.png` });
  };
  await page.locator("input[name=name]").fill("anna");
  for (const field of await page.locator("input[type=password]").all()) await field.fill("a long password");
  await look(page, "setup");
  await page.getByRole("button", { name: "Set up", exact: true }).click();
  await page.locator("select option").first().waitFor({ state: "attached" });
  await look(page, "new class");
  await page.locator("input[type=number]").fill("1");
  await page.getByRole("button", { name: "Open the class", exact: true }).click();
  const code = (await page.locator(".code-panel .letters").textContent()).replace(/ /g, "");
  await page.locator("[data-exercise]").first().waitFor();
  await look(page, "class");
  for (const name of ["people", "trust"]) {
    await page.goto(new URL(name, door.url).href);
    await page.locator("main :is(li, code)").first().waitFor();
    await look(page, name);
  }
  const trainee = await openPage(`${door.url}?code=${code}`, phone);
  await trainee.locator("input[name=name]").waitFor();
  await look(trainee, "join");
  await trainee.goto(new URL("login", door.url).href);
  await trainee.locator("input[name=password]").waitFor();
  await look(trainee, "login");
  assert.deepEqual(wrong, []);
  for (const each of [page, trainee]) {
    hadNoProblems(each);
    await closePage(each);
  }
  await door.stop();
  await rm(folder, { recursive: true, force: true });
});

/** A finger of a hand: its number, and where it is. */
type Finger = readonly [id: number, x: number, y: number];

/** What the fingers on a page's screen do, as the touch screen tells it; the rest of them goes on where it was. */
async function fingers(page: TestPage) {
  const session = await page.context().newCDPSession(page);
  const on = new Map<number, Finger>();
  const send = (type: "touchStart" | "touchMove" | "touchEnd") =>
    session.send("Input.dispatchTouchEvent", {
      type,
      touchPoints: [...on.values()].map(([id, x, y]) => ({ id, x, y })),
    });
  return {
    put: (...finger: Finger) => (on.set(finger[0], finger), send("touchStart")),
    move: (...finger: Finger) => (on.set(finger[0], finger), send("touchMove")),
    lift: (id: number) => (on.delete(id), send("touchEnd")),
  };
}
const boxOf = async (page: TestPage, name: string) => {
  const slider = page.getByRole("slider", { name, exact: true });
  await slider.scrollIntoViewIfNeeded();
  return slider.boundingBox();
};
type Box = Awaited<ReturnType<typeof boxOf>>;
/** On a wheel whose hub is at a share of its box's height: so many turns clockwise from the top. */
const onRim = ({ x, y, width, height }: Box, turns: number, hub = 0.5): [number, number] => {
  const radius = 0.35 * Math.min(width, height);
  return [
    x + width / 2 + radius * Math.sin(2 * Math.PI * turns),
    y + hub * height - radius * Math.cos(2 * Math.PI * turns),
  ];
};

test("on a phone the bar and the newest order are a line each, and lie over no control that is held", async () => {
  const page = await open("forecastle", [390, 844]);
  const box = (selector: string) => page.locator(selector).first().boundingBox();
  const orders = page.locator(".heard li");
  await rig.say("order", "let-go", "--side", "port");
  await rig.say("order", "hold-on", "6", "--side", "port");
  await eventually("both were heard", async () => (await orders.count()) >= 2);
  assert.ok(await orders.first().getByRole("button").isVisible(), "it can be repeated");
  assert.ok(await orders.first().locator(".spoken").isVisible());
  assert.equal(await orders.nth(1).isVisible(), false, "the newest alone");
  const [bar, line] = [await box(".top-bar"), await box(".heard")];
  assert.ok(bar.height + line.height < 0.15 * 844, `${bar.height} + ${line.height}`);

  await orders.first().locator(".spoken").tap();
  assert.ok(await orders.nth(1).isVisible(), "its words unfold all of them");
  await page.keyboard.press("Escape");
  assert.equal(await orders.nth(1).isVisible(), false);

  const briefing = page.getByRole("button", { name: "Briefing" });
  const stand = await box(".stand");
  assert.equal(await briefing.isVisible(), false);
  await page.getByRole("button", { name: "more buttons" }).tap();
  assert.ok(await briefing.isVisible());
  assert.deepEqual(await box(".stand"), stand, "nothing moves away from under a finger");
  assert.deepEqual(await cutOff(page), []);
  await page.keyboard.press("Escape");
  assert.equal(await briefing.isVisible(), false);

  // The wheel half under the line: it is above once it is in the hand.
  const atTheLine = () =>
    page.evaluate(() => {
      const wheel = document.querySelector(".controls .wheel");
      const line = document.querySelector(".heard").getBoundingClientRect();
      document.querySelector("main").scrollTop += wheel.getBoundingClientRect().top - line.top;
      const { left, right } = wheel.getBoundingClientRect();
      return wheel.contains(document.elementFromPoint((left + right) / 2, (line.top + line.bottom) / 2));
    });
  await boxOf(page, "brake hand-wheel");
  assert.equal(await atTheLine(), false, "the order lies over what is not touched");
  const hand = await fingers(page);
  const rim = await page.getByRole("slider", { name: "brake hand-wheel", exact: true }).boundingBox();
  await hand.put(1, ...onRim(rim, 0.5));
  await eventually("the wheel lies over it", atTheLine);
  await hand.lift(1);
  await eventually("and the order over the wheel again", async () => !(await atTheLine()));
  hadNoProblems(page);
  await closePage(page);
});

test("one finger heaves while another turns the brake, and each lets go of its own", async () => {
  const page = await open("forecastle", [1024, 768]);
  const hand = await fingers(page);
  // On a slow computer what is first told of the exercise comes while one looks, and takes its place.
  await eventually("the stand lies still", async () => {
    const before = await boxOf(page, "brake hand-wheel");
    await delay(1000);
    return isDeepStrictEqual(before, await boxOf(page, "brake hand-wheel"));
  });
  const lever = await boxOf(page, "speed lever");
  const rim = await boxOf(page, "brake hand-wheel");
  const x = lever.x + lever.width / 2;
  await hand.put(1, x, lever.y + lever.height / 2);
  await hand.move(1, x, lever.y + 5);
  await rig.truly("it heaves", ({ port }) => port.windlass.speed_lever > 0.99);
  await hand.put(2, ...onRim(rim, 0));
  for (let step = 1; step <= 6; ++step) {
    await hand.move(2, ...onRim(rim, -step / 60));
    await hand.move(1, x, lever.y + 5 + (step % 2)); // and trembles
  }
  await rig.truly(
    "the brake is a tenth of a turn off, and she heaves",
    ({ port: { windlass } }) => Math.abs(windlass.brake_position - 0.98) < 0.004 && windlass.speed_lever > 0.99,
  );
  assert.deepEqual(await boxOf(page, "brake hand-wheel"), rim, "what is said of it leaves it its size and place");
  assert.deepEqual(await boxOf(page, "speed lever"), lever);
  await hand.lift(2);
  await hand.move(1, x, lever.y + lever.height - 5);
  await rig.truly("it lowers", ({ port }) => port.windlass.speed_lever < -0.99);
  await hand.lift(1);
  await rig.truly(
    "it has sprung back, and the wheel is as it was left",
    ({ port: { windlass } }) => windlass.speed_lever === 0 && Math.abs(windlass.brake_position - 0.98) < 0.004,
  );
  hadNoProblems(page);
  await closePage(page);
});

test("one finger holds the bow thruster while another turns the wheel", async () => {
  const page = await open("bridge", [768, 1024]);
  const hand = await fingers(page);
  const bow = await boxOf(page, "Bow thruster");
  const wheel = await boxOf(page, "wheel");
  const y = bow.y + bow.height / 3;
  await hand.put(1, bow.x + bow.width / 2, y);
  await hand.move(1, bow.x + bow.width - 5, y);
  await hand.put(2, ...onRim(wheel, 0, 100 / 254));
  for (let step = 1; step <= 10; ++step) await hand.move(2, ...onRim(wheel, step / 60, 100 / 254));
  await hand.put(3, bow.x + 5, y); // a third that gets onto the lever moves nothing
  await hand.move(3, bow.x + 8, y);
  const helm = await rig.truly("both have come", ({ ship }) => ship.bow_thruster > 0.9 && ship.rudder > 0.25);
  assert.ok(helm.ship.rudder < 0.4, `${helm.ship.rudder}`); // 60 of the wheel's degrees are 18 of the rudder's
  await hand.lift(3);
  await hand.lift(2);
  await rig.truly("the thruster is still held", ({ ship }) => ship.bow_thruster > 0.9);
  await hand.lift(1);
  await rig.truly("it springs back, the wheel stays", ({ ship }) => ship.bow_thruster < 0.05 && ship.rudder > 0.25);
  hadNoProblems(page);
  await closePage(page);
});
