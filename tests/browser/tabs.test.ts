// What a panel listens to is what its page subscribes: each tab of each page of a lesson has its content, the marks and
// the assessor's word among them.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { after, before, describe, test } from "node:test";

import type { Locator } from "playwright-core";

import { type GatewayMessage, type PageOptions, type TestPage, closeBrowser, openPage, root } from "./browser";
import { hadNoProblems, passesAxe } from "./pages";
import { type Station, Rig, eventually } from "./rig";

const kExercise = "L01_let_go_25m";
const kNote = "the mate told him to, I saw it";
const rig = new Rig();
let criteria: { id: string }[];
let desk: Opened;
let stations: Record<"forecastle" | "bridge", Station>;

/** A page and what it subscribes, by the channels' names. */
interface Opened {
  page: TestPage;
  subscribed: string[];
}

const plan = { init: () => localStorage.setItem("windlass.views", "plan") };
const button = (name: string) => desk.page.getByRole("button", { name, exact: true });
const field = (name: string) => desk.page.getByLabel(name, { exact: true });
const figures = (text: string) => (text.match(/\d/g) ?? []).length;

/** Opens a page and keeps what it subscribes, by the channels' names. */
async function opened(url: string, options: PageOptions = {}): Promise<Opened> {
  const names = new Map<number, string>();
  const subscribed: string[] = [];
  const watch = (page: TestPage) =>
    page.on("websocket", (socket) => {
      socket.on("framereceived", ({ payload }) => {
        const message = typeof payload === "string" ? (JSON.parse(payload) as GatewayMessage) : undefined;
        for (const { id, topic } of message?.op === "advertise" ? message.channels : []) names.set(id, topic);
      });
      socket.on("framesent", ({ payload }) => {
        const message = JSON.parse(payload.toString()) as GatewayMessage;
        for (const { channelId } of message.op === "subscribe" ? message.subscriptions : [])
          subscribed.push(names.get(channelId));
      });
    });
  return { page: await openPage(url, { ...options, watch }), subscribed };
}

/** Opens each tab of a page and sees what it must have; content: a look by the tab's name, which gives true then. */
async function tour({ page, subscribed }: Opened, content: Record<string, (panel?: Locator) => Promise<unknown>>) {
  const tabs = await page.getByRole("tab").all();
  const seen: string[] = [];
  await eventually("the page is told of the exercise", () =>
    page.locator('.top-bar .state[data-state="RUN_RUNNING"]').count(),
  );
  await content.all?.();
  const before = [...subscribed].sort();
  for (const tab of tabs) {
    if (!(await tab.isVisible())) continue;
    const name = await tab.textContent();
    seen.push(name);
    assert.ok(content[name], `nobody looks what the tab "${name}" has`);
    await tab.click();
    const panel = page.locator(`#${await tab.getAttribute("aria-controls")}`);
    await eventually(`${name} has its content`, async () => (await panel.isVisible()) && content[name](panel));
  }
  assert.deepEqual(
    [...subscribed].sort(),
    before,
    "a panel that asks for its topic when it is looked at has nothing at first",
  );
  return seen;
}

before(
  async () => {
    const file = await readFile(join(root, `config/exercises/${kExercise}.json`), "utf8");
    ({ criteria } = (JSON.parse(file) as { lesson: { criteria: typeof criteria } }).lesson);
    rig.server(kExercise);
    const console = await rig.desk();
    stations = { forecastle: await rig.station("forecastle"), bridge: await rig.station("bridge") };
    desk = await opened(console.url, plan);
    await rig.say("fault", "load-cell-bias", "--severity", "0.5");
  },
  { timeout: 120000 },
);
after(async () => {
  await closeBrowser();
  await rig.end();
});

