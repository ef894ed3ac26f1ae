// How a fault is given: side, severity, when, how fast, to which of several.

import "./fault_form.css";

import { units } from "../../../../words/words.json";
import { h } from "../kit/dom";
import { type Unit, kTonne, loads, scaleEnd, sideWord, unitWritten } from "../kit/units";
import { orderLabel, orderRows, saidOf } from "../kit/words";
import { BridgeOrderCode, FaultTrigger } from "../wire/generated";
import type { OrderSample } from "../wire/connection";
import { type Typed, type TypedFields, inMinutes, inUnit } from "./as_typed";
import { type FaultWords, eventsWaitedFor } from "./fault_words";
import { seconds } from "./time_field";
import { t, translated, typedFigure } from "../kit/language";

/** A trigger, the fields that it asks for, and what they become; throws Error with what is allowed. */
interface Trigger {
  code: FaultTrigger;
  fields: HTMLElement[];
  sample: () => OrderSample;
  /** How its figures are typed. */
  typed?: Typed;
}

/** A figure that was typed; unit: SI of one. */
function typed(input: HTMLInputElement, what: string, unit: number): number {
  const value = input.value.trim() ? Number(typedFigure(input.value)) : NaN;
  if (!(value >= 0))
    throw new Error(
      t("{what}: {typed} is not allowed: a figure from 0 on", { what, typed: input.value || t("nothing|typed") }),
    );
  return value * unit;
}
function typedTime(input: HTMLInputElement, what: string): number {
  const value = seconds(input.value);
  if (Number.isNaN(value))
    throw new Error(
      t("{what}: {typed} is no time; m:ss is allowed", { what, typed: input.value || t("nothing|typed") }),
    );
  return value;
}

const triggerSaid = (code: FaultTrigger): string => saidOf("FaultTrigger", code);

function figureTrigger(code: FaultTrigger, unit: Unit, value: string): Trigger {
  const { si } = unit;
  const written = unitWritten(unit);
  const label = triggerSaid(code);
  const input = h("input", { "aria-label": `${label}, ${written}`, inputMode: "decimal", value });
  return {
    code,
    fields: [h("span", { class: "with-unit" }, input, written)],
    sample: () => ({ trigger_value: typed(input, label, si) }),
    typed: inUnit(label, written, si),
  };
}

function triggers(): Trigger[] {
  const time = h("input", { class: "time", "aria-label": t("at exercise time, m:ss"), placeholder: t("m:ss") });
  const from = h("input", { class: "time", "aria-label": t("from, m:ss"), placeholder: t("m:ss") });
  const until = h("input", { class: "time", "aria-label": t("until, m:ss"), placeholder: t("m:ss") });
  const event = h(
    "select",
    { "aria-label": t("code of the event") },
    ...eventsWaitedFor.map((code) => h("option", { value: code }, code)),
  );
  event.value = "anchor.on_bottom";
  const order = h("select", { "aria-label": t("order of the bridge") });
  for (const [code, { enumerator }] of orderRows.entries())
    if (orderLabel(code)) order.append(h("option", { value: enumerator }, orderLabel(code)));
  order.value = "BRIDGE_ORDER_LET_GO";
  return [
    { code: FaultTrigger.TRIGGER_NOW, fields: [], sample: () => ({}) },
    {
      code: FaultTrigger.TRIGGER_AT_TIME,
      fields: [time],
      sample: () => ({ trigger_value: typedTime(time, triggerSaid(FaultTrigger.TRIGGER_AT_TIME)) }),
      typed: inMinutes(triggerSaid(FaultTrigger.TRIGGER_AT_TIME)),
    },
    figureTrigger(FaultTrigger.TRIGGER_AT_CABLE_OUT, units.shackle, "3"),
    figureTrigger(FaultTrigger.TRIGGER_AT_CABLE_OUT_AT_MOST, units.shackle, "3"),
    figureTrigger(FaultTrigger.TRIGGER_AT_LOAD, loads.unit, `${scaleEnd(loads.of(30 * kTonne))}`),
    figureTrigger(FaultTrigger.TRIGGER_AT_LOAD_AT_MOST, loads.unit, `${scaleEnd(loads.of(10 * kTonne))}`),
    {
      code: FaultTrigger.TRIGGER_AT_EVENT,
      fields: [event],
      sample: () => ({ trigger_event: event.value }),
    },
    {
      code: FaultTrigger.TRIGGER_AT_ORDER,
      fields: [order],
      sample: () => ({ trigger_order: BridgeOrderCode[order.value as keyof typeof BridgeOrderCode] }),
    },
    {
      code: FaultTrigger.TRIGGER_AT_CHANCE,
      fields: [from, until],
      sample: () => ({ trigger_value: typedTime(from, t("from|time")), trigger_until: typedTime(until, t("until")) }),
      typed: inMinutes(t("chance between")),
    },
  ];
}

