// What class page and desk say of a bridge that has no answer.

import assert from "node:assert/strict";
import { test } from "node:test";

import { askingOf, asksInVain } from "../../src/kit/asks_in_vain";

const asks = (time: number, gives_up: number, code = "assessment.unanswered") => ({ code, time, value: gives_up });
const lied = "assessment.misled";
const answered = { code: "assessment.answered", time: 50, value: 0 };
const report = { code: "report.made", time: 40, value: 0 };

test("a bridge asks in vain from the first time on, and gives up as it said last", () => {
  assert.equal(askingOf([]), undefined);
  assert.deepEqual(askingOf([asks(18, 63)]), { since: 18, gives_up: 63, misled: false });
  assert.deepEqual(askingOf([asks(18, 63), report, asks(33, 78)]), { since: 18, gives_up: 78, misled: false });
});

test("it does so no more once it has its answer, or the lesson is over; and anew when it asks again", () => {
  assert.equal(askingOf([asks(18, 63), answered]), undefined);
  assert.equal(askingOf([asks(18, 63), { code: "lesson.over", time: 63, value: 0 }]), undefined);
  assert.deepEqual(askingOf([asks(18, 63), answered, asks(90, 140)]), { since: 90, gives_up: 140, misled: false });
});

test("it is told for how long, in fives of seconds, and when the lesson ends by it", () => {
  const asking = { since: 18, gives_up: 63, misled: false };
  const said = (time: number): string => asksInVain(asking, time);
  assert.match(said(18.2), /has been asking for 0:00, and has no answer: at 1:03 it gives up, and the lesson ends$/);
  assert.match(said(41), /asking for 0:20, and has no answer: at 1:03/);
  assert.match(said(63.2), /asking for 0:45, and has no answer: it gives up, and the lesson ends$/);
});

test("a bridge that was told what is not so has no true answer, also when it asks again", () => {
  const asking = askingOf([asks(18, 63), asks(25, 55, lied), asks(55, 85)])!;
  assert.deepEqual(asking, { since: 18, gives_up: 85, misled: true });
  assert.match(asksInVain(asking, 41), /asking for 0:20, and has no true answer: at 1:25 it gives up/);
  assert.match(asksInVain(asking, 86), /and has no true answer: it gives up, and the lesson ends$/);
  assert.equal(askingOf([asks(18, 63, lied), answered, asks(90, 140)])!.misled, false, "it is asked something else");
});
