// The forecastle's page, worked as a trainee works it, against a real server.

import assert from "node:assert/strict";
import { after, afterEach, before, describe, test } from "node:test";

import type { Locator } from "playwright-core";

import { type TestPage, closeBrowser, closePage, openPage } from "./browser";
import { hadNoProblems, hasPalettes, holdDown, passesAxe, unreachable } from "./pages";
import { type Station, Rig, eventually, sleep } from "./rig";

const kWheelTurns = 5;
// How far a hand-wheel in the truth may be off where the page's hand has put it: the server's wheel follows within
// a few frames, and the truth is told once a second.
const kNear = 0.02;
/** Of the hand-wheel's way. */
const degrees = (angle: number) => angle / 360 / kWheelTurns;
const near = (a: number, b: number, tolerance = kNear) => Math.abs(a - b) <= tolerance;

const rig = new Rig();
let station: Station;
let page: TestPage;

const wheel = () => page.getByRole("slider", { name: "brake hand-wheel" });
const lever = () => page.getByRole("slider", { name: "speed lever" });
const clutch = () => page.getByRole("switch", { name: "clutch" });
const stopper = () => page.getByRole("switch", { name: "chain stopper" });
const emergency = () => page.getByRole("switch", { name: "emergency stop" });
const owner = () => page.locator(".owner").textContent();
const setBrake = async () => Number(await wheel().getAttribute("aria-valuenow")) / 100;
const setSpeed = async () => Number(await lever().getAttribute("aria-valuenow")) / 100;

/** Holds the mouse on a guarded button, or a key, until the lever is at its other place. */
async function hold(button: () => Locator, key?: string) {
  const before = await button().getAttribute("aria-checked");
  if (key) await page.keyboard.down(key);
  else {
    await button().hover();
    await page.mouse.down();
  }
  await eventually("the lever moves", async () => (await button().getAttribute("aria-checked")) !== before);
  if (key) await page.keyboard.up(key);
  else await page.mouse.up();
}

/** A stand-in for navigator.getGamepads: window.pads is what it gives. */
const padStub = () => {
  window.pads = [null];
  navigator.getGamepads = () => window.pads as unknown as Gamepad[];
};
/** Gives window.cut(true), which shuts the page's socket and lets no other open, until window.cut(false). */
const cutter = () => {
  let shut = false;
  const sockets = new Set<WebSocket>();
  window.WebSocket = class extends WebSocket {
    constructor(address: string | URL, protocols?: string | string[]) {
      super(shut ? new URL("/nowhere", address) : address, protocols);
      sockets.add(this);
    }
  };
  window.cut = (on: boolean) => {
    shut = on;
    if (on) for (const socket of sockets) socket.close();
  };
};

/**
 * Axes and buttons (number: value) of the gamepad from now on; null: unplugged. Comes back when the page has read it.
 */
const pad = (state: { axes?: number[]; buttons?: Record<number, number> } | null) =>
  page.evaluate((state) => {
    window.pads = [
      state && {
        connected: true,
        index: 0,
        mapping: "standard",
        axes: [0, 0, 0, 0].map((zero, i) => state.axes?.[i] ?? zero),
        buttons: Array.from({ length: 16 }, (_, i) => ({
          value: state.buttons?.[i] ?? 0,
          pressed: (state.buttons?.[i] ?? 0) > 0.5,
        })),
      },
    ];
    return new Promise((read) => requestAnimationFrame(() => requestAnimationFrame(read)));
  }, state);

/** The page's address; without its picture, which takes more of a machine without a GPU than all the rest. */
const address = (query = "picture=off") => station.url.replace("#", `?${query}#`);

async function open(options = {}) {
  page = await openPage(address(), { init: padStub, ...options }); // an init of the options takes the place of the stub
  await eventually("the stand shows the windlass", () => page.locator(".counter strong").first().textContent());
  await eventually("the levers may be moved", () => clutch().isEnabled());
}

/** Stopper on, brake hard on, clutch out, lever at zero: as the exercise begins. */
async function secure() {
  await page.keyboard.press("b");
  await rig.truly("the brake is hard on", ({ port }) => port.windlass.brake_position > 0.99);
}

before(
  async () => {
    rig.server("anchor_and_weigh_25m");
    station = await rig.station("forecastle");
    await open();
  },
  { timeout: 180000 },
);
after(async () => {
  await closeBrowser();
  await rig.end();
});
afterEach(() => hadNoProblems(page));

test("the ammeter has a red line at the motor's rated current, and says what it is", async () => {
  const motor = page.getByRole("meter", { name: "motor" });
  await eventually("it stands on the face", async () => (await motor.locator(".red-line").count()) === 1);
  assert.equal(await motor.getAttribute("title"), "red line: rated current, 180 A");
});

