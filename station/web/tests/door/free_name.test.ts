// Names for classes of one day.

import assert from "node:assert/strict";
import { test } from "node:test";

import { freeName } from "../../src/door/free_name";

test("a name that is taken gets the first letter that is free", () => {
  assert.equal(freeName("sun", ["mon"]), "sun");
  assert.equal(freeName("sun", ["sun"]), "sun-b");
  assert.equal(freeName("sun", ["sun", "sun-b", "sun-c"]), "sun-d");
});

test("a long name stays within what the door takes", () => {
  const long = "a".repeat(24);
  assert.equal(freeName(long, [long]), `${"a".repeat(22)}-b`);
});
