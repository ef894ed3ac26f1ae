// The desk's list of reports: each once, at its own time, beside what was so then, whenever the desk was opened.

import assert from "node:assert/strict";
import { test } from "node:test";

import { EventStore } from "../../src/desk/events";
import { ReportLog } from "../../src/desk/report_log";
import { bareReport, reportText } from "../../src/kit/words";
import type { Connection } from "../../src/wire/connection";
import { AnchorPhase, type AnchorState, EventSeverity, ReportCode, type WindlassLoad } from "../../src/wire/generated";

const kShackle = 27.5; // m

/** A desk that has just been opened, and what it is told. */
function desk() {
  const listeners = new Map<string, ((sample: never, key: string, written: number) => void)[]>();
  const tracks = new Map<string, { sample: unknown }[]>();
  const track = (topic: string, side: number) => tracks.get(`${topic}/${side}`) ?? [];
  const nothing = (): void => undefined;
  const link = {
    on: (topic: string, listener: never) => listeners.set(topic, [...(listeners.get(topic) ?? []), listener]),
    onState: nothing,
    onAnotherServer: nothing,
    onMessage: nothing,
    latest: nothing,
    track,
  } as unknown as Connection;
  const log = new ReportLog(link, new EventStore(link), () => false, nothing);
  const tell = (topic: string, sample: object): void =>
    listeners.get(topic)?.forEach((listener) => listener(sample as never, "", 0));
  let number = 0;
  const event = (time: number, code: string, side: number, text: string): void =>
    tell("Event", { number: ++number, tick: 10 * time, time, code, side, text, severity: EventSeverity.EVENT_INFO });
  return {
    event,
    /** Truth of the port side: shackles out, of the anchor, and the lip's height, m. */
    stands: (time: number, out: number, phase = AnchorPhase.ANCHOR_ON_BOTTOM, lip = 0) => {
      tracks.set("ChainState/0", [...track("ChainState", 0), { sample: { time, nodes: [0, 0, lip] } }]);
      tracks.set("WindlassLoad/0", [...track("WindlassLoad", 0), { sample: { time, cable_out: out * kShackle } }]);
      tracks.set("AnchorState/0", [...track("AnchorState", 0), { sample: { time, phase } }]);
    },
    /** As the forecastle says it: without a time. */
    says: (code: ReportCode, value = 0) => tell("Report", { ...bareReport(code, 0), value }),
    /** As the server has heard it. */
    logs: (time: number, code: ReportCode, value = 0) =>
      event(time, "report.made", 0, `reported: ${reportText({ ...bareReport(code, 0), value })}`),
    /** The judge, of what was reported then: with the side of the cable that it was held against. */
    judges: (...all: [time: number, text: string, side?: number][]) =>
      tell("Assessment", { reports: all.map(([time, text, side = 0]) => ({ tick: 10 * time, side, text })) }),
    /** Truth of then, as a recording has it that was being made when the desk was opened. */
    recorded: (...all: [time: number, out: number][]) => {
      log.forget();
      for (const [time, out] of all) {
        log.hear("WindlassLoad", { side: 0, time, cable_out: out * kShackle } as WindlassLoad);
        log.hear("AnchorState", { side: 0, time, phase: AnchorPhase.ANCHOR_ON_BOTTOM } as AnchorState);
      }
      log.caughtUp();
    },
    lines: () => log.lines.map(({ event: { time }, words, was }) => ({ time, words, was })),
  };
}

const { REPORT_LET_GO: letGo, REPORT_SHACKLES_IN_PIPE: inPipe } = ReportCode;

test("a report stands once, at the time of its event, beside the truth of that moment, whichever comes first", () => {
  const both = [{ time: 195, words: "port: 2 shackles in the pipe", was: "was 4.15 in the pipe" }];
  const early = desk();
  early.stands(195, 4.1);
  early.says(inPipe, 2);
  early.logs(195, inPipe, 2);
  early.stands(200, 6);
  assert.deepEqual(early.lines(), both);
  const late = desk();
  late.stands(195, 4.1);
  late.logs(195, inPipe, 2);
  late.stands(200, 6);
  late.says(inPipe, 2);
  assert.deepEqual(late.lines(), both);
});

