// What the bridge orders, and the answer: an order is repeated back, with its figure as the trainee understood it.

import type { Connection } from "../wire/connection";
import { type BridgeOrder, BridgeOrderState, type SeatEvent } from "../wire/generated";
import { Before, begins, leave } from "../kit/branch";
import { h, setText } from "../kit/dom";
import { isAnswered, isInForce } from "../kit/order_done";
import { isOpen, isQuestion, repeatState, written } from "../kit/orders";
import { clock } from "../kit/units";
import type { Popover } from "../kit/popover";
import { RepeatBack } from "../kit/repeat_back";
import { t } from "../kit/language";

const kShown = 30;
const kReports = 200;

/** The newest first; those of an earlier run do not count any more. */
function newestFirst(orders: BridgeOrder[], run: number | undefined): BridgeOrder[] {
  return orders.filter((order) => run === undefined || order.run === run).sort((a, b) => b.number - a.number);
}

/** A report in the log. */
type Made = SeatEvent & { left: boolean };

const isToRepeat = (order: BridgeOrder): boolean => isOpen(order) && !isQuestion(order);

/** What waits or is in force stands first, each of these and of the others the newest first. */
export class Orders {
  readonly element: HTMLElement;
  private readonly list = h("ol", {});
  private readonly none = h("p", { class: "quiet" }, t("No orders yet."));
  private readonly announce = h("div", { class: "sr-only", role: "status", "aria-live": "polite" });
  private readonly listeners = new Set<(order: BridgeOrder) => void>();
  private heard = 0; // number of the newest that was announced
  private reports: Made[] = []; // by which questions are answered
  private readonly before = new Before();
  private readonly back: RepeatBack;

  /** answer: offers what answers a question; tell: for what became of a repeat. */
  constructor(
    private readonly link: Connection,
    popover: Popover,
    private readonly answer: (question: BridgeOrder, from: HTMLElement) => void,
    private readonly tell: (text: string) => void,
  ) {
    this.back = new RepeatBack(link, popover, tell);
    this.element = h(
      "div",
      { class: "orders", tabindex: 0, role: "group", "aria-label": t("orders") },
      this.none,
      this.list,
      this.announce,
    );
    link.on("BridgeOrder", () => this.update());
    link.on("ExerciseStatus", () => this.orders().length !== this.list.childElementCount && this.update());
    link.on("ForecastleEvent", (event) => this.hear(event));
    link.onState((state) => {
      if (state === "open") {
        this.reports = []; // all of it comes again
        this.before.clear();
      }
      this.update();
    });
  }

  /** Calls back for each new order: for the page's sound. */
  onOrder(listener: (order: BridgeOrder) => void): void {
    this.listeners.add(listener);
  }

  /** Repeats the newest order that waits for it, or asks for its figure. */
  repeatNewest(): void {
    const order = this.orders().find(isToRepeat);
    const button = order && this.list.querySelector<HTMLButtonElement>(`[data-number="${order.number}"] button`);
    if (button) button.click();
    else this.tell(t("no order waits to be repeated"));
  }

  private hear(event: SeatEvent): void {
    this.before.hear(event);
    if (begins(event)) {
      leave(this.reports, event);
      this.update();
    } else if (event.code === "report.made") {
      this.reports = [...this.reports, { ...event, left: false }].slice(-kReports);
      if (this.list.querySelector("[data-stands]")) this.update(); // which it may end
    }
  }

  private orders(): BridgeOrder[] {
    return newestFirst(this.link.all("BridgeOrder"), this.link.latest("ExerciseStatus")?.run).slice(0, kShown);
  }

  private update(): void {
    const orders = this.orders();
    this.none.hidden = orders.length > 0;
    const rows = orders.map((order) => this.row(order));
    const stands = (row: HTMLElement): boolean => row.hasAttribute("data-stands");
    this.list.replaceChildren(...rows.filter(stands), ...rows.filter((row) => !stands(row)));
    const newest = orders[0];
    if (!newest) this.heard = 0;
    else if (newest.number > this.heard) {
      if (newest.state === BridgeOrderState.ORDER_GIVEN) {
        setText(this.announce, t("order: {order}", { order: written(newest) }));
        for (const listener of this.listeners) listener(newest);
      }
      this.heard = newest.number;
      this.element.scrollTop = 0; // wherever the older ones were being read
    }
  }

  private row(order: BridgeOrder): HTMLElement {
    const open = isToRepeat(order);
    const asked = isOpen(order) && isQuestion(order);
    const reports = this.reports.filter(({ left }) => !left);
    const answered = asked && isAnswered(order, reports);
    const before = asked && !answered ? this.before.said(order) : "";
    const waits = asked && !answered && !before && this.orders()[0]?.number === order.number;
    const newest = waits ? t("answer by a report") : repeatState(order, this.orders());
    const stands = open || (!before && isInForce(order, this.orders(), reports));
    const button = open && this.back.button(order);
    const answers: HTMLButtonElement | false =
      waits &&
      h(
        "button",
        { class: "primary", "aria-haspopup": "dialog", "aria-label": t("answer: {order}", { order: written(order) }) },
        t("Answer"),
      );
    if (answers) answers.addEventListener("click", () => this.answer(order, answers));
    return h(
      "li",
      {
        "data-number": order.number,
        "data-state": BridgeOrderState[order.state],
        "data-stands": stands ? "" : undefined,
      },
      h("time", {}, clock(order.time)),
      h("span", { class: "spoken", lang: "en" }, written(order)),
      h("span", { class: "quiet" }, answered ? t("answered") : before || newest),
      button || answers,
    );
  }
}
