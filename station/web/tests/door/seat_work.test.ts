// What the page of a class says of who sits where.

import assert from "node:assert/strict";
import { test } from "node:test";

import type { ClassExercise, Seat, TrainingClass } from "../../src/door/ask";
import { doing, standing } from "../../src/door/seat_work";
import { RunState } from "../../src/wire/generated";

const running = {
  exercise: "mon-1",
  state: RunState.RUN_RUNNING,
  time: 100,
  heard: true,
  outcome: "",
} as ClassExercise;
const idle: Seat = { place: "forecastle", name: "ann", here: true, silent: 5, acted: false };

test("whose page is merely open is at the page, and nobody is at work before a first deed", () => {
  assert.equal(doing(running, idle), "at the page");
  assert.equal(doing(running, { ...idle, acted: true }), "at work");
  assert.equal(doing({ ...running, state: RunState.RUN_READY }, { ...idle, silent: 0 }), "at the page");
});

test("from a minute of silence on it is told, in tens of seconds, whoever has done something before or not", () => {
  for (const acted of [false, true]) {
    assert.notEqual(doing(running, { ...idle, acted, silent: 59 }), "silent 0:50");
    assert.equal(doing(running, { ...idle, acted, silent: 60 }), "silent 1:00");
    assert.equal(doing(running, { ...idle, acted, silent: 139 }), "silent 2:10");
  }
});

test("what stands, is not heard, or only watches is silent for no time", () => {
  const long = { ...idle, silent: 600 };
  assert.equal(doing({ ...running, state: RunState.RUN_PAUSED }, long), "at the page");
  assert.equal(doing({ ...running, heard: false }, long), "at the page");
  assert.equal(doing(running, { ...long, place: "watch" }), "at the page");
});

test("who is away, and whose lesson is over, is neither", () => {
  assert.equal(doing(running, { ...idle, here: false }), "away");
  assert.equal(doing({ ...running, outcome: "achieved" }, { ...idle, acted: true }), "here");
});

test("the count is of the seats that are taken and of the pages that are open", () => {
  const away = { ...idle, place: "bridge" as const, here: false };
  const free = { ...away, place: "watch" as const, name: null };
  const its = { exercises: [{ ...running, seats: [idle, away, free] }] } as TrainingClass;
  assert.equal(standing(its), "2 of 3 seats taken, 1 at the page");
});
