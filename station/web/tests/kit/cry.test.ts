// "Stand clear" as the log has it, by whoever cried.

import assert from "node:assert/strict";
import { test } from "node:test";

import { Cry, isStandClear } from "../../src/kit/cry";
import { bareReport, orderText, reportText } from "../../src/kit/words";
import { BridgeOrderCode, ReportCode, type SeatEvent } from "../../src/wire/generated";

const ordered = (code: BridgeOrderCode, side: number): Pick<SeatEvent, "code" | "side" | "text"> => ({
  code: "order.given",
  side,
  text: `order 3 given: ${orderText(code, side, 0)}`,
});
const reported = (code: ReportCode, side: number): Pick<SeatEvent, "code" | "side" | "text"> => ({
  code: "report.made",
  side,
  text: reportText(bareReport(code, side)),
});

test("an order and a report to stand clear are one, of either cable; others are not", () => {
  for (const side of [0, 1, -1]) {
    assert.ok(isStandClear(ordered(BridgeOrderCode.BRIDGE_ORDER_STAND_CLEAR, side)));
    assert.ok(isStandClear(reported(ReportCode.REPORT_STAND_CLEAR, side)));
    assert.ok(!isStandClear(ordered(BridgeOrderCode.BRIDGE_ORDER_SLIP, side)));
    assert.ok(!isStandClear(reported(ReportCode.REPORT_CLEAR_ANCHOR, side)));
  }
  const repeated = { ...ordered(BridgeOrderCode.BRIDGE_ORDER_STAND_CLEAR, 0), code: "order.repeated" };
  assert.ok(!isStandClear(repeated));
});

test("a cry of a branch that was left is forgotten", () => {
  let tell: (event: SeatEvent) => void = () => {};
  const link = {
    on: (_: string, listener: (event: never) => void) => (tell = listener as typeof tell),
    onState: () => {},
  };
  const cry = new Cry(link as unknown as ConstructorParameters<typeof Cry>[0], "forecastle");
  tell({ ...reported(ReportCode.REPORT_STAND_CLEAR, 0), time: 40 } as SeatEvent);
  assert.equal(cry.time, 40);
  tell({ code: "exercise.restored", side: -1, text: "", time: 50 } as SeatEvent);
  assert.equal(cry.time, 40);
  tell({ code: "exercise.restored", side: -1, text: "", time: 20 } as SeatEvent);
  assert.equal(cry.time, undefined);
});

test("each seat hears it by its own log", () => {
  const heard: string[] = [];
  const link = { on: (topic: string) => heard.push(topic), onState: () => {} };
  for (const seat of ["forecastle", "bridge"] as const)
    new Cry(link as unknown as ConstructorParameters<typeof Cry>[0], seat);
  assert.deepEqual(heard, ["ForecastleEvent", "BridgeEvent"]);
});
