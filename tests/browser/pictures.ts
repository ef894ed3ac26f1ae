// Takes the pictures of docs/pictures: real stations, a real server, each at a fixed instant of the exercise. The page
// stands still (?still=1), so that nothing in it moves by time.
//
// usage: WINDLASS_DOMAIN=N node station/web/tools/ts.mjs tests/browser/pictures.ts [OUTPUT [NAME...]]     (after a build; some minutes)
// A NAME may be the beginning of several.

import { mkdir } from "node:fs/promises";
import { join } from "node:path";

import { type TestPage, closeBrowser, closePage, openPage, root } from "./browser";
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

const look = (url: string) => openPage(url, { viewport: kSize });

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
  const file = name.endsWith(".jpg") ? name : `${name}.png`;
  await page.screenshot({ path: join(output, file), ...(file === name ? { type: "jpeg", quality: 82 } : {}) });
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
  await picture(still(conning.url, "/bridge"), "bridge_cctv.jpg", async (page) => {
    await page.getByRole("button", { name: "Look out" }).click();
    await page.getByRole("button", { name: "CCTV" }).click();
  });
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
  await picture(still(desk.url, "/classroom"), "classroom");
});

// Figure 13 of the paper that the project began with: chain housed, running, anchor down; from the deck and from over
// the bow; the ship falling astern on her cable and brought up. One sheet of nine.
const figure13: [string, Is, ...[string, string, string][]][] = [
  ["start", ({ time }) => time > 1, ["a", "Aft", "housed, on deck"], ["d", "Over the bow", "at the water"]],
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
