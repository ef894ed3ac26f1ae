// Plain JSON, places in it, and its text as the shipped exercises are written.

import { t } from "../kit/language";

export type Json = null | boolean | number | string | Json[] | JsonObject;
export interface JsonObject {
  [name: string]: Json;
}

export const isObject = (value: Json | undefined): value is JsonObject =>
  typeof value === "object" && value !== null && !Array.isArray(value);
export const isScalar = (value: Json | undefined): value is null | boolean | number | string =>
  value !== undefined && (typeof value !== "object" || value === null);
/** A scalar as text; "" for anything else. */
export const scalarText = (value: Json | undefined): string => (isScalar(value) ? `${value}` : "");

/** A value in a document, there or not. */
export interface Place {
  /** JSON pointer (RFC 6901), e.g. "/lesson/criteria/2/max". */
  readonly pointer: string;
  get(): Json | undefined;
  /** undefined: takes it away. */
  set(value: Json | undefined): void;
}

/** The document as a whole. */
export const wholeOf = (document: JsonObject): Place => ({ pointer: "", get: () => document, set: () => undefined });

/** A field of an object, which is made when something is put there; or an entry of a list. */
export function placeIn(parent: Place, key: string | number): Place {
  return {
    pointer: `${parent.pointer}/${`${key}`.replaceAll("~", "~0").replaceAll("/", "~1")}`,
    get: () => (parent.get() as JsonObject | undefined)?.[key],
    set: (value) => {
      const holder = (parent.get() ?? {}) as JsonObject;
      if (value === undefined) delete holder[key];
      else holder[key] = value;
      if (parent.get() === undefined) parent.set(holder);
    },
  };
}

/** What stands at a pointer; undefined: nothing. */
export function at(document: Json | undefined, pointer: string): Json | undefined {
  return pointer
    .split("/")
    .slice(1)
    .map((step) => step.replaceAll("~1", "/").replaceAll("~0", "~"))
    .reduce<Json | undefined>(
      (value, step) => (typeof value === "object" && value !== null ? (value as JsonObject)[step] : undefined),
      document,
    );
}

/** Where a pointer leads, in words: "lesson, criteria 3 (pay-out), max". */
export function placeWords(document: Json, pointer: string): string {
  let value: Json | undefined = document;
  const words: string[] = [];
  for (const step of pointer.split("/").slice(1)) {
    const name = step.replaceAll("~1", "/").replaceAll("~0", "~");
    const list = Array.isArray(value);
    value = typeof value === "object" && value !== null ? (value as JsonObject)[name] : undefined;
    const id = isObject(value) ? scalarText(value.id ?? value.code) : "";
    const named = id && ` (${id})`;
    if (list) words.push(`${words.pop() ?? ""} ${Number(name) + 1}${named}`.trim());
    else words.push(name.replaceAll("_", " "));
  }
  return words.join(", ") || t("all of it");
}

const kWidth = 280; // columns in which an object or a list stays on one line

function onOneLine(value: Json): string {
  if (Array.isArray(value)) return `[${value.map(onOneLine).join(", ")}]`;
  if (!isObject(value)) return JSON.stringify(value);
  const fields = Object.entries(value).map(([name, each]) => `${JSON.stringify(name)}: ${onOneLine(each)}`);
  return fields.length ? `{ ${fields.join(", ")} }` : "{}";
}

/**
 * As the shipped exercises are laid out: an entry of a list on a line, so that a change of one figure changes one
 * line.
 */
export function textOf(value: Json, indent = ""): string {
  const flat = onOneLine(value);
  const inside = isScalar(value) ? [] : Object.values(value as JsonObject);
  const rows =
    inside.length > 0 && inside.every((each) => isObject(each)) && (Array.isArray(value) || inside.length > 1);
  if (isScalar(value) || (indent && !rows && indent.length + flat.length <= kWidth)) return flat;
  const inner = `${indent}  `;
  const parts = Array.isArray(value)
    ? value.map((each) => textOf(each, inner))
    : Object.entries(value).map(([name, each]) => `${JSON.stringify(name)}: ${textOf(each, inner)}`);
  const [open, close] = Array.isArray(value) ? "[]" : "{}";
  return `${open}\n${parts.map((part) => inner + part).join(",\n")}\n${indent}${close}`;
}
