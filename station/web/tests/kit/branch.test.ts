// What is known here of an order that was given before an exercise was gone on with: in a class that begins again from
// a moment of a recording, say.

import assert from "node:assert/strict";
import { test } from "node:test";

import { Before } from "../../src/kit/branch";

const given = (number: number, time: number) => ({ code: "order.given", value: number, time });
const restored = (time: number) => ({ code: "exercise.restored", value: 0, time });

test("what was given before the moment from which it goes on, and was not heard here, is of before", () => {
  const before = new Before();
  before.hear({ code: "exercise.ready", value: 0, time: 0 });
  assert.ok(!before.has({ number: 1, time: 43 }), "its event is yet to come");
  before.hear(restored(190));
  before.hear(given(3, 200));
  assert.ok(before.has({ number: 2, time: 150 }));
  assert.ok(!before.has({ number: 3, time: 200 }));
  assert.ok(!before.has({ number: 4, time: 210 }), "its event is yet to come");
  const said = "asked before 3:10, from where this goes on; whether it was answered is not told here";
  assert.equal(before.said({ number: 2, time: 150 }), said);
  assert.equal(before.said({ number: 3, time: 200 }), "");
});

test("an exercise that goes back within itself has heard its orders", () => {
  const before = new Before();
  before.hear(given(1, 20));
  before.hear(given(2, 80));
  before.hear(restored(60));
  assert.ok(!before.has({ number: 1, time: 20 }));
  before.hear(restored(300)); // of a recording, with a second order of its own
  assert.ok(before.has({ number: 2, time: 150 }));
  before.hear({ code: "exercise.reset", value: 0, time: 0 });
  assert.ok(!before.has({ number: 2, time: 150 }), "it begins anew");
});
