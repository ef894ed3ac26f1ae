// What the desk has controls for, by the seat that opens it: for who looks on, none that moves nothing.

import assert from "node:assert/strict";
import { readFile, readdir } from "node:fs/promises";
import { join } from "node:path";
import { test } from "node:test";

import { type Gives, type SeatTold, mayGive, withheld } from "../../src/desk/may_give";
import type { Seat } from "../../src/wire/connection";
import type { TopicName } from "../../src/wire/generated";
import { root } from "../../tools/web.mjs";

const src = join(root, "station/web/src/desk");

/** A seat as its station tells of it: what roles.txt lets it write. */
async function told(seat: Seat, replay = false): Promise<SeatTold> {
  const lines = (await readFile(join(root, "config/security/roles.txt"), "utf8")).split("\n");
  const where = replay ? ["exercise/*", "exercise/replay*"] : ["exercise/*"];
  const written = lines
    .map((line) => line.split(/\s+/))
    .filter(([role, partition, what]) => role === seat && where.includes(partition!) && what === "write");
  return { seat, commands: written.flatMap((line) => line.slice(3)) as TopicName[] };
}

const kLive: Gives[] = [
  "InstructorWindlassCommand",
  "InstructorHelmCommand",
  "ExerciseCommand",
  "EnvironmentCommand",
  "FaultCommand",
  "BridgeOrderCommand",
  "AssessmentCommand",
];

test("an instructor has every control, an assessor the marks' alone, an observer none", async () => {
  assert.deepEqual(withheld(await told("instructor"), false), []);
  const assessor = withheld(await told("assessor"), false);
  const observer = withheld(await told("observer"), false);
  assert.deepEqual(observer, [...kLive, "ReplayCommand", "RestoreCommand", "files"]);
  assert.deepEqual(
    assessor,
    observer.filter((what) => what !== "AssessmentCommand"),
  );
});

test("a replay takes its own orders alone, and an instructor's files are there", async () => {
  assert.deepEqual(withheld(await told("instructor", true), true), kLive);
  assert.ok(!mayGive(await told("assessor", true), true, "AssessmentCommand"));
});

test("an assessor seeks in a replay, and an observer does not", async () => {
  assert.deepEqual(withheld(await told("assessor", true), true), [...kLive, "RestoreCommand", "files"]);
  assert.deepEqual(withheld(await told("observer", true), true), [
    ...kLive,
    "ReplayCommand",
    "RestoreCommand",
    "files",
  ]);
});

test("before the station has said which seat it is, nothing is given", () => {
  assert.ok(!mayGive(undefined, false, "ExerciseCommand"));
  assert.ok(withheld(undefined, false).includes("files"));
});

test("each control that says what it gives has its line in the style sheet, which has no other", async () => {
  const files = (await readdir(src)).filter((file) => file.endsWith(".ts"));
  const texts = await Promise.all(files.map((file) => readFile(join(src, file), "utf8")));
  const given = texts.flatMap((text) =>
    [...text.matchAll(/"data-gives":([^,}]*)/g)].flatMap(([, value]) =>
      [...value!.matchAll(/"(\w{5,})"/g)].map(([, what]) => what!),
    ),
  );
  const css = await readFile(join(src, "desk.css"), "utf8");
  const hidden = [...css.matchAll(/\[data-withheld~="(\w+)"\] \[data-gives="(\w+)"\]/g)].map(([, by, what]) => {
    assert.equal(by, what);
    return what!;
  });
  assert.deepEqual([...new Set(given)].sort(), hidden.sort());
  assert.deepEqual(hidden, withheld(undefined, false).sort());
});
