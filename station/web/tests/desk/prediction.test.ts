// What the desk says of a prediction, and which it draws, without a browser.

import assert from "node:assert/strict";
import { test } from "node:test";

import { aheadOf, aheadWords } from "../../src/desk/prediction";
import { EventSeverity, PredictionState } from "../../src/wire/generated";

type Link = Parameters<typeof aheadOf>[0];

/** A link that has heard of an exercise at that time (s) and of a prediction from 100 s on, so many seconds long. */
function heard(time: number, state: PredictionState, seconds = 60, more: object = {}): Link {
  const moments = Array.from({ length: seconds + 1 }, (_, i) => ({ time: 100 + i, cables: [] }));
  const samples = {
    ExerciseStatus: { run: 7, time },
    Prediction: { run: 7, time: 100, state, moments: seconds < 0 ? [] : moments, events: [], ...more },
  };
  return { latest: (topic: keyof typeof samples) => samples[topic] } as unknown as Link;
}

test("what is drawn is of this run and of now", () => {
  const whole = PredictionState.PREDICTION_WHOLE;
  assert.ok(aheadOf(heard(100, whole)));
  assert.ok(aheadOf(heard(160, whole)));
  assert.equal(aheadOf(heard(99, whole)), undefined, "a replay has gone back to before it");
  assert.equal(aheadOf(heard(161, whole)), undefined, "all of it has come");
  assert.equal(aheadOf(heard(110, whole, 60, { run: 6 })), undefined, "of a past that was left");
  assert.equal(aheadOf(heard(110, PredictionState.PREDICTION_AWAITED, -1)), undefined);
});

test("how old it is, how far it goes and what comes is said", () => {
  const link = heard(103, PredictionState.PREDICTION_DEAR, 12, {
    events: [
      { time: 101, severity: EventSeverity.EVENT_ALARM, code: "cable.parted", side: 0, text: "over" },
      { time: 104, severity: EventSeverity.EVENT_INFO, code: "x", side: 0, text: "of no weight" },
      { time: 105, severity: EventSeverity.EVENT_ALARM, code: "x", side: -1, text: "it parts" },
    ],
  });
  assert.equal(aheadWords(link), "made 3 s ago; 12 s: more costs too much; 1:45 it parts");
});

test("where there is none it is said why", () => {
  assert.equal(aheadWords(heard(110, PredictionState.PREDICTION_OFF, -1)), "");
  assert.equal(aheadWords(heard(110, PredictionState.PREDICTION_WHOLE, 60, { run: 6 })), "");
  assert.equal(aheadWords(heard(110, PredictionState.PREDICTION_AWAITED, -1)), "being made");
  assert.equal(aheadWords(heard(110, PredictionState.PREDICTION_FOREIGN, -1)), "none: another simulator sails her");
  assert.equal(aheadWords(heard(190, PredictionState.PREDICTION_WHOLE)), "none of now: the computer is too slow");
  assert.equal(aheadWords(heard(105, PredictionState.PREDICTION_ASKED, 9)), "made 5 s ago; 9 s, then the lesson asks");
});
