// The line's log on the bridge: each report once, when it was heard, whenever the page was opened.

import assert from "node:assert/strict";
import { test } from "node:test";

import { type HeardReport, Line } from "../../src/bridge/line";
import { bareReport, reportText } from "../../src/kit/words";
import type { Connection } from "../../src/wire/connection";
import { EventSeverity, ReportCode } from "../../src/wire/generated";

/** A bridge page whose exercise stands at `now` (s), and what it is told. */
function bridge(now: number) {
  const listeners = new Map<string, ((sample: never) => void)[]>();
  const nothing = (): void => undefined;
  const link = {
    on: (topic: string, listener: never) => listeners.set(topic, [...(listeners.get(topic) ?? []), listener]),
    onState: nothing,
    latest: (topic: string) => (topic === "ExerciseStatus" ? { time: now } : undefined),
    all: () => [],
  } as unknown as Connection;
  const line = new Line(link);
  const heard: Pick<HeardReport, "time" | "number" | "fresh">[] = [];
  line.onReport(({ time, number, fresh }) => heard.push({ time, number, fresh }));
  const tell = (topic: string, sample: object): void =>
    listeners.get(topic)?.forEach((listener) => listener(sample as never));
  const event = (time: number, number: number, code: string, text: string, on = "BridgeEvent"): void =>
    tell(on, { time, number, code, side: 0, text, severity: EventSeverity.EVENT_INFO });
  return {
    event,
    heard,
    says: (code: ReportCode) => tell("Report", bareReport(code, 0)),
    logs: (time: number, number: number, code: ReportCode) =>
      event(time, number, "report.made", `reported: ${reportText(bareReport(code, 0))}, to order 3`),
    log: () => line.log().map(({ kind, time, text, left }) => `${kind} ${time} ${text}${left ? ", left" : ""}`),
  };
}

const { REPORT_LET_GO: letGo, REPORT_BROUGHT_UP: broughtUp } = ReportCode;

test("a page that opens late has reports at the times at which they were heard, and speaks none of them", () => {
  const late = bridge(600);
  late.says(letGo);
  late.says(broughtUp);
  late.logs(30, 4, letGo);
  late.logs(420, 9, broughtUp);
  assert.deepEqual(late.log(), ["report 420 port: she is brought up", "report 30 port anchor is let go"]);
  assert.deepEqual(late.heard, [
    { time: 30, number: 4, fresh: false },
    { time: 420, number: 9, fresh: false },
  ]);
});

test("a report is told once, whichever of its two samples comes first, and again when it is said again", () => {
  const page = bridge(31);
  page.logs(30, 4, letGo);
  page.says(letGo);
  page.logs(30, 4, letGo); // told again, after the link was lost
  page.logs(31, 5, letGo);
  page.says(letGo);
  assert.deepEqual(page.heard, [
    { time: 30, number: 4, fresh: true },
    { time: 31, number: 5, fresh: true },
  ]);
  assert.equal(page.log().length, 2);
});

test("what the bridge did not hear does not stand there, and what a restore has left is said to be left", () => {
  const page = bridge(31);
  page.says(letGo);
  const onDeck = "no answer from the bridge; reported: port anchor is let go";
  page.event(20, 3, "report.not_heard", onDeck, "ForecastleEvent");
  assert.deepEqual([page.log(), page.heard], [[], []]);
  page.logs(30, 4, letGo);
  page.event(25, 5, "exercise.restored", "restored");
  assert.deepEqual(page.log(), ["report 30 port anchor is let go, left"]);
  const late = bridge(31);
  late.logs(30, 4, letGo);
  late.event(25, 5, "exercise.restored", "restored");
  assert.deepEqual(late.log(), [], "a page that has not heard it is not told");
});
