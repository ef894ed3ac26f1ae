// The report pad turns with the work, by what its seat knows.

import assert from "node:assert/strict";
import { test } from "node:test";

import { Work, leafAfter } from "../../src/forecastle/work";
import { bareReport, orderText, padLeaves, placeOf, reportRows, reportText } from "../../src/kit/words";
import type { Connection } from "../../src/wire/connection";
import { AnchorSeen, BridgeOrderCode, type ForecastleView, ReportCode, type SeatEvent } from "../../src/wire/generated";

type Told = Pick<SeatEvent, "code" | "side" | "text">;

/** Lines of the log as the server writes them. */
const ordered = (code: BridgeOrderCode, side = 0, value = 0): Told => ({
  code: "order.given",
  side,
  text: `order 3 given: ${orderText(code, side, value)}`,
});
const reported = (code: ReportCode, side = 0, value = 0): Told => ({
  code: "report.made",
  side,
  text: reportText({ ...bareReport(code, side), value }),
});

/** A forecastle that hears events, and sees its anchors so. */
class Heard {
  private readonly listeners: ((event: SeatEvent) => void)[] = [];
  private open: (state: string) => void = () => {};
  readonly work: Work;
  private time = 0;

  constructor(private readonly anchors: AnchorSeen[]) {
    this.work = new Work({
      on: (_: string, listener: (event: SeatEvent) => void) => this.listeners.push(listener),
      onState: (listener: (state: string) => void) => (this.open = listener),
      latest: (_: string, side: number) => ({ anchor: this.anchors[side] }) as ForecastleView,
    } as unknown as Connection);
  }
  hear(event: Told, time = ++this.time): void {
    for (const listener of this.listeners) listener({ ...event, time } as SeatEvent);
  }
  reconnect(): void {
    this.open("open");
  }
  leaf = (side = 0): string => this.work.leaf(side).const;
}

const C = BridgeOrderCode;
const R = ReportCode;

test("a let-go, from the order to stand by until she is secured, and then the weighing", () => {
  const deck = new Heard([AnchorSeen.ANCHOR_SEEN_ACOCKBILL]);
  const seen = [deck.leaf()];
  const then = (event: Told): void => {
    deck.hear(event);
    if (seen.at(-1) !== deck.leaf()) seen.push(deck.leaf());
  };
  then(ordered(C.BRIDGE_ORDER_STAND_BY));
  then(ordered(C.BRIDGE_ORDER_LET_GO));
  then(reported(R.REPORT_LET_GO));
  then(reported(R.REPORT_ON_THE_BOTTOM));
  then(ordered(C.BRIDGE_ORDER_PAY_OUT, 0, 3));
  then(reported(R.REPORT_SHACKLES_IN_PIPE, 0, 3));
  then(ordered(C.BRIDGE_ORDER_HOLD_ON, 0, 6));
  then(ordered(C.BRIDGE_ORDER_HOW_LEADING));
  then(reported(R.REPORT_BROUGHT_UP));
  then(ordered(C.BRIDGE_ORDER_SECURE));
  then(ordered(C.BRIDGE_ORDER_HEAVE));
  then(reported(R.REPORT_ANCHOR_HOME));
  assert.deepEqual(seen, ["letting_go", "bringing_up", "riding", "weighing"]);
});

test("nothing that has happened turns it before it was said", () => {
  const deck = new Heard([AnchorSeen.ANCHOR_SEEN_ACOCKBILL]);
  deck.hear(ordered(C.BRIDGE_ORDER_LET_GO));
  deck.hear({ code: "anchor.on_bottom", side: 0, text: "port anchor is on the bottom" });
  assert.equal(deck.leaf(), "letting_go");
});

test("a ship at anchor rides, until something is ordered, and each side has its own work", () => {
  const deck = new Heard([AnchorSeen.ANCHOR_SEEN_UNDER_WATER, AnchorSeen.ANCHOR_SEEN_HOME]);
  assert.deepEqual([deck.leaf(0), deck.leaf(1)], ["riding", "letting_go"]);
  deck.hear(ordered(C.BRIDGE_ORDER_HEAVE, 0));
  assert.deepEqual([deck.leaf(0), deck.leaf(1)], ["weighing", "letting_go"]);
  deck.hear(ordered(C.BRIDGE_ORDER_LET_GO, -1));
  assert.deepEqual([deck.leaf(0), deck.leaf(1)], ["letting_go", "letting_go"]);
});

test("what a restore leaves turns it no more, nor what was heard before a reconnection", () => {
  const deck = new Heard([AnchorSeen.ANCHOR_SEEN_ACOCKBILL]);
  deck.hear(ordered(C.BRIDGE_ORDER_LET_GO), 10);
  deck.hear(reported(R.REPORT_ON_THE_BOTTOM), 20);
  assert.equal(deck.leaf(), "bringing_up");
  deck.hear({ code: "exercise.restored", side: -1, text: "" }, 15);
  assert.equal(deck.leaf(), "letting_go");
  deck.hear(ordered(C.BRIDGE_ORDER_HEAVE), 16);
  assert.equal(deck.leaf(), "weighing");
  deck.reconnect();
  assert.equal(deck.leaf(), "letting_go");
});

test("every order and report after which the pad turns is known in the log's words", () => {
  for (const leaf of padLeaves) {
    for (const side of [0, 1, -1])
      for (const name of leaf.after?.orders ?? []) {
        const code: BridgeOrderCode = placeOf("BridgeOrderCode", name);
        for (const value of [0, 2.5])
          assert.equal(leafAfter(ordered(code, side, value)), leaf, `${name} ${side} ${value}`);
      }
    for (const side of [0, 1])
      for (const name of leaf.after?.reports ?? []) {
        const line = reported(placeOf("ReportCode", name), side);
        assert.equal(leafAfter(line), leaf, name);
        assert.equal(
          leafAfter({ ...line, code: "report.not_heard", text: `no answer; ${line.text}, 12 o'clock` }),
          leaf,
        );
      }
  }
  const turning = new Set(
    padLeaves.flatMap(({ after }) => after?.reports ?? []).map((name) => placeOf("ReportCode", name)),
  );
  for (let code = 1; code < reportRows.length; ++code)
    if (!turning.has(code)) assert.equal(leafAfter(reported(code)), undefined, reportRows[code]!.enumerator);
});

test("a let-go asks for the anchor on the bottom, and each phase for the cable", () => {
  const leaf = (name: string): string[] => padLeaves.find((one) => one.const === name)!.reports;
  assert.ok(leaf("letting_go").includes("on_the_bottom") && !leaf("letting_go").includes("foul_anchor"));
  for (const phase of padLeaves.filter(({ after }) => after))
    assert.ok(phase.reports.includes("shackles_in_pipe"), phase.const);
  assert.ok(leaf("trouble").includes("no_power"));
});
