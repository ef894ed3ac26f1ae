// The pages' words: of words.json alone, in the sentences that the server makes of them.

import assert from "node:assert/strict";
import { readFile, readdir } from "node:fs/promises";
import { join } from "node:path";
import { test } from "node:test";

import words from "../../../../words/words.json";
import { faultName, faults, machines } from "../../src/desk/fault_words";
import { isQuestion } from "../../src/kit/orders";
import { bareReport, orderText, orderWith, reportText, saidOf, stateSaid, withSide } from "../../src/kit/words";
import {
  AlertPriority,
  AnchorPhase,
  BridgeOrderCode,
  CableWeight,
  CriterionKind,
  CriterionState,
  FaultCode,
  Growing,
  LiningSeen,
  ReportCode,
  RunState,
  Soil,
} from "../../src/wire/generated";
import { root } from "../../tools/web.mjs";

const C = BridgeOrderCode;
const R = ReportCode;
const report = (code: ReportCode, more: object = {}): string => reportText({ ...bareReport(code, 0), ...more });

// The same as tests/words/sentences_test.cpp asks of the server's.
test("an order names its side, and its figure in its unit", () => {
  assert.equal(orderText(C.BRIDGE_ORDER_PAY_OUT, 0, 3), "pay out port cable to 3 shackles in the pipe");
  assert.equal(orderText(C.BRIDGE_ORDER_PAY_OUT, 0, 1), "pay out port cable to 1 shackle in the pipe");
  assert.equal(orderText(C.BRIDGE_ORDER_WALK_OUT, 1, 20), "walk out starboard anchor to 20 m");
  assert.equal(orderText(C.BRIDGE_ORDER_LET_GO, -1, 0), "let go both anchors");
  assert.equal(orderText(C.BRIDGE_ORDER_GEAR_IN, -1, 0), "put both windlasses in gear");
  assert.equal(orderText(C.BRIDGE_ORDER_HOLD_ON, 1, 0), "hold on starboard cable");
  assert.equal(orderText(C.BRIDGE_ORDER_HOW_MUCH, 0, 0), "how much port cable is out?");
  assert.equal(orderText(C.BRIDGE_ORDER_HOW_MUCH, -1, 0), "how much cable is out?");
});

test("what is added to a question is a sentence of its own", () => {
  assert.equal(orderWith("let go port anchor", "I say again"), "let go port anchor, I say again");
  assert.equal(
    orderWith("how much cable is out?", "this is my last call"),
    "how much cable is out? This is my last call",
  );
  assert.equal(orderWith("how much cable is out?", ""), "how much cable is out?");
});

test("a report says all that was given, and nothing else", () => {
  assert.equal(report(R.REPORT_SHACKLES_ON_DECK, { value: 3 }), "3 shackles on deck");
  assert.equal(report(R.REPORT_TURNS, { value: 1 }), "1 turn in port cable");
  assert.equal(report(R.REPORT_ANCHOR_AWEIGH, { side: -1 }), "anchor is aweigh");
  assert.equal(report(R.REPORT_ANCHOR_READY), "port anchor is ready");
  assert.equal(report(R.REPORT_LEAD), "port cable is leading");
  assert.equal(report(R.REPORT_LEAD, { lead: 11, stay: 2 }), "port cable is leading 11 o'clock, short stay");
  assert.equal(
    report(R.REPORT_WEIGHT, { weight: CableWeight.WEIGHT_TOO_MUCH, text: "stop" }),
    "too much weight on port cable, stop",
  );
  assert.equal(
    report(R.REPORT_BROUGHT_UP, { lead: 12, growing: Growing.GROWING_SLACK }),
    "she is brought up, 12 o'clock, slack",
  );
  assert.equal(
    report(R.REPORT_ORDER_REPEATED, { side: -1, order_code: C.BRIDGE_ORDER_LET_GO }),
    "repeats: let go both anchors",
  );
  assert.equal(report(R.REPORT_ORDER_REPEATED), "repeats: the order");
  assert.equal(report(R.REPORT_ORDER_REPEATED, { text: "ring the bell" }), "repeats: ring the bell");
  assert.equal(report(R.REPORT_TEXT, { text: "all well" }), "all well");
  assert.equal(report(R.REPORT_UNSAFE), "unsafe");
  assert.equal(
    report(R.REPORT_UNSAFE, { order_code: C.BRIDGE_ORDER_HOLD_ON, value: 4, text: "the wind rises" }),
    "unsafe: I propose to hold on port cable at 4 shackles in the pipe, the wind rises",
  );
});