describe("each tab has its content", () => {
  test("on the instructor's desk", async () => {
    const seen = await tour(desk, {
      all: () =>
        eventually(
          "plots have figures",
          async () => figures(await desk.page.locator(".pane .legend").first().textContent()) > 0,
        ),
      Faults: async (panel) =>
        /active/.test(await panel.locator(".faults-given li[data-code=FAULT_LOAD_CELL_BIAS]").textContent()),
      Environment: async (panel) => figures(await panel.textContent()) > 10,
      Marks: async (panel) => (await panel.locator(".marks li").count()) === criteria.length,
      Levers: async (panel) =>
        figures(await panel.locator(".lever-card[data-what='0'] .now").first().textContent()) > 0,
      Truth: async (panel) => figures(await panel.locator("tbody tr").first().textContent()) > 1,
      Talk: async (panel) => /stand by/i.test(await panel.textContent()),
      Log: async (panel) => (await panel.locator(".log li").count()) > 0,
    });
    assert.equal(seen.length, 7, `${seen}`);
  });

  test("on the bridge", async () => {
    const bridge = await opened(stations.bridge.url);
    const readouts = () => bridge.page.locator(".instruments").textContent();
    const seen = await tour(bridge, {
      all: () => eventually("instruments have figures", async () => figures(await readouts()) > 10),
      Forecastle: async (panel) => /stand by/i.test(await panel.textContent()),
      "Anchor watch": async (panel) =>
        /Anchor ball: (down|up)/.test(await panel.textContent()) &&
        (await panel.locator("button", { hasText: "Plot: hawse now" }).first().isEnabled()),
    });
    assert.equal(seen.length, 2);
    hadNoProblems(bridge.page);
  });

  test("on the forecastle", async () => {
    const { page } = await opened(stations.forecastle.url.replace("#", "?picture=off#"));
    await eventually("the counter", () => page.locator(".counter strong").first().textContent());
    await eventually("the order", () => page.locator(".orders li", { hasText: "stand by" }).first().isVisible());
    await eventually("the log", async () => (await page.locator(".log li").count()) > 0);
    hadNoProblems(page);
  });
});

describe("the marks", () => {
  const row = (code: string) =>
    desk.page.locator(".marks li", { hasText: new RegExp(`^${code}( \\(must\\))?`) }).first();

  test("stand there with their criteria, and count", async () => {
    await desk.page.getByRole("tab", { name: "Marks" }).click();
    await eventually("points", async () =>
      /\d of 100 points/.test(await desk.page.locator(".marks-head").textContent()),
    );
    for (const { id } of criteria) await eventually(`${id} has a row`, () => row(id).isVisible());
    const offered = await field("criterion").locator("option").allTextContents();
    assert.deepEqual(
      offered,
      criteria.map(({ id }) => id),
    );
  });

  test("take the assessor's word, and show it with its note", async () => {
    await field("criterion").selectOption("lead");
    await field("verdict").selectOption("VERDICT_MET");
    await field("note").fill(kNote);
    await button("Set").filter({ visible: true }).click();
    await eventually("it stands", async () => (await row("lead").textContent()).includes("set by the assessor"));
    await eventually("with all its points", async () => /(\d+\.\d) of \1/.test(await row("lead").textContent()));
    await eventually("and its note", async () => (await row("lead").textContent()).includes(kNote));
    await eventually("beside what was computed", async () =>
      /\(computed /.test(await desk.page.locator(".marks-head").textContent()),
    );
    await passesAxe(desk.page);
  });

  test("stay when the lesson is over, with what came of it, and can still be spoken to", async () => {
    await rig.say("stop");
    await eventually("over", async () =>
      /not yet|not shown|achieved/.test(await desk.page.locator(".marks-head").textContent()),
    );
    assert.equal(await desk.page.locator(".marks li").count(), criteria.length);
    await field("criterion").selectOption("bottom");
    await field("verdict").selectOption("VERDICT_NOT_APPLICABLE");
    await field("note").fill(kNote);
    await button("Set").filter({ visible: true }).click();
    await eventually("it stands", async () => (await row("bottom").textContent()).includes("set by the assessor"));
    hadNoProblems(desk.page);
  });
});

test("a page of the station, which is of no exercise, subscribes nothing of one", async () => {
  const { page, subscribed } = await opened(
    desk.page.url().replace("/instructor", "/classroom") +
      `#token=${await desk.page.evaluate(() => sessionStorage.getItem("windlass.token"))}`,
  );
  await eventually("it has the exercise's tile", () => page.locator(".tile").count());
  assert.deepEqual([...subscribed].sort(), ["/ClassroomStatus", "/classroom/Event"]);
  assert.ok(!(await page.locator(".top-bar").textContent()).includes("running"));
  hadNoProblems(page);
});
