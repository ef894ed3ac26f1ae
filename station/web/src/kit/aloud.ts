// Orders and reports as they are spoken aloud: in the words of the IMO's Standard Marine Communication Phrases
// (A.918(22), on-board phrases for anchoring) where they have the phrase.

import { type BridgeOrder, BridgeOrderCode, CableWeight, Growing, type Report, ReportCode } from "../wire/generated";
import { stays } from "./orders";

const C = BridgeOrderCode;
const R = ReportCode;
const kNumbers = "zero one two three four five six seven eight nine ten eleven twelve".split(" ");

/** "six", "one and a half"; figures beyond twelve, and broken ones, stay figures. */
export function inWords(value: number): string {
  const whole = Math.floor(value);
  const name = kNumbers[whole];
  if (value === 0.5) return "a half";
  if (name === undefined || (value !== whole && value !== whole + 0.5)) return `${value}`;
  return value === whole ? name : `${name} and a half`;
}

const names = (side: number): string => (side === 0 ? "port " : side === 1 ? "starboard " : "");
const anchor = (side: number): string => (side < 0 ? "both anchors" : `${names(side)}anchor`);
const cable = (side: number): string => (side < 0 ? "both cables" : `${names(side)}cable`);
const sentence = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1);
const shackles = (value: number): string =>
  `${inWords(value)} ${value === 1 || value === 0.5 ? "shackle" : "shackles"}`;
/** Of an order: where its figure is meant, as the pages write it. */
const inThePipe = (value: number): string => `${shackles(value)} in the pipe`;

type Phrase = (side: number, value: number) => string;
const orders: Record<BridgeOrderCode, Phrase> = {
  [C.BRIDGE_ORDER_TEXT]: () => "",
  [C.BRIDGE_ORDER_STAND_BY]: (side) => `stand by ${anchor(side)}`,
  [C.BRIDGE_ORDER_CLEAR_AWAY]: (side) => `clear away ${anchor(side)}`,
  [C.BRIDGE_ORDER_WALK_OUT]: (side, value) => `walk out ${anchor(side)} to ${inWords(value)} metres`,
  [C.BRIDGE_ORDER_LET_GO]: (side) => `let go ${anchor(side)}`,
  [C.BRIDGE_ORDER_PAY_OUT]: (side, value) => `pay out ${cable(side)} to ${inThePipe(value)}`,
  [C.BRIDGE_ORDER_VEER]: (side, value) => `veer ${cable(side)} to ${inThePipe(value)}`,
  [C.BRIDGE_ORDER_CHECK]: (side) => `check ${cable(side)}`,
  [C.BRIDGE_ORDER_HOLD_ON]: (side, value) =>
    value === 0 ? `hold on ${cable(side)}` : `hold on ${names(side)}at ${inThePipe(value)}`,
  [C.BRIDGE_ORDER_WALK_BACK]: (side, value) =>
    `walk back ${anchor(side)}${value === 0 ? "" : ` to ${inThePipe(value)}`}`,
  [C.BRIDGE_ORDER_GEAR_IN]: (side) => `put ${names(side)}windlass in gear`,
  [C.BRIDGE_ORDER_GEAR_OUT]: (side) => `put ${names(side)}windlass out of gear`,
  [C.BRIDGE_ORDER_HEAVE]: (side) => `heave up ${anchor(side)}`,
  [C.BRIDGE_ORDER_HEAVE_TO]: (side, value) => `heave ${cable(side)} to ${inThePipe(value)}`,
  [C.BRIDGE_ORDER_STOP_HEAVING]: (side) => (side < 0 ? "stop heaving" : `stop heaving ${cable(side)}`),
  [C.BRIDGE_ORDER_SECURE]: (side) => `secure ${anchor(side)}`,
  [C.BRIDGE_ORDER_HOW_MUCH]: (side) => `how much ${names(side)}cable is out?`,
  [C.BRIDGE_ORDER_HOW_LEADING]: (side) => `how is the ${names(side)}cable leading?`,
  [C.BRIDGE_ORDER_HOW_GROWING]: (side) => `how is the ${names(side)}cable growing?`,
  [C.BRIDGE_ORDER_HOW_MUCH_WEIGHT]: (side) => `how much weight is on the ${names(side)}cable?`,
  [C.BRIDGE_ORDER_BROUGHT_UP]: () => "is she brought up?",
  [C.BRIDGE_ORDER_STAND_CLEAR]: (side) => `stand clear of the ${names(side)}cable`,
  [C.BRIDGE_ORDER_CANCEL]: () => "belay the last order",
};

