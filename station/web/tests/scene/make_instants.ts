// Picks instants out of recordings for the scene's test page: for each, samples of every topic of one tick, or
// where there is none the nearest.
//
// usage: recorder export RECORDING --format jsonl --topic SceneDescription SeabedDescription SeaState ShipState \
//          ChainState AnchorState WindlassLoad ForecastleView EnvironmentState --output FILE.jsonl
//        node station/web/tools/ts.mjs station/web/tests/scene/make_instants.ts OUTPUT.json \
//          FILE.jsonl NAME=SECONDS... [FILE.jsonl NAME=SECONDS...]
// SECONDS: of exercise time.

import { createReadStream } from "node:fs";
import { readFile, writeFile } from "node:fs/promises";
import { join } from "node:path";
import { createInterface } from "node:readline";
import { root } from "../../tools/web.mjs";

type Sample = Record<string, unknown> & { tick: number };
/** Samples by topic and side. */
type Streams = Record<string, Sample[]>;

const [output, ...wanted] = process.argv.slice(2);
if (!output) throw new Error("usage: make_instants.ts OUTPUT.json FILE.jsonl NAME=SECONDS...");
const idl = await readFile(join(root, "idl/windlass.idl"), "utf8");
const number = new Map<string, number>(); // of each enumerator
for (const [, body] of idl.replace(/\/\/.*$/gm, "").matchAll(/enum \w+ \{([^}]*)\}/g))
  body!.split(",").forEach((name, i) => number.set(name.trim(), i));

/** Enumerators as numbers, points as flat lists. */
function plain(value: unknown, key?: string): unknown {
  if (typeof value === "string") return number.get(value) ?? value;
  if (Array.isArray(value)) {
    if (key === "nodes" || key === "hull_corners")
      return (value as { x: number; y: number; z: number }[]).flatMap((p) => [p.x, p.y, p.z]);
    return value.map((v) => plain(v));
  }
  if (value && typeof value === "object")
    return Object.fromEntries(Object.entries(value).map(([k, v]) => [k, plain(v, k)]));
  return value;
}

/** One sample of each stream, of ticks as near to each other as there are. */
function together(streams: Streams): Record<string, Sample> {
  const nearest = (samples: Sample[], tick: number): Sample =>
    samples.reduce((a, b) => (Math.abs(b.tick - tick) < Math.abs(a.tick - tick) ? b : a));
  let best: { off: number; chosen: Record<string, Sample> } | undefined;
  for (const { tick } of streams["ForecastleView/0"] ?? []) {
    const chosen = Object.fromEntries(Object.entries(streams).map(([k, v]) => [k, nearest(v, tick)]));
    const off = Object.entries(chosen).reduce(
      (s, [k, v]) => s + (k.startsWith("Environment") ? 0 : Math.abs(v.tick - tick)),
      0,
    );
    if (!best || off <= best.off) best = { off, chosen };
  }
  if (!best) throw new Error("there is no ForecastleView/0");
  console.log(`  ticks apart: ${best.off}`);
  return best.chosen;
}

const kFixed = ["SceneDescription", "SeabedDescription", "SeaState"];
interface Wanted {
  path: string;
  instants: { name: string; time: number }[];
}
const recordings: Wanted[] = [];
for (const word of wanted) {
  const [name, time] = word.split("=");
  if (time === undefined) recordings.push({ path: word, instants: [] });
  else recordings.at(-1)!.instants.push({ name: name!, time: Number(time) });
}
const result: Record<string, unknown>[] = [];
for (const { path, instants } of recordings) {
  const newest: Streams = {};
  const fixed: Record<string, unknown> = {};
  const left = instants.sort((a, b) => a.time - b.time);
  for await (const line of createInterface({ input: createReadStream(path) })) {
    const { topic, message } = JSON.parse(line) as { topic: string; message: Sample & { side?: number; time: number } };
    if (kFixed.includes(topic)) fixed[topic] = plain(message);
    else {
      const recent = (newest[`${topic}/${message.side ?? ""}`] ??= []);
      recent.push(plain(message) as Sample);
      if (recent.length > 60) recent.shift();
      if (topic === "ShipState" && left[0] && message.time >= left[0].time + 0.5) {
        const { name } = left.shift()!;
        result.push({ name, ...structuredClone(fixed), ...structuredClone(together(newest)) });
      }
    }
  }
  if (left.length > 0) throw new Error(`${path} ends before ${left.map((i) => i.name).join(", ")}`);
}
// The scenes are the same for all instants of a recording: kept once each.
const scenes: string[] = [];
for (const instant of result) {
  const scene = JSON.stringify(kFixed.map((k) => instant[k]));
  let at = scenes.indexOf(scene);
  if (at < 0) at = scenes.push(scene) - 1;
  for (const k of kFixed) delete instant[k];
  instant.scene = at;
}
const short = (_: string, v: unknown): unknown =>
  typeof v === "number" && !Number.isInteger(v) ? Number(v.toPrecision(10)) : v;
await writeFile(
  output,
  JSON.stringify(
    {
      scenes: scenes.map((s) =>
        Object.fromEntries<unknown>((JSON.parse(s) as unknown[]).map((v, i) => [kFixed[i]!, v])),
      ),
      instants: result,
    },
    short,
  ) + "\n",
);
