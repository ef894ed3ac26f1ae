// What is drawn over time at a desk that is opened in the midst of an exercise that is being recorded.

import assert from "node:assert/strict";
import { test } from "node:test";

import { RecordedPast } from "../../src/desk/recorded_past";
import type { Connection } from "../../src/wire/connection";
import type { TopicName, TopicTypes } from "../../src/wire/generated";

/** A payload of ShipState in CDR, of which tick and time come first: the rest is 0. */
function payload(time: number): string {
  const view = new DataView(new ArrayBuffer(1000));
  view.setUint16(0, 1); // little-endian
  view.setFloat64(4 + 8, time, true);
  return btoa(String.fromCharCode(...new Uint8Array(view.buffer)));
}

function desk() {
  const asked: object[] = [];
  const told: (number | string)[] = []; // times of the ship's samples, as somebody who draws is told them
  const on = new Map<string, (sample: unknown) => void>();
  const messages = new Map<string, (message: object) => void>();
  let refuse: (why: Error) => void = () => undefined;
  const link = {
    on: (topic: string, listener: (sample: unknown) => void) => on.set(topic, listener),
    onMessage: (op: string, listener: (message: object) => void) => messages.set(op, listener),
    latest: () => undefined,
    ask: (message: object) => {
      asked.push(message);
      return new Promise<void>((_, refused) => (refuse = refused));
    },
  } as unknown as Connection;
  const past = new RecordedPast(link);
  past.add({
    forget: () => void told.splice(0),
    hear: <T extends TopicName>(_: T, sample: TopicTypes[T]) => void told.push((sample as { time: number }).time),
    caughtUp: () => void told.push("caught up"),
  });
  return {
    asked,
    told,
    greet: (recording: string | null) => messages.get("hello")!({ recording }),
    hear: (time: number) => on.get("ShipState")!({ time }),
    answer: (...times: number[]) =>
      messages.get("recording_events")!({
        recording: "mon-1",
        events: [],
        past: times.map((time, k) => [k, "ShipState", payload(time)]),
      }),
    refuse: () => refuse(new Error("no such recording")),
  };
}

test("a desk that is opened late is told what was recorded, and then what it has heard itself", () => {
  const late = desk();
  late.greet("mon-1");
  late.hear(300);
  late.hear(300.5);
  assert.deepEqual(late.asked, [{ op: "read_recording", recording: "mon-1" }]);
  late.answer(0, 1, 2, 299, 300, 301);
  assert.deepEqual(late.told, [0, 1, 2, 299, 300, 301, 300, 300.5, "caught up"]);
  late.hear(302);
  assert.equal(late.asked.length, 1);
});

test("one that was there from the beginning asks for nothing, nor does one without a recording", () => {
  const early = desk();
  early.greet("mon-1");
  early.hear(0);
  early.hear(400);
  assert.deepEqual(early.asked, []);
  const bare = desk();
  bare.greet(null);
  bare.hear(300);
  bare.greet("mon-1"); // begun at this desk
  bare.hear(301);
  assert.deepEqual(bare.asked, []);
});

test("where the recording cannot be read, what was heard stays as it is", async () => {
  const late = desk();
  late.greet("mon-1");
  late.hear(300);
  late.refuse();
  await Promise.resolve();
  await Promise.resolve();
  assert.deepEqual(late.told, []);
});
