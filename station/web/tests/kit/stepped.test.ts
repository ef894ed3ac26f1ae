// The stepper of a question's number.

import assert from "node:assert/strict";
import { test } from "node:test";

import { stepped } from "../../src/kit/stepped";

test("a step goes from what was typed, in no more decimals than both have", () => {
  assert.equal(stepped("", 0.5), "0.5");
  assert.equal(stepped("5.5", 0.5), "6");
  assert.equal(stepped("0.3", -0.1), "0.2");
  assert.equal(stepped("0.1", -0.3), "-0.2");
  assert.equal(stepped("12", 1), "13");
  assert.equal(stepped("-", -1), "-1");
});
