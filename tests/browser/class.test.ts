// A class: twelve exercises on one server, an instructor, two trainees in one of them, forecastle and bridge, from the
// first order to the debriefing. The exercise runs at four times the wall's speed, so that it takes less than a minute.

import assert from "node:assert/strict";
import { mkdtemp, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";

import type { Page } from "playwright-core";

import { type TestPage, closeBrowser, openPage, root } from "./browser";
import { hadNoProblems, passesAxe } from "./pages";
import { type Station, Rig, eventually, sleep } from "./rig";

const kSeats = 12;
const rig = new Rig();
const ids = Array.from({ length: kSeats - 1 }, (_, i) => `${rig.partition}-seat-${i + 2}`);
let desk: Station;
let folder: string, recording: string;
let instructor: TestPage, deck: TestPage, bridge: TestPage;
let debriefing: Page;

const instructorAt = (path: string, query = "") => {
  const url = new URL(desk.url);
  return `${url.origin}${path}${query}${url.hash}`;
};
const tile = (id: string) => instructor.locator(`.tile[data-id='${id}']`);
const on = (page: TestPage, name: string) => page.getByRole("button", { name, exact: true });
/**
 * The order is given in this run, and repeated back by the forecastle's key; its list may still have an earlier
 * run's.
 */
const repeats = (order: string) =>
  eventually(`${order} is repeated`, async () => {
    const said = instructor.locator(".talk li.order", { hasText: order }).first();
    if ((await said.count()) === 0) return false;
    if ((await said.getAttribute("data-state")) === "ORDER_REPEATED") return true;
    await deck.keyboard.press("o");
    await sleep(500); // its way to the server and back
    return false;
  });
const talk = (words: string) =>
  eventually(words, async () => (await instructor.locator(".talk").textContent()).includes(words));

before(async () => {
  folder = await mkdtemp(join(tmpdir(), "windlass-class-"));
  const file = join(root, "config/exercises/L01_let_go_25m.json");
  rig.server(
    "L01_let_go_25m",
    "--wait",
    "--time-scale",
    "4",
    ...ids.flatMap((id) => ["--exercise", file, "--partition", id]),
  );
  desk = await rig.desk({ more: ["--recordings", folder] });
  const [forecastle, conning] = [await rig.station("forecastle"), await rig.station("bridge")];
  instructor = await openPage(instructorAt("/classroom"), {
    viewport: { width: 1600, height: 900 },
    init: () => localStorage.setItem("windlass.views", "plan"),
  });
  deck = await openPage(forecastle.url.replace("#", "?picture=off#"));
  bridge = await openPage(conning.url);
});
after(async () => {
  await closeBrowser();
  await rig.end();
  await rm(folder, { recursive: true, force: true });
});

test("the classroom has a tile of each of twelve exercises, ready", async () => {
  await eventually("twelve", async () => (await instructor.locator(".tile").count()) === kSeats);
  for (const id of [rig.partition, ...ids])
    await eventually(`${id} is ready`, async () => (await tile(id).locator(".state").textContent()) === "ready");
  await passesAxe(instructor);
});

test("an alert of one of them stands on its tile, and leads to its desk", async () => {
  await rig.say("watch-circle", "--radius", "10", "--x", "5000", "--y", "0", "--timeout", "20"); // far from the ship
  await rig.say("start", "--timeout", "20");
  const alert = tile(rig.partition).locator(".tile-alert", { hasText: "Outside anchor circle" });
  await eventually("it is told, with its priority", async () =>
    /^warning: Outside anchor circle, 0:/.test(await alert.textContent()),
  );
  assert.equal(await alert.getAttribute("data-priority"), "warning");
  for (const id of ids) assert.ok(await tile(id).locator(".tile-alert").isHidden(), `${id} has none`);
  await passesAxe(instructor);
  await alert.click();
  await instructor.waitForURL((url) => url.searchParams.get("exercise") === rig.partition);
  await eventually("its desk", async () =>
    (await instructor.locator(".truth tbody tr").first().textContent()).includes("m"),
  );
  await rig.say("alerts", "acknowledge", "watch.circle", "--timeout", "20");
  await rig.say("watch-circle", "--off", "--timeout", "20");
  await rig.say("reset", "--timeout", "20");
  await instructor.goto(instructorAt("/classroom"));
  await eventually("the tile is there", async () => (await tile(rig.partition).count()) === 1);
  await eventually("acknowledged and over, it is gone", () => alert.isHidden());
});

test("it is recorded, and starts; the lesson's order is heard on the forecastle, repeated and carried out", async () => {
  await instructor.goto(instructorAt("/instructor", `?exercise=${rig.partition}`));
  const rec = instructor.locator(".rec");
  await rec.click();
  await eventually("it records", async () => (await rec.getAttribute("aria-pressed")) === "true");
  recording = (await rec.getAttribute("title")).match(/recording (\S+);/)[1];
  await eventually("the recorder hears", () => /recording partition/.test(desk.errors));
  await eventually("ready to start", () => on(instructor, "Start").isEnabled());
  // The lesson's bridge gives up after nine minutes of exercise without an answer: at four times real time a busy
  // machine needs as long to press a button.
  await rig.say("time-scale", "1", "--timeout", "20");
  await on(instructor, "Start").click();
  await repeats("stand by");
  await deck.locator(".reports").getByRole("button", { name: "Standing by", exact: true }).click();
  await talk("standing by");
  await repeats("let go");
  await deck.locator(".owner").waitFor();
  await deck.keyboard.press("0"); // the wheel spun open
  await rig.truly("a shackle is out", ({ port }) => port?.chain?.cable_out > 27.5);
  await deck.keyboard.press("b");
  await deck.locator(".reports").getByRole("button", { name: "Let go", exact: true }).click();
  await rig.truly("she is checked", ({ port }) => port.windlass.brake_position > 0.95);
});

test("the bridge has heard what the forecastle reported, and not what the instructor knows", async () => {
  await eventually("the report", async () => /let go/.test(await bridge.locator("body").textContent()));
  assert.equal((await bridge.locator(".truth").count()) + (await deck.locator(".truth").count()), 0);
});

test("it is ended, and talked over with pictures of what was recorded", async () => {
  await rig.say("pause", "--timeout", "20");
  await instructor.locator(".rec").click();
  const button = on(instructor, "Debrief").first();
  await eventually("it can be talked over", () => button.isEnabled());
  [debriefing] = await Promise.all([instructor.waitForEvent("popup"), button.click()]);
  await debriefing.waitForURL(/\/debrief-[0-9a-f]{32}$/);
  const text = await debriefing.locator("main").textContent();
  assert.ok(text.includes(recording), "which recording it is of");
  for (const words of ["Let go the port anchor, 25 m", "of 100 points", "anchor let go", "stand by", "forecastle-1"])
    assert.ok(text.includes(words), words);
  assert.ok((await debriefing.locator("[aria-labelledby=scenes] svg .cable").count()) > 4, "the cable in pictures");
  await passesAxe(debriefing);
  for (const page of [instructor, deck, bridge]) hadNoProblems(page);
});
