// What is said of an order's repeat: the server lets one repeat-back answer each time that the same order was given.

import assert from "node:assert/strict";
import { test } from "node:test";

import { repeatState } from "../../src/kit/orders";
import { type BridgeOrder, BridgeOrderCode, BridgeOrderState } from "../../src/wire/generated";

const { ORDER_REPEATED: repeated, ORDER_NOT_REPEATED: notRepeated } = BridgeOrderState;

const order = (number: number, more: Partial<BridgeOrder>): BridgeOrder =>
  ({
    number,
    run: 7,
    tick: 1800,
    code: BridgeOrderCode.BRIDGE_ORDER_HOLD_ON,
    side: 0,
    value: 3,
    text: "",
    state: repeated,
    ...more,
  }) as BridgeOrder;

const states = (orders: BridgeOrder[]): string[] => orders.map((each) => repeatState(each, orders));

test("of an order that was said again until it was repeated, only the last one was repeated", () => {
  const orders = [order(3, {}), order(4, { text: "I say again" }), order(5, { text: "I say again" })];
  assert.deepEqual(states(orders), ["not repeated, said again", "not repeated, said again", "repeated"]);
});

test("the same order once more after it was repeated, or another one, says nothing of its repeat", () => {
  const before = order(3, { tick: 600 });
  assert.deepEqual(states([before, order(4, {})]), ["repeated", "repeated"]);
  assert.deepEqual(states([before, order(4, { state: notRepeated })]), ["repeated", "not repeated in time"]);
  assert.deepEqual(states([order(3, {}), order(4, { value: 5 })]), ["repeated", "repeated"]);
});

test("an order in own words is the same behind other words too", () => {
  const text = (number: number, words: string) =>
    order(number, { code: BridgeOrderCode.BRIDGE_ORDER_TEXT, value: 0, text: words });
  assert.deepEqual(states([text(3, "ring the bell"), text(4, "I say again: ring the bell")]), [
    "not repeated, said again",
    "repeated",
  ]);
  assert.deepEqual(states([text(3, "ring the bell"), text(4, "stand clear")]), ["repeated", "repeated"]);
});
