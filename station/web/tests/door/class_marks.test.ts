// Who goes on from a moment of a class that is over, and where each sits then.

import assert from "node:assert/strict";
import { test } from "node:test";

import type { ClassExercise, From, Next, Part, PlaceName, TrainingClass } from "../../src/door/ask";
import {
  afterSaid,
  allAgain,
  doubtOf,
  marksOf,
  momentOf,
  placesBeside,
  whyFrom,
  whyNext,
  whyNotAgain,
  wordSaid,
} from "../../src/door/class_marks";

const part = (name: string, place: PlaceName, since: number | null = null, until: number | null = null): Part => ({
  name,
  place,
  since,
  until,
  judged: true,
});
const classOf = (...exercises: Part[][]): TrainingClass =>
  ({ exercises: exercises.map((parts) => ({ parts })) }) as unknown as TrainingClass;

test("a class that goes on has its two with it, each where they sat at the end", () => {
  const it = classOf(
    [part("eve", "forecastle"), part("fay", "bridge")],
    [part("cid", "forecastle", null, 240), part("ann", "forecastle", 240), part("ben", "bridge")],
  );
  assert.deepEqual(placesBeside("ben", it), { ann: "forecastle", ben: "bridge" });
  assert.deepEqual(placesBeside("fay", it), { eve: "forecastle", fay: "bridge" });
});

test("who was relieved goes on alone, where he was", () => {
  const it = classOf([part("cid", "forecastle", null, 240), part("ann", "forecastle", 240), part("ben", "bridge")]);
  assert.deepEqual(placesBeside("cid", it), { cid: "forecastle" });
});

test("a class that goes on says before what it begins, and what was lost by that", () => {
  const from = { recording: "mon-1-17", position: 14, time: 10, seconds: 10, lost: "fall", lost_at: 33.4 };
  const why = (before: From["before"], standing: string[] = []): string => whyFrom({ ...from, before, standing });
  assert.equal(why("levers"), '10 s before the levers were moved and "fall" went wrong, at 0:33');
  assert.equal(why("order"), '10 s before the order after which "fall" went wrong, at 0:33');
  assert.equal(why("due"), '10 s before it was time for "fall", which went wrong at 0:33');
  assert.equal(why("loss"), '10 s before "fall" went wrong, at 0:33');
  assert.equal(
    why("loss", ["repeat", "pay out"]),
    '10 s before "fall" went wrong, at 0:33; already lost by then: repeat, pay out',
  );
  assert.equal(
    whyFrom({ ...from, time: 0, seconds: 4.9, before: "order", standing: [] }),
    '5 s before the order after which "fall" went wrong, at 0:33',
    "the attempt began no sooner",
  );
});

test("what somebody missed is done again from a moment, or the class says why not", () => {
  const it = { exercises: [{ recording: "mon-1-17" } as ClassExercise] };
  const next = (more: Partial<Next>): Next => ({ practice: true, from: null, no_from: "", ...more }) as Next;
  const from = (recording: string): From => ({ recording }) as From;
  assert.equal(whyNotAgain(next({ from: from("mon-1-17") }), it), "", "there is a button");
  assert.match(whyNotAgain(next({ from: from("tue-1-17") }), it), /under the class of that attempt$/);
  assert.equal(
    whyNotAgain(next({ no_from: "its recording is here no more" }), it),
    "Again from no moment: its recording is here no more",
  );
  assert.equal(whyNotAgain(next({ practice: false }), it), "", "nothing was missed");
});

test("a class that goes on is told of which exercise, not by the name of its recording", () => {
  const it = classOf([part("ben", "ship")]);
  Object.assign(it, {
    crew: 1,
    exercises: [{ ...it.exercises[0], exercise: "gale-2", recording: "gale-2-1796071114" }],
  });
  const from = { recording: "gale-2-1796071114", position: 4 } as From;
  const { exercise, recording, crew, places } = momentOf("ben", from, it);
  assert.deepEqual([exercise, recording, crew, places], ["gale-2", "gale-2-1796071114", 1, { ben: "ship" }]);
});

test("the same class again is for all who had a seat at its end", () => {
  const it = classOf(
    [part("cid", "forecastle", null, 240), part("ann", "forecastle", 240), part("ben", "bridge")],
    [part("eve", "forecastle")],
  );
  const lesson = { lesson: "L01_let_go_25m", practice: false };
  assert.deepEqual(
    allAgain({ ...it, ...lesson }),
    ["ann", "ben", "eve"].map((name) => ({ name, file: "L01_let_go_25m", practice: false })),
  );
});

test("marks say why a lesson was over before it was done", () => {
  const it = { points: 0.7, lost: null, outcome: "not_yet", abort: "cable.lost" } as ClassExercise;
  assert.match(marksOf(it), /^0\.7 of 100 points, not yet, ended: .*anchor and cable/);
  assert.equal(marksOf({ ...it, abort: "" }), "0.7 of 100 points, not yet");
});

test("what is to be done after an attempt of another class is told with whose lesson and day it was", () => {
  const after = { lesson: "L02", recording: "tue-1-17", began_at: "2026-11-30T12:00:00Z" };
  const of = (recording: string) => ({ exercises: [{ recording } as ClassExercise] });
  assert.match(afterSaid({ after }, of("mon-1-17")), /^after L02 on 30 November: $/);
  assert.equal(afterSaid({ after }, of("tue-1-17")), "");
  assert.equal(afterSaid({ after: null }, of("mon-1-17")), "");
});

test("an assessor's word stands with who gave it, and without points where nothing was assessed", () => {
  const word = { recording: "mon-1-17", points: 80, outcome: "not_yet", by: "bo", note: "" };
  assert.equal(wordSaid(word), "bo: 80.0 points, not yet");
  assert.equal(wordSaid({ ...word, points: null, outcome: "achieved" }), "bo: achieved");
  assert.equal(
    wordSaid({ ...word, note: "the load cell had failed" }),
    "bo: 80.0 points, not yet. The load cell had failed",
  );
});

test("whoever calls an attempt achieved with fewer points than its lesson needs is asked", () => {
  assert.match(doubtOf("achieved", 40, 70), /^40\.0 points are below the 70 that the lesson needs\./);
  assert.match(doubtOf("achieved", 69.96, 70), /^69\.9 points/);
  assert.equal(doubtOf("achieved", 70, 70), "");
  assert.equal(doubtOf("not_yet", 40, 70), "");
  assert.equal(doubtOf("achieved", null, 70), "", "nothing was assessed");
  assert.equal(doubtOf("achieved", 40, null), "", "of a class before the door knew");
});

test("why something is to be practised is parted into our words and the lesson's objectives", () => {
  assert.deepEqual(whyNext("not done yet"), [{ said: "not done yet", objective: "" }]);
  assert.deepEqual(whyNext("not yet: lets go; on order; not shown: reports what is so"), [
    { said: "not yet: ", objective: "lets go; on order" },
    { said: "not shown: ", objective: "reports what is so" },
  ]);
});
