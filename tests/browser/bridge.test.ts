// The bridge's page and the anchor watch, worked as a mate works them, against a real server.

import assert from "node:assert/strict";
import { after, afterEach, before, describe, test } from "node:test";

import type { Locator } from "playwright-core";

import { type TestPage, closeBrowser, closePage, openPage } from "./browser";
import { hadNoProblems, hasPalettes } from "./pages";
import { type Station, Rig, eventually } from "./rig";

const kDegree = Math.PI / 180;
const near = (a: number, b: number, tolerance: number) => Math.abs(a - b) <= tolerance;

const rig = new Rig();
let station: Station;
let page: TestPage;

const telegraph = () => page.getByRole("slider", { name: "engine telegraph" });
const wheel = () => page.getByRole("slider", { name: "wheel" });
const thruster = (which: string) => page.getByRole("slider", { name: `${which} thruster` });
const owner = () => page.locator(".helm-bar strong").textContent();
const tab = (name: string) => page.getByRole("tab", { name });
const reads = (control: Locator) => control.getAttribute("aria-valuetext");
const address = (url: string, path: string) => url.replace(/\/bridge#/, `/${path}#`);

/** A stand-in for navigator.getGamepads: window.pads is what it gives. */
const padStub = () => {
  window.pads = [null];
  navigator.getGamepads = () => window.pads as unknown as Gamepad[];
};
const pad = (axis: number, ...pressed: number[]) =>
  page.evaluate(
    ({ axis, pressed }) => {
      const buttons = Array.from({ length: 16 }, (_, i) => ({
        pressed: pressed.includes(i),
        value: pressed.includes(i) ? 1 : 0,
      }));
      window.pads = [{ connected: true, mapping: "standard", axes: [axis, 0, 0, 0], buttons }];
    },
    { axis, pressed },
  );

/** A page of the bridge that shows its instruments. */
async function open(url: string, options = {}) {
  const opened = await openPage(url, { init: padStub, ...options });
  await eventually("the instruments show", async () =>
    /^\d/.test(await opened.getByRole("meter", { name: "HDG" }).getAttribute("aria-valuetext")),
  );
  return opened;
}

/** Drags from one point of an element to others; shares of its box. */
async function drag(control: Locator, points: number[][]) {
  const box = await control.boundingBox();
  const at = ([x, y]: number[]): [number, number] => [box.x + x * box.width, box.y + y * box.height];
  await page.mouse.move(...at(points[0]));
  await page.mouse.down();
  for (const point of points.slice(1)) await page.mouse.move(...at(point), { steps: 5 });
}

before(
  async () => {
    rig.server("anchor_and_weigh_25m");
    station = await rig.station("bridge");
    page = await open(station.url);
  },
  { timeout: 180000 },
);
after(async () => {
  await closeBrowser();
  await rig.end();
});
afterEach(() => hadNoProblems(page));

describe("the helm", () => {
  test("a page that only looks on takes nothing; the first touch takes the helm as it is", async () => {
    await eventually("nobody has the helm", async () => (await owner()) === "nobody");
    await page.keyboard.press("d");
    await eventually("the helm is this page's", async () => (await owner()) === "mine");
    await rig.truly(
      "5 degrees, and nothing else",
      ({ ship }) => near(ship.rudder, 5 * kDegree, 1e-6) && ship.engine === 0 && ship.bow_thruster === 0,
    );
    await eventually(
      "it is read beside the order",
      async () => (await reads(wheel())) === "ordered starboard 5\u00b0, rudder starboard 5\u00b0",
    );
  });

  test("the telegraph by mouse, by its keys and by w and s", async () => {
    const box = await telegraph().boundingBox();
    await page.mouse.click(box.x + box.width / 2, box.y + box.height * (1.5 / 9)); // the second from above
    await eventually("half ahead", async () => /^ordered half ahead/.test(await reads(telegraph())));
    await rig.truly("the engine comes", ({ ship }) => ship.engine > 0.05);
    await telegraph().press("ArrowDown");
    await eventually("slow ahead", async () => /^ordered slow ahead/.test(await reads(telegraph())));
    for (let k = 0; k < 3; ++k) await page.keyboard.press("s");
    await eventually("dead slow astern", async () => /^ordered dead slow astern/.test(await reads(telegraph())));
    await page.keyboard.press("w");
    await eventually("stop", async () => /^ordered stop/.test(await reads(telegraph())));
  });

  test("what another page of the station ordered meanwhile stands when this one comes back, and one lever moves no other", async () => {
    await page.keyboard.press("w");
    await eventually("dead slow ahead", async () => /^ordered dead slow ahead/.test(await reads(telegraph())));
    await page.getByRole("button", { name: "Leave helm" }).click();
    const other = await open(station.url);
    const there = other.getByRole("slider", { name: "engine telegraph" });
    await eventually("it stands there, too", async () => /^ordered dead slow ahead/.test(await reads(there)));
    await other.keyboard.press("s");
    await eventually("stop", async () => /^ordered stop/.test(await reads(there)));
    hadNoProblems(other);
    await closePage(other);
    await eventually("it stands here, too", async () => /^ordered stop/.test(await reads(telegraph())));
    await page.keyboard.press("z");
    await eventually("the helm is this page's", async () => (await owner()) === "mine");
    await rig.truly("the engine comes to a stop", ({ ship }) => Math.abs(ship.engine) < 0.01);
    assert.match(await reads(telegraph()), /^ordered stop/);
    await eventually("no alert is left", async () => {
      await page.keyboard.press("F2");
      return /^\W*no alerts/.test(await page.locator(".alert-button").textContent());
    });
  });

  test("the wheel is turned round its hub, by a and d, and goes amidships by z", async () => {
    const { width, height } = await wheel().boundingBox();
    const unit = Math.min(width / 300, height / 254); // of the drawing, as it fits into its box
    const at = (turned: number) => [
      0.5 + (78 * unit * Math.sin(turned)) / width,
      ((height - 254 * unit) / 2 + 100 * unit - 78 * unit * Math.cos(turned)) / height,
    ];
    await page.keyboard.press("z");
    await eventually("amidships", async () => /^ordered midships/.test(await reads(wheel())));
    await drag(
      wheel(),
      [0, -17, -34].map((degrees) => at(degrees * kDegree)),
    );
    await page.mouse.up();
    // 34 degrees of the wheel are 10 of the rudder
    await eventually("port 10", async () => /^ordered port (9|10|11)\u00b0/.test(await reads(wheel())));
    await rig.truly("the rudder follows", ({ ship }) => near(ship.rudder, -10 * kDegree, 1.5 * kDegree));
    await page.keyboard.press("z");
    await rig.truly("amidships", ({ ship }) => Math.abs(ship.rudder) < 1e-6);
  });

  test("a thruster's lever springs back, or stays when it is told to", async () => {
    const pull = [
      [0.5, 0.3],
      [0.5 + 50 / 232, 0.3],
    ]; // half way to starboard
    await drag(thruster("Bow"), pull);
    await rig.truly("it pushes", ({ ship }) => near(ship.bow_thruster, 0.5, 0.06));
    await page.mouse.up();
    await rig.truly("it has sprung back", ({ ship }) => ship.bow_thruster === 0);
    await page.getByRole("button", { name: "Spring back" }).click();
    await drag(thruster("Stern"), pull);
    await page.mouse.up();
    await rig.truly("it stays", ({ ship }) => near(ship.stern_thruster, 0.5, 0.06));
    await thruster("Stern").press("Home");
    await rig.truly("by hand at zero", ({ ship }) => ship.stern_thruster === 0);
    await page.getByRole("button", { name: "Spring back" }).click();
    await page.locator("h2", { hasText: "Thrusters" }).click();
    await page.keyboard.down(",");
    await rig.truly("to port while the key is held", ({ ship }) => ship.bow_thruster < -0.4);
    await page.keyboard.up(",");
    await rig.truly("and no longer", ({ ship }) => ship.bow_thruster === 0);
    await page.keyboard.down(",");
    await rig.truly("to port again", ({ ship }) => ship.bow_thruster < -0.4);
    await page.evaluate(() => dispatchEvent(new Event("blur")));
    await rig.truly("the hand leaves it with the window's focus", ({ ship }) => ship.bow_thruster === 0);
    await page.keyboard.up(",");
  });

  test("by gamepad: stick, d-pad, triggers; an unplugged one lets go", async () => {
    await pad(1, 12, 7);
    await rig.truly(
      "the rudder goes over, thruster to starboard",
      ({ ship }) => ship.rudder > 0.1 && ship.bow_thruster === 1,
    );
    await eventually("the telegraph shows it", async () => /^ordered dead slow ahead/.test(await reads(telegraph())));
    await eventually("and the wheel", async () => /^ordered starboard 35\u00b0/.test(await reads(wheel())));
    await page.evaluate(() => (window.pads = [null]).length);
    await eventually("amidships", async () => /^ordered midships/.test(await reads(wheel())));
    await rig.truly("no thrust", ({ ship }) => ship.bow_thruster === 0);
    await page.keyboard.press("s");
  });

  test("an instructor takes it over, seen by both; handed back, nothing has moved", async () => {
    // Theirs begins where the rudder is: it must have come back from where the gamepad had it.
    await rig.truly("the rudder is amidships", ({ ship }) => Math.abs(ship.rudder) < 1e-6);
    const desk = await rig.desk();
    const theirs = await open(desk.url.replace(/\/\w+#/, "/bridge#"));
    try {
      const mine = page;
      // Given again until it is seen: a machine that stands still for half a second takes the helm out of their hand,
      // and their page then follows whoever has it.
      await eventually("their order is shown", async () => {
        await theirs.keyboard.press("z");
        await theirs.keyboard.press("a");
        await eventually("port 5", async () => /^ordered port 5\u00b0/.test(await reads(wheel())), 3000);
        return true;
      });
      await eventually(
        "it is said",
        async () => (await mine.locator(".helm-bar strong").textContent()) === "instructor has taken over",
      );
      await eventually("and there", async () => (await theirs.locator(".helm-bar strong").textContent()) === "mine");
      await eventually(
        "it cannot be turned here",
        async () => (await wheel().getAttribute("aria-disabled")) === "true",
      );
      await theirs.getByRole("button", { name: "Leave helm" }).click();
      await eventually("the helm is this page's again", async () => (await owner()) === "mine");
      await eventually("nothing has moved", async () => /^ordered port 5\u00b0/.test(await reads(wheel())));
      await page.keyboard.press("z");
      hadNoProblems(theirs);
    } finally {
      await closePage(theirs); // else their hand stays on the helm of every test that follows
      await desk.stop();
    }
  });
});

describe("the line to the forecastle", () => {
  const said = (text: string) => page.locator(".said li", { hasText: text });
  const order = (text: string) => page.locator('.said li[data-kind="order"]', { hasText: text }).first();
  const state = (text: string) => order(text).getAttribute("data-state");
  let forecastle: Station;
  let deck: TestPage;

  before(async () => {
    forecastle = await rig.station("forecastle");
    deck = await openPage(forecastle.url);
  });
  after(async () => {
    hadNoProblems(deck);
    await closePage(deck);
  });

  test("an order with a figure is heard there, and its repeat here", async () => {
    await page.getByRole("button", { name: "Hold on at \u2026" }).click();
    await page.getByRole("button", { name: "Hold on at 6 shackles" }).click();
    await eventually("given", async () => (await state("at 6 shackles")) === "ORDER_GIVEN");
    await eventually("heard on the forecastle", () =>
      deck.locator(".orders li", { hasText: "hold on port cable at 6 shackles" }).isVisible(),
    );
    // Said again where it is lost: a report of a station that has just begun may find other stations, and no server
    // yet.
    const repeated = async () => (await state("at 6 shackles")) === "ORDER_REPEATED";
    await eventually("repeated", async () => {
      if (await repeated()) return true;
      await deck.keyboard.press("o");
      await deck.getByRole("dialog").getByRole("button", { name: "6", exact: true }).click({ timeout: 5000 });
      return eventually("the server has it", repeated, 3000);
    });
    await eventually("in words", () => said("repeats: hold on port cable at 6 shackles").isVisible());
  });

  test("an order in own words, and one that is cancelled", async () => {
    await page.getByRole("textbox", { name: "order in own words" }).fill("mind the buoy");
    await page.keyboard.press("Enter");
    await eventually("heard on the forecastle", () => deck.getByText("mind the buoy").first().isVisible());
    await page.getByRole("button", { name: "Stand by", exact: true }).click();
    await eventually("given", () => order("stand by").isVisible());
    await order("stand by")
      .getByRole("button", { name: /^cancel order/ })
      .click();
    await eventually("cancelled", async () => (await state("stand by")) === "ORDER_CANCELLED");
  });

  test("an order with more words than fit is not cut: it says so, and does not go out", async () => {
    const words = page.getByRole("textbox", { name: "order in own words" });
    await words.fill("ä".repeat(101));
    await page.keyboard.press("Enter");
    assert.ok(await page.getByText("too long: 202 of 200 characters").isVisible());
    assert.equal(await words.inputValue(), "ä".repeat(101));
    await words.fill("");
    assert.ok(await page.locator(".say .typed-count").isHidden());
  });

  test("keys typed into the order do not steer", async () => {
    const before = await reads(wheel());
    await page.getByRole("textbox", { name: "order in own words" }).fill("");
    await page.keyboard.type("dawz");
    assert.equal(await reads(wheel()), before);
    await page.getByRole("textbox", { name: "order in own words" }).fill("");
  });

  test("'let go' asks for the anchor to be plotted where the hawse was then; cable as reported makes her swinging circle", async () => {
    const report = (name: string) => deck.locator(".reports").getByRole("button", { name, exact: true });
    await report("Letting go").click(); // the order that holds is to hold on
    await report("Let go").click();
    await eventually("heard", () => said("let go").first().isVisible());
    await tab("Anchor watch").click();
    const port = page.getByRole("group", { name: "port anchor" });
    await eventually("it is asked for", () => port.getByText(/Plot: let go at/).isVisible());
    await port.getByRole("button", { name: "plot the port anchor" }).click();
    await eventually("plotted", () => port.getByText(/cable not reported/).isVisible());
    await report("n in water").click();
    await deck.getByRole("dialog").getByRole("button", { name: "4", exact: true }).click();
    // 4 shackles of 27.5 m, 104 m from lip to midships, 112.5 m to the stern
    await eventually("reported", () => port.getByText(/swings 32[67] m/).isVisible());
  });
});

describe("the anchor watch", () => {
  test("its circle alarms when the ship's outline is beyond it, and no longer when it is wide enough", async () => {
    await tab("Anchor watch").click();
    const watch = page.getByRole("tabpanel", { name: "Anchor watch" });
    await watch.getByRole("combobox", { name: "centre of the circle" }).selectOption("ship");
    await watch.getByRole("spinbutton", { name: "radius, m" }).fill("100"); // she is 112.5 m from midships to bow
    await watch.getByRole("button", { name: "Keep watch" }).click();
    await eventually("left", () => watch.getByText(/LEFT: \d+ of 100 m/).isVisible());
    const alert = page.locator('.alert-list li[data-code="watch.circle"]');
    await page.locator(".alert-button").click();
    await eventually("the alert stands", () => alert.getByText("Outside anchor circle").isVisible());
    await eventually("the book has its first line", async () => /m/.test(await watch.getByRole("table").textContent()));
    await watch.getByRole("spinbutton", { name: "radius, m" }).fill("400");
    await watch.getByRole("button", { name: "Set anew" }).click();
    await page.locator(".alert-button").click(); // a touch elsewhere has shut the list
    await eventually("inside", () => watch.getByText(/Inside: \d+ of 400 m/).isVisible());
    await eventually("rectified", () => alert.getByText(/rectified/).isVisible());
    await alert.getByRole("button", { name: /acknowledge/ }).click();
    await eventually("acknowledged and gone", async () => (await alert.count()) === 0);
    await page.keyboard.press("Escape"); // unless it shut with its last
    await eventually("shut", async () => !(await page.locator(".alert-list").isVisible()));
  });

  test("anchors, circle and book are there again when the page is loaded anew", async () => {
    await page.reload();
    await tab("Anchor watch").click();
    await eventually("the circle", () => page.getByText(/Inside: \d+ of 400 m/).isVisible());
    await eventually("the anchor", () =>
      page
        .getByRole("group", { name: "port anchor" })
        .getByText(/plotted at/)
        .isVisible(),
    );
  });

  test("has a page of its own", async () => {
    const own = await open(address(station.url, "watch"));
    await eventually(
      "it is the tab in sight",
      async () => (await own.getByRole("tab", { name: "Anchor watch" }).getAttribute("aria-selected")) === "true",
    );
    hadNoProblems(own);
    await closePage(own);
  });
});

describe("the plan", () => {
  test("zooms, turns head up, and reads bearing and distance", async () => {
    const tools = page.getByRole("toolbar", { name: "plan" });
    const follows = () => tools.getByRole("button", { name: "Own ship", exact: true }).getAttribute("aria-pressed");
    const sheet = page.getByRole("application", { name: /^plan/ });
    await eventually("own ship is in the middle", async () => (await follows()) === "true");
    await drag(sheet, [
      [0.4, 0.7],
      [0.6, 0.8],
    ]);
    await page.mouse.up();
    await eventually("a hand has moved it", async () => (await follows()) === "false");
    await sheet.press("Home");
    await eventually("own ship is in the middle", async () => (await follows()) === "true");
    await tools.getByRole("button", { name: "zoom in" }).click();
    await tools.getByRole("button", { name: /^Head up/ }).click();
    const line = tools.getByRole("button", { name: /^EBL 1/ });
    await line.click();
    await eventually("it reads", async () => /0\.0\u00b0 T, R \d{3}\u00b0, \d+ m/.test(await line.textContent()));
    await line.press("ArrowRight");
    await eventually("a degree more", async () => /1\.0\u00b0 T/.test(await line.textContent()));
    await tools.getByRole("button", { name: "Ruler" }).click();
    await eventually("it reads", async () =>
      /Ruler \d{3}\u00b0 T, \d+ m/.test(await tools.getByRole("button", { name: /^Ruler/ }).textContent()),
    );
  });
});

test("every palette can be read", async () => {
  await tab("Forecastle").click();
  await page.keyboard.press("z"); // a helm that nobody has is an alert
  await hasPalettes(page);
});

test("an instrument that fails shows a mark and no figure, a dead VHF is said to be dead", async () => {
  // The server models none of most of these faults yet; the page is sent what one that does would send. BridgeView
  // has a byte for each instrument behind its figures, which stay as they are: the page must not show them.
  const kWorks = ["gps", "gyro", "log", "anemometer", "echo_sounder", "vhf", "cctv"];
  const kFlags = 13 + 4 + 8 + 24 * 8; // bytes: message's head, CDR's, tick, 24 figures
  const failed = new Set<string>();
  let channel: number;
  const failing = await openPage(station.url);
  await failing.routeWebSocket(/\/ws/, (socket) => {
    const server = socket.connectToServer();
    server.onMessage((message) => {
      if (typeof message === "string") {
        const said = JSON.parse(message) as { op: string; channels: { topic: string; id: number }[] };
        if (said.op === "advertise")
          channel = said.channels.find(({ topic }) => topic === "/BridgeView")?.id ?? channel;
      } else if (message.readUInt32LE(1) === channel)
        for (const name of failed) message[kFlags + kWorks.indexOf(name)] = 0;
      socket.send(message);
    });
  });
  await failing.reload();
  const meter = (name: string) => failing.getByRole("meter", { name, exact: true });
  await eventually("all work", async () => /kn/.test(await meter("Wind, true").getAttribute("aria-valuetext")));
  for (const [instrument, names] of [
    ["log", ["LOG"]],
    ["anemometer", ["Wind, apparent", "Wind, true"]],
    ["echo_sounder", ["Below keel"]],
    ["gyro", ["HDG", "ROT"]],
    ["gps", ["SOG", "COG", "GPS"]],
  ] as const) {
    failed.add(instrument);
    for (const name of names) {
      await eventually(
        `${name} has failed`,
        async () => (await meter(name).getAttribute("aria-valuetext")) === "failed, no signal",
      );
      await eventually(`${name} shows no figure`, async () => !/\d/.test(await meter(name).textContent()));
    }
  }
  await failing.getByRole("button", { name: "Look out" }).click();
  await failing.getByRole("button", { name: "Pelorus" }).click();
  await eventually("the pelorus reads from the bow alone", () =>
    failing.getByText("R 000.0\u00b0, no gyro").isVisible(),
  );
  assert.equal(await failing.getByRole("button", { name: "Lay on plan" }).isEnabled(), false);
  failed.add("vhf");
  await eventually("it is said", () => failing.getByText(/VHF is dead/).isVisible());
  hadNoProblems(failing);
  await closePage(failing);
});

test("a bearing that is taken with the pelorus is laid on the plan", async () => {
  const own = await open(station.url);
  await own.getByRole("button", { name: "Look out" }).click();
  await own.getByRole("button", { name: "Pelorus" }).click();
  const pelorus = own.getByRole("group", { name: "pelorus" });
  const lay = pelorus.getByRole("button", { name: "Lay on plan" });
  await eventually("it looks ahead", async () => /T, R 000\.0\u00b0/.test(await pelorus.textContent()));
  for (let degree = 0; degree < 3; ++degree) await lay.press("ArrowLeft");
  await lay.press("Shift+ArrowRight");
  await eventually("three degrees to port less a tenth", async () =>
    /T, R 357\.1\u00b0/.test(await pelorus.textContent()),
  );
  await lay.click();
  await own.getByRole("button", { name: "Plan", exact: true }).click();
  await eventually("the plan has it", async () =>
    /\d\u00b0 T, R 35\d\u00b0/.test(await own.getByRole("button", { name: /^EBL 1/ }).textContent()),
  );
  hadNoProblems(own);
  await closePage(own);
});

test("the camera on the forecastle shows its windlasses as long as it works", async () => {
  const own = await open(station.url);
  await own.getByRole("button", { name: "Look out" }).click();
  await own.getByRole("button", { name: "CCTV", exact: true }).click();
  assert.equal(await own.getByRole("button", { name: "Pelorus" }).isVisible(), false); // no camera has one
  await rig.say("fault", "cctv-lost");
  await eventually("it has failed", () => own.getByText("No picture").isVisible());
  await rig.say("fault", "cctv-lost", "--clear");
  await eventually("it works again", () =>
    own.getByRole("img", { name: "camera on the forecastle, drawn" }).isVisible(),
  );
  hadNoProblems(own);
  await closePage(own);
});

test("ball and lights are shown and taken in, and the instructor sees it", async () => {
  const desk = await rig.desk();
  const seen = await openPage(address(desk.url, "instructor"));
  await tab("Anchor watch").click();
  for (const [name, shown, not] of [
    ["Anchor ball", "hoisted", "down"],
    ["Anchor lights", "on", "off"],
  ]) {
    const button = page.getByRole("button", { name: new RegExp(`^${name}`) });
    await eventually(`${name}: ${not}`, async () => (await button.textContent()) === `${name}: ${not}`);
    await button.click();
    await eventually(`${name}: ${shown}`, async () => (await button.textContent()) === `${name}: ${shown}`);
    assert.equal(await button.getAttribute("aria-pressed"), "true");
  }
  await seen.getByRole("tab", { name: "Truth" }).click();
  await eventually("the desk has it", () => seen.getByRole("button", { name: "Anchor ball: hoisted" }).isVisible());
  await seen.getByRole("tab", { name: "Log" }).click();
  await eventually("the log has it", () => seen.getByText("anchor lights switched on").first().isVisible());
  const ball = page.getByRole("button", { name: /^Anchor ball/ });
  await ball.click();
  await eventually("down", async () => (await ball.textContent()) === "Anchor ball: down");
  hadNoProblems(seen);
  await closePage(seen);
});

test("a seat for one steers, gives itself no orders, and repeats those to its forecastle here, too", async () => {
  await page.keyboard.press("z");
  const ship = await rig.station("ship");
  const url = ship.urls().find((line) => line.includes("/bridge#")) ?? (await ship.line(/\/bridge#/));
  const own = await open(url);
  await eventually(
    "the helm is not this one's yet",
    async () => (await own.locator(".helm-bar strong").textContent()) === "bridge-1",
  );
  await eventually(
    "no orders to give",
    async () => !(await own.getByRole("button", { name: "Stand by", exact: true }).isVisible()),
  );
  await eventually("it is said", () => own.getByText("This seat gives no orders").isVisible());
  const other = own.getByRole("link", { name: /^Forecastle/ });
  await eventually("the other page is a touch away", () => other.isVisible());
  assert.equal(await other.getAttribute("target"), "windlass-forecastle", "in a tab of its own");
  assert.equal(await own.evaluate(() => window.name), "windlass-bridge", "where that one's link finds it");

  // Whatever is open there, an order to the forecastle is heard, too, and repeated back.
  const waits = (which: TestPage) => which.getByRole("region", { name: "order to the forecastle" });
  const state = (text: string) =>
    page.locator('.said li[data-kind="order"]', { hasText: text }).first().getAttribute("data-state");
  await own.getByRole("tab", { name: "Anchor watch" }).click();
  await tab("Forecastle").click();
  await page.getByRole("button", { name: "Stop heaving", exact: true }).click();
  await eventually("it stands there", () => waits(own).getByText("stop heaving port cable").isVisible());
  const repeated = async () => (await state("stop heaving")) === "ORDER_REPEATED";
  await eventually("repeated", async () => {
    // Said again where it is lost: a station that has just begun may have met no server yet.
    if (await repeated()) return true;
    await waits(own).getByRole("button", { name: "repeat back: stop heaving port cable" }).click({ timeout: 5000 });
    return eventually("the server has it", repeated, 3000);
  });
  await eventually("no more", async () => !(await waits(own).getByText("stop heaving port cable").isVisible()));
  await page.getByRole("button", { name: "Veer to \u2026" }).click();
  await page.getByRole("button", { name: "Veer to 4 shackles", exact: true }).click();
  await waits(own)
    .getByRole("button", { name: /^repeat back: veer/ })
    .click();
  await own.getByRole("dialog").getByRole("button", { name: "4", exact: true }).click();
  await eventually("with its figure", async () => (await state("to 4 shackles")) === "ORDER_REPEATED");
  await page.getByRole("button", { name: "Leading?", exact: true }).click();
  await eventually("a question is answered on the other page", async () =>
    /\/forecastle#/.test(
      await waits(own)
        .getByRole("link", { name: /^answer: how/ })
        .getAttribute("href"),
    ),
  );
  assert.equal(await waits(page).count(), 0, "the conning seat has no forecastle");
  hadNoProblems(own);
  await closePage(own);
});
