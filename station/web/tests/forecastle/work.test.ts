// The report pad turns with the work, by what its seat knows.

import assert from "node:assert/strict";
import { test } from "node:test";

import { Work, leafAfter, leafAfterOrder, leafSeen } from "../../src/forecastle/work";
import { bareReport, padLeaves, placeOf, reportRows, reportText } from "../../src/kit/words";
import type { Connection } from "../../src/wire/connection";
import {
  AnchorSeen,
  type BridgeOrder,
  BridgeOrderCode,
  BridgeOrderState,
  ClutchState,
  type ForecastleView,
  ReportCode,
  type SeatEvent,
} from "../../src/wire/generated";

type Told = Pick<SeatEvent, "code" | "side" | "text">;
type Given = Pick<BridgeOrder, "code" | "side">;

const ordered = (code: BridgeOrderCode, side = 0): Given => ({ code, side });
/** A line of the log as the server writes it. */
const reported = (code: ReportCode, side = 0, value = 0): Told => ({
  code: "report.made",
  side,
  text: reportText({ ...bareReport(code, side), value }),
});
const restored: Told = { code: "exercise.restored", side: -1, text: "" };

/** What is seen of an anchor whose cable is held, unless it is said. */
const look = (anchor: AnchorSeen, more: Partial<ForecastleView> = {}): ForecastleView =>
  ({
    anchor,
    cable_speed_seen: 0,
    brake_position: 1,
    stopper_closed: false,
    clutch: ClutchState.CLUTCH_OUT,
    ...more,
  }) as ForecastleView;

/** A forecastle that hears orders and events, and sees its anchors so. */
class Heard {
  private readonly listeners = new Map<string, (sample: never) => void>();
  private open: (state: string) => void = () => {};
  private anotherServer: () => void = () => {};
  private readonly orders: BridgeOrder[] = [];
  readonly work: Work;
  private time = 0;
  private runs = 1;

  constructor(private views: ForecastleView[]) {
    this.work = new Work({
      on: (topic: string, listener: (sample: never) => void) => this.listeners.set(topic, listener),
      onState: (listener: (state: string) => void) => (this.open = listener),
      onAnotherServer: (listener: () => void) => (this.anotherServer = listener),
      all: () => this.orders,
      latest: (_: string, side: number) => this.views[side],
    } as unknown as Connection);
    this.tell("ExerciseStatus", { run: 1, time: 0 });
    this.sees(views);
  }
  private tell(topic: string, sample: object): void {
    this.listeners.get(topic)!(sample as never);
  }
  hear(event: Told, time = ++this.time): void {
    this.time = time;
    this.tell("ForecastleEvent", { ...event, time });
  }
  order({ code, side }: Given, time = ++this.time, more: Partial<BridgeOrder> = {}): void {
    this.time = time;
    const number = this.orders.length + 1;
    const order = { number, run: this.runs, time, code, side, state: BridgeOrderState.ORDER_GIVEN, ...more };
    this.orders.push(order as BridgeOrder);
    this.tell("BridgeOrder", order);
  }
  /** Another run goes on from a moment; its orders are told with it. */
  restore(time: number, orders: Given[] = [], views = this.views): void {
    ++this.runs;
    this.time = time;
    this.orders.length = 0;
    orders.forEach((order, i) => this.order(order, i + 1));
    this.hear(restored, time);
    this.tell("ExerciseStatus", { run: this.runs, time });
    this.sees(views);
  }
  sees(views: ForecastleView[], time = this.time): void {
    this.views = views;
    views.forEach((view, side) => this.tell("ForecastleView", { ...view, side, time }));
  }
  reconnect(): void {
    this.open("open");
  }
  meetsAnotherServer(): void {
    this.anotherServer();
  }
  leaf = (side = 0): string => this.work.leaf(side).const;
}

const C = BridgeOrderCode;
const R = ReportCode;
const A = AnchorSeen;

test("a let-go, from the order to stand by until she is secured, and then the weighing", () => {
  const deck = new Heard([look(A.ANCHOR_SEEN_ACOCKBILL)]);
  const seen = [deck.leaf()];
  const then = (said: Told | Given): void => {
    if ("text" in said) deck.hear(said);
    else deck.order(said);
    if (seen.at(-1) !== deck.leaf()) seen.push(deck.leaf());
  };
  then(ordered(C.BRIDGE_ORDER_STAND_BY));
  then(ordered(C.BRIDGE_ORDER_LET_GO));
  then(reported(R.REPORT_LET_GO));
  then(reported(R.REPORT_ON_THE_BOTTOM));
  then(ordered(C.BRIDGE_ORDER_PAY_OUT));
  then(reported(R.REPORT_SHACKLES_IN_PIPE, 0, 3));
  then(ordered(C.BRIDGE_ORDER_HOLD_ON));
  then(ordered(C.BRIDGE_ORDER_HOW_LEADING));
  then(reported(R.REPORT_BROUGHT_UP));
  then(ordered(C.BRIDGE_ORDER_SECURE));
  then(ordered(C.BRIDGE_ORDER_HEAVE));
  then(reported(R.REPORT_ANCHOR_HOME));
  assert.deepEqual(seen, ["letting_go", "bringing_up", "riding", "weighing"]);
});

test("nothing that has happened turns it before it was said", () => {
  const deck = new Heard([look(A.ANCHOR_SEEN_ACOCKBILL)]);
  deck.order(ordered(C.BRIDGE_ORDER_LET_GO));
  deck.hear({ code: "anchor.on_bottom", side: 0, text: "port anchor is on the bottom" });
  assert.equal(deck.leaf(), "letting_go");
});

