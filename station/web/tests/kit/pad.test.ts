// What the pad of figures has a key for.

import assert from "node:assert/strict";
import { test } from "node:test";

import { padFigures } from "../../src/kit/pad";
import { inHalves } from "../../src/kit/units";

test("a whole and a half shackle have a key each, which says at one touch what stands on it", () => {
  assert.deepEqual([padFigures[0], padFigures.at(-1), padFigures.length], [0, 12, 25]);
  const keys = padFigures.map(inHalves);
  for (const key of ["1", "\u00bd", "1\u00bd", "2", "11\u00bd"]) assert.ok(keys.includes(key), key);
  assert.equal(new Set(keys).size, keys.length);
});
