// The bridge's keys that push while they are held.

import assert from "node:assert/strict";
import { beforeEach, test } from "node:test";

import type { HelmHand } from "../../src/bridge/helm_hand";
import { listenToKeys } from "../../src/bridge/keys";

class Field extends EventTarget {
  readonly value = "";
}
const windowEvents = new EventTarget();
const page = Object.assign(new EventTarget(), { hidden: false, querySelector: () => null });
Object.assign(globalThis, {
  addEventListener: windowEvents.addEventListener.bind(windowEvents),
  document: page,
  HTMLInputElement: Field,
  HTMLSelectElement: Field,
});

const helm = { thrustersSpring: true, put: (levers: { bow_thruster: number }) => put.push(levers.bow_thruster) };
let put: number[] = [];
listenToKeys(helm as unknown as HelmHand, {});

beforeEach(() => {
  put = [];
  helm.thrustersSpring = true;
  page.hidden = false;
});

const key = (type: "keydown" | "keyup", name: string): boolean =>
  windowEvents.dispatchEvent(
    Object.assign(new Event(type, { cancelable: true }), { key: name, shiftKey: name === ">" }),
  );

test("a thruster's key pushes while it is held", () => {
  for (const name of [",", ".", ">"]) {
    key("keydown", name);
    key("keyup", name);
  }
  assert.deepEqual(put, [-0.5, 0, 0.5, 0, 1, 0]);
});

test("the hand leaves it when the window loses the focus or is hidden: no keyup is heard then", () => {
  key("keydown", ",");
  windowEvents.dispatchEvent(new Event("blur"));
  assert.deepEqual(put, [-0.5, 0]);
  key("keydown", ".");
  page.hidden = true;
  page.dispatchEvent(new Event("visibilitychange"));
  assert.deepEqual(put, [-0.5, 0, 0.5, 0]);
});

test("a lever that stays is left where it is, and one that no key pushed is not touched", () => {
  windowEvents.dispatchEvent(new Event("blur"));
  key("keyup", ","); // was typed into a field
  assert.deepEqual(put, []);
  helm.thrustersSpring = false;
  key("keydown", ",");
  windowEvents.dispatchEvent(new Event("blur"));
  assert.deepEqual(put, [-0.5]);
});
