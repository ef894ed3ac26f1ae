// Who goes on from a moment of a class that is over, and where each sits then.

import assert from "node:assert/strict";
import { test } from "node:test";

import type { Part, PlaceName, TrainingClass } from "../../src/door/ask";
import { placesBeside } from "../../src/door/class_marks";

const part = (name: string, place: PlaceName, since: number | null = null, until: number | null = null): Part => ({
  name,
  place,
  since,
  until,
  judged: true,
});
const classOf = (...exercises: Part[][]): TrainingClass =>
  ({ exercises: exercises.map((parts) => ({ parts })) }) as unknown as TrainingClass;

test("a class that goes on has its two with it, each where they sat at the end", () => {
  const it = classOf(
    [part("eve", "forecastle"), part("fay", "bridge")],
    [part("cid", "forecastle", null, 240), part("ann", "forecastle", 240), part("ben", "bridge")],
  );
  assert.deepEqual(placesBeside("ben", it), { ann: "forecastle", ben: "bridge" });
  assert.deepEqual(placesBeside("fay", it), { eve: "forecastle", fay: "bridge" });
});

test("who was relieved goes on alone, where he was", () => {
  const it = classOf([part("cid", "forecastle", null, 240), part("ann", "forecastle", 240), part("ben", "bridge")]);
  assert.deepEqual(placesBeside("cid", it), { cid: "forecastle" });
});
