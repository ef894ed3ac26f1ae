// Which orders are done with, as far as those who speak and hear know: a question that was answered, an order that was
// reported carried out, and one in whose place another was given. The server lets any be cancelled; a page offers it
// of the others.

import { type BridgeOrder, BridgeOrderCode, BridgeOrderState, ReportCode, type SeatEvent } from "../wire/generated";
import { isOpen, isQuestion } from "./orders";
import { allSaid, bareReport, figureText, orderRows, reportRows, reportText, spoken } from "./words";

const O = BridgeOrderCode;
const R = ReportCode;

/** A line of the log, as far as it may tell of a report. */
export type ReportLine = Pick<SeatEvent, "code" | "side" | "time" | "text">;
type Order = Pick<BridgeOrder, "number" | "code" | "side" | "value" | "time" | "state">;

const kShackles = [R.REPORT_SHACKLES_ON_DECK, R.REPORT_SHACKLES_IN_WATER, R.REPORT_SHACKLES_IN_PIPE];
/** By which report a question is answered, or an order carried out; of a length in shackles, with its figure. */
export const reportsOf: Partial<Record<BridgeOrderCode, readonly ReportCode[]>> = {
  [O.BRIDGE_ORDER_HOW_MUCH]: kShackles,
  [O.BRIDGE_ORDER_HOW_LEADING]: [R.REPORT_LEAD, R.REPORT_SHORT_STAY, R.REPORT_UP_AND_DOWN],
  [O.BRIDGE_ORDER_HOW_GROWING]: [R.REPORT_GROWING],
  [O.BRIDGE_ORDER_HOW_MUCH_WEIGHT]: [R.REPORT_WEIGHT],
  [O.BRIDGE_ORDER_BROUGHT_UP]: [R.REPORT_BROUGHT_UP, R.REPORT_GROWING, R.REPORT_DRAGGING, R.REPORT_LEAD],
  [O.BRIDGE_ORDER_STAND_BY]: [R.REPORT_STANDING_BY, R.REPORT_ANCHOR_READY],
  [O.BRIDGE_ORDER_CLEAR_AWAY]: [R.REPORT_STANDING_BY, R.REPORT_ANCHOR_READY],
  [O.BRIDGE_ORDER_GEAR_IN]: [R.REPORT_STANDING_BY, R.REPORT_ANCHOR_READY],
  [O.BRIDGE_ORDER_WALK_OUT]: [R.REPORT_STANDING_BY, R.REPORT_ANCHOR_READY, ...kShackles],
  [O.BRIDGE_ORDER_LET_GO]: [R.REPORT_LET_GO, R.REPORT_ON_THE_BOTTOM],
  [O.BRIDGE_ORDER_PAY_OUT]: kShackles,
  [O.BRIDGE_ORDER_VEER]: kShackles,
  [O.BRIDGE_ORDER_WALK_BACK]: kShackles,
  [O.BRIDGE_ORDER_HOLD_ON]: kShackles,
  [O.BRIDGE_ORDER_HEAVE_TO]: kShackles,
  [O.BRIDGE_ORDER_HEAVE]: [R.REPORT_ANCHOR_HOME], // shackles, stays and "aweigh" are told on the way there
  [O.BRIDGE_ORDER_SECURE]: [R.REPORT_SECURED],
  [O.BRIDGE_ORDER_BUOY_CABLE]: [R.REPORT_READY_TO_SLIP],
  [O.BRIDGE_ORDER_SLIP]: [R.REPORT_SLIPPED],
  [O.BRIDGE_ORDER_CLEAR_ANCHOR]: [R.REPORT_CLEAR_ANCHOR],
};

const kPreparing = new Set([O.BRIDGE_ORDER_STAND_BY, O.BRIDGE_ORDER_CLEAR_AWAY]);
/** What the cable is to do: the last one counts. */
const kCable = new Set([
  O.BRIDGE_ORDER_WALK_OUT,
  O.BRIDGE_ORDER_LET_GO,
  O.BRIDGE_ORDER_PAY_OUT,
  O.BRIDGE_ORDER_VEER,
  O.BRIDGE_ORDER_CHECK,
  O.BRIDGE_ORDER_HOLD_ON,
  O.BRIDGE_ORDER_WALK_BACK,
  O.BRIDGE_ORDER_HEAVE,
  O.BRIDGE_ORDER_HEAVE_TO,
  O.BRIDGE_ORDER_STOP_HEAVING,
  O.BRIDGE_ORDER_SECURE,
  O.BRIDGE_ORDER_SLIP,
]);
const kGear = new Set([O.BRIDGE_ORDER_GEAR_IN, O.BRIDGE_ORDER_GEAR_OUT]);

