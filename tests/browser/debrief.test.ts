// From a recording to its debriefing by one click, and from a moment of that to the replay; the page by itself: can be
// read, needs nothing, fits a small screen and a sheet of paper.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtemp, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";

import type { Page } from "playwright-core";

import { type GatewayMessage, type TestPage, closeBrowser, closePage, openPage, root } from "./browser";
import { hadNoProblems, passesAxe } from "./pages";
import { type Station, Rig, eventually } from "./rig";

const recorder = join(process.env.WINDLASS_BIN ?? join(root, "build/release/bin"), "recorder");

let rig: Rig;
let desk: Station;
let page: TestPage;
let view: Page;
let folder: string, name: string;
before(async () => {
  folder = await mkdtemp(join(tmpdir(), "windlass_debrief_"));
  rig = new Rig();
  rig.server("let_go_port_25m", "--wait", "--time-scale", "4");
  desk = await rig.desk({ more: ["--recordings", folder] });
  page = await openPage(desk.url, {
    viewport: { width: 1600, height: 1000 },
    init: () => localStorage.setItem("windlass.views", "plan"),
  });
});
after(async () => {
  await closeBrowser();
  await rig.end();
  await rm(folder, { recursive: true, force: true });
});

test("what was recorded is talked over by one click", async () => {
  const debrief = page.getByRole("button", { name: "Debrief" }).first();
  await eventually("nothing was recorded yet", () => debrief.isDisabled());
  const rec = page.locator(".rec");
  await rec.click();
  await eventually("it records", async () => (await rec.getAttribute("aria-pressed")) === "true");
  name = (await rec.getAttribute("title")).match(/recording (\S+);/)[1];
  await eventually("the recorder hears", () => /recording partition/.test(desk.errors));
  await rig.say("start", "--timeout", "20");
  const levers = rig.console("levers", "--brake", "0", "--side", "port");
  await rig.truly("two shackles are out", ({ port }) => port?.chain?.cable_out > 55);
  await levers.stop("SIGINT");
  await rig.say("pause");
  await rec.click();
  await eventually("it can be talked over", () => debrief.isEnabled());
  [view] = await Promise.all([page.waitForEvent("popup"), debrief.click()]);
  await view.waitForURL(/\/debrief-[0-9a-f]{32}$/);
  assert.match(await view.locator("h1").textContent(), /^Debrief: /);
  assert.match(await view.locator("main").textContent(), /anchor let go/);
  assert.ok((await view.locator("svg").count()) >= 6, "plots and a track");
});

test("a key moment opens the replay there", async () => {
  const link = view.locator("#moments").locator("xpath=..").locator("tr", { hasText: "largest tension" }).locator("a");
  const wanted = Number(new URL(await link.getAttribute("href"), view.url()).searchParams.get("t"));
  assert.ok(wanted > 0);
  await link.click();
  await eventually("the replay's desk", () => view.url().includes("/instructor?exercise=replay-"));
  const place = async () =>
    (await view.locator(".replay-bar .place").textContent())
      .match(/^(\d+):(\d+) of/)
      .slice(1)
      .reduce((s, p) => 60 * s + Number(p), 0);
  await eventually("at that moment", async () => (await place()) === Math.floor(wanted + 1e-6));
  await view.locator(".replay-bar").getByRole("button", { name: "Debrief" }).click({ trial: true }); // there as well
  hadNoProblems(page);
});

test("a trainee's station gives no debriefing", async () => {
  const station = await rig.station("forecastle");
  const seat = await openPage(station.url);
  await eventually("it is open", async () => await seat.locator(".veil").isHidden());
  const refused = await seat.evaluate(
    ({ token, recording }) =>
      new Promise((done) => {
        const socket = new WebSocket(`ws://${location.host}/ws?token=${token}`, "windlass.v1");
        socket.onopen = () => socket.send(JSON.stringify({ op: "debrief", id: 1, recording }));
        socket.onmessage = ({ data }: MessageEvent<string | Blob>) => {
          const { op, allowed } = (typeof data === "string" ? JSON.parse(data) : {}) as GatewayMessage;
          if (op === "refused") done(allowed);
        };
      }),
    { token: new URL(station.url).hash.replace("#token=", ""), recording: name },
  );
  assert.equal(refused, "for an instructor");
  await closePage(seat);
});

test("the page by itself needs nothing, can be read, and fits", async () => {
  const file = join(folder, "page.html");
  const itself = join(folder, name);
  execFileSync(recorder, ["debrief", itself, "--over", itself, "--ghost", itself, "-o", file], { stdio: "ignore" });
  const alone = await openPage(pathToFileURL(file).href, { offline: true });
  const ghost = alone.locator("svg text.ghost").first();
  assert.ok(await ghost.isVisible(), "a ghost is behind the curves");
  await alone.getByLabel("out of sight").check();
  assert.ok(await ghost.isHidden(), "and can be put out of sight");
  await alone.getByLabel("in their own time").check();
  await passesAxe(alone);
  for (const summary of await alone.locator("summary").all()) await summary.click();
  await passesAxe(alone); // the tables behind the plots as well
  await alone.setViewportSize({ width: 320, height: 640 });
  assert.equal(
    await alone.evaluate(() => document.documentElement.scrollWidth),
    320,
    "nothing sideways but within plots and tables",
  );
  const levels = await alone.locator("h1, h2, h3").evaluateAll((all) => all.map((h) => Number(h.tagName[1])));
  levels.reduce((before, level) => (assert.ok(level <= before + 1, `${levels}`), level), 0);
  // Elements that a parser had to move or close by itself do not come back as they were written.
  const text = await alone.evaluate(async () => {
    const parsed = new DOMParser().parseFromString(document.documentElement.outerHTML, "text/html");
    return parsed.documentElement.outerHTML === document.documentElement.outerHTML;
  });
  assert.ok(text, "what is parsed again is the same");
  await alone.emulateMedia({ media: "print" });
  const pdf = await alone.pdf({ preferCSSPageSize: true });
  assert.match(pdf.toString("latin1"), /MediaBox\s*\[0 0 59[45]/, "A4");
  assert.deepEqual(alone.problems, []);
  await closePage(alone);
});
