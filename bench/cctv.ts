// What the small pictures of a classroom cost: twelve exercises under way, a page with all their tiles on its screen.
// Percent of one core (processor time) of the server, of the desk's station, and of the browser's processes, and what
// the page is told, kB/s: with pictures off, on, and, for comparison, off with a link to each exercise that subscribes
// what a picture is made of and draws nothing. Where the processor draws. Prints a table; not a test.
//
// usage: WINDLASS_DOMAIN=N node station/web/tools/ts.mjs bench/cctv.ts [SECONDS]   (after a build; two minutes)

import { readFileSync } from "node:fs";
import { loadavg } from "node:os";
import { join } from "node:path";

import { closeBrowser, openPage, root, theBrowser } from "../tests/browser/browser";
import { type Program, Rig, eventually, sleep } from "../tests/browser/rig";

const [seconds = "20"] = process.argv.slice(2);
const kExercises = 12;
const kHertz = 100; // of /proc/PID/stat: USER_HZ
const kTopics = ["SceneDescription", "Landmarks", "SeaState", "LightsAndShapes", "BridgeView", "ForecastleCamera"];

/** s of the processor. */
function processorTime({ pid }: Program): number {
  const fields = readFileSync(`/proc/${pid}/stat`, "utf8").split(") ")[1].split(" ");
  return (Number(fields[11]) + Number(fields[12])) / kHertz;
}

const browser = await theBrowser({ asUsers: true });
const system = await browser.newBrowserCDPSession();
/** s of the processor, by kind of process. */
async function browsers(): Promise<Record<string, number>> {
  const { processInfo } = await system.send("SystemInfo.getProcessInfo");
  const times: Record<string, number> = {};
  for (const { type, cpuTime } of processInfo) times[type] = (times[type] ?? 0) + cpuTime;
  return times;
}

const rig = new Rig();
const file = join(root, "config/exercises/at_anchor_25m.json");
const others = Array.from({ length: kExercises - 1 }, (_, i) => `${rig.partition}-${i + 2}`);
const server = rig.server("at_anchor_25m", ...others.flatMap((id) => ["--exercise", file, "--partition", id]));
const desk = await rig.desk();
const url = new URL(desk.url);
let bytes = 0;
const page = await openPage(`${url.origin}/classroom${url.hash}`, {
  viewport: { width: 1440, height: 1900 },
  watch: (opened) =>
    opened.on("websocket", (socket) =>
      socket.on("framereceived", ({ payload }) => (bytes += Buffer.byteLength(payload))),
    ),
  init: () => {
    // A picture is copied to its tile.
    const { drawImage } = CanvasRenderingContext2D.prototype;
    window.pictures = 0;
    CanvasRenderingContext2D.prototype.drawImage = function (this: CanvasRenderingContext2D, ...given: unknown[]) {
      window.pictures += 1;
      (drawImage as (...given: unknown[]) => void).apply(this, given);
    };
  },
});
await eventually("all tiles", async () => (await page.locator(".tile").count()) === kExercises);
await eventually("all are drawn", () => page.evaluate((all) => window.pictures >= all, kExercises));
console.log(`until each was drawn once: ${(bytes / 1000).toFixed(0)} kB`);
const toggle = page.getByRole("button", { name: /^CCTV/ });

/** Returns the browser's share of a core, and pictures a second. */
async function measure(what: string): Promise<[all: number, pictures: number]> {
  await sleep(6000);
  bytes = 0;
  const programs = [server, desk].map(processorTime);
  const before = await browsers();
  const [pictures, begun] = [await page.evaluate(() => window.pictures), performance.now()];
  await sleep(1000 * Number(seconds));
  const took = (performance.now() - begun) / 1000;
  const after = await browsers();
  const drawn = (await page.evaluate(() => window.pictures)) - pictures;
  const percent = (s: number): string => `${((100 * s) / took).toFixed(1)} %`;
  const [ofServer, ofStation] = [server, desk].map((of, i) => percent(processorTime(of) - programs[i]));
  const kinds = Object.keys(after).map((kind) => `${kind} ${percent(after[kind] - (before[kind] ?? 0))}`);
  const all = Object.keys(after).reduce((sum, kind) => sum + after[kind] - (before[kind] ?? 0), 0);
  console.log(`${what}: server ${ofServer}, station ${ofStation}, browser ${percent(all)} (${kinds.join(", ")})`);
  console.log(`  ${(bytes / 1000 / took).toFixed(1)} kB/s, ${(drawn / took).toFixed(2)} pictures a second`);
  return [all / took, drawn / took];
}

const on = await measure("on");
await toggle.click();
await sleep(30000); // until the station hears the cameras no more
const off = await measure("off");
console.log(`a picture takes ${((1000 * (on[0] - off[0])) / on[1]).toFixed(0)} ms of the browser's processes`);
await page.evaluate(
  ({ ids, topics }) => {
    for (const id of ids) {
      const address = new URL("/ws", location.href);
      address.protocol = "ws:";
      address.search = new URLSearchParams({
        token: sessionStorage.getItem("windlass.token"),
        exercise: id,
      }).toString();
      const socket = new WebSocket(address, "windlass.v1");
      socket.onmessage = ({ data }: MessageEvent<unknown>) => {
        if (typeof data !== "string") return;
        const said = JSON.parse(data) as { op: string; channels: { id: number; topic: string }[] };
        if (said.op !== "advertise") return;
        const wanted = said.channels.filter(({ topic }) => topics.includes(topic.slice(1)));
        const subscriptions = wanted.map((channel) => ({ id: channel.id, channelId: channel.id }));
        socket.send(JSON.stringify({ op: "subscribe", subscriptions }));
      };
    }
  },
  { ids: [rig.partition, ...others], topics: kTopics },
);
await measure("off, every exercise subscribed, nothing drawn");
console.log(`load of the machine at the end: ${loadavg()[0].toFixed(1)}`);
await closeBrowser();
await rig.end();