/** Whether an order takes the place of an earlier one. */
function replaces(later: BridgeOrderCode, earlier: BridgeOrderCode): boolean {
  if (later === earlier) return later !== O.BRIDGE_ORDER_TEXT;
  if (kGear.has(later)) return kGear.has(earlier);
  return kCable.has(later) && (kCable.has(earlier) || kPreparing.has(earlier));
}

/** Whether one is of the other's windlass; -1: both. */
const isOf = (one: number, other: number): boolean => one === other || one === -1 || other === -1;

const made = new Map<string, string[]>(); // of what is asked anew of each line at each change

/** All beginnings of what a report may say; figure: the one that it must have, else a "\0" stands for it. */
function sentences(code: ReportCode, side: number, figure: number | undefined): string[] {
  const name = `${code} ${side} ${figure}`;
  const known = made.get(name) ?? makeSentences(code, side, figure);
  made.set(name, known);
  return known;
}
function makeSentences(code: ReportCode, side: number, figure: number | undefined): string[] {
  const bare = { ...bareReport(code, side), value: figure ?? 1 };
  const say = (more: object): string =>
    reportText({ ...bare, ...more }, (value, unit) => (figure === undefined ? "\0" : figureText(value, unit)));
  const each = (of: "StayGiven" | "Growing" | "CableWeight", field: string): string[] =>
    allSaid(of).map((_, choice) => say({ [field]: choice }));
  if (code === R.REPORT_LEAD) return each("StayGiven", "stay");
  if (code === R.REPORT_GROWING) return each("Growing", "growing");
  return code === R.REPORT_WEIGHT ? each("CableWeight", "weight") : [say({})];
}

/** Whether the words of a report are those of that one. */
function says(words: string, code: ReportCode, side: number, figure: number | undefined): boolean {
  return sentences(code, side, figure).some((sentence) => {
    const [before, after] = sentence.split("\0");
    if (after === undefined) return words.startsWith(sentence);
    return words.startsWith(before!) && /^[\d.]+ \w+$/.test(words.slice(before!.length).split(after)[0]!);
  });
}

/** Whether a report answers a question, or says that an order is carried out. log: lines that count. */
export function isAnswered(order: Order, log: readonly ReportLine[]): boolean {
  const codes = reportsOf[order.code];
  if (!codes) return false;
  const { unit } = orderRows[order.code] ?? {};
  return log.some(({ code: line, side, time, text }) => {
    if (line !== "report.made" || time < order.time || !isOf(side, order.side)) return false;
    const words = spoken(text);
    return codes.some((code) => {
      // An anchor is walked out to metres, and whatever is reported of its shackles is of that.
      const asked = unit && reportRows[code]?.unit === unit ? order.value : undefined;
      return says(words, code, side, asked);
    });
  });
}

/** Whether it makes sense to cancel it. all: orders that it was given among; log: lines that count. */
export function canBeCancelled(order: Order, all: readonly Order[], log: readonly ReportLine[]): boolean {
  if (order.state === BridgeOrderState.ORDER_CANCELLED || order.code === O.BRIDGE_ORDER_CANCEL) return false;
  const replaced = all.some(
    ({ number, state, code, side }) =>
      number > order.number &&
      state !== BridgeOrderState.ORDER_CANCELLED &&
      isOf(side, order.side) &&
      replaces(code, order.code),
  );
  return !replaced && !isAnswered(order, log);
}

/**
 * Whether a question waits for its answer or an order is in force; one that no report ends is until the next is given.
 * all: orders that it was given among; log: lines that count.
 */
export function isInForce(order: Order, all: readonly Order[], log: readonly ReportLine[]): boolean {
  if (!canBeCancelled(order, all, log)) return false;
  const next = (other: Order): boolean =>
    other.number > order.number && isOf(other.side, order.side) && !isQuestion(other);
  return reportsOf[order.code] !== undefined || !all.some(next);
}

/**
 * The newest order that waits for a word of the forecastle's: to be repeated back or, a question that is the newest of
 * all, to be answered. orders: of a run, by their numbers; log: lines that count; isOfBefore: of questions that were
 * asked before the exercise was gone on with here.
 */
export const waitsForWord = (
  orders: readonly BridgeOrder[],
  log: readonly ReportLine[],
  isOfBefore: (question: BridgeOrder) => boolean,
): BridgeOrder | undefined =>
  [...orders]
    .reverse()
    .find(
      (order, place) =>
        isOpen(order) && (!isQuestion(order) || (place === 0 && !isOfBefore(order) && !isAnswered(order, log))),
    );