test("a side stands before a sentence that does not name it", () => {
  assert.equal(withSide(0, "reported: 3 shackles on deck"), "port: reported: 3 shackles on deck");
  assert.equal(withSide(1, "starboard anchor is aweigh"), "starboard anchor is aweigh");
  assert.equal(withSide(-1, "stand clear"), "stand clear");
});

test("an enumerator finds its row", () => {
  assert.equal(saidOf("RunState", RunState.RUN_STOPPED_BY_FAULT), "stopped by a fault");
  assert.equal(saidOf("AlertPriority", AlertPriority.ALERT_EMERGENCY), "emergency");
  assert.equal(saidOf("AnchorPhase", AnchorPhase.ANCHOR_ON_BOTTOM), "on the bottom");
  assert.equal(saidOf("CriterionState", CriterionState.CRITERION_NOT_MET), "not met");
  assert.equal(saidOf("LiningSeen", LiningSeen.LINING_SMOKES), "brake lining smokes");
  assert.equal(saidOf("Soil", Soil.SOIL_MIXED), "mixed");
  assert.equal(saidOf("Soil", 99), "");
  assert.equal(faultName(FaultCode.FAULT_CCTV_LOST), "CCTV lost");
});

test("the desk lists every fault", () => {
  const lost = faults.filter(({ machine }) => !machines.includes(machine));
  assert.deepEqual(lost, []);
});

test("no page has a sentence of its own that words.json has", async () => {
  /** Of all columns that people read, what is more than a word: "up and down". */
  const sentences = new Set<string>();
  const collect = (value: unknown): void => {
    if (typeof value === "string") {
      if (value.includes(" ") && !value.includes("{")) sentences.add(value.toLowerCase());
    } else if (value !== null && typeof value === "object")
      for (const [name, inner] of Object.entries(value)) if (name !== "machine" && name !== "about") collect(inner);
  };
  collect(words);
  assert.ok(sentences.has("up and down") && sentences.has("load at the gypsy from"));
  // Of something else, by the same name: a camera's place, cable that lies there.
  const others = ["desk/scene_view.ts: Under water", "desk/truth.ts: on the bottom"];
  const folder = join(root, "station/web/src");
  const found: string[] = [];
  for (const file of await readdir(folder, { recursive: true })) {
    if (!file.endsWith(".ts")) continue;
    const code = (await readFile(join(folder, file), "utf8")).replace(/\/\/.*|\/\*[^]*?\*\//g, "");
    for (const [, text] of code.matchAll(/["`]([^"`\n]+)["`]/g))
      if (sentences.has(text!.toLowerCase())) found.push(`${file}: ${text}`);
  }
  assert.deepEqual(found.sort(), others.sort());
});

test("what an assessor has not judged is not judged; what a machine never saw is not shown", () => {
  const state = CriterionState.CRITERION_NOT_IN_PLAY;
  assert.equal(stateSaid({ state, kind: CriterionKind.CRITERION_RUBRIC }), "not judged");
  assert.equal(stateSaid({ state, kind: CriterionKind.CRITERION_LIMIT }), "not shown");
  assert.equal(stateSaid({ state: CriterionState.CRITERION_MET, kind: CriterionKind.CRITERION_RUBRIC }), "met");
});

test("a question is answered, not repeated back; an order is repeated", () => {
  const isAsked = (code: BridgeOrderCode) => isQuestion({ code });
  assert.ok(isAsked(C.BRIDGE_ORDER_HOW_LEADING));
  assert.ok(isAsked(C.BRIDGE_ORDER_BROUGHT_UP));
  assert.ok(!isAsked(C.BRIDGE_ORDER_LET_GO));
  assert.ok(!isAsked(C.BRIDGE_ORDER_TEXT));
});
