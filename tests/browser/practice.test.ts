// What is told to one seat alone, as two trainees read it: its part of the briefing, and a hint in practice.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";

import { type TestPage, closeBrowser, openPage } from "./browser";
import { hadNoProblems, passesAxe } from "./pages";
import { Rig, eventually } from "./rig";

const rig = new Rig();
let deck: TestPage, bridge: TestPage;
const briefing = (page: TestPage) => page.getByRole("dialog", { name: "briefing" });

before(
  async () => {
    rig.server("L27_the_conn", "--wait");
    const [forecastle, conning] = [await rig.station("forecastle"), await rig.station("bridge")];
    deck = await openPage(forecastle.url.replace("#", "?picture=off#"));
    bridge = await openPage(conning.url);
  },
  { timeout: 180000 },
);
after(async () => {
  await rig.end();
  await closeBrowser();
});

test("each seat reads the common briefing and its own, and nothing of the other's", async () => {
  for (const [page, own, others] of [
    [deck, "You have the port windlass.", "You have the conn"],
    [bridge, "You have the conn", "You have the port windlass."],
  ] as const) {
    await eventually("its own is there", () => briefing(page).getByText(own).isVisible());
    const text = (await briefing(page).textContent()) ?? "";
    assert.match(text, /Bulk carrier of 225 m/);
    assert.ok(!text.includes(others), `the other seat's own reaches it: ${text}`);
    await passesAxe(page);
    if (process.env.PICTURES)
      await page.screenshot({ path: `${process.env.PICTURES}/${own.slice(13, 17)}_briefing.png` });
  }
});

test("a hint comes to its seat alone, beside its orders and in the log, and the marks say so", async () => {
  await rig.say("load", "L01_let_go_25m.json", "--practice");
  await eventually("it says that it is for practice", () => briefing(deck).getByText("for practice").isVisible());
  assert.ok(
    !((await briefing(deck).textContent()) ?? "").includes("You have the port windlass."),
    "of the other lesson",
  );
  await rig.say("start");
  const levers = rig.console("levers", "--brake", "0");
  const hint = deck.locator(".hint");
  await eventually(
    "the hint is told",
    async () => (await hint.isVisible()) && /too fast/.test((await hint.textContent()) ?? ""),
  );
  assert.match((await deck.locator(".log").textContent()) ?? "", /She runs too fast/);
  assert.ok(
    !((await bridge.locator("body").textContent()) ?? "").includes("She runs too fast"),
    "it is the forecastle's",
  );
  if (process.env.PICTURES) await deck.screenshot({ path: `${process.env.PICTURES}/hint.png` });
  await rig.say("stop");
  const marks = deck.getByRole("dialog", { name: "what came of it" });
  await eventually("practice is said", () => marks.getByText(/For practice, \d hints?: no test/).isVisible());
  if (process.env.PICTURES) await deck.screenshot({ path: `${process.env.PICTURES}/marks.png` });
  await levers.stop();
  hadNoProblems(deck);
  hadNoProblems(bridge);
});
