// Takes the pictures of docs/pictures: real stations, a real server, each at a fixed instant of the exercise. The page
// stands still (?still=1), so that nothing in it moves by time.
//
// usage: WINDLASS_DOMAIN=N node tests/browser/pictures.mjs [OUTPUT [NAME...]]     (after a build; some minutes)

import { mkdir } from "node:fs/promises";
import { join } from "node:path";

import { closeBrowser, closePage, openPage, root } from "./browser.mjs";
import { Rig, eventually, sleep } from "./rig.mjs";

const [output = join(root, "docs/pictures"), ...only] = process.argv.slice(2);
await mkdir(output, { recursive: true });

const kSize = { width: 1440, height: 900 };
const kDrawn = 6000; // ms for a scene to be drawn some frames under software rendering

/** The page's address with a query before the fragment that has the token. */
const still = (url, path) => {
  const address = new URL(url);
  if (path) address.pathname = path;
  address.search = "?still=1";
  return address.href;
};

/** Takes NAME.png of a page that work() has brought where it shall be. */
async function picture(url, name, work = async () => {}) {
  if (only.length && !only.includes(name)) return;
  const page = await openPage(url, { viewport: kSize });
  await sleep(kDrawn / 2);
  await work(page);
  await sleep(kDrawn);
  await page.screenshot({ path: join(output, `${name}.png`) });
  if (page.problems.length) console.log(`${name}: ${page.problems.join("; ")}`);
  await closePage(page);
  console.log(`${name}.png`);
}

/** Takes NAME.png of the desk's scene alone, from one of its places. */
async function scene(url, name, place) {
  if (only.length && !only.includes(name)) return;
  const page = await openPage(url, { viewport: { width: 1600, height: 1000 } });
  await page.getByRole("button", { name: "3D", exact: true }).click();
  await page.getByRole("button", { name: place, exact: true }).click();
  const loads = page.getByRole("button", { name: "Loads on chain" });
  if ((await loads.getAttribute("aria-pressed")) === "true") await loads.click();
  await sleep(kDrawn);
  await page.locator("canvas").first().screenshot({ path: join(output, `${name}.png`) });
  await closePage(page);
  console.log(`${name}.png`);
}

/** Plays a shipped script until a moment, then pauses the exercise there. */
async function playUntil(rig, exercise, what, is, timeScale) {
  rig.server(exercise, "--wait", "--time-scale", `${timeScale}`);
  rig.script(exercise);
  await rig.say("start", "--timeout", "20");
  await eventually(what, async () => is(await rig.truth()), 300000);
  await rig.say("pause");
}

async function session(work) {
  const rig = new Rig();
  try {
    await work(rig);
  } finally {
    await rig.end();
  }
}

const out = (metres) => [`${metres} m are out`, ({ port }) => port?.chain?.cable_out >= metres];

await session(async (rig) => {
  await playUntil(rig, "let_go_port_25m", ...out(14), 1);
  const station = await rig.station("ship");
  await picture(still(station.url, "/forecastle"), "forecastle_let_go");
  await picture(still(station.url, "/forecastle"), "over_the_bow", (page) => page.keyboard.press("2"));
});

await session(async (rig) => {
  await playUntil(rig, "let_go_port_25m", ...out(160), 10);
  const station = await rig.station("ship");
  const desk = await rig.desk();
  await picture(still(station.url, "/bridge"), "bridge");
  await picture(still(desk.url, "/instructor"), "instructor");
  await rig.say("environment", "--time-of-day", "23:10", "--visibility", "1200", "--wind-speed", "14");
  await picture(still(station.url, "/forecastle"), "forecastle_night");
  await station.stop("SIGKILL");
});

// Figure 13 of the paper that the project began with: chain housed, running, anchor down; from the deck and from outside;
// the ship falling astern on her cable and brought up.
const figure13 = [
  ["start", ({ time }) => time > 1, ["a", "Stand"], ["d", "Outside"]],
  [...out(16), ["b", "Stand"], ["e", "Outside"]],
  [...out(50), ["c", "Stand"], ["f", "Outside"]],
  [...out(120), ["g", "Outside"], ["h", "Under water"]],
  ["brought up", ({ port }) => port?.anchor?.phase === "holding" && port.chain.cable_out > 160, ["i", "Outside"]],
];
if (!only.length || only.some((name) => name.startsWith("figure_13")))
  for (const [what, is, ...views] of figure13)
    await session(async (rig) => {
      await playUntil(rig, "let_go_port_25m", what, is, what.startsWith("1") || what === "brought up" ? 10 : 1);
      const desk = await rig.desk();
      for (const [letter, place] of views) await scene(still(desk.url, "/instructor"), `figure_13_${letter}`, place);
    });

await closeBrowser();
