// What a trainee is told to work on, in which order, and in which words.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { test } from "node:test";
import {
  delayWords,
  failsLesson,
  headline,
  judgedBy,
  objectivesRule,
  orderDone,
  rightWords,
  saidIn,
  toWorkOn,
  wentWell,
  whose,
  whyHalved,
  withoutCost,
} from "../../src/kit/own_marks";
import { root } from "../../tools/web.mjs";
import {
  BridgeOrderState,
  type Criterion,
  CriterionKind,
  CriterionState,
  LessonEnding,
} from "../../src/wire/generated";

const criterion = (code: string, more: Partial<Criterion>): Criterion => ({
  code,
  text: "",
  limit: 0,
  worst: 0,
  unit: "",
  time_outside: 0,
  kind: CriterionKind.CRITERION_REPORT,
  state: CriterionState.CRITERION_NOT_MET,
  weight: 10,
  milli: 0,
  counted: 0,
  counts: true,
  met: false,
  must: false,
  deed: false,
  objective: "",
  reason: "",
  tick: 0,
  lost_tick: 0,
  ...more,
});

test("what must be is worked on first, then what cost most; what is met or was not in play is not", () => {
  const order = toWorkOn([
    criterion("a word", { weight: 5 }),
    criterion("half of much", { weight: 30, counted: 400 }),
    criterion("met", { weight: 50, counted: 700, met: true }),
    criterion("not in play", { weight: 50, counts: false }),
    criterion("a must", { weight: 4, must: true }),
    criterion("a must that it never came to", {
      weight: 15,
      must: true,
      state: CriterionState.CRITERION_NOT_IN_PLAY,
    }),
  ]);
  assert.deepEqual(
    order.map(({ code }) => code),
    ["a must", "a must that it never came to", "half of much", "a word"],
  );
});

test("what only was not broken is not told as done", () => {
  const met = { met: true, counts: true, milli: 1000 };
  const { did, kept } = wentWell([
    criterion("reported", { ...met, deed: true }),
    criterion("brake on before the clutch", { ...met, kind: CriterionKind.CRITERION_STATE_AT, deed: true }),
    criterion("stopper closed from the beginning", { ...met, kind: CriterionKind.CRITERION_STATE_AT }),
    criterion("speed", { ...met, kind: CriterionKind.CRITERION_LIMIT }),
    criterion("missed", { counts: true }),
    criterion("not in play", { ...met, counts: false }),
  ]);
  const names = (list: Criterion[]) => list.map(({ code }) => code);
  assert.deepEqual(names(did), ["reported", "brake on before the clutch"]);
  assert.deepEqual(names(kept), ["stopper closed from the beginning", "speed"]);
});

test("the limit of a cable that never ran is not told as kept", () => {
  const limit = { met: true, counts: true, milli: 1000, kind: CriterionKind.CRITERION_LIMIT, unit: "m/s", limit: 3 };
  const { kept } = wentWell([
    criterion("pay out", { ...limit, worst: 0 }),
    criterion("fall", { ...limit, worst: 2.4 }),
    criterion("engine", { ...limit, unit: "", limit: 0.4, worst: 0 }),
  ]);
  assert.deepEqual(
    kept.map(({ code }) => code),
    ["fall", "engine"],
  );
});

test("a report is right to which nothing was wanting, and stands there as it was said", () => {
  assert.deepEqual([1000, 500, 0].map(rightWords), ["right", "nearly right: 50 % of its points", "not right"]);
  const line = { tick: 1530, time: 153, side: 0, text: "reported: 4 shackles in the pipe, to order 4", left: false };
  const log = [{ ...line, text: "reported: 3 shackles in the pipe", left: true }, line];
  assert.equal(saidIn(log, { tick: 1530, side: 0 }), "4 shackles in the pipe");
  assert.equal(saidIn(log, { tick: 1530, side: 1 }), undefined);
  assert.equal(saidIn(log, { tick: 1531, side: 0 }), undefined);
});

test("a reason does not say again what the points beside it say", () => {
  assert.equal(
    withoutCost("0:16 cable's speed 7 m/s, at most 3 m/s: 66.7 % of its points lost"),
    "0:16 cable's speed 7 m/s, at most 3 m/s",
  );
  assert.equal(withoutCost("0:42 stopper open: all of its points lost; a must"), "0:42 stopper open; a must");
  assert.equal(withoutCost("all of its points lost"), "");
});