test("the figures of the speed lever stand beside its knob, not under it", async () => {
  const under = await page.evaluate(() => {
    const knob = document.querySelector(".slot .knob").getBoundingClientRect();
    return [...document.querySelectorAll(".slot .tick")].filter((tick) => {
      const words = document.createRange();
      words.selectNodeContents(tick);
      const { left, right, top, bottom } = words.getBoundingClientRect();
      return right > left && right > knob.left && bottom > knob.top && top < knob.bottom;
    }).length;
  });
  assert.equal(under, 0);
});

describe("levers as found", () => {
  test("a page that only looks on takes nothing", async () => {
    await eventually("nobody has the levers", async () => (await owner()) === "nobody");
    const { port } = await rig.truly("the port windlass is heard of", ({ port }) => port.windlass);
    await eventually("the rim stands where the wheel is", async () =>
      near(await setBrake(), port.windlass.brake_position),
    );
    await eventually(
      "and the stopper",
      async () => (await stopper().getAttribute("aria-checked")) === `${port.windlass.stopper_closed}`,
    );
  });

  test("the first touch takes them, and moves no other", async () => {
    await page.keyboard.press("x");
    await page.keyboard.press("ArrowDown");
    await eventually("the levers are this page's", async () => (await owner()) === "mine");
    await eventually("a tap is ten degrees", async () => near(await setBrake(), 1 - degrees(10), 0.0011));
    const set = await setBrake();
    const { port } = await rig.truly("the brake follows", ({ port }) => near(port.windlass.brake_position, set));
    assert.equal(port.windlass.stopper_closed, true);
    assert.equal(port.windlass.clutch, "CLUTCH_OUT");
    await secure();
  });
});

test("with the anchor home the counter stands below zero, and says that this is up the pipe", async () => {
  const counter = page.getByRole("group", { name: "chain counter" });
  await eventually("it stands below zero", async () =>
    /^Counter inboard of the lip\u2212\d\.\dm\u22120\.\dshackles/.test(await counter.textContent()),
  );
});

