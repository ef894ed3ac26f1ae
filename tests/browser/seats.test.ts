// Forecastle and bridge of one lesson, as two trainees have them: the briefing, what is spoken aloud, and the VHF lost.

import assert from "node:assert/strict";
import { after, afterEach, before, describe, test } from "node:test";

import { type TestPage, closeBrowser, closePage, openPage } from "./browser";
import { hadNoProblems, passesAxe } from "./pages";
import { Rig, eventually } from "./rig";

/** A stand-in for the browser's voice, which a machine for tests need not have: window.spoken is what it says. */
const voiceStub = () => {
  window.spoken = [];
  window.voices = [{ name: "stub", lang: "en-GB", localService: true }];
  window.SpeechSynthesisUtterance = class {
    constructor(readonly text: string) {}
  } as typeof SpeechSynthesisUtterance;
  const synthesis = Object.assign(new EventTarget(), {
    getVoices: () => window.voices,
    speak: (said: SpeechSynthesisUtterance) => {
      window.spoken.push(said.text);
      said.onend?.(new Event("end") as SpeechSynthesisEvent);
    },
    cancel: () => {},
  });
  Object.defineProperty(window, "speechSynthesis", { value: synthesis });
};

const rig = new Rig();
let deck: TestPage, bridge: TestPage;
let bridgeUrl: string;

const briefing = (page: TestPage) => page.getByRole("dialog", { name: "briefing" });
const spoken = (page: TestPage) => page.evaluate(() => window.spoken);
const says = (page: TestPage, words: string) =>
  eventually(`"${words}" is spoken`, async () => (await spoken(page)).includes(words));
const said = (text: string) => bridge.locator(".said li", { hasText: text }).first();
const order = (text: string) => deck.locator(".orders li", { hasText: text });
/** leaf: of the pad, where the work does not ask for that report. */
const report = async (name: string, { choice, leaf }: { choice?: string; leaf?: string } = {}) => {
  const button = (called: string) => deck.locator(".reports").getByRole("button", { name: called, exact: true });
  if (leaf) await button(leaf).click();
  await button(name).click();
  if (choice) await deck.getByRole("dialog").getByRole("button", { name: choice, exact: true }).click();
};
/** An order of the bridge; choice: its figure, as its button is called. */
const give = async (name: string, choice?: string) => {
  await bridge.getByRole("button", { name, exact: true }).click();
  if (choice) await bridge.getByRole("button", { name: choice, exact: true }).click();
};

before(
  async () => {
    rig.server("L01_let_go_25m", "--wait");
    const [forecastle, conning] = [await rig.station("forecastle"), await rig.station("bridge")];
    bridgeUrl = conning.url;
    deck = await openPage(forecastle.url.replace("#", "?picture=off#"), { init: voiceStub });
    bridge = await openPage(bridgeUrl, { init: voiceStub });
  },
  { timeout: 180000 },
);
after(async () => {
  await closeBrowser();
  await rig.end();
});
afterEach(() => {
  hadNoProblems(deck);
  hadNoProblems(bridge);
});

test("before the exercise is started no load is shown as if it had been measured", async () => {
  const dial = deck.getByRole("meter", { name: "gypsy load" });
  await eventually("the gauge has heard", () => dial.getAttribute("aria-valuetext"));
  assert.equal(await dial.getAttribute("aria-valuetext"), "not measured yet");
  assert.match(await dial.textContent(), /^[^0-9]*0\d+[^0-9]*not measured yet/); // the dial's scale, and no figure
  const desk = await openPage((await rig.desk()).url, {
    viewport: { width: 1600, height: 900 },
    init: () => localStorage.setItem("windlass.views", "plan"),
  });
  const row = (name: string) =>
    desk
      .locator(".truth tbody tr")
      .filter({ has: desk.getByRole("rowheader", { name, exact: true }) })
      .locator("td:not(.unit):not([hidden])")
      .allTextContents();
  await eventually("the desk has heard", async () => /\d/.test((await row("cable out")).join()));
  for (const name of ["load, gypsy", "tension, hawse", "of breaking load", "brake bears", "brake could hold"])
    assert.doesNotMatch((await row(name)).join(), /\d/, name);
  assert.ok(await desk.getByText("No loads yet").isVisible());
  hadNoProblems(desk);
  await closePage(desk);
});

