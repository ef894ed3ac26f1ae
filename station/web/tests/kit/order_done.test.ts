// Which orders are done with: what a bridge no longer offers to cancel, and a forecastle no longer has to answer.

import assert from "node:assert/strict";
import { test } from "node:test";

import { type ReportLine, canBeCancelled, isAnswered, isInForce, waitsForWord } from "../../src/kit/order_done";
import { bareReport, orderText, reportText } from "../../src/kit/words";
import {
  type BridgeOrder,
  BridgeOrderCode as O,
  BridgeOrderState,
  CableWeight,
  Growing,
  type Report,
  ReportCode as R,
  StayGiven,
} from "../../src/wire/generated";

/** Given at 10 s a number. */
const order = (number: number, code: O, more: Partial<BridgeOrder> = {}): BridgeOrder =>
  ({
    number,
    code,
    side: 0,
    value: 0,
    time: 10 * number,
    state: BridgeOrderState.ORDER_REPEATED,
    ...more,
  }) as BridgeOrder;
const made = (time: number, code: R, more: Partial<Report> = {}): ReportLine => ({
  code: "report.made",
  side: more.side ?? 0,
  time,
  text: `reported: ${reportText({ ...bareReport(code, 0), ...more })}, to order 3`,
});

test("each question is answered by a report of its kind, however it is worded, and by no other", () => {
  const answers: [O, ReportLine][] = [
    [O.BRIDGE_ORDER_HOW_MUCH, made(11, R.REPORT_SHACKLES_IN_PIPE, { value: 2.5 })],
    [O.BRIDGE_ORDER_HOW_MUCH, made(11, R.REPORT_SHACKLES_ON_DECK, { value: 1 })],
    [O.BRIDGE_ORDER_HOW_LEADING, made(11, R.REPORT_LEAD, { lead: 3, stay: StayGiven.STAY_GIVEN_SHORT })],
    [O.BRIDGE_ORDER_HOW_LEADING, made(11, R.REPORT_LEAD, { stay: StayGiven.STAY_GIVEN_UP_AND_DOWN })],
    [O.BRIDGE_ORDER_HOW_GROWING, made(11, R.REPORT_GROWING, { growing: Growing.GROWING_TIGHT })],
    [O.BRIDGE_ORDER_HOW_MUCH_WEIGHT, made(11, R.REPORT_WEIGHT, { weight: CableWeight.WEIGHT_NONE })],
    [O.BRIDGE_ORDER_BROUGHT_UP, made(11, R.REPORT_BROUGHT_UP)],
  ];
  for (const [code, line] of answers) {
    assert.ok(isAnswered(order(1, code), [line]), line.text);
    assert.ok(!canBeCancelled(order(1, code), [], [line]), line.text);
    assert.ok(!isAnswered(order(1, code), [{ ...line, side: 1 }]), "of the other windlass");
    assert.ok(!isAnswered(order(2, code), [line]), "before it was asked");
    assert.ok(!isAnswered(order(1, code), [{ ...line, code: "report.not_heard" }]), "that nobody heard");
    assert.ok(!isAnswered(order(1, code), [made(11, R.REPORT_STANDING_BY)]));
    assert.ok(canBeCancelled(order(1, code), [], []));
  }
});

test("a length that is repeated back is no report of it", () => {
  const words = orderText(O.BRIDGE_ORDER_PAY_OUT, 0, 3);
  const line = { code: "report.made", side: 0, time: 12, text: `reported: repeats: ${words}` };
  assert.ok(!isAnswered(order(1, O.BRIDGE_ORDER_HOW_MUCH), [line]));
});

test("an order is carried out by the report that says so; of a length, by its own figure", () => {
  const payOut = order(1, O.BRIDGE_ORDER_PAY_OUT, { value: 3 });
  assert.ok(canBeCancelled(payOut, [payOut], [made(11, R.REPORT_SHACKLES_IN_PIPE, { value: 2 })]));
  assert.ok(!canBeCancelled(payOut, [payOut], [made(11, R.REPORT_SHACKLES_IN_PIPE, { value: 3 })]));
  const letGo = order(1, O.BRIDGE_ORDER_LET_GO);
  assert.ok(canBeCancelled(letGo, [letGo], [made(11, R.REPORT_ANCHOR_READY)]));
  assert.ok(!canBeCancelled(letGo, [letGo], [made(11, R.REPORT_LET_GO)]));
  const heave = order(1, O.BRIDGE_ORDER_HEAVE);
  assert.ok(canBeCancelled(heave, [heave], [made(11, R.REPORT_HEAVING)]), "it is still being done");
  const gearIn = order(1, O.BRIDGE_ORDER_GEAR_IN);
  assert.ok(isInForce(gearIn, [gearIn, order(2, O.BRIDGE_ORDER_STAND_CLEAR)], []));
  assert.ok(isAnswered(gearIn, [made(11, R.REPORT_ANCHOR_READY)]), "no report is called that she is in gear");
});