describe("by mouse", () => {
  test("the hand-wheel turns as far as it is dragged round its hub", async () => {
    const box = await wheel().boundingBox();
    const [x, y, r] = [box.x + box.width / 2, box.y + box.height / 2, 0.4 * box.width];
    const at = (turns: number): [number, number] => [
      x + r * Math.sin(2 * Math.PI * turns),
      y - r * Math.cos(2 * Math.PI * turns),
    ];
    await page.mouse.move(...at(0));
    await page.mouse.down();
    for (let step = 1; step <= 36; ++step) {
      await page.mouse.move(...at(-1.5 * (step / 36)));
      await sleep(60); // slower than the wheel may be turned
    }
    await eventually("one and a half turns off", async () => near(await setBrake(), 1 - 1.5 / kWheelTurns, 0.03));
    await page.mouse.up();
    const set = await setBrake();
    await rig.truly("the brake follows", ({ port }) => near(port.windlass.brake_position, set));
    await eventually("in turns", async () =>
      /^brake 3 turns (1[3-9]|2[0-3])\d\u00b0/.test(await wheel().getAttribute("aria-valuetext")),
    );
  });

  test("hard on spins it, no faster than a hand can", async () => {
    const from = await setBrake();
    const begin = await page.evaluate(() => performance.now());
    await page.getByRole("button", { name: "Hard on" }).click();
    await eventually("the rim is hard on", async () => (await setBrake()) > 0.99);
    const took = ((await page.evaluate(() => performance.now())) - begin) / 1000;
    const travel = await page.evaluate(
      () => window.windlass.link.latest("SceneDescription").tackle[0].brake_travel_time,
    );
    assert.ok(took > 0.95 * (1 - from) * travel, `${took} s for ${1 - from} of ${travel} s`);
    await rig.truly("the brake is hard on", ({ port }) => port.windlass.brake_position > 0.99);
  });

  test("the speed lever follows, reaches the windlass, and springs back", async () => {
    const box = await lever().boundingBox();
    const x = box.x + box.width / 2;
    const y = (share: number) => box.y + box.height / 2 - share * (box.height / 2 - 22);
    await page.mouse.move(x, y(0));
    await page.mouse.down();
    await page.mouse.move(x, y(0.52), { steps: 4 });
    await eventually("the detent at 50 % catches it", async () => (await setSpeed()) === 0.5);
    await rig.truly("the windlass has it", ({ port }) => near(port.windlass.speed_lever, 0.5));
    await page.mouse.up();
    await eventually("it has sprung back", async () => (await setSpeed()) === 0);
    await rig.truly("the windlass has it at zero", ({ port }) => port.windlass.speed_lever === 0);
    assert.equal(await lever().evaluate((slot) => slot === document.activeElement), false, "Up is the brake's again");
  });

  test("let go with Shift held, the speed lever stays until it is touched again; the hand is free for the wheel", async () => {
    const box = await lever().boundingBox();
    const x = box.x + box.width / 2;
    const y = (share: number) => box.y + box.height / 2 - share * (box.height / 2 - 22);
    await page.mouse.move(x, y(0));
    await page.mouse.down();
    await page.mouse.move(x, y(0.51), { steps: 4 });
    await page.keyboard.down("Shift");
    await page.mouse.up();
    await page.keyboard.up("Shift");
    await eventually("it says so", async () =>
      /heave 50 %, latched/.test(await lever().getAttribute("aria-valuetext")),
    );
    await page.getByRole("button", { name: "Hard on" }).click();
    await rig.truly("the windlass still has it", ({ port }) => near(port.windlass.speed_lever, 0.5));
    assert.match(await lever().getAttribute("aria-valuetext"), /latched/);
    await lever().click();
    await eventually("a touch releases it", async () => (await setSpeed()) === 0);
    await rig.truly("the windlass has it at zero", ({ port }) => port.windlass.speed_lever === 0);
  });

  test("clutch and stopper act when they are held, not when they are touched", async () => {
    await stopper().click();
    await sleep(900); // well beyond the 0.6 s
    assert.equal(await stopper().getAttribute("aria-checked"), "true");
    await hold(stopper);
    await rig.truly("the stopper is off", ({ port }) => !port.windlass.stopper_closed);
    await hold(clutch);
    await rig.truly("the clutch seeks or is in", ({ port }) => port.windlass.clutch !== "CLUTCH_OUT");
    await eventually("it is seen to", async () =>
      /^(SEEKING|IN)$/.test((await page.locator(".control.clutch .row strong").textContent()) ?? ""),
    );
    await hold(clutch);
    await rig.truly("the clutch is out", ({ port }) => port.windlass.clutch === "CLUTCH_OUT");
    await hold(stopper);
    await rig.truly("the stopper is on", ({ port }) => port.windlass.stopper_closed);
  });

  test("a clutch that bears does not come out: it says so, and its button offers it as it stands", async () => {
    await hold(stopper);
    await hold(clutch);
    await rig.truly("the clutch is in", ({ port }) => port.windlass.clutch === "CLUTCH_IN");
    await page.keyboard.press("0"); // the weight comes onto the clutch
    await rig.truly("the brake is open", ({ port }) => port.windlass.brake_position < 0.01);
    const control = page.locator(".control.clutch");
    const refusals = page.locator(".log li", { hasText: "clutch is loaded and does not come out" });
    for (const tries of [1, 2]) {
      await holdDown(page, clutch());
      await eventually("it is refused", async () => (await refusals.count()) === tries);
      await eventually("it says why", async () =>
        /^under load:/.test((await control.locator(".reason").textContent()) ?? ""),
      );
      assert.equal(await control.locator(".row strong").textContent(), "IN");
      assert.equal(await clutch().textContent(), "Hold: take out");
    }
    await secure();
    await hold(clutch);
    await rig.truly("the clutch is out", ({ port }) => port.windlass.clutch === "CLUTCH_OUT");
    await hold(stopper);
    await rig.truly("as before", ({ port }) => port.windlass.stopper_closed);
  });

  test("the emergency stop latches at one touch and is released by holding", async () => {
    await emergency().click();
    await rig.truly("stopped", ({ port }) => port.windlass.emergency_stop);
    await eventually("its lamp is lit", () => page.locator('.lamp[data-lamp="e-stop"][data-on="warning"]').isVisible());
    await emergency().click();
    await sleep(500);
    assert.equal(await emergency().getAttribute("aria-checked"), "true");
    await hold(emergency);
    await rig.truly("released", ({ port }) => !port.windlass.emergency_stop);
  });
});

