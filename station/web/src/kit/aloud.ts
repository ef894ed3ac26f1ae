// Orders and reports as they are spoken aloud: words.json's sentences, which follow the IMO's Standard Marine
// Communication Phrases (A.918(22), on-board phrases for anchoring) where they have the phrase, with figures in words.

import type { BridgeOrder, Report } from "../wire/generated";
import { type FigureText, capital, orderText, orderWith, reportText } from "./words";

const kNumbers = "zero one two three four five six seven eight nine ten eleven twelve".split(" ");

/** "six", "one and a half"; figures beyond twelve, and broken ones, stay figures. */
export function inWords(value: number): string {
  const whole = Math.floor(value);
  const name = kNumbers[whole];
  if (value === 0.5) return "a half";
  if (name === undefined || (value !== whole && value !== whole + 0.5)) return `${value}`;
  return value === whole ? name : `${name} and a half`;
}

const figureAloud: FigureText = (value, { one, many }) =>
  `${inWords(value)} ${value === 1 || value === 0.5 ? one : many}`;

/** "Let go port anchor"; "Hold on port cable at six shackles in the pipe". Words that the bridge added follow. */
export function orderAloud(order: Pick<BridgeOrder, "code" | "side" | "value" | "text">): string {
  return capital(orderWith(orderText(order.code, order.side, order.value, figureAloud), order.text));
}

/** "Three shackles in the water"; "Port cable is leading eleven o'clock, short stay". */
export const reportAloud = (report: Omit<Report, "origin">): string =>
  capital(reportText(report, figureAloud, inWords));
