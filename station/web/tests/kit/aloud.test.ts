// Orders and reports as they are spoken: every code has words, and those of the standard phrases are theirs.

import assert from "node:assert/strict";
import { test } from "node:test";
import { inWords, orderAloud, reportAloud } from "../../src/kit/aloud";
import { orderUnit } from "../../src/kit/orders";
import { bareReport, orderText } from "../../src/kit/words";
import { BridgeOrderCode, ReportCode, StayGiven } from "../../src/wire/generated";

const C = BridgeOrderCode;
const R = ReportCode;

test("figures are said as a mate says them", () => {
  assert.deepEqual([6, 1.5, 0.5, 12, 25].map(inWords), ["six", "one and a half", "a half", "twelve", "25"]);
});

test("orders name the anchor, and the figure where they have one", () => {
  const aloud = (code: BridgeOrderCode, side: number, value = 0, text = ""): string =>
    orderAloud({ code, side, value, text });
  assert.equal(aloud(C.BRIDGE_ORDER_LET_GO, 0), "Let go port anchor");
  assert.equal(aloud(C.BRIDGE_ORDER_STAND_BY, -1), "Stand by both anchors");
  assert.equal(aloud(C.BRIDGE_ORDER_HOLD_ON, 1, 6), "Hold on starboard cable at six shackles in the pipe");
  assert.equal(aloud(C.BRIDGE_ORDER_PAY_OUT, 0, 1), "Pay out port cable to one shackle in the pipe");
  assert.equal(aloud(C.BRIDGE_ORDER_WALK_OUT, 0, 25), "Walk out port anchor to 25 metres");
  assert.equal(aloud(C.BRIDGE_ORDER_TEXT, -1, 0, "mind the buoy"), "Mind the buoy");
});

test("reports say what was given and nothing else", () => {
  const aloud = (code: ReportCode, more: object = {}): string => reportAloud({ ...bareReport(code, 0), ...more });
  assert.equal(aloud(R.REPORT_SHACKLES_IN_WATER, { value: 3 }), "Three shackles in the water");
  assert.equal(
    aloud(R.REPORT_LEAD, { lead: 11, stay: StayGiven.STAY_GIVEN_SHORT }),
    "Port cable is leading eleven o'clock, short stay",
  );
  assert.equal(aloud(R.REPORT_ANCHOR_AWEIGH), "Port anchor is aweigh");
  assert.equal(
    aloud(R.REPORT_ORDER_REPEATED, { order_code: C.BRIDGE_ORDER_HOLD_ON, value: 6 }),
    "Hold on port cable at six shackles in the pipe",
  );
});

test("every order and report has words of its own", () => {
  const codes = (all: object): number[] => Object.values(all).filter((value) => typeof value === "number");
  const orders = codes(C).map((code) =>
    orderAloud({ code, side: 0, value: 0, text: code === C.BRIDGE_ORDER_TEXT ? "x" : "" }),
  );
  const reports = codes(R)
    .filter((code) => code !== R.REPORT_ORDER_REPEATED)
    .map((code) => reportAloud({ ...bareReport(code, 0), text: code === R.REPORT_TEXT ? "x" : "" }));
  for (const all of [orders, reports]) {
    assert.ok(
      all.every((words) => /^[A-Z]/.test(words)),
      `${all}`,
    );
    assert.equal(new Set(all).size, all.length, `${all}`);
  }
});

test("a figure of cable is one place, on the page and in the voice: the mark in the pipe", () => {
  const codes = Object.values(C).filter(
    (code): code is BridgeOrderCode => typeof code === "number" && orderUnit(code)?.one === "shackle",
  );
  assert.equal(codes.length, 5);
  for (const code of codes) {
    assert.match(orderText(code, 0, 6), / 6 shackles in the pipe$/);
    assert.match(orderAloud({ code, side: 0, value: 6, text: "" }), / six shackles in the pipe$/);
    assert.match(orderText(code, 0, 1), / 1 shackle in the pipe$/);
  }
});
