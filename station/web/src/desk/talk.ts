// Orders to the forecastle and its reports, each beside the truth at that moment.

import { h, setText } from "../kit/dom";
import { orderMayBeBare, orderUnit, repeatState, written } from "../kit/orders";
import { TypedCount, kMostWords } from "../kit/typed_count";
import { clock, sideWord } from "../kit/units";
import { orderRows } from "../kit/words";
import { type BridgeOrder, BridgeOrderCode, BridgeOrderState } from "../wire/generated";
import type { Desk } from "./desk";
import { ReportLog, type ReportLine } from "./report_log";
import { t, typedFigure } from "../kit/language";

/** A line of the list. */
interface Said {
  time: number; // s, exercise time
  element: HTMLElement;
  after: HTMLElement; // its last words
}

export class TalkPanel {
  readonly element: HTMLElement;
  private readonly list = h("ol", { class: "talk scroll", tabIndex: 0, "aria-label": t("orders and reports") });
  private readonly orders = new Map<number, Said>();
  private readonly reports = new Map<ReportLine, Said>();
  private readonly all: Said[] = []; // the newest first
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
    class: "words",
  });
  private readonly typed = new TypedCount(this.words, kMostWords.order);
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
      {
        class: "order-form",
        "data-gives": "BridgeOrderCommand",
        "aria-label": t("order to the forecastle"),
        onsubmit: (e: Event) => this.give(e),
      },
      this.side,
      this.code,
      this.value,
      this.unit,
      this.words,
      h("button", { class: "plain primary" }, t("Order")),
      this.typed.element,
    );
    this.element = h("div", { class: "talk-panel" }, this.list, form);
    const { link } = desk;
    link.on("ExerciseStatus", (status) => {
      if (status.run === this.run) return;
      if (!desk.replay) this.dropOrders(); // of a restore: they come again
      this.run = status.run;
      for (const order of link.all("BridgeOrder")) this.takeOrder(order); // what came before it was known
    });
    link.onState((state) => state === "lost" && this.dropOrders());
    link.on("BridgeOrder", (order) => this.takeOrder(order));
    const log = new ReportLog(
      link,
      desk.events,
      () => desk.replay,
      () => this.showReports(log.lines),
    );
    desk.past.add(log);
    desk.onSide((side) => (this.side.value = `${side}`));
  }

  private dropOrders(): void {
    for (const said of this.orders.values()) this.remove(said);
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
    if (sent) this.typed.clear();
  }

  /** An order of the run before may come late, or be known still; it was not given in this one. */
  private takeOrder(order: BridgeOrder): void {
    if (order.run !== this.run) return;
    if (!this.orders.has(order.number)) this.orders.set(order.number, this.add(order.time, false, written(order)));
    this.orders.get(order.number)!.element.dataset.state = BridgeOrderState[order.state];
    const all = this.desk.link.all("BridgeOrder").filter(({ run }) => run === this.run);
    for (const each of all) {
      const said = this.orders.get(each.number);
      if (said) setText(said.after, repeatState(each, all)); // a later one may be the same, said again
    }
  }

  private showReports(lines: readonly ReportLine[]): void {
    for (const [line, said] of this.reports)
      if (!lines.includes(line)) {
        this.remove(said);
        this.reports.delete(line);
      }
    for (const line of lines) {
      const said = this.reports.get(line) ?? this.add(line.event.time, true, line.words);
      this.reports.set(line, said);
      setText(said.after, line.was);
    }
  }

  /** Newest on top. */
  private add(time: number, report: boolean, words: string): Said {
    const after = h("span", { class: report ? "was" : "quiet" });
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
      after,
    );
    const said = { time, element, after };
    const before = this.all.find((other) => other.time <= time);
    this.all.splice(before ? this.all.indexOf(before) : this.all.length, 0, said);
    this.list.insertBefore(element, before?.element ?? null);
    return said;
  }

  private remove(said: Said): void {
    said.element.remove();
    this.all.splice(this.all.indexOf(said), 1);
  }
}
