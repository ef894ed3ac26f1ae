// Names for classes of one day.

import assert from "node:assert/strict";
import { test } from "node:test";

import { freeName, nameAfter } from "../../src/door/free_name";

test("a name that is taken gets the first letter that is free", () => {
  assert.equal(freeName("sun", ["mon"]), "sun");
  assert.equal(freeName("sun", ["sun"]), "sun-b");
  assert.equal(freeName("sun", ["sun", "sun-b", "sun-c"]), "sun-d");
});

test("a class that goes on from another has its name", () => {
  assert.equal(nameAfter("gale", "again"), "gale-again");
  assert.equal(nameAfter("gale-again", "again"), "gale-again", "and a letter, as long as the first is kept");
  assert.equal(nameAfter("gale-next-b", "again"), "gale-again");
  assert.equal(nameAfter("a".repeat(24), "again"), `${"a".repeat(18)}-again`);
});

test("a long name stays within what the door takes", () => {
  const long = "a".repeat(24);
  assert.equal(freeName(long, [long]), `${"a".repeat(22)}-b`);
});
