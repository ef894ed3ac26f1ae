// Faults by machine, in words: the server's own table of faults, as the station program serves it.

import { FaultCode, FaultPhase, type FaultStatus, FaultTrigger } from "../wire/generated";
import { orderWords } from "../kit/orders";
import { clock, figure, shackles, tonnes } from "../kit/units";
import type { Connection } from "../wire/connection";

/** One row of the table of faults. */
export interface FaultWords {
  /** As people type it, e.g. "brake-wet". */
  code: string;
  /** The enumerator, e.g. "FAULT_BRAKE_WET". */
  wire_name: string;
  symptom: string;
  reason: string;
  way_out: string;
  /** What 1 means. */
  severity: string;
  both_sides: boolean;
  /** What is counted where the model has several of the part; empty: one. */
  targets: string;
}

async function document<T>(path: string): Promise<T> {
  const answer = await fetch(path);
  if (!answer.ok) throw new Error(`${path}: ${answer.status}`);
  return (await answer.json()) as T;
}

/**
 * The table of faults, and the codes of the events that one may wait for. Throws when the station does not serve
 * them.
 */
export async function loadFaultWords(): Promise<{ faults: FaultWords[]; events: string[] }> {
  const [faults, events] = await Promise.all([
    document<FaultWords[]>("/faults.json"),
    document<string[]>("/events.json"),
  ]);
  return { faults, events };
}

export const machines = [
  "brake",
  "drive",
  "clutch, gypsy",
  "stopper",
  "chain",
  "anchor, ground",
  "sensors",
  "ship",
] as const;
export type Machine = (typeof machines)[number];

const machineOf: Record<FaultCode, Machine> = {
  [FaultCode.FAULT_BRAKE_LINING_FADED]: "brake",
  [FaultCode.FAULT_BRAKE_LINING_WORN]: "brake",
  [FaultCode.FAULT_BRAKE_LINING_GLAZED]: "brake",
  [FaultCode.FAULT_BRAKE_WET]: "brake",
  [FaultCode.FAULT_BRAKE_SEIZED]: "brake",
  [FaultCode.FAULT_MOTOR_POWER_LOST]: "drive",
  [FaultCode.FAULT_DRIVE_TRIP]: "drive",
  [FaultCode.FAULT_PHASE_LOST]: "drive",
  [FaultCode.FAULT_OVERLOAD_RELAY_MISSET]: "drive",
  [FaultCode.FAULT_OVERSPEED_PROTECTION_LOST]: "drive",
  [FaultCode.FAULT_HYDRAULIC_PUMP_LOST]: "drive",
  [FaultCode.FAULT_HYDRAULIC_HOSE_BURST]: "drive",
  [FaultCode.FAULT_COUNTERBALANCE_STUCK_OPEN]: "drive",
  [FaultCode.FAULT_RELIEF_VALVE_LOW]: "drive",
  [FaultCode.FAULT_CLUTCH_JUMPS_OUT]: "clutch, gypsy",
  [FaultCode.FAULT_CLUTCH_SHAFT_DAMAGED]: "clutch, gypsy",
  [FaultCode.FAULT_CLUTCH_SEIZED]: "clutch, gypsy",
  [FaultCode.FAULT_GYPSY_POCKETS_WORN]: "clutch, gypsy",
  [FaultCode.FAULT_STOPPER_PIN_OUT]: "stopper",
  [FaultCode.FAULT_STOPPER_JAMMED]: "stopper",
  [FaultCode.FAULT_SPURLING_PIPE_JAMMED]: "chain",
  [FaultCode.FAULT_CABLE_TWISTED]: "chain",
  [FaultCode.FAULT_CHAIN_LINK_WEAK]: "chain",
  [FaultCode.FAULT_JOINING_SHACKLE_OPEN]: "chain",
  [FaultCode.FAULT_BITTER_END_WEAK]: "chain",
  [FaultCode.FAULT_ANCHOR_FOULED]: "anchor, ground",
  [FaultCode.FAULT_FLUKES_SEIZED]: "anchor, ground",
  [FaultCode.FAULT_SOIL_POOR]: "anchor, ground",
  [FaultCode.FAULT_LOAD_CELL_DEAD]: "sensors",
  [FaultCode.FAULT_LOAD_CELL_BIAS]: "sensors",
  [FaultCode.FAULT_CHAIN_COUNTER_DRIFT]: "sensors",
  [FaultCode.FAULT_BLACKOUT]: "ship",
  [FaultCode.FAULT_SHIP_BLACKOUT]: "ship",
  [FaultCode.FAULT_TELEGRAPH_FAILED]: "ship",
  [FaultCode.FAULT_CCTV_LOST]: "ship",
  [FaultCode.FAULT_VHF_LOST]: "ship",
};

/** Of a fault by its enumerator; those that this page does not know are the ship's. */
export function machine(wireName: string): Machine {
  return machineOf[FaultCode[wireName as keyof typeof FaultCode]] ?? "ship";
}

/** "Brake lining faded", "CCTV lost"; of a code or its enumerator. */
export function faultName(code: FaultCode | string): string {
  const name = typeof code === "string" ? code : (FaultCode[code] ?? "?");
  const words = name
    .replace(/^FAULT_/, "")
    .toLowerCase()
    .replaceAll("_", " ")
    .replace(/^(cctv|vhf)/, (letters) => letters.toUpperCase());
  return words[0]!.toUpperCase() + words.slice(1);
}

const length = (metres: number): string => `${figure(shackles(metres), 1)} sh`;
const load = (force: number): string => `${figure(tonnes(force), 0)} t`;

/** What an armed fault waits for, and how far off that is. */
export function waitsFor(fault: FaultStatus, link: Connection): string {
  const windlass = link.latest("WindlassLoad", fault.side);
  const time = link.latest("ExerciseStatus")?.time ?? NaN;
  const out = length(windlass?.cable_out ?? NaN);
  const pull = load(windlass?.gypsy_load ?? NaN);
  switch (fault.trigger) {
    case FaultTrigger.TRIGGER_NOW:
      return "now";
    case FaultTrigger.TRIGGER_AT_TIME:
      return `at ${clock(fault.trigger_value)}, in ${clock(fault.trigger_value - time)}`;
    case FaultTrigger.TRIGGER_AT_CABLE_OUT:
      return `from ${length(fault.trigger_value)} out on, now ${out}`;
    case FaultTrigger.TRIGGER_AT_CABLE_OUT_AT_MOST:
      return `at ${length(fault.trigger_value)} out or less, now ${out}`;
    case FaultTrigger.TRIGGER_AT_LOAD:
      return `from ${load(fault.trigger_value)} on, now ${pull}`;
    case FaultTrigger.TRIGGER_AT_LOAD_AT_MOST:
      return `at ${load(fault.trigger_value)} or less, now ${pull}`;
    case FaultTrigger.TRIGGER_AT_EVENT:
      return `at event ${fault.trigger_event}`;
    case FaultTrigger.TRIGGER_AT_ORDER:
      return `at order ${orderWords(fault.trigger_order, fault.side, 0)}`;
    case FaultTrigger.TRIGGER_AT_CHANCE:
      return `by chance, ${clock(fault.trigger_value)} to ${clock(fault.trigger_until)}`;
  }
}

export const phases: Record<FaultPhase, string> = {
  [FaultPhase.FAULT_PHASE_ARMED]: "armed",
  [FaultPhase.FAULT_PHASE_ACTIVE]: "active",
  [FaultPhase.FAULT_PHASE_CLEARED]: "cleared",
};
