// The catalogue of the pages' second language against the sources, and what makes a sentence of it.

import assert from "node:assert/strict";
import { readFile, readdir } from "node:fs/promises";
import { join } from "node:path";
import { test } from "node:test";

import german from "../../../../words/pages_de.json";
import words from "../../../../words/words.json";
import { t, translatedAs, typedFigure } from "../../src/kit/language";
import { doorSentences } from "../../src/door/door_sentences";
import { endings, modelSteps, serverSentences, stepKinds } from "../../src/kit/server_sentences";
import { need, root } from "../../tools/web.mjs";

/** German words that are English ones. */
const kSame = "ACK Motor Name Pause REC Simulation Stand Start Stopper Wind bar m:ss normal".split(" ");

/** What stands there as it is: names, what is spoken, and what machines read. */
const kNoWords = new Set(
  [
    ["Windlass", "Gamepad", "RT, LT", "LB, RB", "iPad, iPhone"],
    ["by hand signal", "zero one two three four five six seven eight nine ten eleven twelve"],
    ["other page", "cone up", "cone down"],
    ["the order"], // of a repeat, which is English
    ["the bridge "], // with which the judge's reasons begin
  ].flat(),
);

/** What the pages show by translated() beside the sentences of words.json, server and door: also of kit/units. */
const kTranslated = [
  ["load", "cable speed", "NM"],
  ["achieved", "not yet", "not shown"],
  ["port windlass", "starboard windlass", "helm", "is not at the levers", "is not heard any more", "its last hand"],
  ["speed lever at zero; brake, clutch and stopper as they were", "the helm's levers stay as they are"],
  ["instructor", "assessor", "observer", "owner"],
  ["orders, repeated back and carried out in time"], // of a hint
].flat();

const catalogue: Readonly<Record<string, string>> = german;

interface Syntax {
  type: string;
  range: [number, number];
  [part: string]: unknown;
}
interface Source {
  file: string;
  tree: Syntax;
}
/** The formatter's own parser: TypeScript 7 has none to be called. */
interface Formatter {
  parsers: { typescript: { parse: (text: string, options: { filepath: string }) => Syntax | Promise<Syntax> } };
}
const { parsers } = need("prettier/plugins/typescript") as Formatter;

async function sources(): Promise<Source[]> {
  const src = join(root, "station/web/src");
  const files = (await readdir(src, { recursive: true })).filter((file) => file.endsWith(".ts")).sort();
  return Promise.all(
    files.map(async (file) => {
      const text = await readFile(join(src, file), "utf8");
      return { file, tree: await parsers.typescript.parse(text, { filepath: file }) };
    }),
  );
}

const isSyntax = (part: unknown): part is Syntax => typeof (part as Syntax | null)?.type === "string";
const list = (part: unknown): Syntax[] => (part as (Syntax | null)[]).filter(isSyntax);

function visit(node: Syntax, see: (node: Syntax) => void): void {
  see(node);
  for (const part of Object.values(node))
    for (const child of Array.isArray(part) ? (part as unknown[]) : [part]) if (isSyntax(child)) visit(child, see);
}

/** A literal, or several joined by +; undefined: it is computed. */
function literal(node: Syntax | undefined): string | undefined {
  if (node?.type === "Literal" && typeof node.value === "string") return node.value;
  if (node?.type !== "BinaryExpression" || node.operator !== "+") return undefined;
  const [left, right] = [literal(node.left as Syntax), literal(node.right as Syntax)];
  return left === undefined || right === undefined ? undefined : left + right;
}

const nameOf = (node: Syntax): string =>
  ((node.type === "MemberExpression" ? (node.property as Syntax) : node).name as string | undefined) ?? "";
/** The called function's name and its arguments; undefined: it is no call. */
function call(node: Syntax): { name: string; given: Syntax[] } | undefined {
  if (node.type !== "CallExpression") return undefined;
  return { name: nameOf(node.callee as Syntax), given: list(node.arguments) };
}

