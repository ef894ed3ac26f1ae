// What a new class may be of, and how many trainees it has to each exercise.

import assert from "node:assert/strict";
import { test } from "node:test";

import type { ExerciseFile } from "../../src/door/ask";
import { crewFor, offered } from "../../src/door/new_class";

test("the crew is what suits the lesson, unless the person has chosen one that can play it", () => {
  assert.deepEqual([crewFor(false), crewFor(true)], [1, 2]);
  assert.deepEqual([crewFor(false, 2), crewFor(true, 3)], [2, 3]);
  assert.equal(crewFor(true, 1), 2, "a judged bridge is none for one alone");
});

test("lessons are offered first, and an accident once, as its lesson", () => {
  const file = (name: string, lesson: string | null, taught_as: string | null = null): ExerciseFile => ({
    name,
    title: "",
    lesson,
    taught_as,
    bridge_judged: false,
  });
  const files = [file("L01", "L01"), file("accident", null, "A1"), file("let_go", null), file("A01", "A1")];
  assert.deepEqual(
    offered(files).map(({ name }) => name),
    ["L01", "A01", "let_go"],
  );
});
