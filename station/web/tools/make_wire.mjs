// Makes build/web/wire/generated.ts of the wire contract: a type and a decoder for every struct of idl/windlass.idl,
// and the table of topics of idl/topics.md. The contract stands in those two files only; a page cannot disagree with
// it.
//
// usage: node make_wire.mjs

import { mkdir, readFile, rename, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { need, root, web } from "./web.mjs";

/** @typedef {import("@foxglove/omgidl-parser").IDLMessageDefinitionField & { enumType?: string }} Field */

/**
 * TypeScript and the reader's call for the scalars of the IDL.
 * @type {Record<string, [type: string, read: string]>}
 */
const scalars = {
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

/**
 * Rows of the tables of topics.md.
 * @param {string} text
 */
function topicRows(text) {
  const row = /^\| (\w+) \| windlass::v\d+::(\w+) \| ([\w, -]+) \| \d+ \| [\w >-]+ \| (\d+|at once) \|/gm;
  return [...text.matchAll(row)].map(([, topic, type, keys, rate]) => ({
    topic,
    type,
    keys: keys === "-" ? [] : /** @type {string} */ (keys).split(", "),
    rate: Number(rate) || 0,
  }));
}

/**
 * The text of generated.ts.
 * @param {string} idl of windlass.idl
 * @param {string} topics of topics.md
 */
function wireText(idl, topics) {
  const { parseIDL } = /** @type {typeof import("@foxglove/omgidl-parser")} */ (need("@foxglove/omgidl-parser"));
  const definitions = parseIDL(idl);
  const version = Number(/WIRE_VERSION = (\d+)/.exec(idl)?.[1]);
  const prefix = `windlass::v${version}::`;
  /** @param {string | undefined} name of a type in the IDL */
  const short = (name) => {
    if (!name?.startsWith(prefix)) throw new Error(`${name} is not of ${prefix}`);
    return name.slice(prefix.length);
  };
  // Sequences of these are read in one piece; points are x, y, z, x, y, z ...
  /** @type {Record<string, [type: string, read: string]>} */
  const packed = {
    float32: ["Float32Array", "f32s(1)"],
    uint32: ["Uint32Array", "u32s()"],
    uint8: ["Uint8Array", "u8s()"],
    [`${prefix}Point3f`]: ["Float32Array", "f32s(3)"],
  };

  /**
   * The type of one value of a field, and the expression that reads it.
   * @param {Field} f
   * @returns {[type: string, read: string]}
   */
  const value = (f) => {
    if (f.enumType) return [short(f.enumType), "r.u32()"];
    if (f.isComplex) return [short(f.type), `read${short(f.type)}(r)`];
    // Hashes need every bit; other 64-bit figures are counts and times below 2^53.
    if (f.type === "uint64" && f.name.endsWith("_hash")) return ["bigint", "r.hash()"];
    const scalar = scalars[f.type];
    if (!scalar) throw new Error(`${f.name}: no reader of ${f.type}`);
    return [scalar[0], `r.${scalar[1]}()`];
  };
  /**
   * As value, of a field that may be a sequence.
   * @param {Field} f
   * @returns {[type: string, read: string]}
   */
  const field = (f) => {
    const inOnePiece = f.isArray && !f.enumType && packed[f.type];
    if (inOnePiece) return [inOnePiece[0], `r.${inOnePiece[1]}`];
    const [type, read] = value(f);
    return f.isArray ? [`${type}[]`, `r.list(() => ${read})`] : [type, read];
  };

  /**
   * One line each, indented.
   * @template T
   * @param {readonly T[]} of
   * @param {(one: T) => string} line
   */
  const lines = (of, line) => of.map((one) => `  ${line(one)}\n`).join("");
  const enums = definitions
    .filter((d) => d.aggregatedKind === "module")
    .filter((d) => d.name?.startsWith(prefix) && d.definitions.length > 0);
  const structs = definitions.filter((d) => d.aggregatedKind === "struct");

  let out = `// Made by station/web/tools/make_wire.mjs of idl/windlass.idl and idl/topics.md.
import type { CdrReader } from "./cdr";

export const WIRE_VERSION = ${version};
`;
  for (const d of enums) {
    const enumerators = lines(d.definitions, (v) => `${v.name} = ${Number(v.value)},`);
    out += `\nexport enum ${short(d.name)} {\n${enumerators}}\n`;
  }
  for (const d of structs) {
    const name = short(d.name);
    /** @type {Field[]} */
    const fields = d.definitions;
    out += `\nexport interface ${name} {\n${lines(fields, (f) => `${f.name}: ${field(f)[0]};`)}}\n`;
    out += `export function read${name}(r: CdrReader): ${name} {\n  return {\n`;
    out += lines(fields, (f) => `  ${f.name}: ${field(f)[1]},`) + "  };\n}\n";
  }
  const rows = topicRows(topics);
  out += "\n/** The type of each topic. */\nexport interface TopicTypes {\n";
  out += lines(rows, (row) => `${row.topic}: ${row.type};`) + "}\nexport type TopicName = keyof TopicTypes;\n";
  out += "\nexport const decoders: { [T in TopicName]: (r: CdrReader) => TopicTypes[T] } = {\n";
  out += lines(rows, (row) => `${row.topic}: read${row.type},`) + "};\n";
  out += '\n/** Which instance of its topic a sample is of; "" where a topic has but one. */\n';
  out += "export const keys: { [T in TopicName]: (s: TopicTypes[T]) => string } = {\n";
  out += lines(rows, ({ topic, keys }) => {
    const key = keys.map((k) => `\${s.${k}}`).join("/");
    return `${topic}: ${keys.length ? "(s)" : "()"} => \`${key}\`,`;
  });
  out += "};\n\n/** Hz at time scale 1; 0: when something changes. */\n";
  out += "export const rates: { [T in TopicName]: number } = {\n";
  return out + lines(rows, (row) => `${row.topic}: ${row.rate},`) + "};\n";
}

/** Writes generated.ts where it is not as it should be, in one stroke: presets that build at once share it. */
export async function makeWire() {
  const idl = await readFile(join(root, "idl/windlass.idl"), "utf8");
  const text = wireText(idl, await readFile(join(root, "idl/topics.md"), "utf8"));
  const output = join(web, "wire/generated.ts");
  if ((await readFile(output, "utf8").catch(() => "")) === text) return;
  await mkdir(dirname(output), { recursive: true });
  await writeFile(`${output}.${process.pid}`, text);
  await rename(`${output}.${process.pid}`, output);
}

if (process.argv[1] === fileURLToPath(import.meta.url)) await makeWire();
