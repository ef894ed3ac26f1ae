// What is taken for silence, without a browser: by rate, by the pace of the exercise, and never by a page's own delay.

import assert from "node:assert/strict";
import { test } from "node:test";

import { LiveWatch, isUnheard, showsTopic } from "../../src/kit/live";
import type { Connection } from "../../src/wire/connection";
import { RunState, type TopicName } from "../../src/wire/generated";

/** A link that heard each topic last at a time, ms; status: of the exercise. */
function link(heard: Partial<Record<TopicName, number>>, status: object = {}) {
  const latest = { ExerciseStatus: { state: RunState.RUN_RUNNING, time_scale_achieved: 1, ...status } };
  return {
    heard,
    as: {
      state: "open",
      heardAt: (topic: TopicName) => heard[topic] ?? -Infinity,
      latest: (topic: TopicName) =>
        topic === "ExerciseStatus" || heard[topic] !== undefined
          ? ((latest as Record<string, unknown>)[topic] ?? {})
          : undefined,
    } as unknown as Connection,
  };
}
const panel = () => {
  const element = { old: false, toggleAttribute: (_: string, on: boolean) => (element.old = on) };
  return element;
};

test("a server that is not heard for more than 4 s is said to be silent, at the second look", () => {
  const { heard, as } = link({ ExerciseStatus: 1000, ForecastleView: 1000 });
  const live = new LiveWatch(as, "ForecastleView");
  assert.equal(live.look(4900), 0);
  assert.equal(live.look(5250), 0, "a page that was held up may find samples yet");
  assert.equal(live.look(5500), 4500);
  assert.ok(isUnheard(as));
  heard.ExerciseStatus = heard.ForecastleView = 5600;
  assert.equal(live.look(5750), 0);
  assert.ok(!isUnheard(as));
});

test("levers that go on, as the station's own do, are no sign of a server", () => {
  const { heard, as } = link({ ExerciseStatus: 1000, ForecastleView: 1000 });
  const live = new LiveWatch(as, "ForecastleView");
  for (let now = 1000; now < 7000; now += 250) {
    heard.WindlassCommand = now;
    live.look(now);
  }
  assert.ok(isUnheard(as));
});

test("a view that falls silent beside a server that speaks makes the page old, and the levers are heard", () => {
  const { as } = link({ ExerciseStatus: 9900, BridgeView: 1000 });
  const live = new LiveWatch(as, "BridgeView");
  live.look(9900);
  assert.equal(live.look(10000), 9000);
  assert.ok(!isUnheard(as));
});

test("a panel goes by its own topic, slower where the exercise does", () => {
  for (const [pace, old] of [
    [1, true],
    [0.1, false],
  ] as const) {
    const { as } = link({ ExerciseStatus: 9900, ShipState: 9900, WindlassLoad: 3000 }, { time_scale_achieved: pace });
    const [load, ship] = [panel(), panel()];
    showsTopic(load as unknown as Element, as, "WindlassLoad");
    showsTopic(ship as unknown as Element, as, "ShipState");
    const live = new LiveWatch(as, "ShipState");
    live.look(9950);
    live.look(10000);
    assert.equal(load.old, old, `at x${pace}`);
    assert.equal(ship.old, false);
  }
});

test("a replay that stands repeats its status alone, and is of now", () => {
  const { as } = link({ ExerciseStatus: 9900, ShipState: 1000, ReplayStatus: 9900 });
  const load = panel();
  showsTopic(load as unknown as Element, as, "ShipState");
  const live = new LiveWatch(as, "ShipState");
  live.look(9950);
  assert.equal(live.look(10000), 0);
  assert.equal(load.old, false);
});