/** "Let go port anchor"; "Hold on port at six shackles in the pipe". Words that the bridge added follow. */
export function orderAloud(order: Pick<BridgeOrder, "code" | "side" | "value" | "text">): string {
  return sentence([orders[order.code](order.side, order.value), order.text].filter(Boolean).join(", "));
}

const growing: Record<Growing, string> = {
  [Growing.GROWING_NOT_GIVEN]: "growing",
  [Growing.GROWING_SLACK]: "slack",
  [Growing.GROWING_GROWING]: "growing",
  [Growing.GROWING_TIGHT]: "tight",
};
const weight: Record<CableWeight, string> = {
  [CableWeight.WEIGHT_NOT_GIVEN]: "weight",
  [CableWeight.WEIGHT_NONE]: "no weight",
  [CableWeight.WEIGHT_MODERATE]: "moderate weight",
  [CableWeight.WEIGHT_MUCH]: "much weight",
  [CableWeight.WEIGHT_TOO_MUCH]: "too much weight",
};

function lead({ side, lead, stay }: Spoken): string {
  const how = [lead ? `leading ${inWords(lead)} o'clock` : "", stays[stay]].filter(Boolean).join(", ");
  return `${names(side)}cable is ${how || "leading"}`;
}

type Spoken = Omit<Report, "origin">;
const reports: Record<ReportCode, (report: Spoken) => string> = {
  [R.REPORT_TEXT]: () => "",
  [R.REPORT_STANDING_BY]: ({ side }) => `standing by ${names(side)}anchor`,
  [R.REPORT_ANCHOR_READY]: ({ side }) => `${names(side)}anchor is ready for letting go`,
  [R.REPORT_LET_GO]: ({ side }) => `${names(side)}anchor is let go`,
  [R.REPORT_SHACKLES_ON_DECK]: ({ value }) => `${shackles(value)} on deck`,
  [R.REPORT_SHACKLES_IN_WATER]: ({ value }) => `${shackles(value)} in the water`,
  [R.REPORT_LEAD]: lead,
  [R.REPORT_BROUGHT_UP]: () => "she is brought up",
  [R.REPORT_HEAVING]: ({ side }) => `heaving ${names(side)}cable`,
  [R.REPORT_SHORT_STAY]: ({ side }) => `${names(side)}cable is at short stay`,
  [R.REPORT_UP_AND_DOWN]: ({ side }) => `${names(side)}cable is up and down`,
  [R.REPORT_ANCHOR_AWEIGH]: ({ side }) => `${names(side)}anchor is aweigh`,
  [R.REPORT_CLEAR_ANCHOR]: ({ side }) => `${names(side)}anchor is clear`,
  [R.REPORT_FOUL_ANCHOR]: ({ side }) => `${names(side)}anchor is foul`,
  [R.REPORT_ANCHOR_HOME]: ({ side }) => `${names(side)}anchor is home`,
  [R.REPORT_DRAGGING]: ({ side }) => `${names(side)}anchor is dragging`,
  [R.REPORT_ORDER_REPEATED]: ({ order_code, side, value }) => orders[order_code](side, value),
  [R.REPORT_ON_THE_BOTTOM]: ({ side }) => `${names(side)}anchor is on the bottom`,
  [R.REPORT_SHACKLES_IN_PIPE]: ({ value }) => `${shackles(value)} in the pipe`,
  [R.REPORT_GROWING]: (report) => `${names(report.side)}cable is ${growing[report.growing]}`,
  [R.REPORT_WEIGHT]: (report) => `${weight[report.weight]} on the ${names(report.side)}cable`,
  [R.REPORT_TURNS]: ({ side, value }) =>
    `${inWords(value)} ${value === 1 ? "turn" : "turns"} in the ${names(side)}cable`,
  [R.REPORT_SECURED]: ({ side }) => `${names(side)}anchor is secured`,
  [R.REPORT_DOES_NOT_RUN]: ({ side }) => `${names(side)}cable does not run`,
  [R.REPORT_BRAKE_DOES_NOT_HOLD]: ({ side }) => `${names(side)}brake does not hold`,
  [R.REPORT_NO_POWER]: ({ side }) => `no power on the ${names(side)}windlass`,
  [R.REPORT_STAND_CLEAR]: () => "stand clear",
  [R.REPORT_DEFECT]: () => "defect",
};

/** "Three shackles in the water"; "Port cable is leading eleven o'clock, short stay". */
export function reportAloud(report: Spoken): string {
  return sentence([reports[report.code](report), report.text].filter(Boolean).join(", "));
}
