// What is said of the brake's hand-wheel.

import assert from "node:assert/strict";
import { test } from "node:test";

import { brakeWords } from "../../src/forecastle/wheel";

const said = (set: number, real = set): string => brakeWords(set, real).said;

test("how far the brake is on is a phrase, and what it is or was set to stands behind a comma", () => {
  assert.equal(said(0.8433), "4 turns 78\u00b0 of 5 turns");
  assert.equal(said(1), "5 turns 0\u00b0, hard on");
  assert.equal(said(0), "0 turns 0\u00b0, open");
  assert.equal(said(0.2, 0.6), "3 turns 0\u00b0, set 1 turn 0\u00b0");
});