describe("by keys", () => {
  test("Down and Up turn the wheel while they are held, a tap by ten degrees, with Shift by two", async () => {
    await page.keyboard.down("ArrowDown");
    await eventually("a fifth off", async () => (await setBrake()) < 0.8);
    await page.keyboard.up("ArrowDown");
    await sleep(200);
    const off = await setBrake();
    await rig.truly("the brake follows", ({ port }) => near(port.windlass.brake_position, off));
    for (let tap = 0; tap < 3; ++tap) await page.keyboard.press("ArrowUp");
    await eventually("on by three taps", async () => near(await setBrake(), off + degrees(30), 0.0011));
    for (let tap = 0; tap < 5; ++tap) await page.keyboard.press("Shift+ArrowUp");
    await eventually("and by five fine ones", async () => near(await setBrake(), off + degrees(40), 0.0011));
    await secure();
  });

  test("Right heaves while it is held, with Shift at a tenth", async () => {
    await page.keyboard.down("ArrowRight");
    await rig.truly("full", ({ port }) => port.windlass.speed_lever > 0.99);
    await page.keyboard.down("Shift");
    await rig.truly("creeping", ({ port }) => near(port.windlass.speed_lever, 0.1));
    await page.keyboard.up("Shift");
    await page.keyboard.up("ArrowRight");
    await rig.truly("zero", ({ port }) => port.windlass.speed_lever === 0);
  });

  test("x takes the speed lever to zero and nothing else: a wheel on its way to hard on goes on", async () => {
    await page.keyboard.press("0");
    await eventually("a fifth off", async () => (await setBrake()) < 0.8);
    await page.keyboard.press("b");
    await page.keyboard.press("x");
    await rig.truly("hard on", ({ port }) => port.windlass.brake_position > 0.99);
  });

  test("c and t are held, e is not", async () => {
    await page.keyboard.press("t");
    await hold(stopper, "t");
    await rig.truly("the stopper is off", ({ port }) => !port.windlass.stopper_closed);
    await hold(clutch, "c");
    await rig.truly("the clutch seeks or is in", ({ port }) => port.windlass.clutch !== "CLUTCH_OUT");
    await page.keyboard.press("e");
    await rig.truly("stopped", ({ port }) => port.windlass.emergency_stop);
    await hold(emergency, "e");
    await rig.truly("released", ({ port }) => !port.windlass.emergency_stop);
    await hold(clutch, "c");
    await hold(stopper, "t");
    await rig.truly("as before", ({ port }) => port.windlass.clutch === "CLUTCH_OUT" && port.windlass.stopper_closed);
    await secure();
  });

  test("p takes the other windlass; this one stays as left", async () => {
    await page.keyboard.press("ArrowDown");
    await sleep(500);
    const left = await setBrake();
    await page.keyboard.press("p");
    await page.keyboard.down("ArrowDown");
    await eventually("starboard's rim is a quarter off", async () => (await setBrake()) < 0.75);
    await page.keyboard.up("ArrowDown");
    await rig.truly(
      "both are where they were put",
      ({ port, starboard }) => near(port.windlass.brake_position, left) && starboard.windlass.brake_position < 0.76,
    );
    await page.keyboard.press("b");
    await rig.truly("starboard hard on", ({ starboard }) => starboard.windlass.brake_position > 0.99);
    await page.keyboard.press("p");
    await secure();
  });

  test("? shows the keys", async () => {
    await page.keyboard.press("?");
    await eventually("they are shown", () => page.getByRole("dialog", { name: "keys and gamepad" }).isVisible());
    await page.keyboard.press("Escape");
  });
});

describe("by gamepad", () => {
  test("stick and triggers are lever and wheel; an unplugged one lets go", async () => {
    await pad({ axes: [0, -1] });
    await rig.truly("heaving", ({ port }) => port.windlass.speed_lever > 0.99);
    await pad({ axes: [0, 0.05], buttons: { 6: 1 } }); // within the dead zone; LT turns the brake off
    await eventually("the wheel is a fifth off", async () => (await setBrake()) < 0.8);
    await rig.truly(
      "the brake follows, the lever is at zero",
      ({ port }) => port.windlass.speed_lever === 0 && port.windlass.brake_position < 0.81,
    );
    await pad({ axes: [0, 1] });
    await rig.truly("lowering", ({ port }) => port.windlass.speed_lever < -0.99);
    await pad(null);
    await rig.truly("let go", ({ port }) => port.windlass.speed_lever === 0);
    await secure();
  });

  test("X and Y are held, Back is not", async () => {
    await pad({ buttons: { 3: 1 } });
    await rig.truly("the stopper is off", ({ port }) => !port.windlass.stopper_closed);
    await pad({ buttons: { 2: 1 } });
    await rig.truly("the clutch seeks or is in", ({ port }) => port.windlass.clutch !== "CLUTCH_OUT");
    await pad({ buttons: { 8: 1 } });
    await rig.truly("stopped", ({ port }) => port.windlass.emergency_stop);
    await pad({});
    await pad({ buttons: { 8: 1 } });
    await rig.truly("released", ({ port }) => !port.windlass.emergency_stop);
    await pad({});
    await hold(clutch, "c");
    await hold(stopper, "t");
    await pad(null);
    await rig.truly("as before", ({ port }) => port.windlass.clutch === "CLUTCH_OUT" && port.windlass.stopper_closed);
    await secure();
  });
});

