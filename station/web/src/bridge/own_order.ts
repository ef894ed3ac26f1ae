// For who has both seats: the newest order to the forecastle that waits for a word, on the bridge's page too, whatever
// is open there. Who may not report has none of it: the gateway says who may.

import { h, setShown, setText } from "../kit/dom";
import { t } from "../kit/language";
import { waitsForWord } from "../kit/order_done";
import { isQuestion, kByHand, repeatState, written } from "../kit/orders";
import { seatLink } from "../kit/other_seat";
import { Popover } from "../kit/popover";
import { RepeatBack } from "../kit/repeat_back";
import { clock } from "../kit/units";
import type { Connection } from "../wire/connection";
import { type BridgeOrder, BridgeOrderState } from "../wire/generated";
import type { Line } from "./line";

const kFresh = 5; // s of exercise time

export class OwnOrder {
  /** Over the page, so that no lever moves away from under a hand; hidden while nothing waits. */
  readonly element: HTMLElement;
  private readonly time = h("time", {});
  private readonly words = h("span", { class: "spoken", role: "status", lang: "en" });
  private readonly state = h("span", { class: "quiet", role: "alert" });
  private readonly acts = h("span", {});
  private readonly back: RepeatBack;
  private readonly listeners = new Set<(order: BridgeOrder) => void>();
  private shown = ""; // the order that stands there
  private heard = 0; // number of the newest that was told

  constructor(
    private readonly link: Connection,
    private readonly line: Line,
  ) {
    const panel = h("div", { class: "row panel" }, this.time, this.words, this.state, this.acts);
    this.element = h(
      "section",
      { class: "own-order", hidden: true, "aria-label": t("order to the forecastle") },
      panel,
    );
    this.back = new RepeatBack(link, new Popover(panel), (text) => setText(this.state, text));
    line.onChange(() => this.show());
    link.onMessage("hello", () => this.show());
  }

  /** Calls back for each new order: for the page's voice. */
  onOrder(listener: (order: BridgeOrder) => void): void {
    this.listeners.add(listener);
  }

  private show(): void {
    const may = this.link.hello?.commands.includes("Report") ?? false;
    const orders = may ? this.line.orders() : [];
    this.tell(orders.at(-1));
    const order = waitsForWord(orders, this.line.heard(), (question) => this.line.saidOfBefore(question) !== "");
    setShown(this.element, order !== undefined);
    setText(this.words, order ? written(order) : "");
    setText(this.state, order && order.state !== BridgeOrderState.ORDER_GIVEN ? repeatState(order, orders) : "");
    const which = order ? `${order.run} ${order.number} ${order.time}` : "";
    if (which === this.shown) return; // a figure may be being chosen
    this.shown = which;
    setText(this.time, order ? clock(order.time) : "");
    this.acts.replaceChildren(...(order ? [isQuestion(order) ? this.answer(order) : this.back.button(order)] : []));
  }

  /** What answers a question is said where the reports are. */
  private answer(order: BridgeOrder): HTMLElement {
    return seatLink("forecastle", { "aria-label": t("answer: {order}", { order: written(order) }) }, t("Answer"));
  }

  private tell(newest: BridgeOrder | undefined): void {
    if (!newest) this.heard = 0;
    if (!newest || newest.number <= this.heard) return;
    this.heard = newest.number;
    const fresh = newest.time > (this.link.latest("ExerciseStatus")?.time ?? Infinity) - kFresh;
    if (!fresh || newest.text === kByHand || newest.state !== BridgeOrderState.ORDER_GIVEN) return;
    for (const listener of this.listeners) listener(newest);
  }
}