test("a desk that is opened late has each report at its time, and no truth of now beside it", () => {
  const late = desk();
  late.stands(131, 5);
  late.says(letGo);
  late.says(inPipe, 2);
  late.logs(27, letGo);
  late.logs(53, inPipe, 2);
  assert.deepEqual(late.lines(), [
    { time: 27, words: "port anchor is let go", was: "" },
    { time: 53, words: "port: 2 shackles in the pipe", was: "" },
  ]);
});

test("a desk that is opened late has what was so from the lesson's judge, whichever it hears first", () => {
  const late = desk();
  late.stands(131, 5);
  late.judges([27, "2 s after it was so, at 0:25"], [27, "of the other cable", 1]);
  late.logs(27, letGo);
  late.logs(53, inPipe, 2);
  late.logs(131, inPipe, 2);
  const was = (): string[] => late.lines().map((line) => line.was);
  assert.deepEqual(was(), ["2 s after it was so, at 0:25", "", "was 5 from the lip, on the bottom"]);
  late.judges([27, "2 s after it was so, at 0:25"], [53, "2.41 were so"], [131, "4.97 were so"]);
  assert.deepEqual(was(), ["2 s after it was so, at 0:25", "2.41 were so", "was 5 from the lip, on the bottom"]);
});

test("a desk that is opened late has what was so of every report from a recording that was being made", () => {
  const late = desk();
  late.stands(131, 5);
  late.judges([27, "2 s after it was so, at 0:25"]);
  late.says(inPipe, 2);
  late.logs(27, letGo);
  late.logs(53, inPipe, 2);
  late.logs(131, inPipe, 2);
  // Back from 55 s to 52 s, a branch that was left.
  late.recorded([26, 0.2], [27, 0.4], [28, 0.9], [53, 9], [55, 9.5], [52, 2.1], [53, 2.3], [54, 2.6], [130, 4.9]);
  assert.deepEqual(
    late.lines().map(({ was }) => was),
    ["was 0.4 from the lip, on the bottom", "was 2.35 in the pipe", "was 5.05 in the pipe"],
  );
});

test("shackles are told from where the report counts them", () => {
  const { REPORT_SHACKLES_ON_DECK: onDeck, REPORT_SHACKLES_IN_WATER: inWater } = ReportCode;
  const at = (code: ReportCode): string => {
    const early = desk();
    early.stands(50, 4, undefined, 6);
    early.says(code, 4);
    early.logs(50, code, 4);
    return early.lines()[0]!.was;
  };
  assert.equal(at(onDeck), "was 4.15 on deck");
  assert.equal(at(inPipe), "was 4.05 in the pipe");
  assert.equal(at(inWater), "was 3.78 in the water");
});

test("the same words said twice are two reports, each beside its own truth", () => {
  const early = desk();
  for (const [time, out] of [
    [10, 1.9],
    [20, 2.4],
  ] as const) {
    early.stands(time, out);
    early.says(inPipe, 2);
    early.logs(time, inPipe, 2);
  }
  assert.deepEqual(
    early.lines().map(({ time, was }) => [time, was]),
    [
      [10, "was 1.95 in the pipe"],
      [20, "was 2.45 in the pipe"],
    ],
  );
});

test("what a restore has left is gone; the order that a report answers is not said again", () => {
  const early = desk();
  early.event(10, "report.made", 0, "reported: repeats: let go port anchor, to order 4");
  early.logs(50, letGo);
  early.event(20, "exercise.restored", -1, "exercise restored to 0:20, paused, by instructor");
  early.event(25, "report.not_heard", 0, "no answer from the bridge; reported: port anchor is let go");
  assert.deepEqual(
    early.lines().map(({ time, words }) => [time, words]),
    [
      [10, "repeats: let go port anchor"],
      [25, "no answer from the bridge; reported: port anchor is let go"],
    ],
  );
});
