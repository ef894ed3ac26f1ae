// The desk's timeline: what has happened in the attempt that runs, and nothing of one that was reset.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";

import { type TestPage, closeBrowser, openPage } from "./browser";
import { hadNoProblems } from "./pages";
import { Rig, eventually } from "./rig";

const rig = new Rig();
let desk: TestPage;

before(
  async () => {
    rig.server("let_go_port_25m", "--wait");
    desk = await openPage((await rig.desk()).url, { init: () => localStorage.setItem("windlass.views", "plan") });
  },
  { timeout: 180000 },
);
after(async () => {
  await closeBrowser();
  await rig.end();
});

const marks = async () => Number((await desk.locator(".timeline canvas").getAttribute("aria-label")).match(/\d+/)[0]);
const alerts = () => desk.locator(".alert-button").textContent();
const started = () => desk.locator('.log li[data-code="exercise.started"]').count();

test("an alert of an attempt that is reset is none of the next one's, though it is rectified only then", async () => {
  await rig.say("start", "--timeout", "20");
  await eventually("it runs", async () => (await started()) === 1);
  const fresh = await marks();
  await rig.say("watch-circle", "--radius", "10", "--x", "5000", "--y", "0", "--timeout", "20"); // far from the ship
  await eventually("an alert", async () => /1 warning/.test(await alerts()));
  await eventually("it is marked", async () => (await marks()) > fresh);
  await desk.evaluate(() => {
    window.told = 0;
    window.windlass.link.on("Alert", (alert) => (window.told += alert.raised_time > alert.time ? 1 : 0));
  });
  await rig.say("reset", "--timeout", "20");
  await rig.say("start", "--timeout", "20");
  await eventually("it is told once more", () => desk.evaluate(() => window.told > 0));
  await eventually("the next one runs", async () => (await started()) === 2);
  await desk.evaluate(() => new Promise((drawn) => setTimeout(drawn, 2000))); // the timeline is drawn each second
  assert.equal(await marks(), fresh);
  hadNoProblems(desk);
});
