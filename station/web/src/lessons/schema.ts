// The published JSON Schemas (config/schema), as far as a form is made of them: what a field is called, of what type it
// is, what it means. Whether a value will do is judged by the station program alone.

import anchor from "../../../../config/schema/anchor.schema.json";
import chain from "../../../../config/schema/chain.schema.json";
import exercise from "../../../../config/schema/exercise.schema.json";
import ground from "../../../../config/schema/ground.schema.json";
import lesson from "../../../../config/schema/lesson.schema.json";
import condition from "../../../../config/schema/lesson_condition.schema.json";
import ship from "../../../../config/schema/ship.schema.json";
import windlass from "../../../../config/schema/windlass.schema.json";
import words from "../../../../words/words.json";
import type { Json } from "./json";

/** What is used of JSON Schema draft 7. */
export interface Schema {
  $ref?: string;
  type?: string | string[];
  enum?: Json[];
  description?: string;
  default?: Json;
  maxLength?: number;
  properties?: { [name: string]: Schema };
  additionalProperties?: boolean | Schema;
  required?: string[];
  items?: Schema;
}

const files: { [name: string]: unknown } = {
  "anchor.schema.json": anchor,
  "chain.schema.json": chain,
  "exercise.schema.json": exercise,
  "ground.schema.json": ground,
  "lesson.schema.json": lesson,
  "lesson_condition.schema.json": condition,
  "ship.schema.json": ship,
  "windlass.schema.json": windlass,
};

/** The names of a list of rows of words.json, e.g. "../../words/words.json#/enumerations/Soil". */
function choices(reference: string): Schema {
  let at: unknown = words;
  for (const step of reference.split("#/")[1]!.split("/")) at = (at as { [name: string]: unknown })[step];
  return { enum: (at as { oneOf: { const: string }[] }).oneOf.map((row) => row.const) };
}

/** The schema that is meant: a reference leads to its file; what stands beside it goes before what that says. */
export function resolved({ $ref, ...beside }: Schema): Schema {
  if (!$ref) return beside;
  return { ...($ref.includes("#") ? choices($ref) : (files[$ref] as Schema)), ...beside };
}

export const exerciseSchema = exercise as unknown as Schema;
export const lessonSchema = lesson as unknown as Schema;

/** What a field means, for a form: which JSON gives bounds is the form's business. */
export const meaning = (schema: Schema): string => (schema.description ?? "").replace(/; a number alone.*/, "");

/** Names of the figures that a condition or a limit may look at, with unit and meaning. */
export const quantities: ReadonlyMap<string, string> = new Map(
  Object.entries((condition as unknown as Schema).properties!)
    .filter(([, schema]) => typesOf(schema).includes("object"))
    .map(([name, schema]) => [name, meaning(schema)]),
);

export function typesOf(schema: Schema): string[] {
  return typeof schema.type === "string" ? [schema.type] : (schema.type ?? []);
}

/** Whether it is shown in one line: no list of objects, no object but bounds of a figure. */
export function isPlain(schema: Schema): boolean {
  const types = typesOf(schema);
  if (schema.enum || types.some((type) => ["string", "number", "integer", "boolean"].includes(type))) return true;
  return types.includes("array") && isPlain(resolved(schema.items ?? {}));
}

/** "wind from" of wind_from_deg: the unit stands in the description. */
export const label = (name: string): string => name.replace(/_(deg|hz|h)$/, "").replaceAll("_", " ");

/** A new entry of a list: what it cannot do without, as far as the schema says it. */
export function blank(schema: Schema): Json {
  if (schema.enum) return schema.enum[0]!;
  if (schema.default !== undefined) return schema.default;
  const types = typesOf(schema);
  if (types.includes("string")) return "";
  if (types.includes("number") || types.includes("integer")) return 0;
  if (types.includes("boolean")) return true;
  if (types.includes("array")) return [];
  return Object.fromEntries((schema.required ?? []).map((name) => [name, blank(resolved(schema.properties![name]!))]));
}