describe("hands off", () => {
  for (const [why, leave] of [
    ["the window loses the focus", () => page.evaluate(() => dispatchEvent(new Event("blur")))],
    [
      "the window loses the focus, latched or not",
      async () => {
        await page.keyboard.down("Shift");
        await page.mouse.up();
        await page.keyboard.up("Shift");
        await eventually("it is latched", async () => /latched/.test(await lever().getAttribute("aria-valuetext")));
        await page.evaluate(() => dispatchEvent(new Event("blur")));
      },
    ],
    ["the pointer is lost", () => lever().dispatchEvent("pointercancel", { pointerId: 1 })],
  ] as const)
    test(`the speed lever springs back when ${why}`, async () => {
      const box = await lever().boundingBox();
      await page.mouse.move(box.x + box.width / 2, box.y + 30);
      await page.mouse.down();
      await rig.truly("heaving", ({ port }) => port.windlass.speed_lever > 0.9);
      await leave();
      await rig.truly("zero", ({ port }) => port.windlass.speed_lever === 0);
      await page.mouse.up();
    });

  test("a hidden page gives the levers out of its hand, the lever first at zero", async () => {
    await page.keyboard.down("ArrowRight");
    await rig.truly("heaving", ({ port }) => port.windlass.speed_lever > 0.9);
    await page.evaluate(() => {
      Object.defineProperty(document, "hidden", { value: true, configurable: true });
      document.dispatchEvent(new Event("visibilitychange"));
      delete (document as { hidden?: boolean }).hidden;
    });
    await page.keyboard.up("ArrowRight");
    await eventually("nobody has them", async () => (await owner()) === "nobody");
    await rig.truly("zero", ({ port }) => port.windlass.speed_lever === 0);
    await page.evaluate(() => document.dispatchEvent(new Event("visibilitychange"))); // in sight again
    await eventually("it says so", () => page.getByText(/^The page was hidden, and its levers were left/).isVisible());
  });
});

describe("the bridge", () => {
  const order = (text: string) => page.locator(".orders li", { hasText: text });
  const log = (text: string | RegExp) => page.locator(".log li", { hasText: text }).first();

  test("an order is repeated back with the figure that the trainee says", async () => {
    await rig.say("order", "hold-on", "6", "--side", "port");
    await eventually("it is heard", () => order("hold on port cable at 6 shackles").isVisible());
    await page.keyboard.press("o");
    await page.getByRole("dialog").getByRole("button", { name: "5", exact: true }).click();
    await eventually("wrong", () => order("repeated wrongly").isVisible());
    await page.keyboard.press("o");
    await page.getByRole("dialog").getByRole("button", { name: "6", exact: true }).click();
    await eventually(
      "right",
      async () => (await order("hold on port cable at 6").getAttribute("data-state")) === "ORDER_REPEATED",
    );
  });

  test("an order without a figure is repeated at one touch", async () => {
    await rig.say("order", "stand-by", "--side", "port");
    await order("stand by").getByRole("button").click();
    await eventually("repeated", async () => (await order("stand by").getAttribute("data-state")) === "ORDER_REPEATED");
    await eventually("the log has it", () => log(/^[\d:]*order \d+ repeated: stand by port anchor$/).isVisible());
    assert.equal(await page.locator(".log li", { hasText: "repeats: stand by" }).count(), 0, "one act, one line");
  });

  test("reports say what was touched, and no more", async () => {
    const button = (name: string) => page.locator(".reports").getByRole("button", { name, exact: true });
    const choice = (name: string) => page.getByRole("dialog").getByRole("button", { name, exact: true });
    await button("Standing by").click();
    await eventually("reported", () => log("standing by").isVisible());
    await button("On the bottom").click(); // a touch: a let-go waits for it for some seconds only
    await eventually("reported", () => log("on the bottom").isVisible());
    const open = () => page.locator(".leaves [aria-pressed=true]").textContent();
    await eventually("the pad goes on with the work", async () => (await open()) === "Bringing up");
    assert.equal(await button("Home").count(), 0, "what the phase does not ask for");
    await button("Weighing").click();
    assert.ok(await button("Home").isVisible(), "is a touch away");
    await button("Bringing up").click();
    await button("Growing, weight").click();
    await choice("Tight").click();
    await eventually("reported", () => log("tight").isVisible());
    await button("Growing, weight").click();
    await choice("Much weight").click();
    await eventually("reported", () => log(/much weight/).isVisible());
    await button("n in water").click();
    await choice("3").click();
    await eventually("reported", () => log(/3 .*water/).isVisible());
    await button("n in water").click();
    await choice("1\u00bd").click(); // at one touch, as the wholes
    await eventually("reported", () => log(/1\.5 .*water/).isVisible());
    const set = await setBrake();
    await button("n in water").click();
    await page.keyboard.type("10"); // a figure, and neither a look over the rail nor a brake wide open
    await page.keyboard.press("Enter");
    await eventually("reported", () => log(/10 .*water/).isVisible());
    assert.equal(await setBrake(), set);
    assert.match(await page.locator(".cameras [aria-pressed=true]").first().textContent(), /Stand/);
    await button("Lead").click();
    await choice("11 o'clock").click();
    await choice("Short stay").click();
    await eventually("reported", () => log(/11/).isVisible());
    await button("Own words").click();
    await page.getByRole("textbox", { name: "report in own words" }).fill("cable is clear of the anchor");
    await page.keyboard.press("Enter");
    await eventually("reported", () => log("cable is clear of the anchor").isVisible());
    await eventually("what was chosen from is shut", async () => (await page.getByRole("dialog").count()) === 0);
  });

  test("a question offers what answers it, and stands out until it is answered", async () => {
    const dialog = page.getByRole("dialog", { name: "is she brought up?" });
    await rig.say("order", "brought-up", "--side", "port");
    const asked = order("is she brought up?");
    await asked.getByRole("button", { name: /^answer/ }).click();
    for (const answer of ["Brought up", "She is dragging", "Slack", "Growing", "Tight", "12 o'clock"])
      assert.ok(await dialog.getByRole("button", { name: answer, exact: true }).isVisible(), answer);
    assert.equal(await asked.getAttribute("data-stands"), "");
    await dialog.getByRole("button", { name: "Tight", exact: true }).click();
    await eventually("it is answered", () => asked.getByText("answered").isVisible());
    assert.equal(await asked.getAttribute("data-stands"), null);
    assert.equal(await asked.getByRole("button").count(), 0);
    const first = page.locator(".orders li").first();
    assert.match(await first.textContent(), /hold on port cable/, "what is in force stands over what was answered");
    assert.equal(await first.getAttribute("data-stands"), "");
  });
});

