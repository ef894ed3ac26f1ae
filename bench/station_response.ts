// How quick the browser stations are, and what their page costs: bundle, page load, lever to gauge, pictures drawn, work
// of the page at rest. Prints a table; not a test. What a station costs the processor: station_pages.ts.
//
// usage: WINDLASS_DOMAIN=N node station/web/tools/ts.mjs bench/station_response.ts   (after a build; a machine at rest; about a minute)

import { readdir, stat } from "node:fs/promises";
import { cpus, loadavg } from "node:os";
import { join } from "node:path";

import { type TestPage, closeBrowser, closePage, openPage, root, theBrowser } from "../tests/browser/browser";
import { Rig, sleep } from "../tests/browser/rig";

const bin = process.env.WINDLASS_BIN ?? join(root, "build/release/bin");

const at = (sorted: number[], share: number) => sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))];
const spread = (values: number[], digits = 0) => {
  const sorted = [...values].sort((a, b) => a - b);
  return `p50 ${at(sorted, 0.5).toFixed(digits)}, p99 ${at(sorted, 0.99).toFixed(digits)}, n ${sorted.length}`;
};

async function bundle() {
  const folder = join(bin, "web/assets");
  const sums: Record<string, number> = { js: 0, css: 0, woff2: 0 };
  for (const file of await readdir(folder)) {
    const zipped = /\.(js|css)\.gz$/.exec(file);
    const kind = zipped ? zipped[1] : file.endsWith(".woff2") ? "woff2" : undefined;
    if (kind) sums[kind] += (await stat(join(folder, file))).size;
  }
  return Object.entries(sums)
    .map(([kind, bytes]) => `${kind} ${Math.round(bytes / 1024)} kB`)
    .join(", ");
}

/** ms from a lever's message leaving the page to the gauge's sample in the page, by a link of the page's own. */
const leverToGauge = (times: number) =>
  new Promise<number[]>((done) => {
    const token = sessionStorage.getItem("windlass.token");
    const socket = new WebSocket(`ws://${location.host}/ws?token=${token}`, "windlass.v1");
    socket.binaryType = "arraybuffer";
    // Of a message 0x01: 13 bytes of its own, 4 of CDR's header; then ForecastleView's fields as in windlass.idl.
    const kSide = 17,
      kSpeedLever = 17 + 96;
    const found: number[] = [];
    let lever = 0,
      sent = 0;
    const send = () =>
      socket.send(
        JSON.stringify({
          op: "levers",
          side: 0,
          brake: 1,
          speed_lever: lever,
          clutch_in: false,
          stopper_closed: false,
          emergency_stop: false,
        }),
      );
    const move = () => {
      lever = lever === 0.25 ? 0.5 : 0.25;
      sent = performance.now();
      send();
    };
    const holding = setInterval(send, 100);
    socket.onmessage = ({ data }: MessageEvent<string | ArrayBuffer>) => {
      if (typeof data === "string") {
        const message = JSON.parse(data) as { op: string; channels: { id: number; topic: string }[] };
        if (message.op === "advertise") {
          const channel = message.channels.find(({ topic }) => topic.endsWith("ForecastleView"));
          if (!channel) return;
          socket.send(JSON.stringify({ op: "subscribe", subscriptions: [{ id: 1, channelId: channel.id }] }));
          setTimeout(move, 500);
        }
        return;
      }
      const view = new DataView(data);
      if (!sent || view.getInt32(kSide, true) !== 0 || view.getFloat64(kSpeedLever, true) !== lever) return;
      found.push(performance.now() - sent);
      sent = 0;
      if (found.length < times) {
        setTimeout(move, 60 + 70 * Math.random()); // at any moment between two samples
        return;
      }
      clearInterval(holding);
      socket.close();
      done(found);
    };
  });

const rows = [["machine", `${cpus()[0].model}, ${cpus().length} cores, load ${loadavg()[0].toFixed(1)} at the start`]];
rows.push(["bundle, gzipped", await bundle()]);

await theBrowser({ asUsers: true });
const rig = new Rig();
rig.server("let_go_port_25m");
const station = await rig.station("ship");
const loads: number[] = [];
for (let i = 0; i < 5; ++i) {
  const page = await openPage(station.url);
  loads.push(
    await page.evaluate(
      () =>
        new Promise<number>((done) => {
          const look = () =>
            /\d/.test(document.querySelector(".top-bar .time")?.textContent ?? "")
              ? done(performance.now())
              : setTimeout(look, 5);
          look();
        }),
    ),
  );
  await closePage(page);
}
rows.push(["page load to the first figure, ms", spread(loads)]);

const blank = await openPage(new URL("/favicon.svg", station.url).href);
await blank.evaluate(
  (token) => sessionStorage.setItem("windlass.token", token),
  new URL(station.url).hash.split("=")[1],
);
rows.push(["lever in the browser to gauge in the browser, ms", spread(await blank.evaluate(leverToGauge, 300), 0)]);
await closePage(blank);

/** Of one core, in percent: what the page's main thread works in a time at rest. */
async function mainThread(page: TestPage, ms: number): Promise<number> {
  const cdp = await page.context().newCDPSession(page);
  await cdp.send("Performance.enable");
  const worked = async () =>
    (await cdp.send("Performance.getMetrics")).metrics.find(({ name }) => name === "TaskDuration").value;
  const before = await worked();
  await sleep(ms);
  return (100 * ((await worked()) - before)) / (ms / 1000);
}
for (const picture of [true, false]) {
  const url = picture ? station.url : station.url.replace("#", "?picture=off#");
  const page = await openPage(url, { viewport: { width: 1280, height: 720 } });
  await sleep(8000);
  const works = await mainThread(page, 15000);
  const what = picture ? "forecastle, drawn by software at 1280x720" : "forecastle without its picture";
  if (picture)
    rows.push([`${what}: pictures a second`, (await page.evaluate(() => window.windlass.stats().fps)).toFixed(1)]);
  rows.push([`${what}: main thread, % of a core`, works.toFixed(0)]);
  await closePage(page);
}

await closeBrowser();
await rig.end();
for (const [what, figure] of rows) console.log(`${what.padEnd(62)} ${figure}`);
