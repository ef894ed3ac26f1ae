// A class whose server is killed in the midst of a let-go and started again: what trainee and instructor see of it, and
// what is said of it in the debriefing. Pictures of it in $PICTURES, where that is set.

import assert from "node:assert/strict";
import { mkdtemp, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";

import type { Page } from "playwright-core";

import { type TestPage, closeBrowser, closePage, openPage } from "./browser";
import { firstOwner, hadNoProblems, openClass, passesAxe } from "./pages";
import { type Program, Rig, eventually, sleep } from "./rig";

const rig = new Rig();
const tls = { ignoreHTTPSErrors: true };
let folder: string, then: string;
let server: Program;
let door: Awaited<ReturnType<Rig["door"]>>;
let owner: TestPage, deck: TestPage;

const on = (page: TestPage, name: string) => page.getByRole("button", { name, exact: true });
const look = async (page: Page, name: string) => {
  if (process.env.PICTURES) await page.screenshot({ path: join(process.env.PICTURES, `class_loss_${name}.png`) });
};
const states = () => owner.locator(".exercises .state").allTextContents();
const log = (code: string) => deck.locator(`.log li[data-code="${code}"]`);
const pad = () => deck.locator(".reports [data-leaf][aria-pressed=true]").textContent();
const counter = async () => parseFloat((await deck.locator(".counter strong").first().textContent()) ?? "");
const begin = () => rig.server("let_go_port_25m", "--workers", "2", "--keep", join(folder, "keep"), "--wait");

before(async () => {
  folder = await mkdtemp(join(tmpdir(), "windlass-class-loss-"));
  server = begin();
  door = await rig.door(join(folder, "door"));
  owner = await firstOwner(door.setup);
  const code = await openClass(owner, 2);
  await eventually("both exercises are there", async () => {
    const all = await states();
    if (all.length === 2 && all.every((state) => state.startsWith("ready"))) return true;
    throw new Error(`${await owner.locator("main").innerText()}\nserver: ${server.errors}\ndoor: ${door.errors}`);
  });
  deck = await openPage(`${door.url}?code=${code}`, tls);
  await deck.locator("input[name=name]").fill("ben");
  await on(deck, "Take a seat").click();
  await deck.waitForURL(/\/forecastle$/);
  const other = await openPage(`${door.url}?code=${code}`, tls); // an exercise is started where somebody has a seat
  await other.locator("input[name=name]").fill("carl");
  await on(other, "Take a seat").click();
  await other.waitForURL(/\/forecastle$/);
  await closePage(other);
});
after(async () => {
  await closeBrowser();
  await rig.end();
  await rm(folder, { recursive: true, force: true });
});

/** Gives the forecastle's answers to an order of the bridge as soon as it stands there. */
async function answer(order: string) {
  const said = deck.locator(".orders li", { hasText: order });
  await eventually(`${order} is ordered`, async () => (await said.count()) > 0);
  await eventually("it is repeated", async () => {
    if ((await said.first().getAttribute("data-state")) === "ORDER_REPEATED") return true;
    await deck.keyboard.press("o");
    await sleep(500); // its way to the server and back
    return false;
  });
}

test("the anchor is let go, and the cable runs", async () => {
  await on(owner, "Start all").click();
  await answer("stand by");
  await deck.locator(".reports").getByRole("button", { name: "Standing by", exact: true }).click();
  await answer("let go");
  await deck.keyboard.press("0"); // the wheel spun open
  await eventually("it runs", async () => (await counter()) > 12);
});

test("the server is killed: both pages say so, and nothing is said to be made", async () => {
  then = await deck.locator(".top-bar .time").textContent();
  await server.stop("SIGKILL");
  await eventually("the seat is told", () => deck.locator(".silence").isVisible());
  await eventually("the class is told", async () =>
    (await owner.locator(".notice").textContent()).startsWith("No server is heard."),
  );
  const last = /^not heard, was running \d+:\d\d, \d+\.\d of 100 points, \d+\.\d lost so far$/;
  for (const state of await states()) assert.match(state, last);
  await look(deck, "seat_lost");
  await look(owner, "lost");
  for (const page of [owner, deck]) await passesAxe(page);
});

test("it is started again: the class stands where it stood, with its log, its orders and its report pad", async () => {
  server = begin();
  await eventually("both exercises stand", async () => (await states()).every((state) => /^paused/.test(state)));
  await eventually("nothing is said any more", async () => (await owner.locator(".notice").textContent()) === "");
  const before = ["order.given", "report.made", "exercise.taken_up"];
  for (const loaded of ["there all the time", "loaded anew"]) {
    await eventually(`the seat is told, ${loaded}`, async () => (await log("exercise.taken_up").count()) > 0);
    assert.equal(await log("exercise.taken_up").count(), 1, loaded);
    for (const code of before) assert.ok((await log(code).count()) > 0, `${code}, ${loaded}`);
    assert.match(await deck.locator(".orders").textContent(), /let go port anchor/);
    await eventually("the pad has what is to be reported now", async () => (await pad()) === "Letting go");
    assert.ok((await counter()) > 12 && (await deck.locator(".top-bar .time").textContent()) >= then);
    await look(deck, `taken_up_${loaded.replaceAll(" ", "_")}`);
    if (loaded !== "loaded anew") await deck.reload();
  }
  await look(owner, "taken_up");
});

test("it goes on with the hand that takes the levers, and is ended", async () => {
  await deck.keyboard.press("b");
  await eventually("the hand has them", async () => (await deck.locator(".owner").textContent()) === "mine");
  await on(owner, "Start all").click();
  await eventually("it runs", async () => /running/.test(await deck.locator(".top-bar").textContent()));
  await eventually("she is checked", async () => /hard on/.test(await deck.locator(".brake .figures").textContent()));
  await deck.locator(".reports").getByRole("button", { name: "Let go", exact: true }).click();
  const told = log("order.repeated").filter({ hasText: "let go port anchor" });
  await eventually("it is told", async () => (await told.count()) > 0);
  await look(deck, "goes_on");
  await on(owner, "End the class").focus();
  await owner.keyboard.down("Enter");
  await owner.locator(".class-marks tbody tr", { hasText: "ben" }).waitFor();
  await owner.keyboard.up("Enter");
});

test("the debriefing is of all of it, and says when the server was lost", async () => {
  const row = owner.locator(".class-marks tbody tr", { hasText: "ben" });
  await eventually("marked", async () => /points, not/.test(await row.locator(".marks").textContent()));
  const link = row.getByRole("link", { name: "Debriefing" });
  const [debriefing] = await Promise.all([owner.waitForEvent("popup"), link.click()]);
  const text = () => debriefing.locator("main").innerText();
  await eventually("it is talked over", async () => (await text()).includes("Let go the port anchor"));
  assert.match(await text(), /Time of exercise\s+0:00 to 0:/);
  assert.match(await text(), new RegExp(`WARNING: taken up again at \\d:\\d\\d after the server was lost, paused`));
  assert.match(await text(), /ben: \d moves of the windlass, \d reports/);
  await look(debriefing, "debriefing");
  await look(owner, "over");
  for (const page of [owner, deck]) hadNoProblems(page);
});