describe("the briefing", () => {
  test("opens by itself at both seats while the exercise waits, and says what the lesson asks for", async () => {
    for (const [page, seat] of [
      [deck, "the forecastle"],
      [bridge, "the bridge"],
    ] as const) {
      await eventually("it is open", () => briefing(page).isVisible());
      await eventually("all of it has come", async () =>
        /hold the fall with the brake.*true reports.*orders by what it hears\./.test(
          await briefing(page).textContent(),
        ),
      );
      assert.match(
        await briefing(page).getByRole("heading").textContent(),
        /^Let go the port anchor, 25 m, 6 shackles$/,
      );
      await eventually("the seat is named", () => briefing(page).getByText(`Your seat: ${seat}`).isVisible());
    }
    await passesAxe(deck);
  });

  test("is shut by a hand, and opens again on demand", async () => {
    await briefing(bridge).getByRole("button", { name: "Close" }).click();
    await eventually("shut", async () => !(await briefing(bridge).isVisible()));
    await bridge.getByRole("button", { name: "Briefing" }).click();
    await eventually("open again", () => briefing(bridge).isVisible());
    await briefing(bridge).getByRole("button", { name: "Close" }).click();
  });

  test("is out of the way when the exercise begins", async () => {
    assert.ok(await briefing(deck).isVisible());
    await rig.say("start");
    await eventually("shut by itself", async () => !(await briefing(deck).isVisible()));
    await eventually("it is still there to be read", () => deck.getByRole("button", { name: "Briefing" }).isVisible());
  });
});

describe("spoken aloud", () => {
  test("an order on the forecastle, in the words of the trade, and its repeat on the bridge", async () => {
    await says(deck, "Stand by port anchor"); // the lesson's first
    await deck.keyboard.press("o");
    await says(bridge, "Stand by port anchor");
    await give("Hold on at \u2026", "Hold on at 6 shackles");
    await says(deck, "Hold on port cable at six shackles in the pipe");
    await eventually("the page writes the same place", () =>
      order("hold on port cable at 6 shackles in the pipe").isVisible(),
    );
    await eventually("and so does the server, in the log", () =>
      deck.locator(".log li", { hasText: "given: hold on port cable at 6 shackles in the pipe" }).first().isVisible(),
    );
  });

  test("a report on the bridge, until the voice is turned off", async () => {
    await report("n in water", { choice: "3" });
    await says(bridge, "Three shackles in the water");
    const voice = bridge.getByRole("button", { name: /^voice/ });
    await voice.click();
    await eventually("it says so", async () => (await voice.textContent()) === "voice off");
    await report("Heaving", { leaf: "Weighing" });
    await eventually("read", () => said("heaving").isVisible());
    assert.ok(!(await spoken(bridge)).some((words: string) => /heaving/i.test(words)));
    await voice.click();
    // A voice that sends what it says elsewhere is none.
    const hear = (localService: boolean) =>
      bridge.evaluate((localService: boolean) => {
        window.voices = [{ name: "stub", lang: "en-GB", localService }];
        window.speechSynthesis.dispatchEvent(new Event("voiceschanged"));
      }, localService);
    await hear(false);
    await eventually("no switch without a voice", async () => !(await voice.isVisible()));
    await report("Home");
    await eventually("read", () => said("port anchor is home").isVisible());
    assert.ok(!(await spoken(bridge)).some((words: string) => /home/i.test(words)));
    await hear(true);
    await eventually("the switch is back", () => voice.isVisible());
  });
});

