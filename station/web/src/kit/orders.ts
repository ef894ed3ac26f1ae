// Orders of the bridge and reports of the forecastle, in the words of the trade.

import {
  type BridgeOrder,
  BridgeOrderCode,
  BridgeOrderState,
  type Report,
  ReportCode,
  CableWeight,
  Growing,
  StayGiven,
} from "../wire/generated";
import { figure, sideName } from "./units";

interface OrderWords {
  said: string;
  /** Of its figure; undefined: it has none. */
  unit?: "shackles" | "m";
  /** Before the figure: "at", "to". */
  before?: string;
  /** Also given without its figure. */
  bareToo?: boolean;
}

/** The server's words for an order that came by a hand signal. */
export const kByHand = "by hand signal";

const orders: Record<BridgeOrderCode, OrderWords> = {
  [BridgeOrderCode.BRIDGE_ORDER_TEXT]: { said: "" },
  [BridgeOrderCode.BRIDGE_ORDER_STAND_BY]: { said: "stand by" },
  [BridgeOrderCode.BRIDGE_ORDER_CLEAR_AWAY]: { said: "clear away" },
  [BridgeOrderCode.BRIDGE_ORDER_WALK_OUT]: { said: "walk out", unit: "m", before: "to" },
  [BridgeOrderCode.BRIDGE_ORDER_LET_GO]: { said: "let go" },
  [BridgeOrderCode.BRIDGE_ORDER_PAY_OUT]: { said: "pay out", unit: "shackles", before: "to" },
  [BridgeOrderCode.BRIDGE_ORDER_VEER]: { said: "veer", unit: "shackles", before: "to" },
  [BridgeOrderCode.BRIDGE_ORDER_CHECK]: { said: "check" },
  [BridgeOrderCode.BRIDGE_ORDER_HOLD_ON]: { said: "hold on", unit: "shackles", before: "at", bareToo: true },
  [BridgeOrderCode.BRIDGE_ORDER_WALK_BACK]: { said: "walk back", unit: "shackles", before: "to", bareToo: true },
  [BridgeOrderCode.BRIDGE_ORDER_GEAR_IN]: { said: "put in gear" },
  [BridgeOrderCode.BRIDGE_ORDER_GEAR_OUT]: { said: "gear out" },
  [BridgeOrderCode.BRIDGE_ORDER_HEAVE]: { said: "heave up" },
  [BridgeOrderCode.BRIDGE_ORDER_HEAVE_TO]: { said: "heave", unit: "shackles", before: "to" },
  [BridgeOrderCode.BRIDGE_ORDER_STOP_HEAVING]: { said: "stop heaving" },
  [BridgeOrderCode.BRIDGE_ORDER_SECURE]: { said: "secure" },
  [BridgeOrderCode.BRIDGE_ORDER_HOW_MUCH]: { said: "how much is out?" },
  [BridgeOrderCode.BRIDGE_ORDER_HOW_LEADING]: { said: "how does the cable lead?" },
  [BridgeOrderCode.BRIDGE_ORDER_HOW_GROWING]: { said: "how does the cable grow?" },
  [BridgeOrderCode.BRIDGE_ORDER_HOW_MUCH_WEIGHT]: { said: "how much weight is on it?" },
  [BridgeOrderCode.BRIDGE_ORDER_BROUGHT_UP]: { said: "brought up?" },
  [BridgeOrderCode.BRIDGE_ORDER_STAND_CLEAR]: { said: "stand clear" },
  [BridgeOrderCode.BRIDGE_ORDER_CANCEL]: { said: "belay the last order" },
};

/** The unit of an order's figure; undefined where it has none. */
export const orderUnit = (code: BridgeOrderCode): "shackles" | "m" | undefined => orders[code].unit;

/** Whether an order may be given without its figure. */
export const orderMayBeBare = (code: BridgeOrderCode): boolean =>
  orders[code].unit === undefined || orders[code].bareToo === true;

const trimmed = (value: number): string => figure(value, Number.isInteger(value) ? 0 : 1);

/** "port: hold on at 6 shackles in the pipe". side -1: both. */
export function orderWords(code: BridgeOrderCode, side: number, value: number): string {
  const { said, unit, before, bareToo } = orders[code];
  const text = `${sideName(side)}: ${said}`;
  if (!unit || (bareToo && value === 0)) return text;
  const what = unit === "m" ? "m" : `${value === 1 ? "shackle" : "shackles"} in the pipe`;
  return `${text} ${before} ${trimmed(value)} ${what}`;
}

/** An order as it was spoken. */
export function spoken(order: BridgeOrder): string {
  if (order.code === BridgeOrderCode.BRIDGE_ORDER_TEXT) return order.text;
  return orderWords(order.code, order.side, order.value) + (order.text ? `, ${order.text}` : "");
}

