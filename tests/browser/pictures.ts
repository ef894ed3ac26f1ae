// Takes the pictures of docs/pictures: real stations, a real server, each at a fixed instant of the exercise. The page
// stands still (?still=1), so that nothing in it moves by time. Those of views/ (docs/views.md) are drawn as a graphics
// card draws them, whatever draws here.
//
// usage: WINDLASS_DOMAIN=N node station/web/tools/ts.mjs tests/browser/pictures.ts [OUTPUT [NAME...]]     (after a build; some minutes)
// A NAME may be the beginning of several.

import { cp, mkdir, mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";

import { type PageOptions, type TestPage, closeBrowser, closePage, openPage, root } from "./browser";
import { LiningSeen } from "../../station/web/src/wire/generated";
import { type Station, type Truth, Rig, eventually, sleep } from "./rig";

const [output = join(root, "docs/pictures"), ...only] = process.argv.slice(2);
await mkdir(output, { recursive: true });

const wanted = (name: string) => !only.length || only.some((beginning) => name.startsWith(beginning));

const kSize = { width: 1440, height: 900 };
const kDrawn = 6000; // ms for a scene to be drawn some frames under software rendering

/** The page's address with a query before the fragment that has the token. */
const still = (url: string, path?: string) => {
  const address = new URL(url);
  if (path) address.pathname = path;
  address.search = "?still=1";
  return address.href;
};

const look = (url: string, more: PageOptions = {}) => openPage(url, { viewport: kSize, ...more });
/** The bridge's camera on the forecastle, as large as the page has it. */
const byCamera = async (page: TestPage) => {
  await page.getByRole("button", { name: "Look out" }).click();
  await page.getByRole("button", { name: "CCTV" }).click();
};

/**
 * Takes the picture NAME (a JPEG where it is called so, else NAME.png) of a page, or of one opened at an address, that
 * work() has brought where it shall be.
 */
async function picture(
  of: string | TestPage,
  name: string,
  work: (page: TestPage) => Promise<unknown> = async () => {},
) {
  if (!wanted(name)) return;
  const page = typeof of === "string" ? await look(of) : of;
  await sleep(kDrawn / 2);
  await work(page);
  await sleep(kDrawn);
  const old = page.getByText("not heard", { exact: true }); // on a machine that is busy otherwise
  await eventually("what is shown is not old", async () => !(await old.isVisible()));
  const file = name.endsWith(".jpg") ? name : `${name}.png`;
  await mkdir(dirname(join(output, file)), { recursive: true });
  await page.screenshot({ path: join(output, file), ...(file === name ? { type: "jpeg", quality: 72 } : {}) });
  if (page.problems.length) console.log(`${name}: ${page.problems.join("; ")}`);
  await closePage(page);
  console.log(file);
}

/** A picture of the desk's scene alone, from one of its places; as a JPEG for a page. */
async function scene(url: string, place: string) {
  const page = await openPage(url, { viewport: { width: 1600, height: 1000 } });
  await page.getByRole("button", { name: "3D", exact: true }).click();
  await page.getByRole("button", { name: place, exact: true }).click();
  const loads = page.getByRole("button", { name: "Loads on chain" });
  if ((await loads.getAttribute("aria-pressed")) === "true") await loads.click();
  await page.addStyleTag({ content: ".chips { visibility: hidden; }" });
  await sleep(kDrawn);
  const taken = await page.locator("canvas").first().screenshot({ type: "jpeg", quality: 80 });
  await closePage(page);
  console.log(place);
  return `data:image/jpeg;base64,${taken.toString("base64")}`;
}

type Is = (truth: Truth) => boolean;

/** Plays a shipped script until a moment, then pauses the exercise there; watch: opens pages that are to see it all. */
async function playUntil(rig: Rig, exercise: string, what: string, is: Is, timeScale: number, watch = async () => {}) {
  rig.server(exercise, "--wait", "--time-scale", `${timeScale}`);
  await watch();
  rig.script(exercise);
  await rig.say("start", "--timeout", "20");
  await eventually(what, async () => is(await rig.truth()), 300000);
  await rig.say("pause");
}

/** Programs for pictures of these names, while work() takes them; nothing where none is wanted. */
async function session(names: string[], work: (rig: Rig) => Promise<void>) {
  if (!names.some(wanted)) return;
  const rig = new Rig("anna");
  try {
    await work(rig);
  } finally {
    await rig.end();
  }
}

const out = (metres: number): [string, Is] => [`${metres} m are out`, ({ port }) => port?.chain?.cable_out >= metres];

await session(["forecastle_let_go", "over_the_bow"], async (rig) => {
  await playUntil(rig, "let_go_port_25m", ...out(14), 1);
  const station = await rig.station("ship");
  await picture(still(station.url, "/forecastle"), "forecastle_let_go");
  await picture(still(station.url, "/forecastle"), "over_the_bow", (page) => page.keyboard.press("2"));
});

await session(["bridge", "bridge_cctv.jpg", "instructor", "forecastle_night"], async (rig) => {
  let conning: Station, bridge: TestPage, desk: TestPage;
  await playUntil(rig, "let_go_port_25m", ...out(160), 10, async () => {
    conning = await rig.station("bridge");
    bridge = await look(still(conning.url, "/bridge"));
    desk = await look(still((await rig.desk()).url, "/instructor"));
    await desk.getByRole("button", { name: "Plan", exact: true }).click(); // a scene that is drawn starves the script
  });
  await picture(desk, "instructor", (page) => page.getByRole("button", { name: "3D and plan", exact: true }).click());
  await picture(bridge, "bridge", async (page) => {
    await page.getByRole("tab", { name: "Anchor watch" }).click();
    await page.getByRole("button", { name: "plot the port anchor" }).click();
    await page.getByRole("button", { name: "Keep watch" }).click();
    await page.getByRole("button", { name: /^Anchor ball/ }).click();
    await page.getByRole("button", { name: "Fit" }).click();
  });
  await picture(still(conning.url, "/bridge"), "bridge_cctv.jpg", byCamera);
  await rig.say("environment", "--time-of-day", "23:10", "--visibility", "1200", "--wind-speed", "14");
  await picture(still((await rig.station("forecastle")).url), "forecastle_night");
});

await session(["lessons", "classroom"], async (rig) => {
  const names = ["ben", "carl", "dora", "emil", "frida", "gero", "hanna"];
  const file = join(root, "config/exercises/L01_let_go_25m.json");
  rig.server(
    "L01_let_go_25m",
    "--wait",
    "--name",
    "room-1",
    ...names.flatMap((name) => ["--exercise", file, "--partition", name]),
  );
  const desk = await rig.desk({ more: ["--exercises", join(root, "config/exercises")] });
  await picture(still(desk.url, "/lessons"), "lessons", async (page) => {
    await page.locator(".files button[data-name=L01_let_go_25m]").click();
    await page.locator(".sections").getByRole("button", { name: "criteria" }).click();
    await page.locator("[data-at='/lesson/criteria/2'] summary").click();
    await page.locator("[data-at='/lesson/criteria/2/fail_above'] input").fill("1");
    await eventually("a mistake", () => page.locator(".mistake").first().isVisible());
    await page.evaluate(() => localStorage.clear());
  });
  await rig.say("watch-circle", "--radius", "10", "--x", "5000", "--y", "0", "--timeout", "20");
  await rig.say("start", "--timeout", "20");
  await picture(still(desk.url, "/classroom"), "classroom", (page) =>
    eventually("all forecastles are drawn", async () => (await page.locator(".cctv p:not([hidden])").count()) === 0),
  );
});

// The views: each by day, at dusk, by night, in fog and in a gale, of a ship that lies to six shackles.

/** A graphics card's name for what draws here: the page then draws as for one. */
const asByACard = (): void => {
  const { prototype } = WebGL2RenderingContext;
  const parameter = prototype.getParameter;
  prototype.getParameter = function (this: WebGL2RenderingContext, of: GLenum) {
    const found: unknown = parameter.call(this, of);
    return typeof found === "string" && /llvmpipe|swiftshader/i.test(found) ? "a graphics card" : found;
  };
};
const byACard = (url: string, path: string) => look(still(url, path), { init: asByACard });

const weathers: Record<string, string[]> = {
  day: ["--time-of-day", "10:30", "--visibility", "20000"],
  dusk: ["--time-of-day", "18:12", "--visibility", "15000"],
  night: ["--time-of-day", "23:10", "--visibility", "15000"],
  fog: ["--time-of-day", "08:00", "--visibility", "250", "--wind-speed", "3"],
  gale: ["--time-of-day", "15:00", "--visibility", "3700", "--wind-speed", "20", "--fetch", "60000"],
};
const kViews = ["stand", "bow", "bridge", "cctv"];
const kSettles = 60; // s of the exercise, in which she takes the weather

for (const [weather, says] of Object.entries(weathers)) {
  const name = (view: string) => `views/${view}_${weather}.jpg`;
  await session(kViews.map(name), async (rig) => {
    rig.server("at_anchor_25m", "--time-scale", "4");
    await rig.say("environment", ...says, "--timeout", "60");
    const { status } = await rig.truly("the exercise is heard of", (now) => now.status?.time > 0);
    await rig.truly("she has taken the weather", (now) => now.status.time > status.time + kSettles);
    await rig.say("pause");
    await rig.say("lights-and-shapes", /dusk|night/.test(weather) ? "--lights" : "--ball");
    const station = await rig.station("ship");
    const inTheDark = async (page: TestPage) => {
      if (/night/.test(weather)) await page.keyboard.press("l");
    };
    await picture(await byACard(station.url, "/forecastle"), name("stand"), inTheDark);
    await picture(await byACard(station.url, "/forecastle"), name("bow"), async (page) => {
      await page.keyboard.press("2");
      await inTheDark(page);
    });
    await picture(await byACard(station.url, "/bridge"), name("bridge"), (page) =>
      page.getByRole("button", { name: "Look out" }).click(),
    );
    await picture(await byACard(station.url, "/bridge"), name("cctv"), byCamera);
  });
}

// The instructor's: forces as arrows, and the plan over uneven ground.
const deskPictures = { "views/desk_forces.jpg": "3D", "views/desk_plan.jpg": "Plan" };
for (const [name, shown] of Object.entries(deskPictures))
  await session([name], async (rig) => {
    rig.server(shown === "3D" ? "at_anchor_25m" : "uneven_ground", "--time-scale", "4");
    await rig.say("environment", ...weathers.gale, "--timeout", "60");
    await rig.truly("she rides to it", (now) => now.status?.time > kSettles);
    await rig.say("pause");
    const page = await look(still((await rig.desk()).url, "/instructor"), { init: asByACard });
    await picture(page, name, async () => {
      await page.getByRole("button", { name: shown, exact: true }).click();
      if (shown !== "3D") return page.getByRole("button", { name: "Fit" }).click();
      await page.getByRole("button", { name: "t, m/min" }).click();
      await page.getByRole("radio", { name: /^kN/ }).check();
      await page.keyboard.press("Escape");
      await page.getByRole("button", { name: "Forces", exact: true }).click();
      await page.getByRole("button", { name: "Full screen", exact: true }).click();
      await page.getByRole("button", { name: "Plots", exact: true }).click();
    });
  });

// Danger: a cable that runs away, and a brake that was ridden until it burns. Both in deep water, by the page's own keys.

/** An exercise of ours in so deep water, m, without its lesson, while work() has its file. */
async function inDeepWater(depth: number, work: (file: string) => Promise<void>) {
  const folder = await mkdtemp(join(tmpdir(), "windlass-pictures-"));
  await cp(join(root, "config"), join(folder, "config"), { recursive: true });
  const file = join(folder, "config/exercises/deep.json");
  const read = JSON.parse(await readFile(join(root, "config/exercises/let_go_port_25m.json"), "utf8")) as {
    environment: { depth: number };
  };
  read.environment.depth = depth;
  await writeFile(file, JSON.stringify(read));
  await work(file);
  await rm(folder, { recursive: true });
}

/** A page without its picture, whose levers may be moved. */
async function handAtTheStand(station: Station) {
  const address = new URL(station.url);
  address.pathname = "/forecastle";
  address.search = "?picture=off";
  const hand = await openPage(address.href);
  await eventually("the levers may be moved", () => hand.getByRole("switch", { name: "clutch" }).isEnabled());
  return hand;
}
/** What the mate sees at his stand. */
const atTheStand = (page: TestPage) =>
  page.evaluate(() => {
    const view = window.windlass.link.latest("ForecastleView", 0);
    return { speed: view.cable_speed_indicated, out: view.cable_out_indicated, lining: view.lining };
  });

const kOnDeck = ["stand", "bow", "brake"]; // by their keys
const danger = (what: string) => [...kOnDeck, "cctv"].map((place) => `views/${what}_${place}.jpg`);
async function pictureDanger(what: string, station: Station) {
  for (const [k, place] of kOnDeck.entries())
    await picture(await byACard(station.url, "/forecastle"), `views/${what}_${place}.jpg`, (page) =>
      page.keyboard.press(`${k + 1}`),
    );
  await picture(await byACard(station.url, "/bridge"), `views/${what}_cctv.jpg`, byCamera);
}

await session(danger("runaway"), (rig) =>
  inDeepWater(120, async (file) => {
    rig.server(file);
    const station = await rig.station("ship");
    const hand = await handAtTheStand(station);
    await eventually("it runs away", async () => {
      const { speed } = await atTheStand(hand);
      if (speed === 0) await hand.keyboard.press("0");
      return speed > 8.2;
    });
    await rig.say("pause");
    await closePage(hand);
    await pictureDanger("runaway", station);
  }),
);

await session(danger("burnt"), (rig) =>
  inDeepWater(200, async (file) => {
    rig.server(file);
    const station = await rig.station("ship");
    const hand = await handAtTheStand(station);
    const kRidden = 4.5; // m/s
    let last = 0;
    await eventually(
      "the brake burns",
      async () => {
        const { speed, lining } = await atTheStand(hand);
        if (speed > kRidden && speed > last - 0.1) await hand.keyboard.press("ArrowUp");
        else if (speed < kRidden && speed < last + 0.1) await hand.keyboard.press("ArrowDown");
        last = speed;
        return lining >= LiningSeen.LINING_BURNS;
      },
      300000,
    );
    await rig.say("pause");
    await closePage(hand);
    await pictureDanger("burnt", station);
  }),
);

// Figure 13 of the paper that the project began with: chain housed, running, anchor down; from the deck and from over
// the bow; the ship falling astern on her cable and brought up. One sheet of nine.
const figure13: [string, Is, ...[string, string, string][]][] = [
  ["start", ({ status }) => status?.time > 1, ["a", "Aft", "housed, on deck"], ["d", "Over the bow", "at the water"]],
  [...out(16), ["b", "Aft", "running"], ["e", "Over the bow", "running"]],
  [...out(50), ["c", "Aft", "50 m out"], ["f", "Outside", "50 m out"]],
  [...out(120), ["g", "Outside", "120 m out"], ["h", "Under water", "the anchor digs in"]],
  [
    "brought up",
    ({ port }) => port?.anchor?.phase === "ANCHOR_HOLDING" && port.chain.cable_out > 160,
    ["i", "Outside", "brought up"],
  ],
];
if (wanted("seed_figure_13")) {
  const views: [string, string, string][] = [];
  for (const [what, is, ...places] of figure13)
    await session(["seed_figure_13"], async (rig) => {
      await playUntil(rig, "let_go_port_25m", what, is, what.startsWith("1") || what === "brought up" ? 10 : 1);
      const desk = await rig.desk();
      for (const [letter, place, words] of places)
        views.push([letter, words, await scene(still(desk.url, "/instructor"), place)]);
    });
  const cells = views
    .sort(([a], [b]) => a.localeCompare(b))
    .map(
      ([letter, words, image]) => `<figure><img src="${image}"><figcaption>(${letter}) ${words}</figcaption></figure>`,
    );
  const style =
    "body { margin: 0; display: grid; grid-template-columns: repeat(3, 560px); gap: 6px; font: 16px sans-serif } figure { margin: 0 } img { width: 100% }";
  const sheet = await openPage("about:blank", { viewport: { width: 1692, height: 1300 } });
  await sheet.setContent(`<style>${style}</style>${cells.join("")}`);
  await sheet.screenshot({ path: join(output, "seed_figure_13.jpg"), type: "jpeg", quality: 80, fullPage: true });
  await closePage(sheet);
  console.log("seed_figure_13.jpg");
}

await closeBrowser();
