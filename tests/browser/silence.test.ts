// A server that is killed while hands are on its levers: each page says so, shows no state and no gauge as if it were
// of now, and nobody's hand as heard. And what is slow by right is not taken for silence.

import assert from "node:assert/strict";
import { after, afterEach, before, describe, test } from "node:test";

import { type GatewayMessage, type TestPage, closeBrowser, closePage, openPage } from "./browser";
import { hadNoProblems, passesAxe } from "./pages";
import { type Program, Rig, eventually } from "./rig";

let rig: Rig;
let server: Program;
let deck: TestPage, bridge: TestPage, desk: TestPage;

const plan = () => localStorage.setItem("windlass.views", "plan");
const banner = (page: TestPage) => page.locator(".silence");
const state = (page: TestPage) => page.locator(".top-bar .state").textContent();
/** What of the page is marked as old. */
const old = (page: TestPage, selector: string) => page.locator(`${selector}[data-old]`).count();
const runs = (page: TestPage) => eventually("it runs", async () => (await state(page)).startsWith("running"));

/**
 * Lets nothing of the topic window.lost through to the page: in the page itself, since a hundred samples a second by way
 * of the test are more than a slow machine passes on.
 */
const losing = () => {
  localStorage.setItem("windlass.views", "plan");
  const channels = new Map<number, string>();
  window.WebSocket = class extends WebSocket {
    constructor(...how: ConstructorParameters<typeof WebSocket>) {
      super(...how);
      this.addEventListener("message", (event: MessageEvent<string | ArrayBuffer>) => {
        if (typeof event.data === "string")
          for (const { id, topic } of (JSON.parse(event.data) as GatewayMessage).channels ?? [])
            channels.set(id, topic);
        else if (window.lost && channels.get(new DataView(event.data).getUint32(1, true)) === window.lost)
          event.stopImmediatePropagation();
      });
    }
  };
};

/** Keeps, in window.silences, how often the page has said that nothing is heard or marked a panel. */
const counting = () => {
  window.silences = 0;
  addEventListener("DOMContentLoaded", () => {
    const look = () => (window.silences += document.querySelectorAll(".silence:not([hidden]), [data-old]").length);
    new MutationObserver(look).observe(document, {
      subtree: true,
      attributes: true,
      attributeFilter: ["data-old", "hidden"],
    });
  });
};
/** Waits until the server has told its state so many times more, 5 times a second of the wall: they are the clock. */
async function words(page: TestPage, count: number) {
  await page.evaluate(() => {
    window.words ??= window.windlass.link.on("ExerciseStatus", () => ++window.told) && 1;
    window.told = 0;
  });
  await eventually(`${count} words of the server`, () => page.evaluate((n: number) => window.told >= n, count), 240000);
}

async function begin(exercise: string) {
  rig = new Rig();
  server = rig.server(exercise);
  const stations = [await rig.station("forecastle"), await rig.station("bridge"), await rig.desk()];
  deck = await openPage(stations[0].url.replace("#", "?picture=off#"), { init: counting });
  bridge = await openPage(stations[1].url);
  desk = await openPage(stations[2].url, { init: plan });
  for (const page of [deck, bridge, desk]) await runs(page);
}
async function end() {
  await closeBrowser();
  await rig.end();
}

describe("a server that is killed", () => {
  before(() => begin("L05_standing_moor"), { timeout: 120000 });
  after(end);

  test("while forecastle, bridge and desk each have levers", async () => {
    const owner = deck.locator(".owner");
    await eventually(
      "the wheel",
      async () => Number(await deck.getByRole("slider", { name: /brake/ }).first().getAttribute("aria-valuenow")) > 0,
    );
    await deck.keyboard.press("b");
    await eventually("the forecastle has port", async () => (await owner.textContent()) === "mine");
    const helm = bridge.locator(".helm-bar strong");
    await bridge.getByRole("button", { name: "Take helm" }).click();
    await eventually("the bridge has the helm", async () => (await helm.textContent()) === "mine");
    const take = desk.getByRole("button", { name: "take over starboard windlass" });
    await take.hover();
    await desk.mouse.down();
    const who = desk.locator(".lever-card[data-what='1'] .who");
    await eventually("the desk has starboard", async () => (await who.textContent()) === "in your hand");
    await desk.mouse.up();
    for (const page of [deck, bridge, desk]) assert.ok(await banner(page).isHidden());

    await server.stop("SIGKILL");
    for (const page of [deck, bridge, desk]) {
      await eventually("it is said", () => banner(page).isVisible());
      assert.match(await banner(page).textContent(), /^Nothing heard of the exercise for \d+ s: what is shown is old$/);
      assert.equal(await state(page), "not heard");
    }
    for (const said of [owner, helm, who])
      await eventually("nobody hears the hand", async () => (await said.textContent()) === "no server");
  });

  test("leaves no gauge standing as if it were of now", async () => {
    for (const [page, ...panels] of [
      [deck, ".stand .gauges", ".stand .brake", ".stand .clutch"],
      [bridge, ".instruments", ".plan-panel", ".view-out", ".telegraph-panel", ".vhf"],
      [
        desk,
        "table.truth",
        ".plots",
        ".lever-card[data-what='0']",
        ".lever-card[data-what='helm']",
        ".environment",
        ".top-bar .time",
      ],
    ] as [TestPage, ...string[]][])
      for (const panel of panels) await eventually(`${panel} is marked`, () => old(page, panel));
    for (const page of [deck, bridge, desk]) {
      await passesAxe(page);
      hadNoProblems(page);
    }
  });

  test("and started again is heard, and all is of now", async () => {
    rig.server("L05_standing_moor");
    for (const page of [deck, bridge, desk]) {
      await eventually("nothing is said any more", () => banner(page).isHidden());
      await runs(page);
      await eventually("nothing is marked", async () => (await old(page, "")) === 0);
    }
  });
});

