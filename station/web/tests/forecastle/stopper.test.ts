// What is said beside the stopper's button.

import assert from "node:assert/strict";
import { test } from "node:test";

import { stopperReason } from "../../src/forecastle/stopper";
import type { WindlassLevers } from "../../src/wire/connection";
import type { ForecastleView } from "../../src/wire/generated";

const reason = (wanted: boolean, closed: boolean, refused = false, sprung = false): string =>
  stopperReason(
    { stopper_closed: wanted } as WindlassLevers,
    { stopper_closed: closed, stopper_sprung: sprung } as ForecastleView,
    refused,
  );

test("why a bar has not moved is said while it is wanted elsewhere, and for a while after it was left", () => {
  assert.equal(reason(true, true), "");
  assert.equal(reason(false, true), "under load: does not lift");
  assert.equal(reason(true, true, true), "under load: does not lift");
  assert.equal(reason(false, false, true), "does not close on running chain");
});

test("a bar that has sprung open says so, whatever is wanted of it", () => {
  for (const wanted of [true, false]) assert.match(reason(wanted, false, false, true), /^the pin is out/);
});
