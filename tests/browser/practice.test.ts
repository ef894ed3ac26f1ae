// For practice: the model's hands over one's own, off until they are asked for, and a hint that is searched for.

import assert from "node:assert/strict";
import { mkdtemp, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";

import { type TestPage, closeBrowser, closePage, openPage } from "./browser";
import { hadNoProblems, passesAxe } from "./pages";
import { type Program, Rig, eventually } from "./rig";

const rig = new Rig();
let server: Program, keep: string;
let deck: TestPage, bridge: TestPage, german: TestPage;

const practice = (page: TestPage) => page.getByRole("group", { name: "for practice" });
const hands = (page: TestPage) => practice(page).getByRole("button", { name: "Model hands" });
const figures = async (page: TestPage) => (await practice(page).locator(".figures").textContent()) ?? "";
const ghosts = (page: TestPage) => page.locator(".ghost:visible").count();

const begin = () => rig.server("L01_let_go_25m", "--practice", "--keep", keep);

before(async () => {
  keep = await mkdtemp(join(tmpdir(), "windlass-practice-"));
  server = begin();
  const seat = await rig.station("forecastle");
  const conn = await rig.station("bridge");
  deck = await openPage(seat.url.replace("#", "?picture=off#"), { viewport: { width: 1600, height: 900 } });
  bridge = await openPage(conn.url, { viewport: { width: 1600, height: 900 } });
  german = await openPage(seat.url.replace("#", "?picture=off#"), { locale: "de-DE" });
});
after(async () => {
  await rig.end();
  await closeBrowser();
  await rm(keep, { recursive: true, force: true });
});

test("it is offered, and nothing is shown before it is asked for", async () => {
  await eventually("the forecastle is offered it", () => hands(deck).isVisible());
  await eventually("the bridge is offered it", () => hands(bridge).isVisible());
  assert.equal(await hands(deck).getAttribute("aria-pressed"), "false");
  assert.equal(await ghosts(deck), 0);
  assert.equal(await ghosts(bridge), 0);
});

test("the forecastle has the model's levers and its own gauges of them; the bridge has asked for nothing", async () => {
  await hands(deck).click();
  await eventually("marks on wheel and lever", async () => (await ghosts(deck)) === 2);
  await eventually("figures", async () => /turns? .*lever at stop, clutch .* m, .*m\/min/.test(await figures(deck)));
  assert.equal(await hands(deck).getAttribute("aria-pressed"), "true");
  assert.equal(await ghosts(bridge), 0);
  if (process.env.PICTURES) await deck.screenshot({ path: `${process.env.PICTURES}/practice.png` });
  await passesAxe(deck);
});

test("with them shown no control of the stand lies over another, in either language", async () => {
  const shown = async () => /Kupplung .* m, /.test((await german.locator(".practice .figures").textContent()) ?? "");
  await eventually("they are shown in German, too", shown);
  const beyond = (page: TestPage) =>
    page.locator(".controls > .control").evaluateAll((controls) =>
      controls
        .filter((control) => {
          const ends = [...control.children].map((part) => part.getBoundingClientRect().bottom);
          return Math.max(...ends) > control.getBoundingClientRect().bottom + 1;
        })
        .map((control) => control.getAttribute("aria-label")),
    );
  for (const page of [deck, german]) {
    const wide = page.viewportSize();
    for (const [width, height] of [
      [1440, 900],
      [1280, 720],
      [1024, 768],
      [820, 1180],
    ]) {
      await page.setViewportSize({ width, height });
      assert.deepEqual(await beyond(page), [], `${width}x${height}`);
    }
    await page.setViewportSize(wide);
  }
});

/** The model says that it stands by, and is told to let go; nobody says so here. */
test("it waits where this lesson has not come as far", async () => {
  await eventually("late", async () => /\d+ s behind you/.test((await practice(deck).textContent()) ?? ""));
});

test("the bridge has engine and rudder of them", async () => {
  await hands(bridge).click();
  await eventually("marks on telegraph and scale", async () => (await ghosts(bridge)) === 2);
  await eventually("figures", async () => /engine .*rudder .*kn/.test(await figures(bridge)));
  if (process.env.PICTURES) await bridge.screenshot({ path: `${process.env.PICTURES}/practice_bridge.png` });
  await passesAxe(bridge);
});

test("a server that is lost and started again has them again", async () => {
  await server.stop("SIGKILL");
  await eventually("it is said", () => deck.locator(".silence").isVisible());
  server = begin();
  await eventually("the exercise is taken up", async () => await deck.locator(".silence").isHidden());
  for (const page of [deck, bridge]) {
    await eventually("they are shown", async () => (await ghosts(page)) === 2);
    assert.equal(await hands(page).getAttribute("aria-pressed"), "true");
  }
  await eventually("with their figures", async () => /lever at stop, clutch .* m, /.test(await figures(deck)));
  if (process.env.PICTURES) await deck.screenshot({ path: `${process.env.PICTURES}/practice_taken_up.png` });
});

test("switched off they are gone", async () => {
  await hands(deck).click();
  await eventually("no mark", async () => (await ghosts(deck)) === 0);
  assert.equal(await figures(deck), "");
});

test("a hint is searched for, and stands in the picture; in German in German", async () => {
  await practice(deck).getByRole("button", { name: "Hint" }).click();
  const hint = (page: TestPage) => page.locator(".hint span");
  const known =
    /^(The .* now\.|Nothing that a lever keeps is lost .*|No single lever is known .*|There was no time .*)$/;
  await eventually("an answer", async () => known.test((await hint(deck).textContent()) ?? ""));
  await eventually("in German", async () =>
    /^(Jetzt .*\.|Bleibt alles, wie es ist, .*|Mit einem Hebel allein .*|Die Zeit reichte nicht, .*)$/.test(
      (await hint(german).textContent()) ?? "",
    ),
  );
});

test("the pages had no problems", async () => {
  for (const page of [deck, bridge, german]) {
    hadNoProblems(page);
    await closePage(page);
  }
});
