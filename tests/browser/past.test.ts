// What was, for a page that comes late: plots, track, reports and the anchor plotted by them; and what a restore has
// left.

import assert from "node:assert/strict";
import { mkdtemp, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";

import { type TestPage, closeBrowser, closePage, openPage } from "./browser";
import { hadNoProblems } from "./pages";
import { type Station, Rig, eventually } from "./rig";

const rig = new Rig();
let desk: Station, bridge: Station, forecastle: Station;
let recordings: string, recording: string;
let early: Record<"desk" | "bridge" | "forecastle", TestPage>; // pages that were there from the beginning
let stood: number; // s, exercise time at which it was paused
const half = () => (0.5 * stood) / 300; // share of the plots, which show 5 min, that is half of that
const curve: { time: number; out: number }[] = []; // what the early desk plots: time (s), cable out (m), which grows only

/** What is written and drawn on canvases: texts, and how many points the longest thin line has, as a track is. */
const watchCanvas = () => {
  localStorage.setItem("windlass.views", "plan");
  localStorage.setItem("windlass.plots", "loads,speed,out,temperature,motor,levers,holding,dragged,ship,heading");
  window.written = new Set();
  window.trackPoints = 0;
  const { prototype } = CanvasRenderingContext2D;
  const { fillText, beginPath, lineTo, stroke } = prototype;
  prototype.fillText = function (text, ...at) {
    window.written.add(text);
    return fillText.call(this, text, ...at);
  };
  prototype.beginPath = function () {
    this.points = 0;
    return beginPath.call(this);
  };
  prototype.lineTo = function (...at) {
    this.points += 1;
    return lineTo.apply(this, at);
  };
  prototype.stroke = function (...path: [Path2D?]) {
    if (this.canvas.closest(".plan-view") && this.lineWidth === 1.5 && !this.getLineDash().length)
      window.trackPoints = Math.max(window.trackPoints, this.points);
    return stroke.apply(this, path as [Path2D]);
  };
};

const size = { viewport: { width: 1920, height: 1080 }, init: watchCanvas };
const open = {
  desk: () => openPage(desk.url, size),
  bridge: () => openPage(bridge.url),
  forecastle: () => openPage(forecastle.url.replace("#", "?picture=off#")),
};
const clock = async (page: TestPage) =>
  (await page.locator(".top-bar .time").textContent()).split(":").reduce((s, p) => 60 * s + Number(p), 0);

/** The figures that all plots show at a share of their width, by pane and label. */
async function plotted(page: TestPage, share: number) {
  const over = page.locator(".pane[data-pane=loads] .u-over");
  const { width, height } = await over.boundingBox();
  await over.hover({ position: { x: share * width, y: height / 2 } });
  return page.evaluate(() =>
    Object.fromEntries(
      [...document.querySelectorAll<HTMLElement>(".pane")].flatMap((pane) =>
        [...pane.querySelectorAll(".legend")].map((legend) => {
          const value = legend.querySelector("b").textContent;
          return [
            `${pane.dataset.pane}: ${legend.textContent.replace(value, "")}`,
            Number(value.replace("\u2212", "-")),
          ];
        }),
      ),
    ),
  );
}

before(
  async () => {
    recordings = await mkdtemp(join(tmpdir(), "windlass-past-"));
    rig.server("let_go_port_25m", "--wait", "--time-scale", "2");
    [desk, bridge, forecastle] = [
      await rig.desk({ more: ["--recordings", recordings] }),
      await rig.station("bridge"),
      await rig.station("forecastle"),
    ];
    early = { desk: await open.desk(), bridge: await open.bridge(), forecastle: await open.forecastle() };
    for (const page of Object.values(early))
      await eventually("it is ready", async () => /ready/.test(await page.locator(".top-bar .state").textContent()));
    await early.desk.locator(".rec").click();
    await eventually(
      "it records",
      async () => (await early.desk.locator(".rec").getAttribute("aria-pressed")) === "true",
    );
    rig.script("let_go_port_25m");
    await rig.say("start");
    await eventually(
      "2 shackles are reported",
      () => early.bridge.locator(".said li", { hasText: "2 shackles in the water" }).isVisible(),
      240000,
    );
    await rig.say("pause");
    recording = (await early.desk.locator(".rec").getAttribute("title")).match(/recording (\S+);/)[1];
    await early.desk.locator(".rec").click();
    await eventually(
      "it has recorded",
      async () => (await early.desk.locator(".rec").getAttribute("aria-pressed")) === "false",
    );
    stood = (await rig.truly("it stands", ({ status }) => status.state === "RUN_PAUSED")).status.time;
  },
  { timeout: 400000 },
);
after(async () => {
  await closeBrowser();
  await rig.end();
  await rm(recordings, { recursive: true, force: true });
});

test("a desk that is opened late plots what was since the beginning, as one that was there", async () => {
  const late = await open.desk();
  for (const page of [early.desk, late])
    await eventually("it plots", async () => Math.abs((await clock(page)) - stood) <= 1);
  await eventually("both draw the same stretch", async () => !Number.isNaN((await plotted(late, 0.05))["out: out"]));
  for (let k = 0; k <= 10; ++k)
    curve.push({ time: (k / 10) * stood, out: (await plotted(early.desk, ((k / 10) * stood) / 300))["out: out"] });
  for (const at of [0.5 * half(), half(), 1.5 * half()]) {
    const [then, told] = [await plotted(early.desk, at), await plotted(late, at)];
    for (const [what, value] of Object.entries(then)) {
      if (Number.isNaN(value)) continue;
      assert.ok(!Number.isNaN(told[what]), `${what}: nothing at ${at}, it was ${value}`);
    }
    // A sample a second: the cable runs at 6 m/s at most.
    assert.ok(
      Math.abs(then["out: out"] - told["out: out"]) < 7,
      `${then["out: out"]} m and ${told["out: out"]} m were out`,
    );
    assert.ok(Object.values(then).filter((value) => !Number.isNaN(value)).length >= 15, JSON.stringify(then));
  }
  await eventually("the track is long", async () => (await late.evaluate(() => window.trackPoints)) > 10);
  await eventually("it is marked where she let go", () => late.evaluate(() => window.written.has("P let go")));
  await eventually("the report stands beside the truth of then", async () =>
    /let go.*was /s.test(await late.locator(".talk li.report", { hasText: "let go" }).textContent()),
  );
  assert.equal(await late.locator(".talk li.report", { hasText: "2 shackles in the water" }).count(), 1);
  const times = async (page: TestPage) => page.locator(".talk li.report time").allTextContents();
  assert.deepEqual(await times(late), await times(early.desk));
  hadNoProblems(late);
  await closePage(late);
  await closePage(early.desk); // what it draws costs the others their time
});

test("a replay plots what was up to the moment that is shown, wherever it was opened, and nothing of what came after", async () => {
  const partition = `replay-${rig.partition}`;
  rig.replay(join(recordings, recording), partition);
  const { origin, hash } = new URL(desk.url);
  const page = await openPage(`${origin}/instructor?exercise=${partition}${hash}`, size);
  await eventually("it says REPLAY", async () => (await page.locator(".top-bar .state").textContent()) === "REPLAY");
  const scrubber = page.getByLabel("position in the recording, s", { exact: true });
  const duration = await eventually(
    "it has a length",
    async () => Number(await scrubber.getAttribute("max")) > 1 && Number(await scrubber.getAttribute("max")),
  );
  const seek = async (position: number) => {
    await scrubber.fill(`${position}`);
    await eventually(`it stands at ${position}`, async () => Number(await scrubber.inputValue()) === position);
  };
  /** The plots show at a share of their width what the early desk's showed at a time, s. */
  const shows = (share: number, when: () => number | Promise<number>) =>
    eventually(`what was then is plotted at ${share}`, async () => {
      const { "out: out": out } = await plotted(page, share);
      const time = await when();
      const least = curve.findLast((point) => point.time <= time - 2)?.out ?? 0;
      const most = curve.find((point) => point.time >= time + 2)?.out ?? Infinity;
      assert.ok(out >= least - 1 && out <= most + 1, `${out} m, not ${least} to ${most}`);
      return true;
    });
  await seek(Math.floor(duration));
  await shows(half(), () => stood / 2);
  await eventually("the track is long", async () => (await page.evaluate(() => window.trackPoints)) > 5);
  await eventually("it is marked where she let go", () => page.evaluate(() => window.written.has("P let go")));
  for (const part of [0.75, 0.5, 0.9]) {
    await seek(Math.floor(part * duration));
    await shows(0.99, () => clock(page)); // the last that is plotted
  }
  hadNoProblems(page);
  await closePage(page);
});

test("a bridge page that is opened late has the reports, and plots the anchor where it was let go", async () => {
  const late = await open.bridge();
  const reports = (page: TestPage) => page.locator('.said li[data-kind="report"] .text').allTextContents();
  await eventually("the same reports", async () => {
    assert.deepEqual(await reports(late), await reports(early.bridge));
    return true;
  });
  assert.ok((await reports(late)).some((text) => text.includes("let go")));
  const anchor = (page: TestPage) => page.getByRole("group", { name: "port anchor" });
  for (const page of [early.bridge, late]) {
    await page.getByRole("tab", { name: "Anchor watch" }).click();
    await anchor(page).getByRole("button", { name: "plot the port anchor" }).click();
    await eventually("plotted, with the cable that was reported", () =>
      anchor(page)
        .getByText(/plotted at .*swings \d+ m/)
        .isVisible(),
    );
  }
  const plottedAt = async (page: TestPage) =>
    (
      await anchor(page)
        .getByText(/plotted at/)
        .textContent()
    )
      .match(/plotted at (\S+); swings (\d+) m/)
      .slice(1);
  const [[time, swing], [lateTime, lateSwing]] = [await plottedAt(early.bridge), await plottedAt(late)];
  const seconds = (text: string) => text.split(":").reduce((s, p) => 60 * s + Number(p), 0);
  assert.equal(swing, lateSwing);
  assert.ok(Math.abs(seconds(time) - seconds(lateTime)) <= 1, `${time} and ${lateTime}`);
  hadNoProblems(late);
  await closePage(late);
});

test("what a restore has left is struck out on forecastle and bridge, as on the desk; a late page is not told it", async () => {
  await rig.say("restore", "15");
  const state = (await rig.truly("it is restored", ({ status }) => status.time < 20 && status.state === "RUN_PAUSED"))
    .status.time;
  const struckOut = (page: TestPage, list: string) =>
    page.locator(list).evaluateAll(
      (lines, state) =>
        lines.map((line) => {
          const [minutes, seconds] = line.querySelector("time, .time").textContent.split(":").slice(-2).map(Number);
          const struck = getComputedStyle(line.querySelector(".text")).textDecorationLine === "line-through";
          return { later: 60 * minutes + seconds > state, struck, text: line.textContent };
        }),
      state,
    );
  for (const [page, list] of [
    [early.forecastle, ".noticed .log li"],
    [early.bridge, '.said li:not([data-kind="order"])'],
  ] as const) {
    await eventually("something was left", async () => (await struckOut(page, list)).some(({ later }) => later));
    await eventually("all of that and nothing else is struck out", async () =>
      (await struckOut(page, list)).every(({ later, struck }) => later === struck),
    );
  }
  const late = await open.bridge();
  await eventually("it has the notices", async () =>
    /paused/.test(await late.locator(".top-bar .state").textContent()),
  );
  assert.equal(await late.locator(".said li", { hasText: "2 shackles in the water" }).count(), 0);
  // She had let go by then, and nobody had reported how much was out.
  await eventually("the plot is of then", () =>
    early.bridge
      .getByRole("group", { name: "port anchor" })
      .getByText(/plotted at .*; cable not reported/)
      .isVisible(),
  );
  await closePage(late);
});