/** All that is given to t(). */
function sentences(all: Source[]): { file: string; english: string | undefined }[] {
  const found: { file: string; english: string | undefined }[] = [];
  for (const { file, tree } of all)
    visit(tree, (node) => {
      const called = call(node);
      if (called?.name === "t") found.push({ file, english: literal(called.given[0]) });
    });
  return found;
}

/** What pages show of words.json and of the server; not of orders and reports, which are spoken in English. */
function ofWords(): Set<string> {
  const spoken = new Set(["BridgeOrderCode", "ReportCode", "StayGiven", "Growing", "CableWeight"]);
  const found: unknown[] = [];
  const columns = ["said", "unjudged", "seat_said", "explanation"];
  const take = (row: object, names: string[]): void => {
    for (const name of names) found.push((row as Record<string, unknown>)[name]);
  };
  for (const [name, { oneOf }] of Object.entries(words.enumerations))
    if (!spoken.has(name)) for (const row of oneOf) take(row, columns);
  for (const row of words.enumerations.FaultCode.oneOf)
    take(row, ["machine", "symptom", "reason", "way_out", "severity", "targets"]);
  for (const row of [...words.events.waited_for.oneOf, ...words.events.told.oneOf]) take(row, columns);
  for (const row of words.alerts) take(row, columns);
  for (const row of words.report_pad) take(row, columns);
  for (const row of Object.values(words.units)) take(row, ["many"]);
  found.push(...Object.values(serverSentences).flat(), ...endings, modelSteps, ...stepKinds, ...doorSentences);
  return new Set(found.filter((said): said is string => typeof said === "string" && said !== ""));
}

const places = (sentence: string): string[] => [...sentence.matchAll(/\{[^}]*\}/g)].map(([place]) => place).sort();

const kShownProps = new Set(["aria-label", "aria-description", "aria-valuetext", "title", "placeholder", "alt"]);
const kTold = new Set(["setText", "tell", "say", "refuse"]);

/** Expressions whose text somebody reads. */
function shown(tree: Syntax): Syntax[] {
  const found: Syntax[] = [];
  visit(tree, (node) => {
    const called = call(node);
    if (called?.name === "h" || called?.name === "svg") {
      found.push(...called.given.slice(2));
      const props = called.given[1];
      for (const prop of props?.type === "ObjectExpression" ? list(props.properties) : []) {
        const key = prop.key as Syntax | undefined;
        if (key && kShownProps.has((key.value ?? key.name) as string)) found.push(prop.value as Syntax);
      }
    } else if (called?.name === "setAttribute") {
      const [name, value] = called.given.slice(-2);
      if (value && kShownProps.has(literal(name) ?? "")) found.push(value);
    } else if (called && kTold.has(called.name)) found.push(...called.given);
    else if (node.type === "AssignmentExpression" && nameOf(node.left as Syntax) === "textContent")
      found.push(node.right as Syntax);
  });
  return found;
}

/** Literals of letters that an expression comes out as, past t(). */
function bare(node: Syntax): string[] {
  const of = (...parts: unknown[]): string[] => parts.filter(isSyntax).flatMap(bare);
  if (node.type === "Literal") return typeof node.value === "string" ? [node.value] : [];
  if (node.type === "ConditionalExpression") return of(node.consequent, node.alternate);
  if (node.type === "LogicalExpression" || (node.type === "BinaryExpression" && node.operator === "+"))
    return of(node.left, node.right);
  if (node.type !== "TemplateLiteral") return [];
  const text = list(node.quasis).map(({ value }) => (value as { cooked: string }).cooked);
  return [...text, ...of(...list(node.expressions))];
}
/** What nobody reads: of a style, a drawing, a query. */
const kUnreadProps = new Set(["class", "style", "d", "viewBox", "transform"]);
const kUnreadCalls = new Set(["querySelector", "querySelectorAll", "closest", "matchMedia", "line", "t", "translated"]);

