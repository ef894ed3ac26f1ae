// How an order is repeated back: by one touch, or with its figure as whoever has the forecastle understood it.

import { Refused, type Connection } from "../wire/connection";
import { type BridgeOrder, BridgeOrderCode } from "../wire/generated";
import { h } from "./dom";
import { t, translated } from "./language";
import { orderMayBeBare, orderUnit, written } from "./orders";
import { figureField, figurePad } from "./pad";
import type { Popover } from "./popover";
import { unitWritten } from "./units";

/** Whether its repeat asks for the figure first. */
const isRepeatedWithFigure = ({ code, value }: BridgeOrder): boolean =>
  orderUnit(code) !== undefined && !(value === 0 && orderMayBeBare(code));

export class RepeatBack {
  /** popover: for the figure; tell: for what became of a repeat. */
  constructor(
    private readonly link: Connection,
    private readonly popover: Popover,
    private readonly tell: (text: string) => void,
  ) {}

  /** The button of an order that waits to be repeated back. */
  button(order: BridgeOrder): HTMLButtonElement {
    const button = h(
      "button",
      {
        class: "primary",
        "aria-haspopup": isRepeatedWithFigure(order) && "dialog",
        "aria-label": t("repeat back: {order}", { order: written(order) }),
      },
      t("Repeat"),
    );
    button.addEventListener("click", () => this.ask(order, button));
    return button;
  }

  /** At one touch where the order has no figure; else the trainee says the figure. */
  private ask(order: BridgeOrder, button: HTMLButtonElement): void {
    const unit = orderUnit(order.code);
    if (!unit || !isRepeatedWithFigure(order)) {
      this.repeat(order, 0);
      return;
    }
    const many = translated(unit.many);
    const label = t("{units} ordered", { units: many });
    const pad =
      unit.one === "metre"
        ? figureField(label, unitWritten(unit), (value) => this.repeat(order, value))
        : figurePad(label, (value) => this.repeat(order, value));
    this.popover.show(t("repeat back: how many {units}?", { units: many }), button, pad);
  }

  private repeat(order: BridgeOrder, value: number): void {
    this.popover.close();
    this.link
      .order("Report", {
        code: "REPORT_ORDER_REPEATED",
        order_number: order.number,
        order_code: BridgeOrderCode[order.code],
        side: order.side,
        value,
        text: order.code === BridgeOrderCode.BRIDGE_ORDER_TEXT ? order.text : "",
      })
      .catch((why: unknown) =>
        this.tell(why instanceof Refused ? t("not repeated: {why}", { why: why.message }) : `${why}`),
      );
  }
}
