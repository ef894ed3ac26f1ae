// Faults in words.

import { enumerations, events } from "../../../../words/words.json";
import { loadsMeasured } from "../kit/measured";
import { clock, figure, loads, shackles } from "../kit/units";
import { capital, orderLabel, saidOf } from "../kit/words";
import type { Connection } from "../wire/connection";
import { type FaultCode, type FaultPhase, type FaultStatus, FaultTrigger } from "../wire/generated";
import { t } from "../kit/language";

/** One row of the table of faults. */
export interface FaultWords {
  /** As people type it, e.g. "brake-wet". */
  const: string;
  /** In the IDL, e.g. "FAULT_BRAKE_WET". */
  enumerator: string;
  said: string;
  /** Of which part of the ship it is. */
  machine: string;
  symptom: string;
  reason: string;
  way_out: string;
  /** What 1 means. */
  severity: string;
  both_sides?: boolean;
  /** What is counted where the model has several of the part; undefined: one. */
  targets?: string;
}

/** In the order of the enumerators. */
export const faults: readonly FaultWords[] = enumerations.FaultCode.oneOf;

/** Codes of the events that a fault may wait for. */
export const eventsWaitedFor: readonly string[] = events.waited_for.oneOf.map((row) => row.const);

/** Those that can be broken, as the desk lists them. */
export const machines: readonly string[] = [
  "brake",
  "drive",
  "clutch, gypsy",
  "stopper",
  "chain",
  "anchor, ground",
  "sensors",
  "ship",
];

/** "Brake lining faded", "CCTV lost". */
export const faultName = (code: FaultCode): string => capital(saidOf("FaultCode", code)) || "?";

const length = (metres: number): string => t("{shackles} sh", { shackles: figure(shackles(metres), 1) });

/** What an armed fault waits for, and how far off that is. */
export function waitsFor(fault: FaultStatus, link: Connection): string {
  const windlass = link.latest("WindlassLoad", fault.side);
  const time = link.latest("ExerciseStatus")?.time ?? NaN;
  const out = length(windlass?.cable_out ?? NaN);
  const pull = loads.text(windlass && loadsMeasured(windlass) ? windlass.gypsy_load : NaN);
  switch (fault.trigger) {
    case FaultTrigger.TRIGGER_NOW:
      return t("now");
    case FaultTrigger.TRIGGER_AT_TIME:
      return t("at {time}, in {wait}", { time: clock(fault.trigger_value), wait: clock(fault.trigger_value - time) });
    case FaultTrigger.TRIGGER_AT_CABLE_OUT:
      return t("from {length} out on, now {out}", { length: length(fault.trigger_value), out });
    case FaultTrigger.TRIGGER_AT_CABLE_OUT_AT_MOST:
      return t("at {length} out or less, now {out}", { length: length(fault.trigger_value), out });
    case FaultTrigger.TRIGGER_AT_LOAD:
      return t("from {load} on, now {pull}", { load: loads.text(fault.trigger_value), pull });
    case FaultTrigger.TRIGGER_AT_LOAD_AT_MOST:
      return t("at {load} or less, now {pull}", { load: loads.text(fault.trigger_value), pull });
    case FaultTrigger.TRIGGER_AT_EVENT:
      return t("at event {event}", { event: fault.trigger_event });
    case FaultTrigger.TRIGGER_AT_ORDER:
      return t("at order {order}", { order: orderLabel(fault.trigger_order) });
    case FaultTrigger.TRIGGER_AT_CHANCE:
      return t("by chance, {from} to {until}", {
        from: clock(fault.trigger_value),
        until: clock(fault.trigger_until),
      });
  }
}

export const phaseWords = (phase: FaultPhase): string => saidOf("FaultPhase", phase);