/** Literals of two words and more, wherever they stand: most of what is read, also out of a table. */
function ofWordsAnywhere(node: Syntax): string[] {
  const called = call(node);
  if (called && kUnreadCalls.has(called.name)) return [];
  const key = node.type === "Property" ? (node.key as Syntax) : undefined;
  if (key && kUnreadProps.has((key.value ?? key.name) as string)) return [];
  if (/^(Import|Export(All|Named)|TS|Throw)/.test(node.type) && !isSyntax(node.declaration)) return [];
  const text = literal(node) ?? "";
  if (/[a-z]{2}[,:;]? [a-z]{2}/i.test(text)) return [text];
  return Object.values(node)
    .flatMap((part) => (Array.isArray(part) ? (part as unknown[]) : [part]))
    .filter(isSyntax)
    .flatMap(ofWordsAnywhere);
}

/** Letters enough to be a word; abbreviations of instruments and units are the same in all languages. */
const isWord = (text: string): boolean => /[a-z]{2}/i.test(text) && !/^[\s\W]*([A-Z_]+|kn|min|ms)[\s\W]*$/.test(text);

void test("every sentence of the sources is in the catalogue, and none that is not", async () => {
  const given = sentences(await sources());
  assert.deepEqual(
    given.filter(({ english }) => english === undefined),
    [],
    "t() takes a literal; for words that come from elsewhere there is translated()",
  );
  const used = new Set([...given.map(({ english }) => english!), ...ofWords(), ...kTranslated]);
  assert.deepEqual(
    [...used].filter((english) => !(english in catalogue)),
    [],
    "without German",
  );
  assert.deepEqual(
    Object.keys(catalogue).filter((english) => !used.has(english)),
    [],
    "unused",
  );
});

void test("the catalogue is sorted, has the same places on both sides, and German on one", () => {
  const entries = Object.entries(catalogue);
  assert.deepEqual(Object.keys(catalogue), Object.keys(catalogue).sort());
  for (const [english, other] of entries) assert.deepEqual(places(other), places(english), english);
  const same = entries.filter(([english, other]) => other === english).map(([english]) => english);
  assert.deepEqual(same, kSame);
  assert.deepEqual(
    entries.filter(([, other]) => other.trim() !== other || other === "" || other.includes("|")),
    [],
  );
});

void test("nobody reads what did not go by the catalogue", async () => {
  const read = new Set([...kTranslated, ...ofWords()]); // by translated()
  const drawn = /^(scene|sound)\//; // shaders and fonts
  const found = (await sources()).flatMap(({ file, tree }) =>
    [...shown(tree).flatMap(bare).filter(isWord), ...(drawn.test(file) ? [] : ofWordsAnywhere(tree))]
      .filter((text) => !kNoWords.has(text) && !read.has(text))
      .map((text) => `${file}: ${text}`),
  );
  assert.deepEqual(found, []);
});

void test("English is its own key, without its note", () => {
  assert.equal(t("Alerts"), "Alerts");
  assert.equal(t("off|lights"), "off");
  assert.equal(t("and {count} more", { count: 3 }), "and 3 more");
  assert.equal(translatedAs("Nobody has the {0}", "Nobody has the helm"), "Nobody has the helm");
});

void test("what the door says in sentences of its own it says in these", async () => {
  const door = join(root, "door");
  const files = (await readdir(door, { recursive: true })).filter((file) => /\.[ch]pp$/.test(file));
  const all = (await Promise.all(files.map((file) => readFile(join(door, file), "utf8")))).join("\n");
  const history = await readFile(join(root, "instructor_console/history/next_lesson.cpp"), "utf8");
  const joined = (all + history).replace(/"\s*"/g, ""); // of a literal over several lines
  const missing = doorSentences.filter((sentence) => {
    const literal = sentence.split(/\{[^}]*\}/).map((part) => part.trim());
    return !literal.every((part) => joined.includes(part.replace(/^is a class |:$/g, "")));
  });
  assert.deepEqual(missing, []);
});

void test("a figure may be typed with a point or a comma", () => {
  assert.equal(typedFigure(" 1.5"), "1.5");
  assert.equal(typedFigure("1,5 "), "1.5");
  assert.equal(typedFigure("1,500.5"), "1,500.5", "no figure at all: nothing is guessed");
});