describe("a server that dies with an alert", () => {
  before(() => begin("L05_standing_moor"), { timeout: 120000 });
  after(end);

  const alerts = (page: TestPage) => page.locator(".alert-button").textContent();
  const marks = async () => Number((await desk.locator(".timeline canvas").getAttribute("aria-label")).match(/\d+/)[0]);
  const unattended = () => desk.locator('.log li[data-code="levers.lost"]');

  test("that forecastle and desk show, and the desk's timeline and log", async () => {
    const hand = rig.console("levers", "--brake", "1");
    await hand.line(/has the port windlass/);
    await hand.stop();
    for (const page of [deck, desk]) await eventually("an alert", async () => /1 warning/.test(await alerts(page)));
    assert.match(await alerts(bridge), /no alerts/, "it is of the forecastle's panel");
    await eventually("it is logged", async () => (await unattended().count()) === 1);
    assert.match(await unattended().textContent(), /nobody has the port windlass/);
    await eventually("marks", async () => (await marks()) > 1);
  });

  test("owns it no more: while none is heard no page says that there is one", async () => {
    await server.stop("SIGKILL");
    for (const page of [deck, bridge, desk])
      await eventually("nobody's", async () => /alerts not heard/.test(await alerts(page)));
  });

  test("and the next one's desk has nothing of it on its line, and strikes it out in its log", async () => {
    rig.server("L05_standing_moor");
    for (const page of [deck, bridge, desk]) {
      await runs(page);
      await eventually("none", async () => /no alerts/.test(await alerts(page)));
    }
    const stands = '.log li:not(.left)[data-code="exercise.started"]';
    await eventually("the next one's events", async () => (await desk.locator(stands).count()) === 1);
    assert.equal(await desk.locator('.log li.left[data-code="levers.lost"]').count(), 1);
    assert.equal(await desk.locator('.log li:not(.left)[data-code^="levers."]').count(), 0);
    const marked =
      '.log li:not(.left):is(:not([data-severity="info"]), [data-code^="order.given"], [data-code^="report"], [data-code^="fault"])';
    await eventually("its line has the marks of its log alone", async () => {
      return (await marks()) === (await desk.locator(marked).count());
    });
    for (const page of [deck, bridge, desk]) hadNoProblems(page);
  });
});

describe("what is slow by right", () => {
  before(() => begin("L05_standing_moor"), { timeout: 120000 });
  after(end);
  afterEach(() => [deck, bridge, desk].forEach(hadNoProblems));

  for (const [what, ...command] of [
    ["a tenth of the wall's time", "time-scale", "0.1"],
    ["a pause", "pause"],
  ])
    test(`${what} is no silence`, async () => {
      await rig.say(...command);
      await words(deck, 5); // it goes so from here on
      await deck.evaluate(() => (window.silences = 0));
      await words(deck, 60);
      assert.equal(await deck.evaluate(() => window.silences), 0);
      for (const page of [bridge, desk]) {
        assert.ok(await banner(page).isHidden());
        assert.equal(await old(page, ""), 0);
      }
    });

  test("a topic that falls silent alone marks the panels that show it, and no others", async () => {
    await rig.say("time-scale", "1");
    await rig.say("start");
    const page = await openPage("about:blank", { init: losing });
    await page.goto(desk.url() + `#token=${await desk.evaluate(() => sessionStorage.getItem("windlass.token"))}`);
    await runs(page);
    await eventually("figures", async () =>
      /\d/.test(await page.locator("table.truth tbody tr").first().textContent()),
    );
    await eventually("of now", async () => (await old(page, "")) === 0);
    await page.evaluate(() => (window.lost = "/WindlassLoad"));
    await eventually("the truth of the windlass is old", () => old(page, "table.truth"));
    await eventually("its levers too", () => old(page, ".lever-card[data-what='0']"));
    assert.equal(await old(page, ".lever-card[data-what='helm']"), 0);
    assert.equal(await old(page, ".environment"), 0);
    assert.ok(await banner(page).isHidden(), "the exercise is heard");
    await page.evaluate(() => (window.lost = ""));
    await eventually("all of now again", async () => (await old(page, "")) === 0);
    await closePage(page);
  });
});
