// How a fault is given: side, severity, when, how fast, to which of several.

import { kShackle, kTonne } from "../kit/units";
import { h } from "../kit/dom";
import { BridgeOrderCode } from "../wire/generated";
import type { OrderSample } from "../wire/connection";
import { type Typed, type TypedFields, inMinutes, inUnit } from "./as_typed";
import type { FaultWords } from "./fault_words";
import { seconds } from "./time_field";

/** A trigger, the fields that it asks for, and what they become; throws Error with what is allowed. */
interface Trigger {
  code: string;
  label: string;
  fields: HTMLElement[];
  sample: () => OrderSample;
  /** How its figures are typed. */
  typed?: Typed;
}

/** A figure that was typed; unit: SI of one. */
function typed(input: HTMLInputElement, what: string, unit: number): number {
  const value = input.value.trim() ? Number(input.value) : NaN;
  if (!(value >= 0)) throw new Error(`${what}: ${input.value || "nothing"} is not allowed: a figure from 0 on`);
  return value * unit;
}
function typedTime(input: HTMLInputElement, what: string): number {
  const value = seconds(input.value);
  if (Number.isNaN(value)) throw new Error(`${what}: ${input.value || "nothing"} is no time; m:ss is allowed`);
  return value;
}

function figureTrigger(code: string, label: string, unit: string, si: number, value: string): Trigger {
  const input = h("input", { "aria-label": `${label}, ${unit}`, inputMode: "decimal", value });
  return {
    code,
    label,
    fields: [h("span", { class: "with-unit" }, input, unit)],
    sample: () => ({ trigger_value: typed(input, label, si) }),
    typed: inUnit(label, unit, si),
  };
}

/** events: codes of those that a fault may wait for. */
function triggers(events: string[]): Trigger[] {
  const time = h("input", { class: "time", "aria-label": "at exercise time, m:ss", placeholder: "m:ss" });
  const from = h("input", { class: "time", "aria-label": "from, m:ss", placeholder: "m:ss" });
  const until = h("input", { class: "time", "aria-label": "until, m:ss", placeholder: "m:ss" });
  const event = h(
    "select",
    { "aria-label": "code of the event" },
    ...events.map((code) => h("option", { value: code }, code)),
  );
  event.value = "anchor.on_bottom";
  const order = h("select", { "aria-label": "order of the bridge" });
  for (const name of Object.keys(BridgeOrderCode)
    .filter((k) => Number.isNaN(Number(k)))
    .slice(1))
    order.append(h("option", { value: name }, name.replace("BRIDGE_ORDER_", "").toLowerCase().replaceAll("_", " ")));
  order.value = "BRIDGE_ORDER_LET_GO";
  return [
    { code: "TRIGGER_NOW", label: "now", fields: [], sample: () => ({}) },
    {
      code: "TRIGGER_AT_TIME",
      label: "at time",
      fields: [time],
      sample: () => ({ trigger_value: typedTime(time, "at time") }),
      typed: inMinutes("at time"),
    },
    figureTrigger("TRIGGER_AT_CABLE_OUT", "cable out from", "shackles", kShackle, "3"),
    figureTrigger("TRIGGER_AT_CABLE_OUT_AT_MOST", "cable out down to", "shackles", kShackle, "3"),
    figureTrigger("TRIGGER_AT_LOAD", "load from", "t", kTonne, "30"),
    figureTrigger("TRIGGER_AT_LOAD_AT_MOST", "load down to", "t", kTonne, "10"),
    { code: "TRIGGER_AT_EVENT", label: "at event", fields: [event], sample: () => ({ trigger_event: event.value }) },
    {
      code: "TRIGGER_AT_ORDER",
      label: "at order",
      fields: [order],
      sample: () => ({ trigger_order: BridgeOrderCode[order.value as keyof typeof BridgeOrderCode] }),
    },
    {
      code: "TRIGGER_AT_CHANCE",
      label: "by chance between",
      fields: [from, until],
      sample: () => ({ trigger_value: typedTime(from, "from"), trigger_until: typedTime(until, "until") }),
      typed: inMinutes("chance between"),
    },
  ];
}

/**
 * events: codes of those that it may wait for. side: that is proposed. give: sends a FaultCommand, with how its figures
 * were typed; refuse: says what cannot be sent.
 */
export function faultForm(
  fault: FaultWords,
  events: string[],
  side: number,
  give: (sample: OrderSample, typed: TypedFields) => void,
  refuse: (text: string) => void,
): HTMLElement {
  const choices = triggers(events);
  const sides = h(
    "select",
    { "aria-label": "side" },
    h("option", { value: "0" }, "port"),
    h("option", { value: "1" }, "starboard"),
  );
  sides.value = `${side}`;
  const shown = h("output", {}, "100 %");
  const severity = h("input", {
    type: "range",
    min: "0",
    max: "100",
    value: "100",
    "aria-label": "severity, percent",
    oninput: () => (shown.value = `${severity.value} %`),
  });
  const when = h("select", { "aria-label": "trigger", onchange: () => ask() });
  for (const choice of choices) when.append(h("option", { value: choice.code }, choice.label));
  const details = h("span", { class: "details" });
  const ramp = h("input", { value: "0", inputMode: "decimal", "aria-label": "ramp, s" });
  const target = h("input", { value: "0", inputMode: "numeric", "aria-label": fault.targets || "which of several" });
  const chosen = (): Trigger => choices.find((c) => c.code === when.value)!;
  const submit = h("button", { class: "plain primary" }, "Break it");
  const ask = (): void => {
    details.replaceChildren(...chosen().fields);
    submit.textContent = when.value === "TRIGGER_NOW" ? "Break it" : "Arm";
  };
  ask();
  const line = (label: string, ...fields: HTMLElement[]): HTMLElement =>
    h("div", { class: "line" }, h("span", { class: "label" }, label), ...fields);
  const send = (event: Event): void => {
    event.preventDefault();
    try {
      const sample = {
        code: fault.wire_name,
        side: Number(sides.value),
        severity: Number(severity.value) / 100,
        ramp: typed(ramp, "ramp", 1),
        trigger: when.value,
        ...chosen().sample(),
        ...(fault.targets ? { target: Math.round(typed(target, fault.targets, 1)) } : {}),
      };
      give(sample, (field) => (field.startsWith("trigger_") ? chosen().typed : undefined));
    } catch (why) {
      refuse(`${fault.code}: ${(why as Error).message}`);
    }
  };
  return h(
    "form",
    { class: "fault-form", "aria-label": fault.code, onsubmit: send },
    h(
      "dl",
      {},
      h("dt", {}, "seen"),
      h("dd", {}, fault.symptom),
      h("dt", {}, "cause"),
      h("dd", {}, fault.reason),
      h("dt", {}, "way out"),
      h("dd", {}, fault.way_out),
    ),
    line("side", fault.both_sides ? h("span", { class: "quiet" }, "both") : sides),
    line("severity", severity, shown),
    h("p", { class: "quiet" }, `100 %: ${fault.severity}`),
    line("when", when, details),
    line("within", h("span", { class: "with-unit" }, ramp, "s")),
    fault.targets && line("number", target, h("span", { class: "quiet" }, `0: any; ${fault.targets}`)),
    h("div", { class: "line end" }, submit),
  );
}
