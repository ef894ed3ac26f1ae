// What people read and hear, of words.json: the row of an enumerator, and the sentences of orders and reports, filled
// in as words.cpp fills them in.

import { alerts, enumerations, events, report_pad, units } from "../../../../words/words.json";
import {
  BridgeOrderCode,
  CableWeight,
  type Criterion,
  CriterionState,
  Growing,
  type Report,
  type ReportCode,
  type Soil,
  StayGiven,
} from "../wire/generated";
import { translated, translatedAs } from "./language";
import { type Unit, sideName, sideWord } from "./units";
import { endings, modelSteps, serverSentences } from "./server_sentences";

type Enumeration = keyof typeof enumerations;

interface OrderRow {
  enumerator: string;
  said: string;
  /** Without its figure; undefined: a figure must go with it. */
  said_bare?: string;
  label?: string;
  /** s within which it is repeated back; 0: a question, which is answered. */
  repeat: number;
  /** Of units. */
  unit?: string;
}
interface ReportRow {
  enumerator: string;
  said: string;
  /** Aloud, where that differs from what is written. */
  spoken?: string;
  label?: string;
  unit?: string;
}
/** A leaf of the report pad: what a phase of the work asks for; enumerators by their names in files. */
export interface PadLeaf {
  const: string;
  said: string;
  /** What turns the pad to it; undefined: a touch alone. */
  after?: { orders?: string[]; reports?: string[]; anchor?: string[] };
  reports: string[];
}
/** Rows in the order of the enumerators. */
export const orderRows: readonly OrderRow[] = enumerations.BridgeOrderCode.oneOf;
/** Of its button and in a list, without its figure: "hold on at"; empty for own words. */
export const orderLabel = (code: BridgeOrderCode): string => orderRows[code]?.label ?? orderRows[code]?.said ?? "";

export const reportRows: readonly ReportRow[] = enumerations.ReportCode.oneOf;
export const padLeaves: readonly PadLeaf[] = report_pad;

/** What orders and reports are made of: English, in every language. */
const kSpoken = new Set<Enumeration>(["BridgeOrderCode", "ReportCode", "StayGiven", "Growing", "CableWeight"]);

const inEnglish = (enumeration: Enumeration, place: number): string =>
  enumerations[enumeration].oneOf[place]?.said ?? "";

/** What is written for an enumerator; empty for one that words.json does not have. */
export function saidOf(enumeration: Enumeration, place: number): string {
  const said = inEnglish(enumeration, place);
  return kSpoken.has(enumeration) ? said : translated(said);
}

/** How an enumerator is called in files and style sheets: "alarm". */
export const nameOf = (enumeration: Enumeration, place: number): string =>
  enumerations[enumeration].oneOf[place]?.const ?? "";

/** "not met"; of a criterion that an assessor judges and has not, "not judged". */
export function stateSaid({ state, kind }: Pick<Criterion, "state" | "kind">): string {
  const row: { unjudged?: string } | undefined = enumerations.CriterionKind.oneOf[kind];
  const unjudged = state === CriterionState.CRITERION_NOT_IN_PLAY && row?.unjudged;
  return unjudged ? translated(unjudged) : saidOf("CriterionState", state);
}

/** Of the soil on a chart (INT 1, section J): "S", "M" ... */
export const soilLetter = (soil: Soil): string => enumerations.Soil.oneOf[soil]?.letter ?? "";

/** The enumerator of a name in files; -1: there is none. */
export const placeOf = (enumeration: Enumeration, name: string): number =>
  enumerations[enumeration].oneOf.findIndex((row) => row.const === name);

/** What is written for each enumerator, in their order. */
export const allSaid = (enumeration: Enumeration): string[] =>
  enumerations[enumeration].oneOf.map((_, place) => saidOf(enumeration, place));

/** Of Assessment.outcome and an objective's: "not yet"; empty while it runs. */
export const outcomeSaid = (outcome: string): string => translated(outcome.replace("_", " "));

export const capital = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1);

/** The row of a unit; undefined: of none. */
export const unitOf = (name: string | undefined): Unit | undefined =>
  name === undefined ? undefined : units[name as keyof typeof units];

/** How a figure is put into a sentence: "3 shackles" in writing, "three shackles" aloud. */
export type FigureText = (value: number, unit: Unit) => string;

/** "3 shackles", "1 shackle", "20 m". */
export const figureText: FigureText = (value, unit) => {
  const one = value === 1 && unit.written === unit.many;
  return `${Number(value.toPrecision(6))} ${one ? unit.one : unit.written}`;
};

const filled = (sentence: string, fill: (place: string) => string): string =>
  sentence.replace(/\{([^}]*)\}/g, (_, place: string) => fill(place));

/** "port anchor", "both windlasses"; of neither side: "anchor". */
function noun(one: string, side: number, both: boolean): string {
  if (side === 0 || side === 1) return `${sideName(side)} ${one}`;
  return both ? `both ${one}${one.endsWith("s") ? "es" : "s"}` : one;
}

/** What orders and reports have a place for. */
function thing(place: string, side: number, both: boolean): string {
  if (place === "side") return side === 0 || side === 1 ? `${sideName(side)} ` : "";
  return noun(place, side, both);
}

const joined = (...parts: string[]): string => parts.filter(Boolean).join(", ");

/** "pay out port cable to 3 shackles in the pipe". side: 0 port, 1 starboard, -1 both. Empty for own words. */
export function orderText(code: BridgeOrderCode, side: number, value: number, figure = figureText): string {
  const row = orderRows[code];
  if (!row) return "";
  const unit = unitOf(row.unit);
  return filled((value === 0 && row.said_bare) || row.said, (place) =>
    place === "figure" && unit ? figure(value, unit) : thing(place, side, true),
  );
}