/**
 * side: that is proposed. give: sends a FaultCommand, with how its figures were typed; refuse: says what cannot be
 * sent.
 */
export function faultForm(
  fault: FaultWords,
  side: number,
  give: (sample: OrderSample, typed: TypedFields) => void,
  refuse: (text: string) => void,
): HTMLElement {
  const choices = triggers();
  const sides = h(
    "select",
    { "aria-label": t("side") },
    h("option", { value: "0" }, sideWord(0)),
    h("option", { value: "1" }, sideWord(1)),
  );
  sides.value = `${side}`;
  const shown = h("output", {}, "100 %");
  const severity = h("input", {
    type: "range",
    min: "0",
    max: "100",
    value: "100",
    "aria-label": t("severity, percent"),
    oninput: () => (shown.value = `${severity.value} %`),
  });
  const when = h("select", { "aria-label": t("trigger"), onchange: () => ask() });
  for (const choice of choices)
    when.append(h("option", { value: FaultTrigger[choice.code] }, triggerSaid(choice.code)));
  const details = h("span", { class: "details" });
  const ramp = h("input", { value: "0", inputMode: "decimal", "aria-label": t("ramp, s") });
  const target = h("input", {
    value: "0",
    inputMode: "numeric",
    "aria-label": translated(fault.targets ?? "") || t("which of several"),
  });
  const chosen = (): Trigger => choices.find((c) => FaultTrigger[c.code] === when.value)!;
  const submit = h("button", { class: "plain primary" }, t("Break it"));
  const ask = (): void => {
    details.replaceChildren(...chosen().fields);
    submit.textContent = when.value === "TRIGGER_NOW" ? t("Break it") : t("Arm");
  };
  ask();
  const line = (label: string, ...fields: HTMLElement[]): HTMLElement =>
    h("div", { class: "line" }, h("span", { class: "label" }, label), ...fields);
  const send = (event: Event): void => {
    event.preventDefault();
    try {
      const sample = {
        code: fault.enumerator,
        side: Number(sides.value),
        severity: Number(severity.value) / 100,
        ramp: typed(ramp, t("ramp"), 1),
        trigger: when.value,
        ...chosen().sample(),
        ...(fault.targets ? { target: Math.round(typed(target, translated(fault.targets), 1)) } : {}),
      };
      give(sample, (field) => (field.startsWith("trigger_") ? chosen().typed : undefined));
    } catch (why) {
      refuse(`${fault.const}: ${(why as Error).message}`);
    }
  };
  return h(
    "form",
    { class: "fault-form", "aria-label": fault.const, onsubmit: send },
    h(
      "dl",
      {},
      h("dt", {}, t("seen")),
      h("dd", {}, translated(fault.symptom)),
      h("dt", {}, t("cause")),
      h("dd", {}, translated(fault.reason)),
      h("dt", {}, t("way out")),
      h("dd", {}, translated(fault.way_out)),
    ),
    line(t("side"), fault.both_sides ? h("span", { class: "quiet" }, sideWord(-1)) : sides),
    line(t("severity"), severity, shown),
    h("p", { class: "quiet" }, `100 %: ${translated(fault.severity)}`),
    line(t("when"), when, details),
    line(t("within"), h("span", { class: "with-unit" }, ramp, "s")),
    fault.targets &&
      line(
        t("number"),
        target,
        h("span", { class: "quiet" }, t("0: any; {what}", { what: translated(fault.targets) })),
      ),
    h("div", { class: "line end" }, submit),
  );
}