test("an alert sounds, is acknowledged by F2, and stays until it is rectified", async () => {
  for (let tap = 0; tap < 12; ++tap) await page.keyboard.press("ArrowDown"); // who leaves her secured raises none
  await eventually("mine", async () => (await owner()) === "mine");
  await rig.truly("the brake is not hard on", ({ port }) => port.windlass.brake_position < 0.94);
  await page.getByRole("button", { name: "Leave them" }).click(); // the windlass is left alone
  await page.locator(".alert-button").click();
  // Others may wait too, the more urgent first (a loaded machine has its own): F2 takes them one by one.
  const unattended = page.locator('.alert-list li[data-code="levers.unattended"]', { hasText: "port" });
  const waiting = unattended.locator("button");
  await eventually("it waits for a hand", async () => (await waiting.count()) === 1);
  await eventually("it is acknowledged", async () => {
    if ((await waiting.count()) === 0) return true;
    await page.keyboard.press("F2");
    await sleep(500); // an acknowledgement's way to the server and back
    return false;
  });
  assert.equal(await unattended.count(), 1, "acknowledged, it stays");
  await page.locator(".alert-button").click();
  await secure(); // a hand comes back
  await eventually("it is rectified", async () => (await unattended.count()) === 0);
});

test("the deck's blows are made on the audio's own thread, as far as the station lets its page", async () => {
  const listening = await openPage(address(), {
    // window.beeps: how many there are that make them
    init: () => {
      window.beeps = 0;
      window.AudioWorkletNode = class extends AudioWorkletNode {
        constructor(...given: ConstructorParameters<typeof AudioWorkletNode>) {
          super(...given);
          window.beeps += 1;
        }
      };
    },
  });
  await listening.locator("h1").click();
  await eventually("links and claws of both windlasses", () => listening.evaluate(() => window.beeps === 4));
  hadNoProblems(listening);
  await closePage(listening);
});

test("what the instructor takes is said plainly, follows him, and comes back", async () => {
  await page.keyboard.press("ArrowDown");
  await eventually("mine", async () => (await owner()) === "mine");
  const instructor = rig.console("levers", "--side", "port", "--brake", "0.6");
  await eventually("it is said", async () => (await owner()) === "instructor has taken over");
  await eventually("the wheel follows him", async () => near(await setBrake(), 0.6, 0.011));
  await eventually("nothing can be moved here", () => clutch().isDisabled());
  await page.keyboard.press("b");
  await sleep(500);
  assert.ok(near(await setBrake(), 0.6, 0.011), "a hand that has no levers moves none");
  await instructor.stop("SIGINT");
  await eventually("mine again", async () => (await owner()) === "mine");
  await sleep(1500); // time to lurch, and for the truth to be told
  await rig.truly("nothing lurches when he hands back", ({ port }) => near(port.windlass.brake_position, 0.6));
  await secure();
});

test("a second page of the station and a second station look on, and say whose the levers are", async () => {
  await page.keyboard.press("ArrowDown");
  await eventually("mine", async () => (await owner()) === "mine");
  const second = await openPage(address());
  const theirs = second.locator(".owner");
  await eventually("the other page's", async () => (await theirs.textContent()) === "another page of this station");
  await second.keyboard.press("0");
  await eventually("it is refused plainly", async () =>
    /another page/.test(await second.locator(".notice").textContent()),
  );
  hadNoProblems(second);
  await closePage(second);
  await eventually("still mine", async () => (await owner()) === "mine");
  await secure();

  const other = await rig.station("forecastle", { name: "trainee-2" });
  const looker = await openPage(other.url.replace("#", "?picture=off#"));
  await eventually("named", async () => (await looker.locator(".owner").textContent()) === "forecastle-1");
  await page.getByRole("button", { name: "Leave them" }).click();
  await eventually("nobody's", async () => (await looker.locator(".owner").textContent()) === "nobody");
  await looker.keyboard.press("ArrowUp");
  await eventually("the other's", async () => (await owner()) === "trainee-2");
  hadNoProblems(looker);
  await closePage(looker);
  await eventually("nobody's again", async () => (await owner()) === "nobody");
});

