// Orders to the forecastle and its reports, each beside the truth at that moment.

import { h, setText } from "../kit/dom";
import { orderMayBeBare, orderUnit, repeatState, written } from "../kit/orders";
import { cableSpeeds, celsius, clock, figure, loads, shackles, sideWord } from "../kit/units";
import { orderRows, reportText, saidOf, withSide } from "../kit/words";
import type { Connection } from "../wire/connection";
import { type BridgeOrder, BridgeOrderCode, BridgeOrderState, type Report, ReportCode } from "../wire/generated";
import type { Desk } from "./desk";
import { anchorPhase } from "./truth";
import { t, typedFigure } from "../kit/language";

/** What was true when a report was given: "was 3.2 out"; empty where it can be neither right nor wrong. */
export function truthOf(report: Report, link: Connection): string {
  const load = link.latest("WindlassLoad", report.side);
  const chain = link.latest("ChainState", report.side);
  const anchor = link.latest("AnchorState", report.side);
  if (!load || !anchor) return "";
  switch (report.code) {
    case ReportCode.REPORT_SHACKLES_ON_DECK:
    case ReportCode.REPORT_SHACKLES_IN_WATER:
    case ReportCode.REPORT_SHACKLES_IN_PIPE:
      return t("was {shackles} out", { shackles: figure(shackles(load.cable_out), 1) });
    case ReportCode.REPORT_LEAD:
    case ReportCode.REPORT_SHORT_STAY:
    case ReportCode.REPORT_UP_AND_DOWN:
      if (!chain) return ""; // of the past no chain is kept
      return t("was {hour} o'clock, {stay}", { hour: figure(chain.lead_clock, 1), stay: saidOf("Stay", chain.stay) });
    case ReportCode.REPORT_GROWING:
    case ReportCode.REPORT_WEIGHT:
      return t("was {what}", { what: loads.text(load.hawse_tension) });
    case ReportCode.REPORT_TURNS:
      return chain ? t("was {what}", { what: figure(chain.turns, 1) }) : "";
    case ReportCode.REPORT_NO_POWER:
      return load.power ? t("had power") : t("had none");
    case ReportCode.REPORT_BRAKE_DOES_NOT_HOLD:
      return t("bore {load} of {capacity}, lining {degrees} °C", {
        load: loads.figure(load.brake_load),
        capacity: loads.text(load.brake_capacity),
        degrees: figure(celsius(load.lining_temperature)),
      });
    case ReportCode.REPORT_DOES_NOT_RUN:
      return t("ran {speed}", { speed: cableSpeeds.text(load.cable_speed) });
    case ReportCode.REPORT_SECURED:
      return load.stopper_closed
        ? t("brake {percent} %, stopper closed", { percent: figure(100 * load.brake_position) })
        : t("brake {percent} %, stopper open", { percent: figure(100 * load.brake_position) });
    case ReportCode.REPORT_LET_GO:
    case ReportCode.REPORT_ON_THE_BOTTOM:
    case ReportCode.REPORT_BROUGHT_UP:
    case ReportCode.REPORT_ANCHOR_AWEIGH:
    case ReportCode.REPORT_CLEAR_ANCHOR:
    case ReportCode.REPORT_FOUL_ANCHOR:
    case ReportCode.REPORT_ANCHOR_HOME:
    case ReportCode.REPORT_DRAGGING:
      return t("was {what}", { what: anchorPhase(anchor.phase) });
    default:
      return "";
  }
}

/** What was true of that side at large: a replay has the words of a report, but not the Report. */
function atLarge(side: number, link: Connection): string {
  const load = link.latest("WindlassLoad", side);
  const anchor = link.latest("AnchorState", side);
  if (!load || !anchor) return "";
  const out = figure(shackles(load.cable_out), 1);
  return t("was {shackles} out, {phase}", { shackles: out, phase: anchorPhase(anchor.phase) });
}

interface Said {
  time: number;
  side: number;
  report: boolean;
  element: HTMLElement;
}

const kShown = 200;

export class TalkPanel {
  readonly element: HTMLElement;
  private readonly list = h("ol", { class: "talk scroll", tabIndex: 0, "aria-label": t("orders and reports") });
  private readonly orders = new Map<number, { said: Said; state: HTMLElement }>();
  private readonly all: Said[] = [];
  private readonly side = h(
    "select",
    { "aria-label": t("side of the order") },
    h("option", { value: "0" }, sideWord(0)),
    h("option", { value: "1" }, sideWord(1)),
    h("option", { value: "-1" }, sideWord(-1)),
  );
  private readonly code = h("select", { "aria-label": t("order") });
  private readonly value = h("input", {
    "aria-label": t("figure of the order"),
    inputMode: "decimal",
    class: "figure",
  });
  private readonly unit = h("span", { class: "quiet" });
  private readonly words = h("input", {
    "aria-label": t("words of the order"),
    placeholder: t("words"),
    maxLength: 255,
    class: "words",
  });
  private run = -1;