export const orderStates: Record<BridgeOrderState, string> = {
  [BridgeOrderState.ORDER_GIVEN]: "not yet repeated",
  [BridgeOrderState.ORDER_REPEATED]: "repeated",
  [BridgeOrderState.ORDER_MISREPEATED]: "repeated wrongly",
  [BridgeOrderState.ORDER_NOT_REPEATED]: "late: not repeated",
  [BridgeOrderState.ORDER_CANCELLED]: "cancelled",
};

/** Whether it still waits to be repeated back. */
export const isOpen = (order: BridgeOrder): boolean =>
  order.state !== BridgeOrderState.ORDER_REPEATED && order.state !== BridgeOrderState.ORDER_CANCELLED;

export const stays: Record<StayGiven, string> = {
  [StayGiven.STAY_NOT_GIVEN]: "",
  [StayGiven.STAY_GIVEN_UP_AND_DOWN]: "up and down",
  [StayGiven.STAY_GIVEN_SHORT]: "short stay",
  [StayGiven.STAY_GIVEN_MEDIUM]: "medium stay",
  [StayGiven.STAY_GIVEN_LONG]: "long stay",
};
export const growings: Record<Growing, string> = {
  [Growing.GROWING_NOT_GIVEN]: "",
  [Growing.GROWING_SLACK]: "slack",
  [Growing.GROWING_GROWING]: "growing",
  [Growing.GROWING_TIGHT]: "tight",
};
export const weights: Record<CableWeight, string> = {
  [CableWeight.WEIGHT_NOT_GIVEN]: "",
  [CableWeight.WEIGHT_NONE]: "no weight",
  [CableWeight.WEIGHT_MODERATE]: "moderate weight",
  [CableWeight.WEIGHT_MUCH]: "much weight",
  [CableWeight.WEIGHT_TOO_MUCH]: "too much weight",
};

export const reports: Record<ReportCode, string> = {
  [ReportCode.REPORT_TEXT]: "own words",
  [ReportCode.REPORT_STANDING_BY]: "standing by",
  [ReportCode.REPORT_ANCHOR_READY]: "anchor ready",
  [ReportCode.REPORT_LET_GO]: "let go",
  [ReportCode.REPORT_SHACKLES_ON_DECK]: "shackles on deck",
  [ReportCode.REPORT_SHACKLES_IN_WATER]: "shackles in the water",
  [ReportCode.REPORT_LEAD]: "cable leads",
  [ReportCode.REPORT_BROUGHT_UP]: "brought up",
  [ReportCode.REPORT_HEAVING]: "heaving",
  [ReportCode.REPORT_SHORT_STAY]: "short stay",
  [ReportCode.REPORT_UP_AND_DOWN]: "up and down",
  [ReportCode.REPORT_ANCHOR_AWEIGH]: "anchor aweigh",
  [ReportCode.REPORT_CLEAR_ANCHOR]: "clear anchor",
  [ReportCode.REPORT_FOUL_ANCHOR]: "foul anchor",
  [ReportCode.REPORT_ANCHOR_HOME]: "anchor home",
  [ReportCode.REPORT_DRAGGING]: "dragging",
  [ReportCode.REPORT_ORDER_REPEATED]: "repeats",
  [ReportCode.REPORT_ON_THE_BOTTOM]: "on the bottom",
  [ReportCode.REPORT_SHACKLES_IN_PIPE]: "shackles in the pipe",
  [ReportCode.REPORT_GROWING]: "cable is",
  [ReportCode.REPORT_WEIGHT]: "weight on the cable",
  [ReportCode.REPORT_TURNS]: "turns in the cable",
  [ReportCode.REPORT_SECURED]: "secured",
  [ReportCode.REPORT_DOES_NOT_RUN]: "cable does not run",
  [ReportCode.REPORT_BRAKE_DOES_NOT_HOLD]: "brake does not hold",
  [ReportCode.REPORT_NO_POWER]: "no power",
  [ReportCode.REPORT_STAND_CLEAR]: "stand clear",
  [ReportCode.REPORT_DEFECT]: "defect",
};

/** A report as it was spoken: "3 shackles in the water", "cable leads 11 o'clock, short stay". */
export function reportWords(report: Omit<Report, "origin">): string {
  const { code, value } = report;
  if (code === ReportCode.REPORT_TEXT) return report.text;
  if (code === ReportCode.REPORT_ORDER_REPEATED) return `repeats: ${orderWords(report.order_code, report.side, value)}`;
  const counts =
    code === ReportCode.REPORT_SHACKLES_IN_PIPE ||
    code === ReportCode.REPORT_SHACKLES_IN_WATER ||
    code === ReportCode.REPORT_SHACKLES_ON_DECK ||
    code === ReportCode.REPORT_TURNS;
  const said = counts
    ? `${trimmed(value)} ${value === 1 ? reports[code].replace("shackles", "shackle") : reports[code]}`
    : reports[code];
  return [
    said,
    report.lead ? `${report.lead} o'clock` : "",
    stays[report.stay],
    growings[report.growing],
    weights[report.weight],
    report.text,
  ]
    .filter(Boolean)
    .join(", ");
}
