// The instructor's desk, the replay and the classroom, worked as an instructor works them, against real programs.

import assert from "node:assert/strict";
import { mkdtemp, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";

import { events } from "../../words/words.json";
import { type TestPage, closeBrowser, closePage, openPage } from "./browser";
import { hadNoProblems, hasPalettes, holdDown, passesAxe } from "./pages";
import { type Station, Rig, eventually } from "./rig";

const rig = new Rig();
let desk: Station;
let page: TestPage, trainee: TestPage;
let recordings: string;

// Every panel is in sight; the scene, which has tests of its own, is not drawn.
const wide = { viewport: { width: 1600, height: 900 }, init: () => localStorage.setItem("windlass.views", "plan") };
const button = (name: string) => page.getByRole("button", { name, exact: true });
const field = (name: string) => page.getByLabel(name, { exact: true });
const notice = () => page.locator(".notice").textContent();
const address = (path: string, query = "") => {
  const url = new URL(desk.url);
  return `${url.origin}${path}${query}${url.hash}`;
};

const hold = (name: string) => holdDown(page, button(name));

before(async () => {
  recordings = await mkdtemp(join(tmpdir(), "windlass-desk-"));
  rig.server("anchor_and_weigh_25m", "--wait");
  desk = await rig.desk({ more: ["--recordings", recordings] });
  page = await openPage(desk.url, wide);
  await eventually("the desk shows the windlass", async () =>
    (await page.locator(".truth tbody tr").first().textContent()).includes("m"),
  );
});
after(async () => {
  await closeBrowser();
  await rig.end();
  await rm(recordings, { recursive: true, force: true });
});

test("start, time scale and pause reach the exercise, and the bar says so", async () => {
  const state = page.locator(".top-bar .state");
  await eventually("ready", async () => (await state.textContent()) === "ready");
  await button("Start").click();
  await rig.truly("it runs", ({ status }) => status.state === "RUN_RUNNING");
  await field("time scale").selectOption("5");
  await rig.truly("five times as fast", ({ status }) => status.time_scale === 5);
  await eventually("the bar says so", async () => (await state.textContent()).includes("x5"));
  await field("time scale").selectOption("0.25");
  await eventually("with all its digits", async () => (await state.textContent()).includes("x0.25"));
  await field("time scale").selectOption("1");
  await button("Pause").click();
  await rig.truly("it stands", ({ status }) => status.state === "RUN_PAUSED");
  await button("Go on").click();
  await rig.truly("it runs again", ({ status }) => status.state === "RUN_RUNNING");
});

test("a fault is armed, tells how far off it is, becomes active when its time comes, and is cleared", async () => {
  const row = page.locator(".faults-given li[data-code=FAULT_LOAD_CELL_BIAS]");
  const tile = () => page.locator(".tile[data-code=FAULT_LOAD_CELL_BIAS]").click();
  await tile();
  await field("trigger").selectOption("TRIGGER_AT_TIME");
  await field("at exercise time, m:ss").fill("1:00:00");
  await button("Arm").click();
  await eventually("armed", async () => /armed.*at 1:00:00, in 5\d:/.test(await row.textContent()));
  await tile();
  await page.locator(".fault-form input[type=range]").fill("50");
  await button("Break it").click();
  await eventually("active", async () => /active.*50 of 50 %/.test(await row.textContent()));
  await rig.truly(
    "the cell shows half as much again",
    ({ port }) => port.windlass.gypsy_load_indicated > 1.4 * port.windlass.gypsy_load,
  );
  await button("clear Load cell bias").click();
  await eventually("cleared", async () => (await row.textContent()).includes("cleared"));
});

test("a fault waits for any event that the exercise calls and for no other, and comes with it", async () => {
  const row = page.locator(".faults-given li[data-code=FAULT_LOAD_CELL_BIAS]");
  await page.locator(".tile[data-code=FAULT_LOAD_CELL_BIAS]").click();
  await field("trigger").selectOption("TRIGGER_AT_EVENT");
  const offered = await field("code of the event").locator("option").allTextContents();
  assert.deepEqual(
    offered,
    events.waited_for.oneOf.map((row) => row.const),
  );
  assert.ok(offered.includes("anchor.let_go") && !offered.includes("levers.taken"), `offered: ${offered}`);
  await field("code of the event").selectOption("fault.active");
  await button("Arm").click();
  await eventually("armed", async () => /armed.*at event fault.active/.test(await row.textContent()));
  await page.locator(".tile[data-code=FAULT_CCTV_LOST]").click();
  await button("Break it").click();
  await eventually("active", async () => /active/.test(await row.textContent()));
  await button("clear Load cell bias").click();
  await button("clear CCTV lost").click();
  await eventually("cleared", async () => (await row.textContent()).includes("cleared"));
});

test("a fault's trigger without its figure is not sent, and it is said why", async () => {
  await page.locator(".tile[data-code=FAULT_DRIVE_TRIP]").click();
  await field("trigger").selectOption("TRIGGER_AT_TIME");
  await button("Arm").click();
  await eventually("it is said", async () => (await notice()).includes("m:ss is allowed"));
  assert.equal(await page.locator(".faults-given li[data-code=FAULT_DRIVE_TRIP]").count(), 0);
  await page.locator(".tile[data-code=FAULT_DRIVE_TRIP]").click();
});

test("wind and stream come as set, in their time, and the rest stays; what the server refuses is shown", async () => {
  const { environment: before } = await rig.truly("it is heard", ({ environment }) => environment);
  await page.getByRole("tab", { name: "Environment" }).click();
  await field("Wind, speed, kn").fill("30");
  await field("Stream and tide, sets, \u00b0").fill("090");
  await field("comes so within, m:ss").fill("1:00:00");
  await button("Set").click();
  const knot = 1852 / 3600;
  const { environment } = await rig.truly(
    "it is on its way",
    ({ environment: e }) => e.ramp_left > 3000 && Math.abs(e.after.wind_speed - 30 * knot) < 1e-6,
  );
  assert.ok(Math.abs(environment.after.current_towards - Math.PI / 2) < 1e-9);
  assert.equal(environment.after.current_speed, before.after.current_speed);
  assert.ok(environment.now.wind_speed < 20 * knot, "it comes slowly");
  await field("Wind, speed, kn").fill("16");
  await field("comes so within, m:ss").fill("0:00");
  await button("Set").click();
  await rig.truly(
    "at once",
    ({ environment: e }) => e.ramp_left === 0 && Math.abs(e.now.wind_speed - 16 * knot) < 1e-6,
  );
  await field("Wind, speed, kn").fill("37"); // force 8
  await field("Wind sea, fetch of the wind, nm").fill("30");
  await button("By wind").click();
  await eventually(
    "the sea that belongs to it",
    async () => Number(await field("Wind sea, height, m").inputValue()) > 2,
  );
  await button("Set").click();
  const { environment: gale } = await rig.truly(
    "a gale with its sea",
    ({ environment: e }) => Math.abs(e.after.wind_speed - 37 * knot) < 1e-6 && e.after.wave_height > 2,
  );
  assert.ok(
    gale.after.wave_height < 3.5 && gale.after.wave_period > 5 && gale.after.wave_period < 8,
    JSON.stringify(gale.after),
  );
  assert.ok(Math.abs(gale.after.wave_from - gale.after.wind_from) < 0.01, "from where the wind is");
  await field("Wind, speed, kn").fill("16");
  await field("Wind sea, height, m").fill("0");
  await button("Set").click();
  await rig.truly("calm again", ({ environment: e }) => e.after.wave_height === 0);
  await field("Wind, speed, kn").fill("900");
  await button("Set").click();
  await eventually("refused, in knots", async () =>
    (await notice()).includes("wind, speed 900 kn refused; allowed: 0 to 116.6 kn"),
  );
  const logged = await page.locator('.log li[data-code="command.refused"]').first().textContent();
  assert.ok(logged.includes("wind, speed 900 kn refused; allowed: 0 to 116.6 kn"), logged);
  await button("Undo").click();
  await page.getByRole("tab", { name: "Faults" }).click();
});

test("taking over needs a held button, begins with the levers as found, is seen by the trainee, and is handed back", async () => {
  const station = await rig.station("forecastle");
  trainee = await openPage(station.url.replace("#", "?picture=off#"));
  const owner = () => trainee.locator(".owner").textContent();
  await eventually("the stand shows the windlass", () => trainee.locator(".counter strong").first().textContent());
  await trainee.keyboard.press("b"); // hard on, by the trainee's hand
  await eventually("the trainee has the levers", async () => (await owner()) === "mine");
  const { port: found } = await rig.truly("hard on", ({ port }) => port.windlass.brake_position > 0.99);
  await button("take over port windlass").click();
  assert.equal(await page.locator("body.in-command").count(), 0, "a touch takes nothing");
  assert.equal(await button("take over port windlass").textContent(), "Hold: Take over", "and it is said why");
  await hold("take over port windlass");
  await eventually("the trainee is told", async () => (await owner()).includes("instructor"));
  await eventually("an amber frame", async () => (await page.locator("body.in-command").count()) === 1);
  const { port: begun } = await rig.truly("it is heard", ({ port }) => port);
  for (const lever of ["brake_position", "speed_lever", "stopper_closed"] as const)
    assert.equal(begun.windlass[lever], found.windlass[lever], lever);
  await page.locator(".lever-card[data-what='0']").getByRole("slider", { name: "brake on, %" }).fill("80");
  await rig.truly("the wheel follows", ({ port }) => Math.abs(port.windlass.brake_position - 0.8) < 0.01);
  await page.locator(".lever-card[data-what='0']").getByRole("slider", { name: "brake on, %" }).fill("100");
  await rig.truly("hard on again", ({ port }) => port.windlass.brake_position > 0.99);
  await button("hand back port windlass").click();
  await eventually("the trainee has them again", async () => (await owner()) === "mine");
  await eventually("no frame any longer", async () => (await page.locator("body.in-command").count()) === 0);
});

test("an order goes to the forecastle; what it answers, and what it reports, stands beside the truth", async () => {
  await field("order").selectOption("BRIDGE_ORDER_HOLD_ON");
  await field("figure of the order").fill("3");
  await button("Order").click();
  const said = page.locator(".talk li").first();
  await eventually("given", async () =>
    /hold on port cable at 3 shackles.*not yet repeated/.test(await said.textContent()),
  );
  await eventually("it is heard", async () =>
    (await trainee.locator("body").textContent()).includes("hold on port cable at 3 shackles"),
  );
  await trainee.keyboard.press("o");
  await eventually("repeated", async () =>
    (await page.locator(".talk li.order").first().textContent()).includes("repeated"),
  );
  await trainee
    .getByRole("button", { name: /brought up/i })
    .first()
    .click();
  await eventually("the report beside the truth", async () =>
    /brought up.*was housed/s.test(await page.locator(".talk").textContent()),
  );
  hadNoProblems(trainee);
  await closePage(trainee);
});

test("F4 keeps a bookmark with a word, in the log and on the timeline", async () => {
  await page.keyboard.press("F4");
  await page.keyboard.type("brake too early");
  await page.keyboard.press("Enter");
  await eventually("in the log", () =>
    page.locator(".log li[data-code='exercise.bookmark']", { hasText: "brake too early" }).isVisible(),
  );
  await field("filter").fill("too early");
  await eventually("the filter leaves it", async () => (await page.locator(".log li").count()) === 1);
  await field("filter").fill("");
});

test("a restore asks first, says where it goes and what is dropped; what is yet to come is refused", async () => {
  const to = field("restore to, exercise time");
  await rig.truly("past the first checkpoint", ({ status }) => status.time > 11);
  await to.fill("99:00");
  await button("Restore").click();
  await eventually("it is said why not", async () =>
    /^Restore to: 99:00 is yet to come; 0:00 to .*, which is now, is allowed$/.test(
      await page.locator(".notice span").textContent(),
    ),
  );
  await to.fill("0:12");
  await button("Restore").click();
  const question = page.getByRole("dialog", { name: "restore" });
  assert.match(
    await question.textContent(),
    /Back to the checkpoint at 0:10, paused\? What happened from there to now, \d+:\d\d, is dropped/,
  );
  await button("Stay here").click();
  assert.equal(await question.isVisible(), false);
  await button("Restore").click();
  await button("Back to 0:10").click();
  await rig.truly(
    "it stands where the question said",
    ({ status }) => status.state === "RUN_PAUSED" && Math.floor(status.time) === 10,
  );
  await button("Go on").click();
  await rig.truly("it runs again", ({ status }) => status.state === "RUN_RUNNING");
});

test("plots have figures for what they show, and choices are kept", async () => {
  const pane = page.locator(".pane[data-pane=loads]");
  await eventually("the hawse's load", async () => Number(await pane.locator(".legend b").first().textContent()) > 1);
  await page.locator(".plot-menu summary").click();
  await page.locator(".chip[data-pane=motor]").click();
  await eventually("one more", () => page.locator(".pane[data-pane=motor] canvas").isVisible());
  await page.reload();
  await eventually("it is still there", () => page.locator(".pane[data-pane=motor]").isVisible());
});

test("loads and the cable's speed are shown in the units that are chosen, everywhere", async () => {
  const shown = async () => ({
    truth: await page.locator(".truth tbody tr", { hasText: "tension, hawse" }).locator(".unit").textContent(),
    speed: await page.locator(".truth tbody tr", { hasText: "cable speed" }).locator(".unit").textContent(),
    plot: await page.locator("[data-pane=loads] h3 small").textContent(),
  });
  await eventually(
    "tonnes",
    async () => assert.deepEqual(await shown(), { truth: "t", speed: "m/min", plot: "t" }) === undefined,
  );
  await page.getByRole("button", { name: "units: t, m/min" }).click();
  await page.getByRole("radio", { name: /^kN/ }).check();
  await page.getByRole("radio", { name: /^m\/s/ }).check();
  await passesAxe(page);
  await page.keyboard.press("Escape");
  await eventually(
    "kilonewtons",
    async () => assert.deepEqual(await shown(), { truth: "kN", speed: "m/s", plot: "kN" }) === undefined,
  );
  await page.reload();
  await eventually("kept", () => page.getByRole("button", { name: "units: kN, m/s" }).isVisible());
  await page.getByRole("button", { name: "units: kN, m/s" }).click();
  await page.getByRole("radio", { name: /^t\b/ }).check();
  await page.getByRole("radio", { name: /^m\/min/ }).check();
  await page.keyboard.press("Escape");
});

test("the plan has the chart that bridges have", async () => {
  const soundings = await page.evaluate(() => window.windlass.link.latest("Chart").soundings.map(({ depth }) => depth));
  assert.ok(soundings.length > 50 && soundings.every((depth) => depth > 0), `${soundings.length} soundings`);
});

test("forces are drawn over the scene on a switch of the desk, which no trainee's page has", async () => {
  const arrows = page.locator("canvas.forces");
  await button("3D").click();
  await eventually("the scene", () => arrows.count());
  assert.equal(await arrows.isVisible(), false);
  await button("Forces").click();
  // what pulls, in its colour: the anchor hangs on the brake or at home
  await eventually("an arrow", () =>
    arrows.evaluate((canvas: HTMLCanvasElement) => {
      const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
      for (let i = 0; i < data.length; i += 4)
        if (data[i] === 0xe6 && data[i + 1] === 0x9f && data[i + 2] === 0 && data[i + 3] === 255) return true;
      return false;
    }),
  );
  await button("Forces").click();
  assert.equal(await arrows.isVisible(), false);
  await button("Plan").click();
  const seat = await openPage((await rig.station("ship", { name: "looker" })).url);
  await eventually("a seat's picture", () => seat.getByRole("button", { name: "Over the bow" }).isVisible());
  assert.equal(await seat.getByRole("button", { name: "Forces" }).count(), 0);
  await closePage(seat);
});

test("a room is shown pictures, plots and large figures on the full screen, and no levers", async () => {
  const figures = page.getByRole("region", { name: "loads and forces" });
  assert.equal(await figures.isVisible(), false);
  await button("Full screen").click();
  await eventually("the screen is the room's", () =>
    page.evaluate(() => document.fullscreenElement?.classList.contains("projecting")),
  );
  await eventually("a load", async () => /tension, hawse\d+(\.\d)? t/.test(await figures.textContent()));
  for (const seen of [".plan-view", ".panes", ".timeline"]) assert.ok(await page.locator(seen).isVisible(), seen);
  for (const hidden of [".desk > .left", ".desk > .right", ".run-bar"])
    assert.ok(!(await page.locator(hidden).first().isVisible()), hidden);
  await passesAxe(page);
  await button("Plots").click();
  await button("Figures").click();
  assert.ok(!(await page.locator(".panes").isVisible()) && !(await figures.isVisible()), "the picture alone");
  await button("Plots").click();
  await button("Figures").click();
  await button("Leave full screen").click();
  await eventually("the desk is back", () => page.locator(".desk > .left").isVisible());
  assert.equal(await page.evaluate(() => document.fullscreenElement), null);
  await button("Full screen").click();
  await eventually("again", () => page.evaluate(() => document.fullscreenElement !== null));
  await page.evaluate(() => document.exitFullscreen()); // as Escape does
  await eventually("the desk is back", () => page.locator(".desk > .left").isVisible());
});

test("the desk is accessible in every palette", async () => {
  await hasPalettes(page);
  hadNoProblems(page);
});

test("it records, the recording is replayed with all its marks, and a live exercise goes on from there", async () => {
  const rec = page.locator(".rec");
  await rec.click();
  await eventually("it records", async () => (await rec.getAttribute("aria-pressed")) === "true");
  const name = (await rec.getAttribute("title")).match(/recording (\S+);/)[1];
  const clock = async () =>
    (await page.locator(".top-bar .time").textContent()).split(":").reduce((s, p) => 60 * s + Number(p), 0);
  const begin = await clock();
  await eventually("some seconds", async () => (await clock()) > begin + 2);
  await page.keyboard.press("F4");
  await page.keyboard.type("look at this");
  await page.keyboard.press("Enter");
  await eventually("some more", async () => (await clock()) > begin + 6);
  await button("Pause").click();
  await rec.click();
  await eventually("it has ended", async () => (await rec.getAttribute("aria-pressed")) === "false");
  await closePage(page);

  const partition = `replay-${rig.partition}`;
  rig.replay(join(recordings, name), partition);
  page = await openPage(address("/instructor", `?exercise=${partition}`), wide);
  const place = async () =>
    (await page.locator(".replay-bar .place").textContent())
      .match(/^(\d+):(\d+) of/)
      .slice(1)
      .reduce((s, p) => 60 * s + Number(p), 0);
  await eventually("it says REPLAY", async () => (await page.locator(".top-bar .state").textContent()) === "REPLAY");
  await eventually("marks of what is to come", async () =>
    /with [1-9]\d* marks/.test(await page.locator(".timeline canvas").getAttribute("aria-label")),
  );
  // Other marks may stand before it: a loaded machine has its own alerts.
  await eventually("at the bookmark", async () => {
    if ((await place()) >= 1) return true;
    await page.keyboard.press("]");
    return false;
  });
  await page.locator(".top-bar").getByText("exercise time").waitFor(); // two clocks, each with its name
  await page.locator(".replay-bar").getByText("time of the recording").waitFor();
  await page
    .locator(".timeline")
    .getByRole("img", { name: /, in the time of the recording$/ })
    .waitFor();
  // Ten seconds back each: on a loaded machine there are more of them.
  await eventually("back at the beginning", async () => {
    if ((await place()) === 0) return true;
    await page.keyboard.press("Shift+ArrowLeft");
    return false;
  });
  await page.keyboard.press(" ");
  await eventually("it plays", async () => (await page.locator(".replay-bar .play").textContent()) === "Pause");
  await eventually("it goes on", async () => (await place()) >= 1);
  await page.keyboard.press(" ");
  await eventually("it stands", async () => (await page.locator(".replay-bar .play").textContent()) === "Play");
  await field("position in the recording, s").fill("3");
  await eventually("the scrubber leads it", async () => (await place()) === 3);
  await eventually("levers of a replay are nobody's", () => button("take over port windlass").isHidden());

  const shown = await clock();
  await field("exercise that goes on from here").selectOption(rig.partition);
  await hold("Continue live");
  await rig.truly(
    "the live exercise stands there",
    ({ status }) => status.state === "RUN_PAUSED" && Math.abs(status.time - shown) < 1.5,
  );
  await eventually("it is said", async () => (await notice()).includes("stands at"));
  hadNoProblems(page);
});

test("the classroom makes, starts, pauses and removes exercises, and tells why it cannot", async () => {
  await closePage(page);
  page = await openPage(address("/classroom"));
  const tile = (id: string) => page.locator(`.tile[data-id='${id}']`);
  await eventually("what there is", () => tile(rig.partition).isVisible());
  const id = `${rig.partition}-b`;
  await field("name of the exercise").fill(id);
  await field("exercise file of the server").fill("walk_back_60m");
  await button("Create").click();
  await eventually("a tile", async () => (await tile(id).locator(".state").textContent()) === "ready");
  await field(`choose ${id}`).check();
  await page.locator(".bar").getByRole("button", { name: "Start" }).click();
  await eventually("it runs", async () => (await tile(id).locator(".state").textContent()) === "running");
  await button(`pause ${id}`).click();
  await eventually("it stands", async () => (await tile(id).locator(".state").textContent()) === "paused");
  await field("name of the exercise").fill(`${id}-c`);
  await field("exercise file of the server").fill("no_such_file");
  await button("Create").click();
  await eventually("why not", async () => (await notice()).includes("no_such_file"));
  await hasPalettes(page, { axe: false });
  await passesAxe(page);
  await button(`remove ${id}`).click();
  assert.ok(await tile(id).isVisible(), "a touch removes nothing");
  await hold(`remove ${id}`);
  await eventually("it is gone", async () => (await tile(id).count()) === 0);
  hadNoProblems(page);
});

test("who may set marks alone has no other control; his word stands there with his name, its time and its note", async () => {
  const kNote = "stood well clear of the cable";
  const tls = { ignoreHTTPSErrors: true }; // the door's authority is nobody's yet
  const password = "a long password";
  const marked = new Rig(); // of an exercise with a lesson
  try {
    marked.server("L01_let_go_25m");
    const door = await marked.door(join(recordings, "door"));
    const at = (path: string) => new URL(path, door.url).href;
    const owner = await openPage(door.setup, { ...tls, ...wide });
    await owner.locator("input[name=name]").fill("anna");
    for (const input of await owner.locator("input[type=password]").all()) await input.fill(password);
    await owner.getByRole("button", { name: "Set up", exact: true }).click();
    await owner.waitForURL(/\/class$/);
    const letIn = { do: "put", name: "jonas", rank: "assessor", password };
    const status = await owner.evaluate(async (body) => {
      const headers = { "Content-Type": "application/json" };
      return (await fetch("/door/people", { method: "POST", headers, body })).status;
    }, JSON.stringify(letIn));
    assert.equal(status, 200);

    const assessor = await openPage(at("/login"), { ...tls, ...wide });
    await assessor.locator("input[name=name]").fill("jonas");
    await assessor.locator("input[name=password]").fill(password);
    await assessor.getByRole("button", { name: "Log in", exact: true }).click();
    await assessor.waitForURL(/\/class$/);
    await assessor.goto(at(`/instructor?exercise=${marked.partition}`));
    await eventually("his desk shows the windlass", async () =>
      (await assessor.locator(".truth tbody tr").first().textContent()).includes("m"),
    );
    await owner.goto(at(`/instructor?exercise=${marked.partition}`));
    const offers = (of: TestPage, name: string) => of.getByRole("button", { name, exact: true }).count();
    for (const name of ["Pause", "Snapshot", "Restore", "Reset", "End", "Load", "REC", "Debrief", "Mark", "Order"]) {
      await eventually(`an instructor has ${name}`, () => offers(owner, name));
      assert.equal(await offers(assessor, name), 0, name);
    }
    for (const title of ["port windlass", "helm"]) {
      await eventually(`an instructor may take over the ${title}`, () => offers(owner, `take over ${title}`));
      assert.equal(await offers(assessor, `take over ${title}`), 0, title);
    }
    assert.equal(await assessor.locator(".top-bar .seat").textContent(), "Assessor");
    assert.ok(!(await assessor.locator(".catalogue").isVisible()), "no fault to be given");
    await assessor.getByRole("tab", { name: "Environment" }).click();
    const wind = assessor.getByLabel("Wind, speed, kn", { exact: true });
    await eventually(
      "weather is read there",
      async () => !(await wind.isEditable()) && (await wind.inputValue()) !== "",
    );

    await assessor.getByRole("tab", { name: "Marks" }).click();
    const note = assessor.getByLabel("note", { exact: true });
    await note.waitFor();
    const room = await note.evaluate((input: HTMLInputElement) => {
      const ctx = document.createElement("canvas").getContext("2d");
      const { font, paddingLeft, paddingRight } = getComputedStyle(input);
      ctx.font = font;
      const inside = input.clientWidth - parseFloat(paddingLeft) - parseFloat(paddingRight);
      return inside - ctx.measureText(input.placeholder).width;
    });
    assert.ok(room >= 0, `what it asks for is cut off by ${-room} px`);
    await assessor.getByLabel("criterion", { exact: true }).selectOption("stance");
    await assessor.getByLabel("verdict", { exact: true }).selectOption("VERDICT_MET");
    await note.fill(kNote);
    await assessor.getByRole("button", { name: "Set", exact: true }).click();
    const word = (of: TestPage) => of.locator(".marks li", { hasText: "stance" }).locator(".word");
    await eventually("it stands, with when", async () =>
      new RegExp(`^\\d+:\\d\\d jonas: ${kNote}$`).test(await word(assessor).textContent()),
    );
    await owner.getByRole("tab", { name: "Marks" }).click();
    await eventually("for the instructor, too", async () =>
      (await word(owner).textContent()).endsWith(`jonas: ${kNote}`),
    );
    await passesAxe(assessor);
    hadNoProblems(assessor);
    hadNoProblems(owner);
  } finally {
    await marked.end();
  }
});