  constructor(private readonly desk: Desk) {
    this.code.append(h("option", { value: "BRIDGE_ORDER_TEXT" }, t("own words")));
    for (const { enumerator, label } of orderRows)
      if (label !== undefined) this.code.append(h("option", { value: enumerator }, label));
    this.code.value = "BRIDGE_ORDER_STAND_BY";
    this.code.addEventListener("change", () => this.askFigure());
    this.askFigure();
    const form = h(
      "form",
      { class: "order-form", "aria-label": t("order to the forecastle"), onsubmit: (e: Event) => this.give(e) },
      this.side,
      this.code,
      this.value,
      this.unit,
      this.words,
      h("button", { class: "plain primary" }, t("Order")),
    );
    this.element = h("div", { class: "talk-panel" }, this.list, form);
    const { link } = desk;
    link.on("ExerciseStatus", (status) => {
      if (status.run === this.run) return;
      if (this.run !== -1 && !desk.replay) this.backTo(status.time);
      this.run = status.run;
      for (const order of link.all("BridgeOrder")) this.takeOrder(order); // what came before it was known
    });
    link.onState((state) => state === "lost" && this.clear());
    link.on("BridgeOrder", (order) => this.takeOrder(order));
    link.on("Report", (report) => this.takeReport(report));
    desk.events.onChange((event) => {
      if (!event || (event.code !== "report.made" && event.code !== "report.not_heard")) return;
      const known = this.all.some(
        (said) => said.report && Math.abs(said.time - event.time) < 1.5 && said.side === event.side,
      );
      const now = this.now();
      const fresh = Math.abs(now - event.time) < 1; // what is heard now is the truth of then
      if (known || (fresh && !desk.replay)) return; // its Report is on its way
      this.add(
        event.time,
        event.side,
        true,
        event.text.replace(/reported: /, ""),
        fresh ? atLarge(event.side, link) : "",
      );
    });
    desk.onSide((side) => (this.side.value = `${side}`));
  }

  private clear(): void {
    this.list.replaceChildren();
    this.orders.clear();
    this.all.length = 0;
  }

  /** s of exercise time of what is heard now: of the past, of then. */
  private now(): number {
    const { link } = this.desk;
    return link.latest("ShipState")?.time ?? link.latest("ExerciseStatus")?.time ?? 0;
  }

  /** A restore: orders come again, and what was reported since has not happened. */
  private backTo(time: number): void {
    for (const { element } of this.all.filter((said) => !said.report || said.time > time)) element.remove();
    const stays = this.all.filter((said) => said.report && said.time <= time);
    this.all.splice(0, this.all.length, ...stays);
    this.orders.clear();
  }

  private askFigure(): void {
    const code = BridgeOrderCode[this.code.value as keyof typeof BridgeOrderCode];
    const unit = orderUnit(code);
    this.value.hidden = this.unit.hidden = unit === undefined;
    setText(this.unit, unit?.written ?? "");
    this.words.required = code === BridgeOrderCode.BRIDGE_ORDER_TEXT;
  }

  private async give(event: Event): Promise<void> {
    event.preventDefault();
    const code = BridgeOrderCode[this.code.value as keyof typeof BridgeOrderCode];
    const unit = orderUnit(code);
    const text = this.value.value.trim();
    const value = unit && text ? Number(typedFigure(text)) : 0;
    if (Number.isNaN(value) || (!text && !orderMayBeBare(code)))
      return this.desk.say(
        t("Order: {typed} is not allowed: a figure in {unit}", {
          typed: text || t("nothing|typed"),
          unit: unit?.written ?? "",
        }),
      );
    const sent = await this.desk.give("BridgeOrderCommand", {
      code: this.code.value,
      side: Number(this.side.value),
      value,
      text: this.words.value.trim(),
    });
    if (sent) this.words.value = "";
  }

  /** An order of the run before may come late, or be known still; it was not given in this one. */
  private takeOrder(order: BridgeOrder): void {
    if (order.run !== this.run) return;
    let row = this.orders.get(order.number);
    if (!row) {
      const state = h("span", { class: "quiet" });
      row = { said: this.add(order.time, order.side, false, written(order), state), state };
      this.orders.set(order.number, row);
    }
    setText(row.state, repeatState(order));
    row.said.element.dataset.state = BridgeOrderState[order.state];
  }

  private takeReport(report: Report): void {
    const time = this.now();
    this.add(time, report.side, true, withSide(report.side, reportText(report)), truthOf(report, this.desk.link));
  }

  /** Newest on top. */
  private add(time: number, side: number, report: boolean, words: string, after: string | HTMLElement): Said {
    const element = h(
      "li",
      { class: report ? "report" : "order" },
      h("time", {}, clock(time)),
      h(
        "span",
        { class: "who", title: report ? t("forecastle") : t("bridge") },
        report ? t("F|forecastle") : t("B|bridge"),
      ),
      h("span", { class: "text" }, words),
      typeof after === "string" ? h("span", { class: "was" }, after) : after,
    );
    const said = { time, side, report, element };
    const before = this.all.find((other) => other.time <= time);
    this.all.splice(before ? this.all.indexOf(before) : this.all.length, 0, said);
    this.list.insertBefore(element, before?.element ?? null);
    if (this.all.length > kShown) this.all.pop()!.element.remove();
    return said;
  }
}
