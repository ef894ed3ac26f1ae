// What is drawn between samples: late by one and a half intervals, evenly, and never across a break.

import assert from "node:assert/strict";
import { test } from "node:test";
import { between, mixAngle, mixTurn, mixTurning } from "../../src/scene/follow";
import type { Heard } from "../../src/wire/connection";

interface Sample {
  time: number;
  tick: number;
}
const kPeriod = 1000 / 30; // ms, of ForecastleView

/** Samples at 30 Hz that arrive up to 12 ms late, as over a busy machine; rate: exercise s a s. */
function track(count: number, rate = 1, begin = 0): Heard<Sample>[] {
  return Array.from({ length: count }, (_, i) => ({
    sample: {
      time: begin + (rate * i * kPeriod) / 1000,
      tick: Math.round(300 * (begin + (rate * i * kPeriod) / 1000)),
    },
    at: 1000 + i * kPeriod + 12 * Math.abs(Math.sin(3.7 * i)),
  }));
}

test("drawn 60 times a second, time goes on evenly although samples arrive unevenly", () => {
  for (const rate of [1, 5]) {
    const all = track(150, rate);
    let last = NaN;
    for (let now = 2000; now < 5500; now += 1000 / 60) {
      const heard = all.filter((h) => h.at <= now);
      const drawn = between(heard, now)!.time;
      if (!Number.isNaN(last)) {
        const step = (drawn - last) / (rate / 60);
        // of the even step: the mean over 40 arrivals still moves a little with each new one
        assert.ok(step > 0.7 && step < 1.3, `at ${now}: ${step} of a step`);
      }
      last = drawn;
    }
  }
});

test("what is drawn lies between its two samples, some one and a half intervals behind the newest", () => {
  const heard = track(60);
  const newest = heard.at(-1)!;
  const b = between(heard, newest.at)!;
  assert.ok(b.share >= 0 && b.share <= 1);
  assert.ok(b.from.time <= b.time && b.time <= b.to.time);
  const behind = (newest.sample.time - b.time) / (kPeriod / 1000);
  assert.ok(behind > 1 && behind < 2, `${behind} intervals`);
});

test("a restore to an earlier tick is shown at once, not gone back to", () => {
  const heard = [...track(60, 1, 100), { sample: { time: 20, tick: 6000 }, at: 1000 + 60 * kPeriod }];
  const b = between(heard, heard.at(-1)!.at)!;
  assert.equal(b.time, 20);
  assert.equal(b.from, b.to);
});

test("nothing is interpolated across more than half a second, of the clock or of the exercise", () => {
  const first = track(20);
  for (const [late, ahead] of [
    [700, 0.1],
    [40, 0.8],
  ] as const) {
    const last = first.at(-1)!;
    const next = {
      sample: { time: last.sample.time + ahead, tick: last.sample.tick + 300 * ahead },
      at: last.at + late,
    };
    assert.equal(between([...first, next], next.at)!.time, next.sample.time);
  }
});

test("a stream that stands still, as when paused, is drawn at its time", () => {
  const heard = Array.from({ length: 10 }, (_, i) => ({ sample: { time: 42, tick: 12600 }, at: 200 * i }));
  assert.equal(between(heard, 2100)!.time, 42);
  assert.equal(between([], 0), undefined);
});

test("angles go the short way round, attitudes too", () => {
  assert.ok(Math.abs(mixAngle(6.2, 0.1, 0.5) - (6.2 + (0.1 + 2 * Math.PI - 6.2) / 2)) < 1e-12);
  const q = mixTurn({ w: 1, x: 0, y: 0, z: 0 }, { w: -1, x: 0, y: 0, z: 0 }, 0.5); // the same attitude
  assert.ok(Math.abs(q.w) > 0.999);
});

test("a gypsy that turns by more than half a turn between samples goes on the way its cable runs", () => {
  const near = (a: number, b: number): void => assert.ok(Math.abs(a - b) < 1e-9, `${a} for ${b}`);
  near(mixTurning(1, 1.4, 0.5, 0.4), 1.2);
  near(mixTurning(6, 0.2, 1, 0.5), 0.2 + 2 * Math.PI);
  near(mixTurning(1, 1 + 4 - 2 * Math.PI, 1, 3.9), 5); // ten times as fast: 4 rad
  near(mixTurning(1, 0.7, 0.5, -0.25), 0.85);
});