/**
 * An order with what the bridge has added to it, which after a question is a sentence of its own: "how much port cable
 * is out? This is my last call".
 */
export const orderWith = (order: string, added: string): string =>
  added && order.endsWith("?") ? `${order} ${capital(added)}` : joined(order, added);

/** A report of which no more is said than that. */
export const bareReport = (code: ReportCode, side: number): Omit<Report, "origin"> => ({
  code,
  side,
  value: 0,
  lead: 0,
  stay: StayGiven.STAY_NOT_GIVEN,
  growing: Growing.GROWING_NOT_GIVEN,
  weight: CableWeight.WEIGHT_NOT_GIVEN,
  order_number: 0,
  order_code: BridgeOrderCode.BRIDGE_ORDER_TEXT,
  text: "",
});

/** What a report says; aloud: how its clock hour is spoken, and that its sentence is the spoken one. */
export function reportText(
  report: Omit<Report, "origin">,
  figure = figureText,
  aloud?: (hour: number) => string,
): string {
  const row = reportRows[report.code];
  if (!row) return report.text;
  const sentence = (aloud && row.spoken) || row.said;
  const hour = report.lead > 0 ? `${aloud ? aloud(report.lead) : report.lead} o'clock` : "";
  const stay = inEnglish("StayGiven", report.stay);
  const growing = inEnglish("Growing", report.growing);
  const weight = inEnglish("CableWeight", report.weight);
  const unit = unitOf(row.unit);
  const order = orderText(report.order_code, report.side, report.value, figure);
  const ownWords = sentence.includes("{order}") && !order; // the order had no others
  const fill = (place: string): string => {
    if (place === "figure" && unit) return figure(report.value, unit);
    if (place === "order") return order || report.text || "the order";
    if (place === "proposal") return order && `: I propose to ${order}`;
    if (place === "growing") return growing || "growing";
    if (place === "weight") return weight || "weight";
    if (place === "lead") return joined(hour && `leading ${hour}`, stay) || "leading";
    return thing(place, report.side, false);
  };
  // What was given beside what the sentence has a place for.
  const beside = (place: string, ...given: string[]): string[] => (sentence.includes(`{${place}}`) ? [] : given);
  return joined(
    filled(sentence, fill),
    ...beside("lead", hour, stay),
    ...beside("growing", growing),
    ...beside("weight", weight),
    ownWords ? "" : report.text,
  );
}

/** With its side before it, unless the sentence names it: "port: 3 shackles on deck". */
export function withSide(side: number, text: string): string {
  const named = side !== 0 && side !== 1 ? true : new RegExp(`\\b${sideName(side)}\\b`).test(text);
  return named ? text : `${sideName(side)}: ${text}`;
}

interface EventRow {
  const: string;
  said?: string;
  seat_said?: string;
  seat_code?: string;
}
const eventRows: readonly EventRow[] = [...events.waited_for.oneOf, ...events.told.oneOf];

/** The server calls a fault by its name in files: "load-cell-dead is active"; what is said of it has a translation. */
const withFaultSaid = (text: string): string =>
  text.replace(/^\S+/, (name) => enumerations.FaultCode.oneOf.find((row) => row.const === name)?.said ?? name);

const kSteps = /of \d+ steps of the cables [^.]+/;
/** What the model counts of its steps stands within other sentences. */
const withSteps = (text: string): string => text.replace(kSteps, (steps) => translatedAs(modelSteps, steps));

/** Why a lesson ended before it was done: an event's sentence that has no figure, or the judge's. */
export function endingSaid(abort: string): string {
  const row = eventRows.find((each) => each.const === abort);
  const said = [row?.said, row?.seat_said].find((each) => each?.includes("{") === false);
  if (said) return translated(said);
  for (const sentence of endings) {
    const found = translatedAs(sentence, abort);
    if (found !== abort) return found;
  }
  return abort;
}

/** An event's sentence in the person's language, as it came where that has none. */
export function eventText({ code, text: given }: { code: string; text: string }): string {
  const text = code.startsWith("fault.") ? withFaultSaid(given) : given;
  const row = eventRows.find((each) => each.const === code || each.seat_code === code);
  const sentences = [row?.seat_said, row?.said, ...(serverSentences[code] ?? [])];
  for (const sentence of sentences) {
    const found = sentence === undefined ? text : translatedAs(sentence, text);
    if (found !== text) return withSteps(found);
  }
  return given;
}

/** For people to read, with its side before it unless the English names it. */
export const besideSide = (side: number, english: string, said = english): string =>
  withSide(side, english) === english ? said : `${sideWord(side)}: ${said}`;

/** A report's own words, of the log's "reported: she is brought up, to order 4". */
export const spoken = (text: string): string => text.replace(/^.*?reported: /s, "").replace(/, to order \d+$/, "");

/** An event's sentence so. */
export const eventLine = (event: { code: string; text: string; side: number }): string =>
  besideSide(event.side, event.text, eventText(event));

/** What an alert says and explains, in the person's language. */
export function alertWords(alert: { code: string; text: string; explanation: string }): {
  text: string;
  explanation: string;
} {
  const row = alerts.find(({ code }) => code === alert.code);
  if (!row) return alert;
  return {
    text: translatedAs(row.said, alert.text),
    explanation: withSteps(translatedAs(row.explanation, alert.explanation)),
  };
}