test("a ship at anchor rides, until something is ordered, and each side has its own work", () => {
  const deck = new Heard([look(A.ANCHOR_SEEN_UNDER_WATER), look(A.ANCHOR_SEEN_HOME)]);
  assert.deepEqual([deck.leaf(0), deck.leaf(1)], ["riding", "letting_go"]);
  deck.order(ordered(C.BRIDGE_ORDER_HEAVE, 0));
  assert.deepEqual([deck.leaf(0), deck.leaf(1)], ["weighing", "letting_go"]);
  deck.order(ordered(C.BRIDGE_ORDER_LET_GO, -1));
  assert.deepEqual([deck.leaf(0), deck.leaf(1)], ["letting_go", "letting_go"]);
});

test("what a restore leaves turns it no more; what was ordered and reported before its moment does", () => {
  const deck = new Heard([look(A.ANCHOR_SEEN_ACOCKBILL)]);
  deck.order(ordered(C.BRIDGE_ORDER_LET_GO), 10);
  deck.hear(reported(R.REPORT_ON_THE_BOTTOM), 20);
  deck.order(ordered(C.BRIDGE_ORDER_HEAVE), 30);
  assert.equal(deck.leaf(), "weighing");
  deck.restore(25, [ordered(C.BRIDGE_ORDER_LET_GO)]);
  assert.equal(deck.leaf(), "bringing_up");
  deck.restore(15, [ordered(C.BRIDGE_ORDER_LET_GO)]);
  assert.equal(deck.leaf(), "letting_go");
  deck.order(ordered(C.BRIDGE_ORDER_HEAVE), 16);
  assert.equal(deck.leaf(), "weighing");
});

test("a page that opens in a run that went on from elsewhere goes by the orders from before, without their log", () => {
  const running = look(A.ANCHOR_SEEN_UNDER_WATER, { cable_speed_seen: 2, brake_position: 0.3 });
  const deck = new Heard([running]);
  deck.restore(300, [ordered(C.BRIDGE_ORDER_STAND_BY), ordered(C.BRIDGE_ORDER_PAY_OUT)]);
  assert.equal(deck.leaf(), "bringing_up");
});

test("where no word is known what is seen first counts: cable that runs out is being let go, and stays so", () => {
  const running = look(A.ANCHOR_SEEN_UNDER_WATER, { cable_speed_seen: 2, brake_position: 0.3 });
  const held = look(A.ANCHOR_SEEN_UNDER_WATER);
  const deck = new Heard([held]);
  assert.equal(deck.leaf(), "riding");
  deck.sees([held], 200);
  deck.restore(60, [], [look(A.ANCHOR_SEEN_ACOCKBILL)]);
  deck.sees([running], 62);
  deck.sees([held], 70);
  assert.equal(deck.leaf(), "letting_go", "it was at the hawse");
  deck.restore(65, [], [running]);
  deck.sees([held], 70);
  assert.equal(deck.leaf(), "letting_go", "it ran");
  deck.restore(400, [], []);
  deck.sees([running], 65); // of the branch before
  deck.sees([held], 401);
  assert.equal(deck.leaf(), "riding");
  const levers = { brake_position: 0.5, clutch: ClutchState.CLUTCH_IN };
  assert.equal(leafSeen(look(A.ANCHOR_SEEN_UNDER_WATER, levers)).const, "riding", "in gear");
  assert.equal(leafSeen(look(A.ANCHOR_SEEN_UNDER_WATER, { ...levers, cable_speed_seen: -0.25 })).const, "weighing");
});

test("an order that is cancelled turns it no more", () => {
  const deck = new Heard([look(A.ANCHOR_SEEN_UNDER_WATER)]);
  deck.order(ordered(C.BRIDGE_ORDER_HEAVE), 10, { state: BridgeOrderState.ORDER_CANCELLED });
  assert.equal(deck.leaf(), "riding");
});

test("the log comes again when the link opens, and is of no use when another server is heard", () => {
  const deck = new Heard([look(A.ANCHOR_SEEN_ACOCKBILL)]);
  for (const begin of [() => deck.reconnect(), () => deck.meetsAnotherServer()]) {
    deck.hear(reported(R.REPORT_ON_THE_BOTTOM));
    assert.equal(deck.leaf(), "bringing_up");
    begin();
    assert.equal(deck.leaf(), "letting_go");
  }
});

test("it is said when the work may have gone on: at each order once, whatever becomes of it", () => {
  const deck = new Heard([look(A.ANCHOR_SEEN_ACOCKBILL)]);
  let turns = 0;
  deck.work.onTurn(() => ++turns);
  deck.order(ordered(C.BRIDGE_ORDER_LET_GO), 10, { number: 1 });
  deck.order(ordered(C.BRIDGE_ORDER_LET_GO), 10, { number: 1, state: BridgeOrderState.ORDER_REPEATED });
  deck.order(ordered(C.BRIDGE_ORDER_STAND_CLEAR), 11, { number: 2 });
  assert.equal(turns, 1);
});

test("every order after which the pad turns is known, and every report in the log's words", () => {
  for (const leaf of padLeaves) {
    for (const name of leaf.after?.orders ?? [])
      assert.equal(leafAfterOrder(placeOf("BridgeOrderCode", name)), leaf, name);
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
