// What the pad of figures has a key for, and what is typed into it.

import assert from "node:assert/strict";
import { test } from "node:test";

import { padFigures, typedOn } from "../../src/kit/pad";
import { inHalves } from "../../src/kit/units";

test("a whole and a half shackle have a key each, which says at one touch what stands on it", () => {
  assert.deepEqual([padFigures[0], padFigures.at(-1), padFigures.length], [0, 12, 25]);
  const keys = padFigures.map(inHalves);
  for (const key of ["1", "\u00bd", "1\u00bd", "2", "11\u00bd"]) assert.ok(keys.includes(key), key);
  assert.equal(new Set(keys).size, keys.length);
});

test("a figure is typed digit by digit, up to twelve and in halves; a digit that does not fit begins anew", () => {
  const typed = (...keys: string[]): string | undefined =>
    keys.reduce<string | undefined>((text, key) => typedOn(text ?? "", key), "");
  assert.equal(typed("1", "0"), "10");
  assert.equal(typed("1", "2"), "12");
  assert.equal(typed("1", "3"), "3");
  assert.equal(typed("0"), "0");
  assert.equal(typed("1", ",", "5"), "1.5");
  assert.equal(typed("1", ".", "4"), "4");
  assert.equal(typed("1", "2", "."), "12", "there is no twelve and a half");
  assert.equal(typed("1", "1", "Backspace"), "1");
  for (const key of ["b", "Enter", "ArrowUp", "Tab"]) assert.equal(typedOn("1", key), undefined, key);
});