describe("the VHF is lost", () => {
  before(async () => {
    await rig.say("fault", "vhf-lost");
    await eventually("the bridge sees its set dead", () => bridge.getByText(/VHF is dead/).isVisible());
  });

  test("an order in words is not heard, and whoever gave it hears nothing come back; a hand signal is seen", async () => {
    await give("Pay out to \u2026", "Pay out to 2 shackles");
    await eventually("nothing came back", () =>
      said("no answer from the forecastle; ordered: pay out port cable to 2 shackles").isVisible(),
    );
    await give("Check");
    await eventually("the signal is seen", () => order("check port cable, by hand signal").isVisible());
    assert.equal(await order("pay out port cable to 2").count(), 0, "what was given before the signal has not come");
    assert.ok(!(await spoken(deck)).some((words: string) => /check/i.test(words)), "a signal has no voice");
  });

  test("a report is not heard but for the bell, and the forecastle is told", async () => {
    await report("Brought up", { leaf: "Riding" });
    await eventually("no answer", () =>
      deck.locator(".log li", { hasText: "no answer from the bridge; reported: she is brought up" }).isVisible(),
    );
    await report("n on deck", { choice: "3" });
    await eventually("the bell", () => said("bell: 3 strokes").isVisible());
    assert.equal(await said("brought up").count(), 0);
    assert.equal(await said("3 shackles on deck").count(), 0);
    assert.ok(!(await spoken(bridge)).some((words: string) => /brought up|on deck/i.test(words)));
  });

  test("words pass again when it is mended", async () => {
    await rig.say("fault", "vhf-lost", "--clear");
    await eventually("it works", () => bridge.getByText("VHF works").isVisible());
    await give("Stand clear");
    await says(deck, "Stand clear of the port cable");
  });
});

test("a page that has heard nothing yet says that it waits, and not whose the helm is", async () => {
  const page = await openPage(bridgeUrl);
  const kept: (string | Buffer)[] = [];
  let pass: () => void;
  await page.routeWebSocket(/\/ws/, (socket) => {
    const server = socket.connectToServer();
    pass = () => {
      for (const message of kept.splice(0)) socket.send(message);
    };
    server.onMessage((message) => (pass ? kept.push(message) : socket.send(message)));
  });
  await page.reload();
  const owner = page.locator(".helm-bar strong");
  await eventually("the helm waits", async () => (await owner.textContent()) === "waiting \u2026");
  await eventually("the VHF waits", () => page.locator(".vhf", { hasText: "VHF: waiting" }).count());
  const letAll = pass;
  pass = undefined; // what comes from now on goes through
  letAll();
  await eventually("it is known", async () => (await owner.textContent()) === "nobody");
  await eventually("and the VHF", () => page.getByText("VHF works").isVisible());
  hadNoProblems(page);
  await closePage(page);
});

test("a seat is told that the lesson is over, and why, while the exercise runs on", async () => {
  const short = new Rig();
  try {
    short.server("L13_runaway"); // 3 min, when nobody does anything
    const station = await short.station("forecastle");
    const page = await openPage(station.url.replace("#", "?picture=off#"));
    const over = page.getByText(/^The lesson is over/);
    await eventually("it runs", async () => /^running/.test(await page.locator(".top-bar .state").textContent()));
    assert.equal(await over.isVisible(), false);
    await short.say("time-scale", "20");
    await eventually("it is said", () => over.isVisible(), 180000);
    await eventually(
      "and where his marks are",
      async () =>
        (await over.textContent()) ===
        "The lesson is over: the bridge had no answer. What came of it stands under Marks.",
    );
    const marks = page.getByRole("dialog", { name: "what came of it" });
    await eventually("they are shown", () => marks.isVisible());
    await marks.getByRole("heading", { name: /^Not (yet|shown): \d+\.\d of 100 points, \d+ are needed$/ }).waitFor();
    await marks.getByRole("heading", { name: "To work on next time" }).waitFor();
    await passesAxe(page);
    await short.say("reset");
    await eventually("a new run has none", async () => !(await marks.isVisible()));
    assert.equal(await page.getByRole("button", { name: "Marks" }).isVisible(), false);
    await short.say("start");
    await eventually("it runs again", async () => /^running/.test(await page.locator(".top-bar .state").textContent()));
    await closePage(page);
  } finally {
    await short.end();
  }
});

test("when the exercise is over the briefing says so", async () => {
  await rig.say("stop");
  await eventually("it is over", () => deck.locator('.top-bar .state[data-state="RUN_FINISHED"]').isVisible());
  const marks = deck.getByRole("dialog", { name: "what came of it" });
  await marks.getByText("It was ended before its lesson was done").waitFor(); // the lesson ends with its exercise
  await marks.getByRole("button", { name: "Close" }).click();
  await deck.getByRole("button", { name: "Briefing" }).click();
  await eventually("it says so", () => briefing(deck).getByText("The exercise is over.").isVisible());
});