test("every palette, no serious finding of axe in any", { timeout: 300000 }, async () => {
  await hasPalettes(page);
});

test("what is touched by a finger reaches the windlass", async () => {
  await closePage(page);
  await open({ hasTouch: true });
  const touch = await page.context().newCDPSession(page);
  const send = (type: "touchStart" | "touchMove" | "touchEnd", points: [number, number][]) =>
    touch.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y]) => ({ x, y })) });
  const box = await lever().boundingBox();
  const x = box.x + box.width / 2;
  await send("touchStart", [[x, box.y + box.height / 2]]);
  await send("touchMove", [[x, box.y + box.height - 5]]);
  await rig.truly("lowering", ({ port }) => port.windlass.speed_lever < -0.99);
  await send("touchEnd", []);
  await rig.truly("zero", ({ port }) => port.windlass.speed_lever === 0);

  const rim = await wheel().boundingBox();
  const at = (turns: number): [number, number] => [
    rim.x + rim.width * (0.5 + 0.4 * Math.sin(2 * Math.PI * turns)),
    rim.y + rim.height * (0.5 - 0.4 * Math.cos(2 * Math.PI * turns)),
  ];
  await send("touchStart", [at(0)]);
  for (let step = 1; step <= 30; ++step) {
    await send("touchMove", [at(-step / 30)]);
    await sleep(60);
  }
  await eventually("one turn off", async () => near(await setBrake(), 1 - 1 / kWheelTurns, 0.03));
  await send("touchEnd", []);
  const set = await setBrake();
  await rig.truly("the brake follows", ({ port }) => near(port.windlass.brake_position, set));

  const button = await stopper().boundingBox();
  await send("touchStart", [[button.x + 20, button.y + 20]]);
  await rig.truly("the stopper is off", ({ port }) => !port.windlass.stopper_closed);
  await send("touchEnd", []);
  await hold(stopper, "t");
  await rig.truly("the stopper is on", ({ port }) => port.windlass.stopper_closed);
  await secure();
});

test("the picture is drawn, from where the keys say, and the same again when nothing moves", async () => {
  await closePage(page);
  page = await openPage(address("still=1"), { viewport: { width: 1280, height: 800 } });
  await eventually("links, deck and sea are drawn", () =>
    page.evaluate(() => window.windlass.stats()?.triangles > 10000),
  );
  await rig.say("pause");
  const picture = () => page.locator(".scene canvas").screenshot();
  for (const [key, name] of [
    ["2", "Over the bow"],
    ["1", "Stand"],
  ]) {
    await page.keyboard.press(key);
    await eventually(
      `from ${name}`,
      async () => (await page.getByRole("button", { name, exact: true }).getAttribute("aria-pressed")) === "true",
    );
  }
  await eventually("nothing is heard any more", async () => (await page.locator(".captions").innerText()) === "");
  await eventually("two pictures are the same", async () => (await picture()).equals(await picture()), 60000);

  // Who leans over the rail looks closer by a button that is to be seen; no pointer lies on it, nor the focus.
  const stand = await picture();
  await page.keyboard.press("2");
  const touch = (name: string) => page.getByRole("button", { name }).evaluate((button: HTMLElement) => button.click());
  let wide: Buffer;
  // Twice: a busy page may still be on its way there.
  const overTheBow = async () => !(wide = await picture()).equals(stand) && (await picture()).equals(wide);
  await eventually("from over the bow, and the same twice", overTheBow, 60000);
  assert.ok(await page.getByRole("button", { name: "look closer" }).isVisible());
  await touch("look closer");
  await eventually("it is looked at closer", async () => !(await picture()).equals(wide), 60000);
  await touch("look wider");
  await eventually("and as before", async () => (await picture()).equals(wide), 60000);
  await page.keyboard.press("1");

  // By night there is a lamp for the hand; its light is in the lower half, where no button changes.
  await rig.say("environment", "--time-of-day", "23:10");
  const lamp = page.getByRole("button", { name: "Hand lamp" });
  await eventually("a lamp is at hand", () => lamp.isVisible());
  const { x, y, width, height } = await page.locator(".scene canvas").boundingBox();
  const lower = () => page.screenshot({ clip: { x, y: y + height / 2, width, height: height / 2 } });
  let dark: Buffer;
  await eventually("it is dark, and the same twice", async () => (dark = await lower()).equals(await lower()), 60000);
  await page.keyboard.press("l");
  await eventually("it shines", async () => !(await lower()).equals(dark), 60000);
  await page.keyboard.press("l");
  await eventually("it is as dark as before", async () => (await lower()).equals(dark), 60000);
  await rig.say("environment", "--time-of-day", "12:00");
  await rig.say("start");
  await closePage(page);
  await open();
});

