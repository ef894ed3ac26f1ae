// What a controller's axes and buttons do, as taught and as learned from a hand that moves them.

import assert from "node:assert/strict";
import { test } from "node:test";

import {
  type Assignment,
  type Control,
  ControllerMemory,
  Learner,
  type Pad,
  inverted,
  rumble,
  settingsFrom,
  standardMapping,
  turned,
  valueOf,
  withLearned,
} from "../../src/forecastle/controller";

const pad = (axes: number[], buttons: number[] = []): Pad => ({
  axes,
  buttons: buttons.map((value) => ({ value, pressed: value > 0.5 })),
});
const near = (value: number, wanted: number): void =>
  assert.ok(Math.abs(value - wanted) < 1e-9, `${value} is not ${wanted}`);

/** The device's readings while a hand moves it, the first while none does. */
function learn(control: Control, ...readings: Pad[]): Assignment | undefined {
  const [rest, ...moves] = readings;
  const learner = new Learner(control, rest!);
  for (const reading of moves) learner.see(reading);
  return learner.found();
}

test("the standard gamepad: triggers brake, the left stick heaves away from one, the right one is fine", () => {
  const of = (control: Control, at: Pad): number =>
    Math.max(...standardMapping.filter((one) => one.control === control).map((one) => valueOf(one, at)));
  const buttons = Array.from({ length: 17 }, () => 0);
  const at = pad([0, -1, 1, 0], buttons.with(7, 0.525).with(15, 1));
  near(of("on", at), 0.5); // of the way beyond its dead twentieth
  assert.equal(of("off", at), 0);
  assert.equal(of("speed", at), 1);
  assert.equal(of("fine", at), 1);
  assert.equal(of("next", at), 1);
  assert.equal(of("back", at), 0);
  const still = pad([0.05, 0.1, -0.1, 0], buttons);
  for (const control of ["on", "off", "fine", "speed", "choose"] as const) assert.equal(of(control, still), 0);
});

test("a device that lacks an axis or a button leaves that control alone", () => {
  for (const one of standardMapping) assert.equal(valueOf(one, pad([])), 0);
});

test("a stick is learned by moving it on first; the other way is as long where it was not moved", () => {
  const found = learn("speed", pad([0, 0.02]), pad([0, -0.9]), pad([0.2, -0.3]))!;
  assert.equal(found.index, 1);
  near(valueOf(found, pad([0, -0.9])), 1);
  near(valueOf(found, pad([0, 0.94])), -1);
  assert.equal(valueOf(found, pad([0, 0.1])), 0, "its dead zone");
});

test("a trigger that is an axis and rests at its end is a way from there", () => {
  const found = learn("on", pad([-1, -1]), pad([-1, 0]), pad([-1, 1]))!;
  assert.deepEqual([found.source, found.index, found.rest, found.to], ["axis", 1, -1, 1]);
  assert.equal(valueOf(found, pad([0, -1])), 0);
  assert.equal(valueOf(found, pad([0, 1])), 1);
});

test("a button is learned, and a hand that only trembles teaches nothing", () => {
  assert.equal(learn("clutch", pad([0], [0, 0, 0]), pad([0.1], [0, 0, 1]))?.index, 2);
  assert.equal(learn("clutch", pad([0], [0, 0]), pad([0.3], [0, 0.2])), undefined);
  assert.equal(learn("speed", pad([0], [0]), pad([0], [1])), undefined, "a button has no two ways");
});

test("a hand-wheel gives turns between the ends that it was turned to, clockwise first", () => {
  const found = { ...learn("wheel", pad([-0.8]), pad([0]), pad([0.8]), pad([0]))!, turns: 5 };
  near(valueOf(found, pad([-0.8])), 0);
  near(valueOf(found, pad([0])), 2.5);
  near(valueOf(found, pad([0.8])), 5);
  const other = learn("wheel", pad([0.8]), pad([0]), pad([-0.8]))!;
  near(valueOf(other, pad([-0.8])), other.turns);
});

test("a hand-wheel that has gone round while it was learned is endless, and one turn is its axis", () => {
  const found = learn("wheel", pad([0.8]), pad([1]), pad([-0.9]), pad([-0.5]), pad([0]), pad([0.6]), pad([0.9]))!;
  assert.deepEqual([found.endless, found.turns, found.from, found.to], [true, 1, -1, 1]);
});

test("an endless hand-wheel goes on beyond its axis's end; one with ends does not", () => {
  near(turned({ endless: true, turns: 1 }, 0.95, 0.05), 0.1);
  near(turned({ endless: true, turns: 1 }, 0.05, 0.95), -0.1);
  near(turned({ endless: false, turns: 5 }, 4.9, 0.1), -4.8);
});

test("inverted, a control goes the other way, twice inverted as before", () => {
  const stick = learn("speed", pad([0]), pad([1]), pad([-1]))!;
  near(valueOf(inverted(stick), pad([1])), -1);
  assert.deepEqual(inverted(inverted(stick)), stick);
  const trigger = learn("on", pad([-1]), pad([1]))!;
  assert.equal(valueOf(inverted(trigger), pad([1])), 0);
  assert.equal(valueOf(inverted(trigger), pad([-1])), 1);
});

test("what is learned takes the place of what the control had", () => {
  const learned = learn("side", pad([], [0, 0]), pad([], [0, 1]))!;
  const mapping = withLearned(standardMapping, learned);
  assert.deepEqual(
    mapping.filter(({ control }) => control === "side"),
    [learned],
  );
  assert.equal(mapping.length, standardMapping.length - 1);
});

test("settings are kept by device; what is none of ours is not read", () => {
  const settings = { mapping: standardMapping, vibrates: false };
  assert.deepEqual(settingsFrom(JSON.parse(JSON.stringify(settings))), settings);
  for (const bad of [
    null,
    7,
    { mapping: "x", vibrates: true },
    { mapping: [null], vibrates: true },
    { mapping: [{ ...standardMapping[0], control: "toString" }], vibrates: true },
    { mapping: [{ ...standardMapping[0], rest: null }], vibrates: true },
    { mapping: [] },
  ])
    assert.equal(settingsFrom(bad), undefined, JSON.stringify(bad));
  const memory = new ControllerMemory();
  assert.equal(memory.of({ id: "wheel", mapping: "" }), undefined);
  assert.equal(memory.of({ id: "pad", mapping: "standard" })?.mapping, standardMapping);
  memory.keep("wheel", settings);
  assert.equal(memory.of({ id: "wheel", mapping: "" })?.vibrates, false);
  memory.keep("wheel", undefined);
  assert.equal(memory.of({ id: "wheel", mapping: "" }), undefined);
});

test("a controller shakes with the deck and the band, and not at rest", () => {
  assert.deepEqual(rumble(undefined), { deck: 0, band: 0 });
  assert.deepEqual(rumble({ vibration: 0, brake_noise: 0 }), { deck: 0, band: 0 });
  assert.deepEqual(rumble({ vibration: 3, brake_noise: 1 }), { deck: 1, band: 0.15 });
});
