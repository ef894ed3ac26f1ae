// What a station with pages costs: an exercise in which the anchor is let go, a station that hosts pages, and pages
// that hear everything of their seat and draw nothing. Prints a table: processor time of the station's program and of
// the server, in percent of one core, what came to a page, and what each message cost the station. A machine that is
// busy with other things slows the exercise down, and then fewer messages come: the cost of one is what compares.
//
// usage: node station/web/tools/ts.mjs bench/station_pages.ts [BIN [SECONDS [DOMAIN]]]     (after a build)

import { type ChildProcessByStdio, spawn } from "node:child_process";
import { readFileSync } from "node:fs";
import type { Readable } from "node:stream";

import WebSocket from "ws";

const [bin = "build/release/bin", seconds = "20", domain = "23"] = process.argv.slice(2);
const kHertz = 100; // of /proc/PID/stat: USER_HZ
const session = ["--domain", domain, "--partition", "bench"];
const wait = (s: number): Promise<void> => new Promise((done) => setTimeout(done, 1000 * s));

type Child = ChildProcessByStdio<null, Readable, null>;
/** What came to all pages. */
interface HeardByPages {
  messages: number;
  bytes: number;
}

/** s of processor time that the process has taken. */
function processorTime(pid: number): number {
  const fields = readFileSync(`/proc/${pid}/stat`, "utf8").split(") ")[1].split(" ");
  return (Number(fields[11]) + Number(fields[12])) / kHertz;
}

function start(program: string, ...options: string[]): Child {
  return spawn(`${bin}/${program}`, options, { stdio: ["ignore", "pipe", "ignore"] });
}

/** The first line that a program prints. */
async function firstLine(child: Child): Promise<string> {
  let text = "";
  for await (const part of child.stdout) {
    text += `${part as Buffer}`;
    if (text.includes("\n")) return text.split("\n")[0];
  }
  throw new Error("the station ended");
}

function openPage(address: string, heard: HeardByPages): WebSocket {
  const { host, hash } = new URL(address);
  const socket = new WebSocket(`ws://${host}/ws?token=${hash.slice("#token=".length)}`, "windlass.v1");
  socket.on("message", (data: Buffer, binary) => {
    if (binary) {
      heard.messages += 1;
      heard.bytes += data.byteLength;
      return;
    }
    const message = JSON.parse(data.toString()) as { op: string; channels: { id: number }[] };
    if (message.op !== "advertise") return;
    const subscriptions = message.channels.map(({ id }) => ({ id, channelId: id }));
    socket.send(JSON.stringify({ op: "subscribe", subscriptions }));
  });
  return socket;
}

/** A row of the table, for so many pages. */
async function measure(station: string, options: readonly string[], pages: number): Promise<string[]> {
  const server = start("windlass_server", "--exercise", "config/exercises/let_go_port_25m.json", ...session);
  const host = start(station, ...session, ...options, "--ui-port", "0");
  const address = await firstLine(host);
  const heard = { messages: 0, bytes: 0 };
  const sockets = Array.from({ length: pages }, () => openPage(address, heard));
  await wait(3);
  const before = [processorTime(host.pid), processorTime(server.pid)];
  Object.assign(heard, { messages: 0, bytes: 0 });
  const began = performance.now();
  await wait(Number(seconds));
  const took = (performance.now() - began) / 1000;
  const percent = [host.pid, server.pid].map((pid, i) => (100 * (processorTime(pid) - before[i])) / took);
  for (const socket of sockets) socket.close();
  host.kill();
  server.kill();
  await wait(1);
  const each = Math.max(1, pages);
  const cost = heard.messages ? ((percent[0] / 100) * took * 1e6) / heard.messages : 0;
  return [
    ...percent.map((p) => p.toFixed(1)),
    (heard.messages / took / each).toFixed(0),
    (heard.bytes / took / each / 1e3).toFixed(0),
    cost.toFixed(0),
  ];
}

console.log(
  "| station | pages | station, % of a core | server, % of a core | messages/s, a page | kB/s, a page | us of the station, a message |",
);
console.log("|---|---|---|---|---|---|---|");
for (const [name, program, options] of [
  ["forecastle", "trainee_client", ["--ui", "--seat", "forecastle"]],
  ["instructor", "instructor_console", ["ui"]],
] as const)
  for (const pages of [0, 1, 8])
    console.log(`| ${[name, pages, ...(await measure(program, options, pages))].join(" | ")} |`);
