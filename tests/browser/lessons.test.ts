// The page of lessons, as an instructor uses it who writes no JSON: a shipped lesson opened, a limit changed, a mistake
// told at its field, saved under another name, loaded; and nothing for a trainee.

import assert from "node:assert/strict";
import { cp, mkdtemp, readFile, readdir, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";

import type { Locator } from "playwright-core";

import { type GatewayMessage, type TestPage, closeBrowser, closePage, openPage, root } from "./browser";
import { hadNoProblems, holdDown, passesAxe } from "./pages";
import { type Station, Rig, eventually } from "./rig";

const kSource = "L01_let_go_25m";
const rig = new Rig();
let desk: Station;
let page: TestPage;
let config: string, folder: string;

const at = (pointer: string) => page.locator(`[data-at="${pointer}"]`);
const section = (name: string) => page.locator(".sections").getByRole("button", { name }).first();
const shows = async (locator: Locator, words: string) => (await locator.first().textContent()).includes(words);
const sound = () =>
  eventually("sound", async () => {
    const told = await page.locator(".verdict, .told li").allTextContents();
    if (told[0] !== "Sound.") throw new Error(told.join("; "));
    return true;
  });
/** What is looked at of a file that was saved. */
interface Saved {
  title: string;
  lesson: { criteria: { max: number; weight: number }[]; orders: object[] };
  seats: { forecastle: { fitted: string[] } };
  environment: { wind_speed: number };
}
const saved = async (name: string) => JSON.parse(await readFile(join(folder, `${name}.json`), "utf8")) as Saved;

before(async () => {
  config = await mkdtemp(join(tmpdir(), "windlass-lessons-"));
  await cp(join(root, "config"), config, { recursive: true });
  folder = join(config, "exercises");
  rig.server(kSource, "--wait", "--config-root", config);
  desk = await rig.desk({ more: ["--exercises", folder] });
  const url = new URL(desk.url);
  page = await openPage(`${url.origin}/lessons${url.hash}`, { viewport: { width: 1600, height: 1000 } });
  await eventually("the lessons are listed", () => page.locator(`.files button[data-name=${kSource}]`).isVisible());
});
after(async () => {
  await closeBrowser();
  await rig.end();
  await rm(config, { recursive: true, force: true });
});

test("the box for practice stands beside its words", async () => {
  const box = await page.getByLabel("for practice, with hints").boundingBox();
  assert.ok(box.width < 30, `${box.width}`); // its label's words follow at a gap
});

test("a shipped lesson opens as a form made of its schema, with what it takes over", async () => {
  await page.locator(`.files button[data-name=${kSource}]`).click();
  await sound();
  await eventually("its briefing", async () =>
    (await at("/lesson/briefing").locator("textarea").inputValue()).startsWith("Bulk carrier"),
  );
  await section("environment").click();
  const depth = at("/environment/depth").locator("input");
  await eventually(
    "the depth of the exercise that it begins with",
    async () => (await depth.getAttribute("placeholder")) === "25",
  );
  assert.equal(await depth.inputValue(), "");
  await passesAxe(page);
});

test("a limit is changed, and what stands beside it is said in the trade's units", async () => {
  await section("criteria").click();
  const card = at("/lesson/criteria/2");
  await card.locator("summary").click();
  const max = at("/lesson/criteria/2/max");
  await max.locator("input").fill("2.5");
  await eventually("as the counter shows it", () => shows(max, "150 m/min"));
  await sound();
});

test("a mistake is told at its field, as lesson check tells it, and is gone when it is mended", async () => {
  const field = at("/lesson/criteria/2/fail_above");
  await field.locator("input").fill("1");
  await eventually("told at the field", () => shows(field.locator(".mistake"), "lies within the limit"));
  await eventually("and above, with its place", () =>
    shows(page.locator(".told li"), "lesson, criteria 3 (pay-out), fail above"),
  );
  await eventually("and in the bar", async () => (await section("criteria").locator(".count").textContent()) === "1");
  await passesAxe(page);
  await page.getByLabel("file name").fill("unsound");
  await page.getByRole("button", { name: "Save as new" }).click();
  await eventually("not saved", () => shows(page.locator(".notice"), "Not saved"));
  assert.ok(!(await readdir(folder)).includes("unsound.json"));
  await section("orders").click(); // the mistake leads back to its field
  await page.locator(".told button").first().click();
  await eventually("the field is in sight", () => field.isVisible());
  await field.locator("input").fill("5");
  await sound();
});

test("a word where a figure belongs is told as well, and nothing that was typed is lost", async () => {
  const weight = at("/lesson/criteria/2/weight");
  await weight.locator("input").fill("fifteen");
  await eventually("told", () => shows(weight.locator(".mistake"), "a whole number"));
  await page.reload();
  await eventually(
    "still there",
    async () => (await at("/lesson/criteria/2/weight").locator("input").inputValue()) === "fifteen",
  );
  await eventually("and told again", () => shows(page.locator(".verdict"), "1 mistake"));
  await section("criteria").click();
  await at("/lesson/criteria/2").locator("summary").click();
  await weight.locator("input").fill("20");
  await sound();
});

test("orders, faults and weather are added by choosing, and the form offers the names that there are", async () => {
  await section("orders").click();
  await page.getByRole("button", { name: "orders: add an entry" }).click();
  const order = at("/lesson/orders/9");
  await eventually(
    "a new one, with a mistake: it has no name",
    async () => (await at("/lesson/orders/9/id").locator(".mistake").count()) === 1,
  );
  await at("/lesson/orders/9/id").locator("input").fill("how-much");
  await at("/lesson/orders/9/code").locator("select").selectOption({ label: "how much" });
  await order
    .getByLabel(/: add a field/)
    .first()
    .selectOption("when");
  await at("/lesson/orders/9/when")
    .getByLabel(/add a field/)
    .selectOption("moment");
  const offered = await at("/lesson/orders/9/when/moment").locator("option").allTextContents();
  assert.deepEqual(offered.slice(1), ["let-go", "bottom", "brought-up"]);
  await at("/lesson/orders/9/when/moment").locator("select").selectOption("brought-up");
  await section("faults").click();
  await page.getByRole("button", { name: "faults: add an entry" }).first().click();
  await at("/lesson/faults/0/code").locator("input").fill("brake-lining-fadet");
  await eventually("the nearest name is told", () =>
    shows(at("/lesson/faults/0/code").locator(".mistake"), "brake-lining-faded"),
  );
  await at("/lesson/faults/0/code").locator("input").fill("brake-lining-faded");
  await section("environment").click();
  await at("/environment/wind_speed").locator("input").fill("12");
  await section("seats").click();
  await at("/seats")
    .getByLabel(/add a field/)
    .or(page.getByLabel("seats: add a field"))
    .first()
    .selectOption("forecastle");
  await page.getByLabel("seats: forecastle: add a field").selectOption("fitted");
  await at("/seats/forecastle/fitted").getByLabel("load cell").uncheck();
  await sound();
});

test("it is saved under a new name only where none has it, lesson list shows it, and it can be loaded", async () => {
  const before = await readFile(join(folder, `${kSource}.json`), "utf8");
  const name = page.getByLabel("file name");
  const save = page.getByRole("button", { name: "Save as new" });
  for (const [wrong, words] of [
    ["../outside", "not allowed"],
    ["L03_walk_back_60m", "is there already"],
  ]) {
    await name.fill(wrong);
    await save.click();
    await eventually(wrong, () => shows(page.locator(".notice"), words));
  }
  await name.fill("mine");
  await save.click();
  await eventually("saved", () => shows(page.locator(".notice"), "Saved as mine"));
  const mine = await saved("mine");
  assert.equal(mine.lesson.criteria[2].max, 2.5);
  assert.equal(mine.lesson.criteria[2].weight, 20);
  assert.deepEqual(mine.lesson.orders[9], { id: "how-much", code: "how_much", when: { moment: "brought-up" } });
  assert.deepEqual(mine.seats.forecastle.fitted, ["counter"]);
  assert.equal(mine.environment.wind_speed, 12);
  assert.equal(await readFile(join(folder, `${kSource}.json`), "utf8"), before, "the shipped one is as it was");
  assert.match(await rig.say("lesson", "list", folder), /mine\.json/);
  await rig.say("lesson", "check", join(folder, "mine.json"));
  const load = page.getByRole("button", { name: "Load", exact: true });
  await eventually("it can be loaded", () => load.isEnabled());
  await holdDown(page, load);
  await rig.truly("the exercise has its weather", ({ environment }) => environment?.now.wind_speed === 12);
  hadNoProblems(page);
});

test("a shipped file is replaced only by a button that is held", async () => {
  await page.locator(`.files button[data-name=${kSource}]`).click();
  await eventually("open", async () => (await page.getByLabel("file name").inputValue()) === kSource);
  await at("/title").waitFor({ state: "attached" });
  await section("Name and title").click();
  await at("/title").locator("input").fill("L01 in other words");
  const over = page.getByRole("button", { name: "Save over" });
  assert.ok(await page.getByRole("button", { name: "Save as new" }).isHidden());
  await over.hover();
  await page.mouse.down();
  await page.mouse.up();
  assert.notEqual((await saved(kSource)).title, "L01 in other words", "a touch replaces nothing");
  await holdDown(page, over);
  await eventually("replaced", async () => (await saved(kSource)).title === "L01 in other words");
});

test("a trainee's station has no such page and answers no such question", async () => {
  const station = await rig.station("forecastle");
  const seat = await openPage(station.url);
  await eventually("it is open", () => seat.locator(".veil").isHidden());
  const answers = await seat.evaluate(
    (token) =>
      new Promise((done) => {
        const heard: string[] = [];
        const socket = new WebSocket(`ws://${location.host}/ws?token=${token}`, "windlass.v1");
        const ask = (what: string) =>
          socket.send(JSON.stringify({ op: "exercise_files", id: what, what, name: "mine", text: "{}" }));
        socket.onopen = () => ["list", "read", "check", "save"].forEach(ask);
        socket.onmessage = ({ data }: MessageEvent<string | Blob>) => {
          const { op, allowed } = (typeof data === "string" ? JSON.parse(data) : {}) as GatewayMessage;
          if (op === "refused" && heard.push(allowed) === 4) done(heard);
        };
      }),
    new URL(station.url).hash.replace("#token=", ""),
  );
  assert.deepEqual(answers, Array(4).fill("for an instructor"));
  await closePage(seat);
});
