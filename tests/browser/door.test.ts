// The door: the first owner is set up, a class is opened, two trainees join by its code on a phone and a tablet, are
// moved, started together and sent away; all by clicks, by TLS.

import assert from "node:assert/strict";
import { mkdtemp, readFile, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";

import type { Page } from "playwright-core";

import { type TestPage, closeBrowser, closePage, openPage } from "./browser";
import { hadNoProblems, passesAxe } from "./pages";
import { Rig, eventually } from "./rig";

const rig = new Rig();
const picture = process.env.WINDLASS_DOOR_PICTURES; // a folder, to look at the pages
const tls = { ignoreHTTPSErrors: true }; // its authority is nobody's yet
let folder: string, code: string;
let door: Awaited<ReturnType<Rig["door"]>>;
let owner: TestPage, phone: TestPage, tablet: TestPage, late: TestPage;
let replay: string; // the desk of a recording that is shown

const on = (page: TestPage, name: string) => page.getByRole("button", { name, exact: true });
const look = async (page: Page, name: string) => {
  if (picture) await page.screenshot({ path: join(picture, `${name}.png`) });
};
const seat = (exercise: string, place: string) =>
  owner.locator(`[data-exercise=${exercise}] .seat-button`, { hasText: place });
const firstExercise = async () => await owner.locator("[data-exercise]").first().getAttribute("data-exercise");
/** What a page has beyond its width, in pixels. */
const beyond = (page: TestPage) => page.evaluate(() => document.documentElement.scrollWidth - innerWidth);

async function takeSeat(name: string, viewport: { width: number; height: number }): Promise<TestPage> {
  const page = await openPage(`${door.url}?code=${code.toLowerCase()}`, { ...tls, viewport });
  await page.locator("input[name=name]").fill(name);
  await look(page, `join_${viewport.width}`);
  assert.equal(await beyond(page), 0);
  await passesAxe(page);
  await on(page, "Take a seat").click();
  await page.waitForURL(/\/forecastle$|\/bridge$/);
  return page;
}

before(async () => {
  folder = await mkdtemp(join(tmpdir(), "windlass-door-"));
  rig.server("L01_let_go_25m", "--wait");
  door = await rig.door(join(folder, "door"));
});
after(async () => {
  await closeBrowser();
  await rig.end();
  await rm(folder, { recursive: true, force: true });
});

test("the first owner is set up by the link that is printed", async () => {
  owner = await openPage(door.setup, tls);
  await owner.locator("input[name=name]").fill("anna");
  await owner.locator("input[name=password]").fill("a long password");
  await owner.locator("input[type=password]").last().fill("a long password");
  await look(owner, "setup");
  assert.ok(!owner.url().includes("token"), "the link is not left in the address");
  await passesAxe(owner);
  await on(owner, "Set up").click();
  await owner.waitForURL(/\/class$/);
});

test("a class is opened, and its code shown", async () => {
  await owner.locator("select option").first().waitFor({ state: "attached" });
  await owner.locator("select").first().selectOption("L01_let_go_25m");
  await owner.locator("input[type=number]").fill("2");
  await owner.locator("select").last().selectOption("2");
  await look(owner, "class_new");
  const paddingOf = (field: Element) => parseFloat(getComputedStyle(field).paddingTop);
  assert.ok((await owner.locator("input[type=file]").evaluate(paddingOf)) >= 4, "its button is off the box's edge");
  await passesAxe(owner);
  await on(owner, "Open the class").click();
  code = (await owner.locator(".code-panel .letters").textContent()).replace(/ /g, "");
  assert.match(code, /^[A-HJ-NP-Z]{6}$/);
  assert.equal(await owner.locator(".code-panel .qr").count(), 1);
  await eventually("both exercises are there", async () => {
    const states = await owner.locator(".exercises .state").allTextContents();
    return states.length === 2 && states.every((state) => state.startsWith("ready"));
  });
  await on(owner, "Show large").click();
  await look(owner, "class_code_large");
  await owner.locator(".projector").click();
});

test("a wrong code is refused in words, and counts once", async () => {
  const page = await openPage(`${door.url}?code=ZZZZZZ`, tls);
  page.lostOnPurpose = true; // the browser says of each refusal that it was one
  await page.locator("input[name=name]").fill("ben");
  await on(page, "Take a seat").click();
  await page.getByText("no class has this code today").waitFor();
  const audit = await readFile(join(folder, "door", "audit.jsonl"), "utf8");
  assert.equal(audit.split("join.failed").length - 1, 1);
  await closePage(page);
});

test("trainees join by it, on a phone and a tablet, and are seen where they sit", async () => {
  phone = await takeSeat("ben", { width: 390, height: 844 });
  tablet = await takeSeat("carla", { width: 1024, height: 768 });
  assert.match(tablet.url(), /\/bridge$/);
  await eventually(
    "both are at the page",
    async () => (await owner.locator(".seat-button .here").allTextContents()).join() === "at the page,at the page",
  );
  const id = await firstExercise();
  assert.match(await seat(id, "forecastle").textContent(), /ben/);
  assert.match(await seat(id, "bridge").textContent(), /carla/);
  await look(owner, "class_1280");
  await look(phone, "forecastle_390");
  await look(tablet, "bridge_1024");
  await passesAxe(owner);
});

test("a page that is loaded anew has its seat again", async () => {
  await phone.reload();
  await eventually("its exercise is heard", async () => (await phone.locator(".top-bar .time").textContent()) !== "");
  assert.match(phone.url(), /\/forecastle$/);
});

test("who is moved is sent to the other seat, and who sat there changes places", async () => {
  await owner.locator(".seat-button", { hasText: "ben" }).click();
  await owner.locator(".seat-button", { hasText: "carla" }).click();
  await phone.waitForURL(/\/bridge$/);
  await tablet.waitForURL(/\/forecastle$/);
});

test("they are started together, and the exercise in which nobody sits once somebody does", async () => {
  const stand = async (...words: string[]) => {
    const states = await owner.locator(".exercises .state").allTextContents();
    return states.length === words.length && states.every((state, i) => state.startsWith(words[i]));
  };
  const waits = async () => (await owner.locator(".bar .waits").allTextContents()).join();
  await on(owner, "Start all").click();
  await eventually("theirs runs", () => stand("running", "ready"));
  await eventually("the other waits", async () => (await waits()) === "1 exercise waits: nobody sits in it");
  await passesAxe(owner);
  late = await takeSeat("dora", { width: 1024, height: 768 });
  await eventually("it can begin", async () => (await waits()) === "1 exercise waits for Start all");
  await on(owner, "Start all").click();
  await eventually("both run", () => stand("running", "running"));
  await eventually("and nothing waits", async () => (await waits()) === "");
  await eventually("and the seats see it", async () => /running/.test(await tablet.locator(".top-bar").textContent()));
  await look(tablet, "forecastle_1024");
});

test("words and a fault are given to all of them", async () => {
  const notice = () => owner.locator(".class > .notice").textContent();
  await on(owner, "Say to all").click();
  await owner.locator("input[aria-label='words to all']").fill("mind the lead");
  await look(owner, "say_to_all");
  await passesAxe(owner);
  await on(owner, "Say it").click();
  await owner.locator(".to-all").waitFor({ state: "detached" });
  await eventually("it is confirmed", async () => (await notice()) === "“mind the lead” said in 2 exercises");
  await eventually("it is heard", async () => /mind the lead/.test(await tablet.locator("body").textContent()));
  await on(owner, "Fault to all").click();
  await owner.locator("select[aria-label=fault]").selectOption("load-cell-dead");
  await look(owner, "fault_to_all");
  await passesAxe(owner);
  await on(owner, "Break it").click();
  await owner.locator(".to-all").waitFor({ state: "detached" });
  await eventually("it is confirmed", async () => (await notice()) === "load cell dead in 2 exercises");
  await eventually("for a while", async () => (await notice()) === "");
});

test("the page of the class has a small picture of each forecastle", async () => {
  const pictures = owner.locator(".exercises .cctv canvas");
  await eventually("both are drawn", () =>
    pictures.evaluateAll(
      (all: HTMLCanvasElement[]) =>
        all.length === 2 && all.every((one) => one.getContext("2d").getImageData(160, 150, 1, 1).data[3] === 255),
    ),
  );
  await owner.setViewportSize({ width: 1440, height: 900 });
  await look(owner, "class_cctv");
  await owner.getByRole("button", { name: "CCTV on" }).click();
  assert.equal(await pictures.first().isVisible(), false);
  await owner.getByRole("button", { name: "CCTV off" }).click();
});

test("of a lesson that is over the class says so, and who has the marks there is at the page", async () => {
  const second = owner.locator("[data-exercise]").nth(1);
  const its = new Rig(await second.getAttribute("data-exercise"));
  await its.say("stop", "--timeout", "20");
  await its.end();
  await eventually("it is over", async () =>
    /^lesson over, \d+\.\d of 100 points, not shown/.test(await second.locator(".state").textContent()),
  );
  await eventually("she is there", async () => (await second.locator(".here").textContent()) === "here");
  await eventually("all three are at their pages", async () =>
    /3 of 4 seats taken, 3 at the page/.test(await owner.locator(".bar .said").textContent()),
  );
  await look(owner, "class_lesson_over");
  hadNoProblems(late);
  await closePage(late);
});

test("a seat that is freed sends its browser to the door", async () => {
  await owner.locator(".seat-button", { hasText: "ben" }).click();
  await on(owner, "Free the seat").click();
  await phone.locator("input[name=code]").waitFor();
});

test("the instructor's desk and the other pages come by the door as they do from a station", async () => {
  const id = await firstExercise();
  for (const [path, words, name] of [
    [`/instructor?exercise=${id}`, "running", "desk"],
    ["/classroom", id, "classroom"],
    ["/people", "anna", "people"],
    ["/trust", "SHA-256", "trust"],
  ] as const) {
    await owner.goto(new URL(path, door.url).href);
    await eventually(`${path} shows ${words}`, async () => (await owner.locator("body").textContent()).includes(words));
    await look(owner, name);
  }
  await owner.setViewportSize({ width: 390, height: 844 });
  await owner.goto(new URL("/class", door.url).href);
  await owner.locator("[data-exercise]").first().waitFor();
  await look(owner, "class_390");
  assert.equal(await beyond(owner), 0);
});

test("a device that stands at a seat is led to it by an address that is opened once, and after every start", async () => {
  await owner.setViewportSize({ width: 1280, height: 800 });
  await on(owner, "Devices").click();
  await owner.locator("input[name=device]").fill("forecastle 1");
  await on(owner, "Make an address").click();
  const address = await owner.locator(".kiosk-made code").textContent();
  await look(owner, "devices");
  await passesAxe(owner);
  const device = await openPage(address.replace(/https:..[^/]*/, new URL(door.url).origin), tls);
  await eventually("somebody sits there", async () =>
    /carla sits here/.test(await device.locator("main").textContent()),
  );
  assert.ok(!device.url().includes("key"), "the key is not left in the address");
  await look(device, "kiosk_waits");
  await passesAxe(device);
  await on(owner, await owner.locator(".tabs button").first().textContent()).click();
  await owner.locator(".seat-button", { hasText: "carla" }).click();
  await owner.locator(".seat-button", { hasText: "bridge" }).first().click();
  await device.waitForURL(/\/forecastle$/);
  await device.goto(door.url); // a browser that is started anew begins here
  await device.waitForURL(/\/forecastle$/);
  await tablet.waitForURL(/\/bridge$/);
  await on(owner, "Devices").click();
  await on(owner, "Take it back").click();
  await device.locator("input[name=code]").waitFor();
  hadNoProblems(device);
  await closePage(device);
  await on(owner, await owner.locator(".tabs button").first().textContent()).click();
});

/** The table of a class that is over says that something is still to come, as long as the history has not told it. */
async function saysWhatIsComing() {
  const coming = owner.getByText("What next and assessors' words are coming.");
  assert.equal(await coming.isVisible(), false, "it has come");
  let comes = () => {};
  const told = new Promise<void>((resolve) => (comes = resolve));
  const question = /\/door\/next\?/;
  await owner.route(question, async (route) => {
    await told;
    await route.continue();
  });
  await on(owner, "New class").click();
  await owner.locator(".tabs button").first().click();
  await coming.waitFor();
  comes();
  await coming.waitFor({ state: "hidden" });
  await owner.unroute(question);
}

/** A class that is over is called by its lesson's title, and by no file's name before that is known. */
async function namesNoFile() {
  let comes = () => {};
  const told = new Promise<void>((resolve) => (comes = resolve));
  const question = /\/door\/lessons/;
  await owner.route(question, async (route) => {
    await told;
    await route.continue();
  });
  await owner.reload();
  await owner.locator(".tabs button").first().click();
  const heading = owner.locator(".class-marks h2");
  assert.ok(!/L01_/.test(await heading.textContent()), await heading.textContent());
  comes();
  await eventually("its title", async () => /Let go the port anchor/.test(await heading.textContent()));
  await owner.unroute(question);
}

test("with the class its seats end, and each seat's marks and debriefing are there", async () => {
  // By then it is lost that nobody has let go; what is not shown when a class ends went wrong at no moment.
  await eventually("a while", async () =>
    /running 0:5/.test(await owner.locator(".exercises .state").first().textContent()),
  );
  await on(owner, "End the class").evaluate((button) => {
    for (const type of ["keydown", "keyup"]) button.dispatchEvent(new KeyboardEvent(type, { key: "Enter" }));
  });
  await on(owner, "Hold: End the class").waitFor(); // who only touches it is told
  await on(owner, "End the class").focus();
  await owner.keyboard.down("Enter");
  const row = owner.locator(".class-marks tbody tr", { hasText: "carla" }).first();
  await row.waitFor();
  await owner.keyboard.up("Enter");
  const all = await owner.locator(".class-marks tbody tr").allTextContents();
  const whose = (name: string, part: RegExp) => all.some((text) => text.startsWith(name) && part.test(text));
  assert.ok(whose("carla", /bridge, from 0:/) && whose("ben", /bridge, to 0:/), `who was moved: ${all.join()}`);
  await eventually("marked", async () => /points, not/.test(await row.locator(".marks").textContent()));
  const over = tablet.locator(".own-marks .class-over"); // her lesson was still going: she has her marks all the same
  await over.waitFor();
  await look(tablet, "class_over_seat");
  await passesAxe(tablet);
  await tablet.reload(); // to where there is no seat any more: the marks are there until they are closed
  const kept = tablet.getByRole("dialog", { name: "what came of it" });
  await kept
    .getByText(/of 100 points/)
    .first()
    .waitFor();
  await passesAxe(tablet);
  await on(tablet, "Close").click();
  assert.match(await tablet.locator(".notice").textContent(), /^(The class is over|Die Klasse ist beendet)/);
  await tablet.locator("input[name=code]").fill("A"); // she is at another class
  assert.equal(await tablet.locator(".notice").textContent(), "");
  await tablet.reload();
  await tablet.locator("input[name=code]").waitFor();
  assert.equal(await kept.count(), 0);
  await owner.setViewportSize({ width: 1280, height: 800 });
  await eventually("what she is to practise next", async () =>
    /for practice.*not (yet|shown)/.test(await row.locator(".next").textContent()),
  );
  await look(owner, "class_over");
  await saysWhatIsComing();
  await namesNoFile();
  await owner.setViewportSize({ width: 390, height: 844 });
  await look(owner, "class_over_390");
  assert.equal(await beyond(owner), 0);
  await owner.setViewportSize({ width: 1280, height: 800 });
  await passesAxe(owner);
  const link = row.getByRole("link", { name: "Debriefing" });
  const [debriefing] = await Promise.all([owner.waitForEvent("popup"), link.click()]);
  await eventually("it is talked over", async () =>
    (await debriefing.locator("main").textContent()).includes("Let go the port anchor"),
  );
  const aside = owner.getByRole("link", { name: "The class side by side" });
  const [beside] = await Promise.all([owner.waitForEvent("popup"), aside.click()]);
  await beside.getByRole("heading", { name: "Who did what when" }).waitFor();
  await passesAxe(beside);
  await look(beside, "class_side_by_side");
  await beside.getByRole("link", { name: /carla/ }).click();
  await eventually("each leads to its debriefing", () => beside.url().includes("/door/debriefing?recording="));
  await beside.close();
  await debriefing.locator('a[href^="/replay?"]').first().click();
  await eventually("its times open the replay", () => debriefing.url().includes("/instructor?exercise=replay-"));
  replay = debriefing.url();
  const itsClass = (await row.getAttribute("data-exercise")).replace(/-\d+$/, ""); // "mon" of "mon-1"
  await row.getByRole("button", { name: /^Again from \d+:\d\d$/ }).click();
  await eventually("a class for her and who sat beside her, from there", async () =>
    new RegExp(`For .*carla.* alone.*; from \\d+:\\d\\d of ${itsClass}-\\d+, .*went wrong.*`).test(
      await owner.locator("form").textContent(),
    ),
  );
  const proposed = await owner.getByRole("textbox", { name: "Name of the class" }).inputValue();
  assert.equal(proposed, `${itsClass}-again`);
  await look(owner, "class_again");
  assert.ok(await owner.getByLabel("for practice, with hints").isDisabled(), "it is no test");
  await owner.getByRole("textbox", { name: "Name of the class" }).fill("again");
  await on(owner, "Open the class").click();
  await eventually("it stands at that moment", async () => {
    const states = await owner.locator(".exercises .state").allTextContents();
    return states.length === 1 && states[0].startsWith("paused");
  });
  await look(owner, "class_again_open");
  code = (await owner.locator(".code-panel .letters").textContent()).replace(/ /g, "");
  const again = await openPage(`${door.url}?code=${code}`, tls);
  await again.locator("select[name=listed]").press("c"); // carla, as a hand chooses it
  await on(again, "Take a seat").click();
  await again.getByText(/^It goes on at \d+:\d\d, for practice/).waitFor(); // by itself, with the lesson's briefing
  await look(again, "goes_on");
  await closePage(again);
  await on(owner, "End the class").focus();
  await owner.keyboard.down("Enter");
  await owner.getByRole("button", { name: "again, over" }).waitFor();
  await owner.keyboard.up("Enter");
  await owner.getByRole("button", { name: /^(?!again).*, over$/ }).click();
  await row.waitFor();
  await owner
    .locator("button", { hasText: /^Class of/ })
    .first()
    .click();
  await eventually("a class for those who do the same", async () =>
    (await owner.locator("form").textContent()).includes("carla"),
  );
  const form = owner.locator("form");
  assert.ok(await form.getByLabel("for practice, with hints").isChecked());
  assert.equal(await form.locator("select").first().inputValue(), "L01_let_go_25m");
  await look(owner, "class_next");
  await on(owner, "New class").click();
  assert.ok(!(await form.getByLabel("for practice, with hints").isChecked()), "it is somebody else's class");
  await owner.getByRole("button", { name: /^(?!again).*, over$/ }).click();
  await on(owner, "The same class again").click();
  await eventually("the same class from its beginning", async () =>
    /For .*carla.* alone, unless you give a file$/.test(await form.locator("p.quiet").textContent()),
  );
  assert.ok(!(await form.getByLabel("for practice, with hints").isChecked()), "as it was, a test");
  assert.equal(await form.locator("select").first().inputValue(), "L01_let_go_25m");
  await tablet.locator("input[name=code]").waitFor();
  const first = (await owner.locator(".tabs button").first().textContent()).replace(", over", "");
  await owner.goto(new URL("/class", door.url).href);
  const name = await owner.getByRole("textbox", { name: "Name of the class" }).inputValue();
  assert.equal(name, `${first}-b`, "that of a class that is over is taken");
  for (const page of [owner, tablet, phone]) hadNoProblems(page);
});

test("an assessor looks at the replay that is shown, and seeks in it; an observer looks on", async () => {
  const password = "a long password";
  const recording = new URL(replay).searchParams.get("exercise").replace(/^replay-/, "");
  const staff = async (rank: string): Promise<TestPage> => {
    const body = JSON.stringify({ do: "put", name: rank, rank, password });
    await owner.evaluate(
      (text) => fetch("/door/people", { method: "POST", headers: { "Content-Type": "application/json" }, body: text }),
      body,
    );
    const page = await openPage(new URL("/login", door.url).href, { ...tls, viewport: { width: 1280, height: 800 } });
    await page.locator("input[name=name]").fill(rank);
    await page.locator("input[name=password]").fill(password);
    await on(page, "Log in").click();
    await page.waitForURL(/\/class$/);
    return page;
  };
  const assessor = await staff("assessor");
  await assessor.locator(".class-marks").waitFor(); // he opens no class, and none goes on
  for (const page of [owner, assessor]) await page.getByRole("button", { name: /^(?!again).*, over$/ }).click();
  const word = assessor.locator(".class-marks .word").first();
  for (const note of ["the load cell had failed", "the counter had failed with it"]) {
    await word.locator("summary").click();
    await word.getByRole("textbox", { name: /^Why/ }).fill(note);
    await on(assessor, "Set").first().click();
    await eventually("a page that is open has it, the second as the first", async () =>
      new RegExp(`^assessor: .*${note}`, "i").test(await owner.locator(".class-marks .word p").first().textContent()),
    );
  }
  await word.locator("summary").click();
  await word.getByRole("combobox", { name: "Outcome" }).selectOption("achieved");
  await word.getByRole("spinbutton", { name: /^Points/ }).fill("40");
  await word.getByRole("textbox", { name: /^Why/ }).fill("she was hailed meanwhile");
  await on(assessor, "Set").first().click();
  await word.getByText("40.0 points are below the 70 that the lesson needs.").waitFor();
  assert.match(await word.locator("p").first().textContent(), /the counter had failed with it$/i, "it is asked first");
  await on(assessor, "Set").first().click();
  await word.getByText(/40\.0 points, achieved\. She was hailed meanwhile$/).waitFor();
  await assessor.goto(new URL(`/replay?recording=${recording}&t=5`, door.url).href); // as a debriefing's time does
  await assessor.waitForURL(/\/instructor\?exercise=replay-/);
  const place = () => assessor.locator(".replay-bar .place").textContent();
  await eventually("it stands there", async () => /^0:05 of /.test(await place()));
  await on(assessor, "on 10 s, Shift and right arrow").click();
  await eventually("it goes where he wants", async () => /^0:15 of /.test(await place()));
  await eventually("all events of the recording are there", async () =>
    /Let go|let go/.test(await assessor.locator(".log").first().textContent()),
  );
  for (const name of ["Continue live", "Debrief", "REC"]) assert.equal(await on(assessor, name).count(), 0, name);
  await look(assessor, "assessor_replay");
  const observer = await staff("observer");
  await observer.goto(new URL(`/replay?recording=${recording}&t=5`, door.url).href);
  await observer.getByText("cannot be replayed here: ").waitFor();
  await closePage(observer);
  hadNoProblems(assessor);
  await closePage(assessor);
});

test("of an exercise that its server does not make the class says so", async () => {
  const asked = { do: "open", class: "hindered", lesson: "let_go_port_25m", exercises: 1, crew: 1, practice: true };
  const status = await owner.evaluate(
    async (body) =>
      (await fetch("/door/class", { method: "POST", headers: { "Content-Type": "application/json" }, body })).status,
    JSON.stringify(asked), // no lesson: a form does not offer it
  );
  assert.equal(status, 200);
  await on(owner, "hindered").click();
  await eventually("it says so", async () =>
    (await owner.locator(".exercises .trouble").textContent()).includes("has not made it"),
  );
  await look(owner, "class_hindered");
  await passesAxe(owner);
});

test("a class with a list offers its names, and who is in haste is none of them", async () => {
  const names = ["emil", "fritz"];
  const asked = { do: "open", class: "listed", lesson: "let_go_port_25m", exercises: 1, crew: 2, names };
  const its = await owner.evaluate(async (body) => {
    const headers = { "Content-Type": "application/json" };
    const answer = await fetch("/door/class", { method: "POST", headers, body });
    const { classes } = (await answer.json()) as { classes: { id: string; code: string }[] };
    return classes.find(({ id }) => id === "listed").code;
  }, JSON.stringify(asked));
  const page = await openPage(`${door.url}?code=${its}`, tls);
  const list = page.locator("select[name=listed]");
  await list.waitFor();
  assert.equal(await list.inputValue(), "");
  await on(page, "Take a seat").click();
  assert.equal(await list.evaluate((select: HTMLSelectElement) => select.validity.valueMissing), true);
  await passesAxe(page);
  await look(page, "join_listed");
  await list.press("f"); // as a hand chooses it: Playwright takes an option under a browser's own hint for disabled
  assert.equal(await list.inputValue(), "fritz");
  await on(page, "Take a seat").click();
  await page.waitForURL(/\/forecastle$/);
  hadNoProblems(page);
  await closePage(page);
});