describe("a lost connection", () => {
  let left: number; // of the brake
  test("is said at once, gives up the levers, and comes back by itself with everything", async () => {
    await closePage(page);
    await open({ init: cutter });
    await eventually("the levers may be moved", () => clutch().isEnabled());
    await page.keyboard.press("ArrowDown");
    await eventually("mine", async () => (await owner()) === "mine");
    await rig.say("order", "check", "--side", "port");
    await eventually("an order is heard", () => page.locator(".orders li").first().isVisible());
    left = await setBrake();
    await rig.truly("the brake follows", ({ port }) => near(port.windlass.brake_position, left));
    const lines = await page.locator(".log li").count();
    page.lostOnPurpose = true;
    await page.evaluate(() => window.cut(true));
    await eventually("it is said", () => page.locator(".veil").isVisible());
    await eventually("nothing can be moved", () => clutch().isDisabled());
    await page.evaluate(() => window.cut(false));
    await eventually("it is back", async () => !(await page.locator(".veil").isVisible()));
    await eventually("the levers may be moved", () => clutch().isEnabled());
    await eventually("the log is whole", async () => (await page.locator(".log li").count()) >= lines);
    await eventually("orders are there", () => page.locator(".orders li").first().isVisible());
    await eventually(`the levers are as they were left, ${left}`, async () => near(await setBrake(), left, 0.011));
  });

  test("a station that was killed and started again says so on its old page, and has the whole state on a new one", async () => {
    page.lostOnPurpose = true;
    await station.stop("SIGKILL");
    await eventually("it is said", () => page.locator(".veil").isVisible());
    station = await rig.station("forecastle", { port: station.port });
    await eventually("the old page is of the earlier run", () =>
      page.getByText("This station was started again").isVisible(),
    );
    await eventually("and what to do", () =>
      page.getByText(/Open the address that the station has printed anew/).isVisible(),
    );
    await closePage(page);
    await open();
    await eventually("orders are there", () => page.locator(".orders li").first().isVisible());
    await eventually(`the levers are as they were left, ${left}`, async () => near(await setBrake(), left, 0.011));
    await secure();
  });
});

test("a first visit explains itself in four pictures, once, and hides nothing that is touched", async () => {
  const url = station.url.replace("#", "?picture=off#");
  const visitor = await openPage(url, { firstVisit: true });
  const guide = visitor.getByRole("region", { name: "first visit" });
  const button = (name: string) => guide.getByRole("button", { name, exact: true });
  const ringed = () =>
    visitor.locator("[data-spoken-of]").evaluateAll((parts) => parts.map((part) => part.getAttribute("aria-label")));
  await eventually("it is there", () => guide.isVisible());
  assert.ok(!(await guide.evaluate((el) => el.contains(document.activeElement))), "the keys are the levers'");
  await eventually("the stand is heard", () => visitor.locator(".counter strong").first().textContent());
  const controls = await unreachable(visitor);
  assert.deepEqual(controls, [], "every control can be touched while it is there");
  await passesAxe(visitor);
  assert.ok(await button("Back").isDisabled());
  const seen = [];
  for (let i = 0; i < 4; ++i) {
    seen.push([await guide.getByRole("heading").textContent(), ...(await ringed())]);
    await button(i < 3 ? "Next" : "Done").press("Enter");
  }
  assert.deepEqual(seen, [
    ["1 of 4: Look", "picture"],
    ["2 of 4: Answer", "orders"],
    ["3 of 4: Work", "stand"],
    ["4 of 4: Report", "reports"],
  ]);
  assert.deepEqual([await guide.isVisible(), await ringed()], [false, []]);
  await visitor.keyboard.press("?");
  await visitor.getByRole("button", { name: "First steps" }).click();
  await eventually("it is back", () => button("Next").isVisible());
  assert.ok(await button("Next").evaluate((el) => el === document.activeElement), "in the hand of who asked for it");
  await visitor.keyboard.press("Escape");
  assert.equal(await guide.isVisible(), false);
  await visitor.reload();
  await eventually("the stand is heard", () => visitor.locator(".counter strong").first().textContent());
  assert.equal(await guide.isVisible(), false, "who was here before is left alone");
  hadNoProblems(visitor);
  await closePage(visitor);
});

test("who works by a finger is told of no keys", async () => {
  const url = station.url.replace("#", "?picture=off#");
  for (const byFinger of [false, true]) {
    const visitor = await openPage(url, { firstVisit: true, hasTouch: byFinger, isMobile: byFinger });
    const guide = visitor.getByRole("region", { name: "first visit" });
    await guide.waitFor();
    assert.equal(/keys 1 to 4/.test(await guide.textContent()), !byFinger);
    await closePage(visitor);
  }
});