test("walking out to metres is answered by any shackles, as to the server; heaving up, once the anchor is home", () => {
  const walkOut = order(1, O.BRIDGE_ORDER_WALK_OUT, { value: 14 });
  for (const code of [R.REPORT_SHACKLES_ON_DECK, R.REPORT_SHACKLES_IN_PIPE, R.REPORT_SHACKLES_IN_WATER])
    assert.ok(isAnswered(walkOut, [made(11, code, { value: 0.5 })]));
  assert.ok(isAnswered(walkOut, [made(11, R.REPORT_ANCHOR_READY)]));
  assert.ok(!isAnswered(walkOut, [made(11, R.REPORT_LET_GO)]));
  const heave = order(1, O.BRIDGE_ORDER_HEAVE);
  for (const on of [made(11, R.REPORT_SHACKLES_ON_DECK, { value: 2 }), made(11, R.REPORT_ANCHOR_AWEIGH)])
    assert.ok(canBeCancelled(heave, [heave], [on]), "she may still be told to stop");
  assert.ok(!canBeCancelled(heave, [heave], [made(11, R.REPORT_ANCHOR_HOME)]));
});

test("an order whose place a later one of that windlass has taken is not offered, until that is cancelled", () => {
  const standBy = order(1, O.BRIDGE_ORDER_STAND_BY);
  const letGo = order(2, O.BRIDGE_ORDER_LET_GO);
  const holdOn = order(3, O.BRIDGE_ORDER_HOLD_ON, { value: 6 });
  const other = order(4, O.BRIDGE_ORDER_HEAVE, { side: 1 });
  const clear = order(5, O.BRIDGE_ORDER_STAND_CLEAR);
  const offered = (all: BridgeOrder[]): number[] =>
    all.filter((each) => canBeCancelled(each, all, [])).map(({ number }) => number);
  assert.deepEqual(offered([standBy, letGo, holdOn, other, clear]), [3, 4, 5]);
  const cancelled = { ...holdOn, state: BridgeOrderState.ORDER_CANCELLED };
  assert.deepEqual(offered([standBy, letGo, cancelled, other, order(6, O.BRIDGE_ORDER_CANCEL)]), [2, 4]);
});

test("orders in own words do not take each other's place", () => {
  const all = [
    order(1, O.BRIDGE_ORDER_TEXT, { text: "mind the buoy" }),
    order(2, O.BRIDGE_ORDER_TEXT, { text: "lamp" }),
  ];
  assert.ok(all.every((each) => canBeCancelled(each, all, [])));
});

test("in force is what is still to be done or answered, and of orders that no report ends the last", () => {
  const standBy = order(1, O.BRIDGE_ORDER_STAND_BY);
  const clear = order(2, O.BRIDGE_ORDER_STAND_CLEAR);
  const letGo = order(3, O.BRIDGE_ORDER_LET_GO);
  const asked = order(4, O.BRIDGE_ORDER_BROUGHT_UP, { state: BridgeOrderState.ORDER_GIVEN });
  const inForce = (all: BridgeOrder[], log: ReportLine[]): number[] =>
    all.filter((each) => isInForce(each, all, log)).map(({ number }) => number);
  assert.deepEqual(inForce([standBy, clear], []), [1, 2]);
  assert.deepEqual(inForce([standBy, clear, letGo, asked], []), [3, 4], "a question takes no order's place");
  assert.deepEqual(inForce([letGo, asked], [made(41, R.REPORT_GROWING, { growing: Growing.GROWING_TIGHT })]), [3]);
  assert.deepEqual(inForce([letGo, asked], [made(31, R.REPORT_LET_GO)]), [4]);
});

// The bridge's page of who has both seats shows this one.
test("what waits for a word is the newest order that nobody has repeated, or a question that was asked last", () => {
  const { ORDER_GIVEN: given, ORDER_NOT_REPEATED: late, ORDER_CANCELLED: cancelled } = BridgeOrderState;
  const never = (): boolean => false;
  const waits = (orders: BridgeOrder[], log: ReportLine[] = [], before = never): number | undefined =>
    waitsForWord(orders, log, before)?.number;
  const heave = order(1, O.BRIDGE_ORDER_HEAVE);
  const stop = order(2, O.BRIDGE_ORDER_STOP_HEAVING, { state: late });
  const again = order(3, O.BRIDGE_ORDER_STOP_HEAVING, { state: given });
  assert.equal(waits([heave]), undefined);
  assert.equal(waits([heave, stop]), 2);
  assert.equal(waits([heave, stop, again]), 3);
  assert.equal(waits([heave, stop, { ...again, state: cancelled }]), 2);
  const asked = order(4, O.BRIDGE_ORDER_HOW_LEADING, { state: given });
  assert.equal(waits([heave, asked]), 4);
  assert.equal(waits([heave, asked], [made(41, R.REPORT_LEAD, { lead: 3 })]), undefined);
  assert.equal(
    waits([heave, asked], [], () => true),
    undefined,
  );
  assert.equal(waits([asked, order(5, O.BRIDGE_ORDER_HEAVE)]), undefined, "the bridge went on without it");
});
