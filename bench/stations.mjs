// What the browser stations cost and how quick they are: bundle, page load, lever to gauge, frames drawn, processor
// time of a station with one page and with eight. Prints a table; not a test.
//
// usage: WINDLASS_DOMAIN=N node --experimental-websocket bench/stations.mjs   (after a build; a machine at rest; about three minutes)

import { readdir, readFile, stat } from "node:fs/promises";
import { cpus, loadavg } from "node:os";
import { join } from "node:path";

import { closeBrowser, closePage, openPage, root } from "../tests/browser/browser.mjs";
import { Rig, sleep } from "../tests/browser/rig.mjs";

const bin = process.env.WINDLASS_BIN ?? join(root, "build/release/bin");

const at = (sorted, share) => sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))];
const spread = (values, digits = 0) => {
  const sorted = [...values].sort((a, b) => a - b);
  return `p50 ${at(sorted, 0.5).toFixed(digits)}, p99 ${at(sorted, 0.99).toFixed(digits)}, n ${sorted.length}`;
};

/** s of processor time that a process has taken so far, of /proc/PID/stat (ticks of 10 ms). */
async function processorTime(pid) {
  const fields = (await readFile(`/proc/${pid}/stat`, "utf8")).split(") ")[1].split(" ");
  return (Number(fields[11]) + Number(fields[12])) / 100;
}

/** Share of a core over so many seconds. */
async function load(pid, seconds) {
  const before = await processorTime(pid);
  await sleep(1000 * seconds);
  return ((await processorTime(pid)) - before) / seconds;
}

async function bundle() {
  const folder = join(bin, "web/assets");
  const sums = { js: 0, css: 0, woff2: 0 };
  for (const file of await readdir(folder)) {
    const zipped = /\.(js|css)\.gz$/.exec(file);
    const kind = zipped ? zipped[1] : file.endsWith(".woff2") ? "woff2" : undefined;
    if (kind) sums[kind] += (await stat(join(folder, file))).size;
  }
  return Object.entries(sums).map(([kind, bytes]) => `${kind} ${Math.round(bytes / 1024)} kB`).join(", ");
}

/** ms from a lever's message leaving the page to the gauge's sample in the page, by a link of the page's own. */
const leverToGauge = (times) =>
  new Promise((done) => {
    const token = sessionStorage.getItem("windlass.token");
    const socket = new WebSocket(`ws://${location.host}/ws?token=${token}`, "windlass.v1");
    socket.binaryType = "arraybuffer";
    // Of a message 0x01: 13 bytes of its own, 4 of CDR's header; then ForecastleView's fields as in windlass.idl.
    const kSide = 17, kSpeedLever = 17 + 96;
    const found = [];
    let lever = 0, sent = 0;
    const send = () => socket.send(JSON.stringify({ op: "levers", side: 0, brake: 1, speed_lever: lever, clutch_in: false, stopper_closed: false, emergency_stop: false }));
    const move = () => {
      lever = lever === 0.25 ? 0.5 : 0.25;
      sent = performance.now();
      send();
    };
    const holding = setInterval(send, 100);
    socket.onmessage = ({ data }) => {
      if (typeof data === "string") {
        const message = JSON.parse(data);
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
      if (found.length < times) return setTimeout(move, 60 + 70 * Math.random()); // at any moment between two samples
      clearInterval(holding);
      socket.close();
      done(found);
    };
  });

const rows = [["machine", `${cpus()[0].model}, ${cpus().length} cores, load ${loadavg()[0].toFixed(1)} at the start`]];
rows.push(["bundle, gzipped", await bundle()]);

const rig = new Rig();
const server = rig.server("let_go_port_25m");
const station = await rig.station("ship");
const loads = [];
for (let i = 0; i < 5; ++i) {
  const page = await openPage(station.url);
  loads.push(await page.evaluate(() => new Promise((done) => {
    const look = () => (/\d/.test(document.querySelector(".top-bar .time")?.textContent ?? "") ? done(performance.now()) : setTimeout(look, 5));
    look();
  })));
  await closePage(page);
}
rows.push(["page load to the first figure, ms", spread(loads)]);

const blank = await openPage(new URL("/favicon.svg", station.url).href);
await blank.evaluate((token) => sessionStorage.setItem("windlass.token", token), new URL(station.url).hash.split("=")[1]);
rows.push(["lever in the browser to gauge in the browser, ms", spread(await blank.evaluate(leverToGauge, 300), 0)]);
await closePage(blank);

const drawn = await openPage(station.url, { viewport: { width: 1280, height: 720 } });
await sleep(5000);
const intervals = await drawn.evaluate(() => new Promise((done) => {
  const found = [];
  let last = performance.now();
  const next = (now) => {
    found.push(now - last);
    last = now;
    found.length < 200 ? requestAnimationFrame(next) : done(found.slice(1));
  };
  requestAnimationFrame(next);
}));
rows.push(["forecastle, software rendering, 1280x720, frame interval, ms", spread(intervals)]);
await closePage(drawn);

const addresses = Array.from({ length: 8 }, () => `${station.url}`);
const listen = (url) => {
  const { host, hash } = new URL(url);
  const socket = new WebSocket(`ws://${host}/ws?token=${hash.split("=")[1]}`, "windlass.v1");
  socket.binaryType = "arraybuffer";
  socket.onmessage = ({ data }) => {
    if (typeof data !== "string") return;
    const message = JSON.parse(data);
    if (message.op === "advertise")
      socket.send(JSON.stringify({ op: "subscribe", subscriptions: message.channels.map(({ id }) => ({ id, channelId: id })) }));
  };
  return socket;
};
const percent = (share) => `${(100 * share).toFixed(1)} % of a core`;
const desk = await rig.desk();
if (typeof WebSocket === "undefined") throw new Error("run it as node --experimental-websocket");
for (const [name, program] of [["trainee's station", station], ["instructor's station", desk]]) {
  const sockets = [];
  for (const pages of [0, 1, 8]) {
    while (sockets.length < pages) sockets.push(listen(name.startsWith("t") ? addresses[0] : program.url));
    await sleep(1500);
    rows.push([`${name}, ${pages} pages that hear every topic`, percent(await load(program.child.pid, 6))]);
  }
  for (const socket of sockets) socket.close();
}
rows.push(["the server beside them, one exercise", percent(await load(server.child.pid, 6))]);

await closeBrowser();
await rig.end();
for (const [what, figure] of rows) console.log(`${what.padEnd(62)} ${figure}`);
