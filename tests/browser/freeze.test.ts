// A question at a freeze: it covers the page of the asked seat alone, is answered by the page's controls, and the
// exercise goes on.

import assert from "node:assert/strict";
import { cp, mkdtemp, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";

import { type TestPage, closeBrowser, openPage, root } from "./browser";
import { hadNoProblems, passesAxe } from "./pages";
import { Rig, eventually, sleep } from "./rig";

const lesson = {
  id: "T",
  briefing: "Look about you.",
  bridge: "manned",
  criteria: [
    {
      id: "out",
      kind: "question",
      ask: "How many shackles are out?",
      of: "shackles",
      tolerance: 0.5,
      when: { time: 2, cable_out: 1 },
      meant_for: 20,
    },
    {
      id: "holds",
      kind: "question",
      seat: "bridge",
      ask: "Does she hold?",
      when: { time: 4, cable_out: 1 },
      choices: [
        { answer: "She lies to her anchor", that: { dragged: { below: 18 } } },
        { answer: "She drags", that: { dragged: { above: 18 } } },
      ],
    },
    {
      id: "again",
      kind: "question",
      ask: "How fast does the cable run?",
      of: "cable_speed",
      tolerance: 0.2,
      when: { time: 6, cable_out: 1 },
    },
  ],
  end: { time: 600 },
};

const rig = new Rig();
let folder: string;
let deck: TestPage, bridge: TestPage, desk: TestPage;
const sheet = (page: TestPage) => page.getByRole("dialog", { name: "question" });
const asked = (page: TestPage, text: string) =>
  eventually(`asked: ${text}`, () => sheet(page).getByText(text).isVisible());
const button = (page: TestPage, name: string) => sheet(page).getByRole("button", { name, exact: true });

before(
  async () => {
    folder = await mkdtemp(join(tmpdir(), "windlass-freeze-"));
    await cp(join(root, "config"), join(folder, "config"), { recursive: true });
    const file = join(folder, "config/exercises/freeze.json");
    await writeFile(file, JSON.stringify({ from: "at_anchor_25m", name: "freeze", lesson }));
    rig.server(file, "--wait");
    deck = await openPage((await rig.station("forecastle")).url.replace("#", "?picture=off#"));
    bridge = await openPage((await rig.station("bridge")).url);
    desk = await openPage((await rig.desk()).url);
    await eventually("the exercise is there", () => deck.getByText("Look about you.").isVisible());
  },
  { timeout: 180000 },
);
after(async () => {
  await rig.end();
  await closeBrowser();
  await rm(folder, { recursive: true });
});

test("a number is asked of the forecastle, over its gauges, and answered by the pad", async () => {
  await rig.say("start");
  await asked(deck, "How many shackles are out?");
  assert.equal(await sheet(bridge).isVisible(), false, "the other seat is not asked");
  const { status } = await rig.truly("the exercise holds", ({ status }) => status.state === "RUN_PAUSED");
  assert.ok(Math.abs(status.time - 2) < 0.01, `at its tick: ${status.time}`);
  await eventually("the desk says so", () =>
    desk.getByText("The exercise holds for a question to the forecastle:").isVisible(),
  );
  // Nothing of its gauges comes any more, also to a page that is loaded now.
  const views = () => deck.evaluate(() => window.windlass.link.heardAt("ForecastleView"));
  await deck.reload();
  await asked(deck, "How many shackles are out?");
  await sleep(1000); // five samples of an exercise that stands still
  assert.ok((await views()) <= 0, "a view has come");
  await deck.keyboard.press("Escape");
  await deck.keyboard.press("Escape");
  await asked(deck, "How many shackles are out?");
  const levers = await rig.truly("there is a windlass to be seen", ({ port }) => port);
  await deck.keyboard.press("b");
  await passesAxe(deck);
  if (process.env.PICTURES) await deck.screenshot({ path: `${process.env.PICTURES}/freeze_number.png` });
  if (process.env.PICTURES) await desk.screenshot({ path: `${process.env.PICTURES}/freeze_desk.png` });
  assert.equal(await button(deck, "Answer").isDisabled(), true, "nothing is filled in");
  await button(deck, "figure 5").click();
  await button(deck, "more by 0.5").click();
  await button(deck, "more by 0.5").click();
  assert.match((await sheet(deck).locator("output").textContent()) ?? "", /^6$/);
  await button(deck, "Answer").click();
  await eventually("the sheet goes", async () => !(await sheet(deck).isVisible()));
  await eventually("the gauges are back", async () => (await views()) > 0);
  const now = await rig.truly("there still is", ({ port }) => port);
  assert.equal(now.port.windlass.brake_position, levers.port.windlass.brake_position);
});

test("a choice is asked of the bridge, and answered by its button", async () => {
  await asked(bridge, "Does she hold?");
  assert.equal(await sheet(deck).isVisible(), false);
  await passesAxe(bridge);
  if (process.env.PICTURES) await bridge.screenshot({ path: `${process.env.PICTURES}/freeze_choice.png` });
  await button(bridge, "She lies to her anchor").click();
  await eventually("the sheet goes", async () => !(await sheet(bridge).isVisible()));
});

test("the instructor goes on without an answer, and a page that comes late is asked, too", async () => {
  await asked(deck, "How fast does the cable run?");
  await deck.reload();
  await asked(deck, "How fast does the cable run?");
  await desk.getByRole("button", { name: "Go on without an answer" }).click();
  await eventually("the sheet goes", async () => !(await sheet(deck).isVisible()));
  await rig.truly("she goes on", ({ status }) => status.state === "RUN_RUNNING" && status.time > 6);
  await desk.getByRole("tab", { name: "Marks" }).click();
  for (const words of [/6 shackles; right: \d/, /She lies to her anchor"; right:/, /not answered; right:/])
    await eventually(`the marks say ${words}`, () => desk.getByText(words).isVisible());
  for (const page of [deck, bridge, desk]) hadNoProblems(page);
});
