// Orders of the bridge and reports of the forecastle, as they are written.

import { type BridgeOrder, BridgeOrderCode, BridgeOrderState } from "../wire/generated";
import type { Unit } from "./units";
import { orderRows, orderText, saidOf, unitOf } from "./words";

/** The server's words for an order that came by a hand signal. */
export const kByHand = "by hand signal";

/** What an order's figure counts; undefined where it has none. */
export const orderUnit = (code: BridgeOrderCode): Unit | undefined => unitOf(orderRows[code]?.unit);

/** Whether an order may be given without its figure. */
export const orderMayBeBare = (code: BridgeOrderCode): boolean =>
  orderUnit(code) === undefined || orderRows[code]?.said_bare !== undefined;

/** An order as it was written: "hold on port cable at 6 shackles in the pipe". */
export function written(order: Pick<BridgeOrder, "code" | "side" | "value" | "text">): string {
  if (order.code === BridgeOrderCode.BRIDGE_ORDER_TEXT) return order.text;
  return orderText(order.code, order.side, order.value) + (order.text ? `, ${order.text}` : "");
}

export const orderState = (state: BridgeOrderState): string => saidOf("BridgeOrderState", state);
/** What is said of an order's repeat; nothing of a question's, which there is none of. */
export const repeatState = (order: Pick<BridgeOrder, "code" | "state">): string =>
  isQuestion(order) && order.state === BridgeOrderState.ORDER_GIVEN ? "" : orderState(order.state);

/** Whether it still waits to be repeated back. */
export const isOpen = (order: BridgeOrder): boolean =>
  order.state !== BridgeOrderState.ORDER_REPEATED && order.state !== BridgeOrderState.ORDER_CANCELLED;
/** A question is answered by a report, and not repeated back. */
export const isQuestion = ({ code }: Pick<BridgeOrder, "code">): boolean => orderRows[code]?.repeat === 0;
