// A worker of the server that is killed, and one that hangs, while hands are on the levers of its exercise: what its
// pages show before, during and after; and that its neighbour's page, in another worker, shows nothing of it.
// Pictures of it in $PICTURES, where that is set.

import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { mkdtemp, readFile, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";

import { type TestPage, closeBrowser, openPage, root } from "./browser";
import { hadNoProblems, passesAxe } from "./pages";
import { Rig, eventually } from "./rig";

const kExercise = "let_go_port_25m";
const rig = new Rig(`browser-${process.pid}-worker`);
const other = new Rig(`${rig.partition}-neighbour`); // its stations; the server is the first one's
let keep: string;
let deck: TestPage, desk: TestPage, neighbour: TestPage;

const banner = (page: TestPage) => page.locator(".silence");
const state = (page: TestPage) => page.locator(".top-bar .state").textContent();
const logged = (page: TestPage, code: string) => page.locator(`.log li[data-code="${code}"]:not(.left)`);
const owner = () => deck.locator(".owner").textContent();
const brake = async () =>
  Number(await deck.getByRole("slider", { name: /brake/ }).first().getAttribute("aria-valuenow"));
/** The process of the worker that has the first exercise. */
const worker = async () => Number.parseInt(await readFile(join(keep, "worker-1", "lock"), "utf8"));

/** Pictures of all three pages. */
async function look(when: string) {
  const folder = process.env.PICTURES;
  if (!folder) return;
  for (const [name, page] of Object.entries({ deck, desk, neighbour }))
    await page.screenshot({ path: join(folder, `worker_${when}_${name}.png`) });
}

/** Keeps in window.silences how often the page has said that nothing is heard or marked a panel. */
const counting = () => {
  window.silences = 0;
  addEventListener("DOMContentLoaded", () => {
    const count = () => (window.silences += document.querySelectorAll(".silence:not([hidden]), [data-old]").length);
    new MutationObserver(count).observe(document, {
      subtree: true,
      attributes: true,
      attributeFilter: ["data-old", "hidden"],
    });
  });
};

/** The exercise runs, and the forecastle has its brake, which is not off. */
async function atWork() {
  await rig.say("start");
  for (const page of [deck, desk]) await eventually("it runs", async () => (await state(page)).startsWith("running"));
  await deck.keyboard.press("b");
  await eventually("the forecastle has the windlass", async () => (await owner()) === "mine");
}

/** What the pages show of an exercise that stands where its worker was lost. */
async function standsWhereItWas(run: number) {
  const truth = await rig.truly("it is taken up in a new run, paused", ({ status }) => {
    return status.run > run && status.state === "RUN_PAUSED";
  });
  for (const page of [deck, desk]) {
    await eventually("nothing is said any more", () => banner(page).isHidden());
    await eventually("it is paused", async () => (await state(page)).startsWith("paused"));
    await eventually("nothing is marked", async () => (await page.locator("[data-old]").count()) === 0);
    const told = logged(page, "exercise.taken_up");
    await eventually("it is told", async () => (await told.count()) > 0);
    assert.match(await told.last().textContent(), /taken up again at \d+:\d\d after the server was lost, paused/);
  }
  return truth;
}

describe("of a server of two workers", () => {
  before(
    async () => {
      keep = await mkdtemp(join(tmpdir(), "windlass-worker-"));
      rig.server(
        kExercise,
        "--exercise",
        join(root, "config/exercises", `${kExercise}.json`),
        "--partition",
        other.partition,
        "--workers",
        "2",
        "--keep",
        keep,
      );
      deck = await openPage((await rig.station("forecastle")).url.replace("#", "?picture=off#"));
      desk = await openPage((await rig.desk()).url, { init: () => localStorage.setItem("windlass.views", "plan") });
      const beside = await other.station("forecastle");
      neighbour = await openPage(beside.url.replace("#", "?picture=off#"), { init: counting });
      await other.say("start");
      await eventually("the neighbour runs", async () => (await state(neighbour)).startsWith("running"));
    },
    { timeout: 120000 },
  );
  after(async () => {
    await closeBrowser();
    await other.end();
    await rig.end();
    await rm(keep, { recursive: true, force: true });
  });

  test("one is killed: its pages have the exercise back where it stood, paused, levers as they were", async () => {
    await atWork();
    const there = await rig.truly(
      "it has run for some seconds, and the hand-wheel is hard on",
      ({ status, port }) => status.time > 3 && port.windlass.brake_position === 1,
    );
    const brakeBefore = await brake();
    await look("before");
    process.kill(await worker(), "SIGKILL");
    const truth = await standsWhereItWas(there.status.run);
    assert.ok(truth.status.time >= there.status.time, "no moment is lost that was shown before");
    assert.equal(truth.port.windlass.brake_position, there.port.windlass.brake_position);
    await eventually("the brake is as it was", async () => (await brake()) === brakeBefore);
    assert.equal(await logged(desk, "exercise.started").count(), 1, "what was before the loss has happened");
    await look("after_a_kill");
    for (const page of [deck, desk]) hadNoProblems(page);
  });

  test("and goes on by the hand that was there", atWork);

  test("one hangs: its pages say so, and of now nothing is shown that is not", async () => {
    const { status } = await rig.truly("it runs", ({ status }) => status.state === "RUN_RUNNING");
    process.kill(await worker(), "SIGSTOP"); // its supervisor waits 10 s for a sign of life, and kills it
    for (const page of [deck, desk]) {
      await eventually("it is said", () => banner(page).isVisible());
      assert.match(await banner(page).textContent(), /^Nothing heard of the exercise for \d+ s: what is shown is old$/);
      assert.equal(await state(page), "not heard");
    }
    await eventually("nobody hears the hand", async () => (await owner()) === "no server");
    await look("during");
    for (const page of [deck, desk]) await passesAxe(page);
    await standsWhereItWas(status.run);
    await look("after_it_hung");
    for (const page of [deck, desk]) hadNoProblems(page);
  });

  test("and goes on, too", atWork);

  test("of all that the page of an exercise in the other worker shows nothing: it ran on in its run", async () => {
    assert.equal(await neighbour.evaluate(() => window.silences), 0);
    assert.ok((await state(neighbour)).startsWith("running"));
    assert.equal(await logged(neighbour, "exercise.taken_up").count(), 0);
    hadNoProblems(neighbour);
  });
});
