// Places in a lesson's JSON, and its text.

import assert from "node:assert/strict";
import { readFile, readdir } from "node:fs/promises";
import { join } from "node:path";
import { test } from "node:test";

import { type JsonObject, at, placeIn, placeWords, scalarText, textOf, wholeOf } from "../../src/lessons/json";
import { inTrade } from "../../src/lessons/trade";
import { root } from "../../tools/web.mjs";

const document = (): JsonObject => ({
  name: "x",
  lesson: { criteria: [{ id: "walk" }, { id: "pay-out", max: 3 }], "a/b": { "c~d": 1 } },
});

test("a pointer leads to what stands there, with / and ~ in names", () => {
  assert.equal(at(document(), "/lesson/criteria/1/max"), 3);
  assert.equal(at(document(), "/lesson/a~1b/c~0d"), 1);
  assert.deepEqual(at(document(), ""), document());
  assert.equal(at(document(), "/lesson/none/of/it"), undefined);
});

test("a place says its pointer, makes what holds it when it is set, and is taken away by undefined", () => {
  const all = document();
  const place = placeIn(placeIn(wholeOf(all), "weather"), "a/b~c");
  assert.equal(place.pointer, "/weather/a~1b~0c");
  assert.equal(place.get(), undefined);
  assert.equal("weather" in all, false);
  place.set(4);
  assert.deepEqual(all.weather, { "a/b~c": 4 });
  place.set(undefined);
  assert.deepEqual(all.weather, {});
});

test("a place in words counts entries from one and names them by their id", () => {
  assert.equal(placeWords(document(), "/lesson/criteria/1/max"), "lesson, criteria 2 (pay-out), max");
  assert.equal(placeWords(document(), ""), "all of it");
});

test("what is no scalar has no text", () => {
  assert.deepEqual([3, "x", null, [1], {}, undefined].map(scalarText), ["3", "x", "null", "", "", ""]);
});

test("every shipped exercise keeps its values, and their order, in the text that an editor writes", async () => {
  const folder = join(root, "config/exercises");
  const files = (await readdir(folder)).filter((file) => file.endsWith(".json"));
  assert.ok(files.length > 20);
  for (const file of files) {
    const exercise = JSON.parse(await readFile(join(folder, file), "utf8")) as JsonObject;
    assert.equal(JSON.stringify(JSON.parse(textOf(exercise))), JSON.stringify(exercise), file);
  }
});

test("an entry of a list stands on a line of its own", () => {
  const text = textOf({ name: "x", list: [{ a: 1 }, { a: [2, 3] }], empty: {}, none: [] });
  assert.deepEqual(text.split("\n"), [
    "{",
    '  "name": "x",',
    '  "list": [',
    '    { "a": 1 },',
    '    { "a": [2, 3] }',
    "  ],",
    '  "empty": {},',
    '  "none": []',
    "}",
  ]);
});

test("figures of a file are said as a seaman says them, by the unit that their description begins with", () => {
  assert.equal(inTrade("m/s, of the wind", 1852 / 360), "10.0 kn");
  assert.equal(inTrade("N, at the hawse", 98066.5), "10 t");
  assert.equal(inTrade("m/s, cable's speed, paying out positive", 3), "180 m/min");
  assert.equal(inTrade("K, of the lining", 373.15), "100 \u00b0C");
  assert.equal(inTrade("m, cable out", 55), "2.0 shackles");
  assert.equal(inTrade("s since the beginning", 75), "1:15");
  assert.equal(inTrade("s since the beginning", 5), "");
  assert.equal(inTrade("m, depth", 20), "");
});
