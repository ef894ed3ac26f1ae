// Names out of a file.

import assert from "node:assert/strict";
import { test } from "node:test";

import { namesOf } from "../../src/door/names";

test("the first column is the names, whatever separates it and however the lines end", () => {
  assert.deepEqual(namesOf("anna\nben\n\ncarla\n"), ["anna", "ben", "carla"]);
  assert.deepEqual(namesOf("\uFEFFanna;2nd mate\r\nben;3rd mate\r\n"), ["anna", "ben"]);
  assert.deepEqual(namesOf('"Berg, Anna",mate\n"Ben ""Boy"" Kay",mate'), ["Berg, Anna", 'Ben "Boy" Kay']);
});

test("a column that is headed as the names is taken, and its head is nobody", () => {
  assert.deepEqual(namesOf("id,name,rank\n7,anna,mate\n8, ben ,mate"), ["anna", "ben"]);
  assert.deepEqual(namesOf("Name\nanna"), ["anna"]);
  assert.deepEqual(namesOf(""), []);
});
