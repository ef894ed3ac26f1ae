// Makes src/wire/generated.ts of the wire contract: a type and a decoder for every struct of idl/windlass.idl, and
// the table of topics of idl/topics.md. The contract stands in those two files only; a page cannot disagree with it.
//
// usage: node tools/make_wire.mjs IDL_FOLDER OUTPUT

import * as parser from "@foxglove/omgidl-parser";
import { mkdir, readFile, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";

const [idlFolder, output] = process.argv.slice(2);
if (!output) throw new Error("usage: node tools/make_wire.mjs IDL_FOLDER OUTPUT");
const parseIDL = parser.parseIDL ?? parser.default.parseIDL;

const definitions = parseIDL(await readFile(join(idlFolder, "windlass.idl"), "utf8"));
const version = Number(/WIRE_VERSION = (\d+)/.exec(await readFile(join(idlFolder, "windlass.idl"), "utf8"))[1]);
const prefix = `windlass::v${version}::`;
const short = (name) => {
  if (!name.startsWith(prefix)) throw new Error(`${name} is not of ${prefix}`);
  return name.slice(prefix.length);
};

const isEnum = (d) => d.aggregatedKind === "module" && d.name?.startsWith(prefix) && d.definitions.length > 0;
const enums = new Map(definitions.filter(isEnum).map((d) => [d.name, d]));
const structs = definitions.filter((d) => d.aggregatedKind === "struct");

const scalars = {
  // type: [TypeScript, reader]
  bool: ["boolean", "bool"],
  int32: ["number", "i32"],
  uint32: ["number", "u32"],
  int64: ["number", "i64"],
  uint64: ["number", "u64"],
  float32: ["number", "f32"],
  float64: ["number", "f64"],
  string: ["string", "string"],
  uint8: ["number", "u8"],
};
// Sequences of these are read in one piece; points are x, y, z, x, y, z ...
const packed = {
  float32: ["Float32Array", "f32s(1)"],
  uint32: ["Uint32Array", "u32s()"],
  uint8: ["Uint8Array", "u8s()"],
  [`${prefix}Point3f`]: ["Float32Array", "f32s(3)"],
};

/** [TypeScript type, expression that reads it] of a field. */
function field(f) {
  if (f.isArray && packed[f.type] && !f.enumType) return [packed[f.type][0], `r.${packed[f.type][1]}`];
  let type, read;
  if (f.enumType) [type, read] = [short(f.enumType), "r.u32()"];
  else if (f.isComplex) [type, read] = [short(f.type), `read${short(f.type)}(r)`];
  // Hashes need every bit; other 64-bit figures are counts and times below 2^53.
  else if (f.type === "uint64" && f.name.endsWith("_hash")) [type, read] = ["bigint", "r.hash()"];
  else if (scalars[f.type]) [type, read] = [scalars[f.type][0], `r.${scalars[f.type][1]}()`];
  else throw new Error(`${f.name}: no reader of ${f.type}`);
  return f.isArray ? [`${type}[]`, `r.list(() => ${read})`] : [type, read];
}

/** Rows of the tables of topics.md: [topic, type, key, rate]. */
function topicRows(text) {
  const row = /^\| (\w+) \| windlass::v\d+::(\w+) \| ([\w, -]+) \| \d+ \| [\w >-]+ \| (\d+|at once) \|/gm;
  return [...text.matchAll(row)].map((m) => [m[1], m[2], m[3] === "-" ? [] : m[3].split(", "), Number(m[4]) || 0]);
}

let out = `// Made by tools/make_wire.mjs of idl/windlass.idl and idl/topics.md.
import type { CdrReader } from "./cdr";

export const WIRE_VERSION = ${version};
`;
for (const [name, d] of enums)
  out += `\nexport enum ${short(name)} {\n${d.definitions.map((v) => `  ${v.name} = ${v.value},\n`).join("")}}\n`;
for (const s of structs) {
  const name = short(s.name);
  const fields = s.definitions.map((f) => [f.name, ...field(f)]);
  out += `\nexport interface ${name} {\n${fields.map(([n, t]) => `  ${n}: ${t};\n`).join("")}}\n`;
  out += `export function read${name}(r: CdrReader): ${name} {\n  return {\n`;
  out += fields.map(([n, , read]) => `    ${n}: ${read},\n`).join("") + "  };\n}\n";
}
const rows = topicRows(await readFile(join(idlFolder, "topics.md"), "utf8"));
out += `\n/** The type of each topic. */\nexport interface TopicTypes {\n${rows.map(([t, type]) => `  ${t}: ${type};\n`).join("")}}\n`;
out += `export type TopicName = keyof TopicTypes;\n`;
out += `\nexport const decoders: { [T in TopicName]: (r: CdrReader) => TopicTypes[T] } = {\n${rows.map(([t, type]) => `  ${t}: read${type},\n`).join("")}};\n`;
out += `\n/** Which instance of its topic a sample is of; "" where a topic has but one. */\nexport const keys: { [T in TopicName]: (s: TopicTypes[T]) => string } = {\n`;
out += rows
  .map(([t, , key]) => `  ${t}: ${key.length ? "(s) =>" : "() =>"} \`${key.map((k) => `\${s.${k}}`).join("/")}\`,\n`)
  .join("");
out += `};\n\n/** Hz at time scale 1; 0: when something changes. */\nexport const rates: { [T in TopicName]: number } = {\n`;
out += rows.map(([t, , , rate]) => `  ${t}: ${rate},\n`).join("") + "};\n";

await mkdir(dirname(output), { recursive: true });
await writeFile(output, out);
