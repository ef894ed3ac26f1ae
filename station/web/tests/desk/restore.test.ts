// Where a restore goes, said before what came after is dropped.

import assert from "node:assert/strict";
import { test } from "node:test";

import { checkpointUpTo } from "../../src/desk/restore";

test("a restore goes to the checkpoint of the ten seconds before, or to a snapshot or restored state after it", () => {
  const events = [
    { code: "exercise.checkpoint", time: 63.2 },
    { code: "exercise.restored", time: 40 },
    { code: "exercise.bookmark", time: 66 },
    { code: "exercise.checkpoint", time: 78 },
  ];
  assert.equal(checkpointUpTo(67, []), 60);
  assert.equal(checkpointUpTo(67, events), 63.2);
  assert.equal(checkpointUpTo(60, events), 60);
  assert.equal(checkpointUpTo(9.9, []), 0);
});
