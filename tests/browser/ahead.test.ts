// A minute ahead: switched on at the desk, dotted in plots and plan, with its age and what comes; no seat hears of it.

import assert from "node:assert/strict";
import { mkdtemp, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";

import { type TestPage, closeBrowser, closePage, openPage } from "./browser";
import { hadNoProblems, passesAxe } from "./pages";
import { type Program, Rig, eventually } from "./rig";

const rig = new Rig();
let desk: TestPage, deck: TestPage;
let levers: Program;
let url: URL; // of the desk
let recordings: string;

/** Counts the points of each dotted line that is drawn, by where: "plan", or the plot's name. */
const countDots = () => {
  localStorage.setItem("windlass.views", "plan");
  window.dotted = {};
  const { prototype } = CanvasRenderingContext2D;
  const { beginPath, lineTo, stroke } = prototype;
  prototype.beginPath = function () {
    this.points = 0;
    return beginPath.call(this);
  };
  prototype.lineTo = function (...at) {
    this.points += 1;
    return lineTo.apply(this, at);
  };
  prototype.stroke = function (...path: [Path2D?]) {
    const [dot, gap] = this.getLineDash();
    const where = this.canvas.closest("[data-pane]")?.getAttribute("data-pane") ?? "plan";
    if (dot < 1 && gap >= 5) window.dotted[where] = Math.max(this.points, window.dotted[where] ?? 0);
    return stroke.apply(this, path as [Path2D]);
  };
};

/** ms until a processor has been idle for the second or so that a prediction takes. */
const kIdleAtLast = 480000;
const size = { viewport: { width: 1600, height: 900 }, init: countDots };
const dotted = () => desk.evaluate(() => window.dotted);
const forget = () =>
  desk.evaluate((): void => {
    window.dotted = {};
  });
const button = () => desk.getByRole("button", { name: "Ahead: if nobody does anything" });
const note = async () => (await desk.locator(".ahead .note").textContent()) ?? "";

before(async () => {
  rig.server("let_go_port_25m", "--wait");
  recordings = await mkdtemp(join(tmpdir(), "windlass-ahead-"));
  url = new URL((await rig.desk({ more: ["--recordings", recordings] })).url);
  const seat = await rig.station("forecastle");
  desk = await openPage(url.href, size);
  deck = await openPage(seat.url.replace("#", "?picture=off#"));
  await eventually("the switch is there", () => button().isVisible());
});
after(async () => {
  await rig.end();
  await closeBrowser();
  await rm(recordings, { recursive: true, force: true });
});

test("it is off until it is asked for, and then of an exercise that stands there is one", async () => {
  assert.equal(await button().getAttribute("aria-pressed"), "false");
  assert.deepEqual(await dotted(), {});
  await button().click();
  await eventually("on", async () => (await button().getAttribute("aria-pressed")) === "true");
  await eventually("its age is said", async () => /^made 0 s ago/.test(await note()), kIdleAtLast);
  await eventually(
    "dotted, a point for each second",
    async () => {
      const found = await dotted();
      const all = found.plan > 0 && ["loads", "speed", "out", "temperature"].every((pane) => found[pane] === 61);
      if (!all) throw new Error(JSON.stringify(found));
      return all;
    },
    kIdleAtLast,
  );
});

test("of a cable that runs it shows where that leads, and says what comes", async () => {
  const rec = desk.locator(".rec");
  await rec.click();
  await eventually("it records", async () => (await rec.getAttribute("aria-pressed")) === "true");
  await rig.say("start");
  levers = rig.console("levers", "--brake", "0");
  await rig.truly("the cable runs", ({ port }) => port.chain.cable_out > 200);
  await rig.say("pause"); // others may have the machine: what is ahead is of this moment whenever they leave it time
  const comes = await eventually(
    "what comes is said",
    async () => {
      const words = await note();
      if (!/; \d+:\d\d .*\w/.test(words)) throw new Error(words);
      return words;
    },
    kIdleAtLast,
  );
  assert.match(comes, /^made \d+ s ago/);
  await forget();
  await eventually("dotted", async () => (await dotted()).loads > 5);
  await desk.getByRole("button", { name: "1 min", exact: true }).click();
  await desk.waitForTimeout(1000);
  if (process.env.PICTURES)
    await desk.locator(".desk > .middle").screenshot({ path: `${process.env.PICTURES}/ahead.png` });
  await passesAxe(desk);
  await levers.stop();
});

test("no seat hears of it", async () => {
  const heard = await deck.evaluate(() => window.windlass.link.heardAt("Prediction"));
  assert.ok(!(heard > 0), `a prediction has come: ${heard}`);
  assert.equal(await deck.getByText("Ahead:").count(), 0);
});

test("nothing of it is shown to a room, and switched off it is gone", async () => {
  await desk.getByRole("button", { name: "Full screen" }).click();
  await eventually("before a room", () => desk.locator(".projecting").count());
  await desk.waitForTimeout(1500);
  await forget();
  await desk.waitForTimeout(1500);
  assert.deepEqual(await dotted(), {});
  await desk.getByRole("button", { name: "Full screen" }).click();
  await eventually("it is back", async () => (await dotted()).plan);
  await button().click();
  await eventually("off", async () => (await note()) === "");
  await desk.waitForTimeout(500);
  await forget();
  await desk.waitForTimeout(1500);
  assert.deepEqual(await dotted(), {});
});

test("a replay's desk draws what the instructor saw", async () => {
  const rec = desk.locator(".rec");
  const name = /recording (\S+);/.exec(await rec.getAttribute("title"))[1];
  await rec.click();
  await eventually("it has ended", async () => (await rec.getAttribute("aria-pressed")) === "false");
  hadNoProblems(desk);
  await closePage(desk);
  const partition = `replay-${rig.partition}`;
  rig.replay(join(recordings, name), partition);
  desk = await openPage(`${url.origin}/instructor?exercise=${partition}${url.hash}`, size);
  await eventually("it says REPLAY", async () => (await desk.locator(".top-bar .state").textContent()) === "REPLAY");
  await eventually("nobody switches it on now", () => button().isHidden());
  await desk.keyboard.press(" ");
  await eventually("it is said", async () => /^made \d+ s ago; .*\d:\d\d /.test(await note()));
  assert.ok((await eventually("dotted", async () => (await dotted()).out)) > 5);
  for (const page of [desk, deck]) hadNoProblems(page);
});