test("the outcome is the server's, beside what is needed", () => {
  assert.equal(headline({ outcome: "not_yet", score: 69.6, pass: 70 }), "Not yet: 69.6 of 100 points, 70 are needed");
});

test("what halved the points is told, and a bridge that was lied to is not one without an answer", () => {
  const { LESSON_TIME_UP: ended } = LessonEnding;
  const halved = { criteria: [], objectives: [], ending: ended, abort: "time is up" };
  assert.deepEqual(whyHalved(halved), []);
  const lied = 'the bridge was told what is not so when it asked "how much port cable is out?"';
  assert.deepEqual(whyHalved({ ...halved, abort: lied }), [lied]);
  assert.deepEqual(whyHalved({ ...halved, ending: LessonEnding.LESSON_BROKEN_OFF, abort: "cable.lost" }), []);
  const objective = { id: "", text: "", stcw: "", score: 49.9, pass: 70, outcome: "not_yet" };
  const criteria = [
    criterion("missed", { must: true }),
    criterion("never came", { must: true, counts: false, state: CriterionState.CRITERION_NOT_IN_PLAY }),
    criterion("excused", { must: true, counts: false, state: CriterionState.CRITERION_OVERRIDDEN }),
  ];
  assert.deepEqual(whyHalved({ ...halved, criteria, objectives: [objective] }), [
    "a criterion marked (must) was missed",
    "a criterion marked (must) was not come to",
    "an objective has less than half of its points",
  ]);
});

test("an objective that falls short of what it needs fails the lesson below half of its points", () => {
  const fails = (outcome: string, score: number, pass = 70) => failsLesson({ outcome, score, pass });
  assert.deepEqual([fails("not_yet", 49.9), fails("not_shown", 0), fails("not_yet", 20, 30)], [true, true, true]);
  assert.deepEqual([fails("not_yet", 61), fails("achieved", 40, 30)], [false, false]);
});

test("by what rule an objective is achieved stands under those of a lesson", () => {
  assert.match(objectivesRule([{}]), /\(must\) are met.*half of its points.*points that are needed.*less than half/);
  assert.equal(objectivesRule([]), "");
});

test("a report is early, late or at once by the second", () => {
  assert.deepEqual([-2.2, 0.4, 8].map(delayWords), ["2 s early", "at once", "8 s after it"]);
});

test("an order that was taken back was not left undone, and what was so before it is no deed", () => {
  const came = (state: keyof typeof BridgeOrderState, done?: number): string =>
    orderDone({ state: BridgeOrderState[state], time: 60 }, done);
  assert.equal(came("ORDER_CANCELLED"), "cancelled");
  assert.equal(came("ORDER_REPEATED", 90), "carried out 1:30");
  assert.equal(came("ORDER_REPEATED", 30), "so already at 0:30");
  assert.equal(came("ORDER_REPEATED"), "not carried out");
});

test("which seat a lesson judges is known by the sentence that the server puts behind each briefing", async () => {
  const server = await readFile(join(root, "server/run/briefing.cpp"), "utf8");
  const said = [...server.matchAll(/"(The bridge's orders come [^"]*)"/g)].map(([, sentence]) => sentence);
  assert.deepEqual(
    said.map((sentence) => judgedBy(`Bring her to anchor. ${sentence} Where no other place is said, she lies there.`)),
    ["bridge", "forecastle"],
  );
  assert.equal(judgedBy(""), undefined);
});

test("a seat that is not the judged one reads whose the marks are", () => {
  for (const [judged, seat] of [
    ["bridge", "conning"],
    ["bridge", "trainee"],
    ["forecastle", "forecastle"],
    ["forecastle", "trainee"],
    [undefined, "forecastle"],
  ] as const)
    assert.equal(whose(judged, seat), undefined, `${judged}, ${seat}`);
  assert.equal(whose("bridge", "forecastle")?.marks, "The bridge's marks");
  assert.match(whose("bridge", "forecastle")!.why, /the forecastle has no marks of it/);
  assert.equal(whose("forecastle", "conning")?.marks, "The forecastle's marks");
  assert.match(whose("forecastle", "conning")!.why, /the bridge shares its marks/);
  assert.deepEqual(whose("bridge", "watcher"), { marks: "The bridge's marks", why: "" });
});
