// What the three-dimensional views cost where the processor draws: of the forecastle's views at 1280x720 pictures a
// second and the processor's time for one, the page's heap, and what each page loads, gzipped. Several builds are
// measured in turn, round by round, so that a machine that is busy with other things is so for each; of the processor's
// time that says least, but a picture has fewer pixels where it was slow before (px: the canvas's width). Prints a
// table; not a test.
//
// usage: WINDLASS_DOMAIN=N node station/web/tools/ts.mjs bench/views.ts [ROUNDS [BIN...]]   (after a build; a minute a round)

import { readFileSync, readdirSync, statSync } from "node:fs";
import { loadavg } from "node:os";
import { join, resolve } from "node:path";

import { closeBrowser, closePage, openPage, root, theBrowser } from "../tests/browser/browser";
import { Rig, sleep } from "../tests/browser/rig";

const [rounds = "3", ...given] = process.argv.slice(2);
const bins = given.length ? given.map((bin) => resolve(bin)) : [join(root, "build/release/bin")];
const kSettles = 8000; // ms, until the scene is drawn and the watch over its quality has come to rest
const kMeasured = 8000; // ms

/**
 * 1024 B, gzipped, of a page: its script with all that this imports at once, its style. whole: also its scene where that
 * comes later, and the style and fonts that all pages have.
 */
function loads(bin: string, page: string, whole: boolean): string {
  const folder = join(bin, "web/assets");
  const files = readdirSync(folder);
  const seen = new Set<string>();
  const take = (file: string): void => {
    if (seen.has(file)) return;
    seen.add(file);
    const text = readFileSync(join(folder, file), "utf8");
    for (const [, other] of text.matchAll(/(?:import|from)\s*"\.\/([\w.-]+\.js)"/g)) take(other);
    const later = /import\(\s*"\.\/((?:scene_view|ship_scene)-[\w.-]+\.js)"/g;
    if (whole) for (const [, other] of text.matchAll(later)) take(other);
  };
  take(`${page}.js`);
  const own = files.filter((file) => file === `${page}.css` || (whole && /^kit\.css$|\.woff2$/.test(file)));
  const size = (file: string): number =>
    statSync(join(folder, files.includes(`${file}.gz`) ? `${file}.gz` : file)).size;
  return `${([...seen, ...own].reduce((sum, file) => sum + size(file), 0) / 1024).toFixed(1)} kB`;
}

const median = (values: number[]): number => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];

const kWeathers = {
  day: ["--time-of-day", "10:30", "--visibility", "20000"],
  gale: ["--time-of-day", "15:00", "--visibility", "3700", "--wind-speed", "20", "--fetch", "60000"],
};
const kViews = { stand: "1", "over the bow": "2" };
const found = new Map<string, Map<string, number[]>>(); // by figure and build

function note(figure: string, bin: string, value: number): void {
  const of = found.get(figure) ?? new Map<string, number[]>();
  found.set(figure, of.set(bin, [...(of.get(bin) ?? []), value]));
}

/** Counts pictures: each has a fence at its end (pace.ts). */
const countPictures = (): void => {
  const { prototype } = WebGL2RenderingContext;
  const fenceSync = prototype.fenceSync;
  window.pictures = 0;
  prototype.fenceSync = function (this: WebGL2RenderingContext, ...given: Parameters<typeof fenceSync>) {
    ++window.pictures;
    return fenceSync.apply(this, given);
  };
};

const browser = await theBrowser({ asUsers: true });
const system = await browser.newBrowserCDPSession();
/** s of the processor, of the process that draws. */
async function drawing(): Promise<number> {
  const { processInfo } = await system.send("SystemInfo.getProcessInfo");
  return processInfo.find(({ type }) => type === "GPU").cpuTime;
}

for (let round = 0; round < Number(rounds); ++round)
  for (const bin of bins) {
    process.env.WINDLASS_BIN = bin;
    for (const [weather, says] of Object.entries(kWeathers)) {
      const rig = new Rig();
      rig.server("at_anchor_25m");
      await rig.say("environment", ...says, "--timeout", "60");
      const page = await openPage((await rig.station("forecastle")).url, {
        viewport: { width: 1280, height: 720 },
        init: countPictures,
      });
      const cdp = await page.context().newCDPSession(page);
      await cdp.send("Performance.enable");
      for (const [view, key] of Object.entries(kViews)) {
        await page.keyboard.press(key);
        await sleep(kSettles);
        const drawn = () =>
          page.evaluate(() => [window.pictures, document.querySelector("canvas").width, performance.now()]);
        const [[before, , begun], worked] = [await drawn(), await drawing()];
        await sleep(kMeasured);
        const [[after, width, ended], works] = [await drawn(), await drawing()];
        note(`${weather}, ${view}: pictures a second`, bin, (1000 * (after - before)) / (ended - begun));
        note(`${weather}, ${view}: ms of the processor a picture`, bin, (1000 * (works - worked)) / (after - before));
        note(`${weather}, ${view}: px`, bin, width);
      }
      await cdp.send("HeapProfiler.collectGarbage");
      const { metrics } = await cdp.send("Performance.getMetrics");
      note(`${weather}: heap, MB`, bin, metrics.find(({ name }) => name === "JSHeapUsedSize").value / 1e6);
      await closePage(page);
      await rig.end();
    }
  }
await closeBrowser();

console.log(`load of the machine at the end: ${loadavg()[0].toFixed(1)}`);
for (const bin of bins) {
  console.log(bin);
  for (const page of ["forecastle", "bridge", "instructor"]) {
    const [atOnce, inAll] = [loads(bin, page, false), loads(bin, page, true)];
    console.log(`  ${page}: ${atOnce} gzipped, ${inAll} with scene, common style and fonts`);
  }
  for (const [figure, of] of found) {
    const values = of.get(bin) ?? [];
    console.log(`  ${figure}: ${median(values).toFixed(1)} (${values.map((v) => v.toFixed(1)).join(", ")})`);
  }
}
