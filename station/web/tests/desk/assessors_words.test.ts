// The assessor's words beside the marks: who, why, and when, as far as the page was there.

import assert from "node:assert/strict";
import { test } from "node:test";

import { AssessorsWords, parted } from "../../src/desk/assessors_words";
import { type Criterion, CriterionKind, CriterionState } from "../../src/wire/generated";

const { CRITERION_LIMIT: limit, CRITERION_RUBRIC: rubric } = CriterionKind;

const judged = (code: string, kind: CriterionKind, reason: string, set = true): Criterion =>
  ({
    code,
    kind,
    reason,
    state: set ? CriterionState.CRITERION_OVERRIDDEN : CriterionState.CRITERION_OPEN,
    counts: true,
    counted: set ? 1000 : 0,
  }) as Criterion;

const stance = judged("stance", rubric, "jonas: stood well clear of the cable");
const open = judged("stance", rubric, "", false);

/** The marks at that time, s. */
const marks = (time: number, ...criteria: Criterion[]) => ({ time, criteria });

test("a word is parted from what was computed", () => {
  assert.deepEqual(parted(stance), { computed: "", by: "jonas", note: "stood well clear of the cable" });
  assert.equal(parted(open), undefined);
  const computed = "0:45 cable speed 6 m/s, at most 5 m/s; beyond it for 3 s in all: 2.0 of 5 points lost; a must";
  assert.deepEqual(parted(judged("speed", limit, `${computed}; jonas: the gauge was wrong`)), {
    computed,
    by: "jonas",
    note: "the gauge was wrong",
  });
  assert.deepEqual(parted(judged("aside", rubric, "jonas: he said; aloud: stand clear")), {
    computed: "",
    by: "jonas",
    note: "he said; aloud: stand clear",
  });
});

test("a word that was given here is told whole, where the marks have no room for it", () => {
  const said = { criterion: "speed", by: "jonas", note: "the gauge; mine: was wrong from the beginning" };
  const cut = judged("speed", limit, "0:45 too fast: 2.0 of 5 points lost; jonas: the gauge; mine: was ...");
  assert.deepEqual(parted(cut, [said]), {
    computed: "0:45 too fast: 2.0 of 5 points lost",
    by: "jonas",
    note: said.note,
  });
});

test("a word that comes has its time, the exercise's where the lesson is over, and keeps it", () => {
  const words = new AssessorsWords();
  words.take(marks(100, open), 100.2, false);
  words.take(marks(101, stance), 130, false);
  words.take(marks(101, stance), 140, false);
  const { time, earlier, by } = words.of(stance)!;
  assert.deepEqual([time, earlier, by], [130, false, "jonas"]);
  const other = judged("stance", rubric, "jonas: not so well later on");
  words.take(marks(101, other), 150, false);
  assert.equal(words.of(other)?.time, 150);
});

test("of a word that stood before the page was there, or came while it was not, no time is made up", () => {
  const late = new AssessorsWords();
  late.take(marks(310, stance), 310, false);
  assert.deepEqual([late.of(stance)?.time, late.of(stance)?.earlier], [310, true]);
  const lost = new AssessorsWords();
  lost.take(marks(100, open), 100, false);
  lost.miss();
  lost.take(marks(160, stance), 160, false);
  assert.ok(lost.of(stance)?.earlier);
  const jumped = new AssessorsWords();
  jumped.take(marks(10, open), 10, true);
  jumped.take(marks(200, stance), 200, true);
  assert.ok(jumped.of(stance)?.earlier);
});

test("after a restore a word that still stands has the time at which it was set", () => {
  const words = new AssessorsWords();
  words.take(marks(100, open), 100, false);
  words.take(marks(101, stance), 101, false);
  words.take(marks(180, stance), 180, false);
  words.take(marks(120, stance), 120, false);
  assert.deepEqual([words.of(stance)?.time, words.of(stance)?.earlier], [101, false]);
  words.take(marks(90, open), 90, false);
  words.take(marks(95, stance), 95, false);
  assert.deepEqual([words.of(stance)?.time, words.of(stance)?.earlier], [95, false], "said again, in another branch");
});
