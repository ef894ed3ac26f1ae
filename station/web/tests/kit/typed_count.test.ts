// How much is typed of what a field takes.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { test } from "node:test";

import { kMostWords, wireLength } from "../../src/kit/typed_count";
import { root } from "../../tools/web.mjs";

void test("what is typed is counted as the wire counts it", () => {
  assert.equal(wireLength(" stand clear "), 11);
  assert.equal(wireLength("Müßig"), 7);
});

void test("a note may be as long as the IDL has it", async () => {
  const idl = await readFile(join(root, "idl/windlass.idl"), "utf8");
  const [, most] = /struct AssessmentCommand [^}]*string<(\d+)> note;/.exec(idl) ?? [];
  assert.equal(Number(most), kMostWords.note);
});
