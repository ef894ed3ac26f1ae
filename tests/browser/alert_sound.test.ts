// The warning of the anchor watch is heard on every page that shows alerts, until it is acknowledged.

import assert from "node:assert/strict";
import { after, afterEach, before, test } from "node:test";

import { type TestPage, closeBrowser, openPage } from "./browser";
import { hadNoProblems } from "./pages";
import { Rig, eventually } from "./rig";

const rig = new Rig();
const pages = {} as Record<"bridge" | "watch" | "desk", TestPage>;

/**
 * window.beeps: how often this page's loudspeaker became loud; window.audio: its context. As browsers do unless they
 * are told otherwise, sound waits for the first touch of the page.
 */
const listen = () => {
  localStorage.setItem("windlass.views", "plan");
  window.beeps = 0;
  const connect = AudioNode.prototype.connect as (this: AudioNode, to: AudioNode, ...more: number[]) => AudioNode;
  AudioNode.prototype.connect = function (this: AudioNode, to: AudioNode, ...more: number[]) {
    if (to === this.context.destination) {
      const ear = new AnalyserNode(this.context);
      connect.call(this, ear);
      const heard = new Float32Array(ear.fftSize); // 40 ms and more
      let loud = false;
      setInterval(() => {
        ear.getFloatTimeDomainData(heard);
        const before = loud;
        loud = heard.some((value) => Math.abs(value) > 0.01);
        if (loud && !before) window.beeps += 1;
      }, 20);
    }
    return connect.call(this, to, ...more);
  } as typeof AudioNode.prototype.connect;
  let touched = false;
  addEventListener("pointerdown", () => (touched = true), true);
  window.AudioContext = class extends AudioContext {
    constructor() {
      super();
      window.audio = this;
      void this.suspend();
    }
    override resume() {
      return touched ? super.resume() : Promise.resolve();
    }
  };
};
const beeps = (page: TestPage) => page.evaluate(() => window.beeps);
const sound = (page: TestPage) => page.locator(".top-bar .sound");
const watch = () => pages.watch.getByRole("tabpanel", { name: "Anchor watch" });
const alert = (page: TestPage) => page.locator('.alert-list li[data-code="watch.circle"]');
const each = <T>(look: (page: TestPage, name: string) => T): Promise<Awaited<T>[]> =>
  Promise.all(Object.entries(pages).map(([name, page]) => look(page, name)));

const state = () => watch().locator(".watch-state").textContent();
/** Keeps watch on a circle round the ship as she lies, who is 112.5 m from midships to bow. */
async function keepWatch(radius: number) {
  await watch().getByRole("combobox", { name: "centre of the circle" }).selectOption("ship");
  await watch().getByRole("spinbutton", { name: "radius, m" }).fill(`${radius}`);
  const kept = new RegExp(`of ${radius} m`);
  await eventually("the circle is kept", async () => {
    await watch()
      .getByRole("button", { name: /^(Keep watch|Set anew)$/ })
      .click();
    // A station that a server does not know yet says so: an officer gives the order again.
    await eventually("it is set or not", async () => kept.test(await state()) || /Not set/.test(await state()), 5000);
    if (kept.test(await state())) return true;
    throw new Error(await state());
  });
}
const sounds = (page: TestPage, name: string) =>
  beeps(page).then((before) => eventually(`${name} sounds`, async () => (await beeps(page)) > before));

before(
  async () => {
    rig.server("anchor_and_weigh_25m");
    const bridge = await rig.station("bridge");
    const desk = await rig.desk();
    pages.bridge = await openPage(bridge.url, { init: listen });
    pages.watch = await openPage(bridge.url.replace("/bridge#", "/watch#"), { init: listen });
    pages.desk = await openPage(desk.url, { init: listen });
    await each((page, name) =>
      eventually(`${name} hears the exercise`, async () =>
        /running/.test(await page.locator(".top-bar .state").textContent()),
      ),
    );
  },
  { timeout: 180000 },
);
after(async () => {
  await closeBrowser();
  await rig.end();
});
afterEach(() => each(hadNoProblems));

test("a page whose sound waits for a touch says so, and says it louder when an alert is not heard", async () => {
  await each((page, name) =>
    eventually(`${name} says it`, async () => /sound: touch to begin$/.test(await sound(page).textContent())),
  );
  await keepWatch(100);
  // The watch was touched to keep it.
  for (const name of ["bridge", "desk"] as const)
    await eventually(
      `${name} says that it is not heard`,
      async () => (await sound(pages[name]).textContent()) === "alert unheard: touch",
    );
  assert.equal(await beeps(pages.bridge), 0);
  for (const name of ["bridge", "desk"] as const) {
    await pages[name].locator("h1").click();
    await eventually(`${name}: on`, async () => (await sound(pages[name]).textContent()) === "sound on");
  }
});

test("the circle's warning sounds on bridge, anchor watch and desk, again and again", async () => {
  await each(sounds);
  await each(sounds);
});

test("a page that is muted says that an alert is not heard", async () => {
  await sound(pages.desk).click();
  await eventually("it says so", async () => (await sound(pages.desk).textContent()) === "alert unheard: muted");
  await sound(pages.desk).click();
  await eventually("it is heard", async () => (await sound(pages.desk).textContent()) === "sound on");
});

test("acknowledged on one page it is silent on all, and the next one sounds", async () => {
  await pages.watch.locator(".alert-button").click();
  // Other alerts may stand, and go while they are looked at: a loaded machine has its own.
  const open = pages.watch.locator(".alert-list li button");
  await eventually("all are acknowledged", async () => {
    if ((await open.count()) === 0) return true;
    await open.first().click({ timeout: 1000 });
    return false;
  });
  await each((page, name) =>
    eventually(`${name} has it`, async () => /, acknowledged/.test(await alert(page).textContent())),
  );
  const heard = await each((page) => page.evaluate(() => ({ beeps: window.beeps, time: window.audio.currentTime })));
  // Two turns of a warning's pattern later none was heard again.
  await each((page, name) =>
    eventually(`${name} plays on`, () =>
      page.evaluate((before) => window.audio.currentTime > before + 7, heard[Object.keys(pages).indexOf(name)].time),
    ),
  );
  assert.deepEqual(
    await each(beeps),
    heard.map(({ beeps }) => beeps),
  );
  await keepWatch(400);
  await each((page, name) => eventually(`${name}: inside`, async () => (await alert(page).count()) === 0));
  await keepWatch(100);
  await each(sounds);
});

test("an order that is not taken says so until the next one", async () => {
  const clock = () => pages.watch.locator(".top-bar .time").textContent();
  await watch().getByRole("spinbutton", { name: "radius, m" }).fill("5");
  await watch().getByRole("button", { name: "Set anew" }).click();
  const refused = /^Not set: the radius is 10 to 2000 m\. /;
  await eventually("it is refused", async () => refused.test(await state()));
  const then = await clock();
  await eventually("time goes by", async () => (await clock()) !== then); // the panel is written anew meanwhile
  assert.match(await state(), refused);
  await keepWatch(400);
  assert.doesNotMatch(await state(), /Not set/);
});
