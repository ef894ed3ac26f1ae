// Orders of the bridge and reports of the forecastle, as they are written.

import { type BridgeOrder, BridgeOrderCode, BridgeOrderState } from "../wire/generated";
import type { Unit } from "./units";
import { orderRows, orderText, orderWith, saidOf, unitOf } from "./words";
import { t } from "./language";

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
  return orderWith(orderText(order.code, order.side, order.value), order.text);
}

/** The same order, also where the bridge put "I say again" before it; one in own words is told by these. */
const isSame = (one: BridgeOrder, other: BridgeOrder): boolean =>
  one.code === other.code &&
  one.side === other.side &&
  one.value === other.value &&
  (one.code !== BridgeOrderCode.BRIDGE_ORDER_TEXT || one.text.endsWith(other.text) || other.text.endsWith(one.text));

/** Nobody had repeated it when it was given again: what answers that one answers both, at the same tick. */
export const wasSaidAgain = (order: BridgeOrder, all: readonly BridgeOrder[]): boolean =>
  order.state === BridgeOrderState.ORDER_REPEATED &&
  all.some(
    (other) =>
      other.number > order.number &&
      other.run === order.run &&
      other.state === order.state &&
      other.tick === order.tick &&
      isSame(order, other),
  );

/** all: orders that it was given among. */
export const orderState = (order: BridgeOrder, all: readonly BridgeOrder[]): string =>
  wasSaidAgain(order, all) ? t("not repeated, said again") : saidOf("BridgeOrderState", order.state);
/** What is said of an order's repeat; nothing of a question's, which there is none of. */
export const repeatState = (order: BridgeOrder, all: readonly BridgeOrder[]): string =>
  isQuestion(order) && order.state === BridgeOrderState.ORDER_GIVEN ? "" : orderState(order, all);

/** Whether it still waits to be repeated back. */
export const isOpen = (order: BridgeOrder): boolean =>
  order.state !== BridgeOrderState.ORDER_REPEATED && order.state !== BridgeOrderState.ORDER_CANCELLED;
/** A question is answered by a report, and not repeated back. */
export const isQuestion = ({ code }: Pick<BridgeOrder, "code">): boolean => orderRows[code]?.repeat === 0;
