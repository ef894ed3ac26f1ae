// Orders to the forecastle: one touch, or two where a figure goes with it. What was said stands under them.

import { kLeft } from "../kit/branch";
import { h, setAttribute, setText } from "../kit/dom";
import { showsTopic } from "../kit/live";
import { canBeCancelled, isAnswered } from "../kit/order_done";
import { isQuestion, orderMayBeBare, orderUnit } from "../kit/orders";
import { TypedCount, kMostWords } from "../kit/typed_count";
import { clock, inHalves } from "../kit/units";
import { capital, figureText, orderRows, orderText } from "../kit/words";
import type { Connection } from "../wire/connection";
import { BridgeOrderCode, BridgeOrderState } from "../wire/generated";
import { type Line, type Said, stateWords } from "./line";
import { t } from "../kit/language";

const C = BridgeOrderCode;
/** As an anchoring goes: those that have a button. */
const kOrders = orderRows.flatMap(({ label }, code: BridgeOrderCode) =>
  label ? [{ code, text: capital(label) }] : [],
);
const kinds = { order: t("order"), report: t("report"), notice: t("notice") };
const kShackles = [0.5, 1, 1.5, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12];
const kMetres = [1, 2, 3, 5, 8, 10, 15, 20, 25, 30, 40, 50, 60, 80];

export class OrderPanel {
  readonly element: HTMLElement;
  private side = 0;
  private readonly sides: HTMLButtonElement[];
  private readonly buttons: HTMLElement;
  private readonly pad = h("div", { class: "figure-pad", hidden: true, role: "group", lang: "en" });
  private readonly words = h("input", {
    type: "text",
    placeholder: t("in own words"),
    "aria-label": t("order in own words"),
  });
  private readonly typed = new TypedCount(this.words, kMostWords.order);
  private readonly vhf = h("p", { class: "vhf", role: "status" });
  private readonly refusal = h("p", { class: "refusal", role: "alert" });
  private readonly list = h("ol", { class: "said", "aria-label": t("said on the line"), tabIndex: 0 });
  private readonly news = h("div", { class: "sr-only", role: "log", "aria-live": "polite" });
  private told: string | undefined;
  private due = false;

  constructor(
    private readonly link: Connection,
    private readonly line: Line,
  ) {
    this.sides = [t("Port"), t("Both"), t("Starboard")].map((text, k) =>
      h("button", { class: "plain", type: "button", onclick: () => this.choose([0, -1, 1][k]!) }, text),
    );
    this.buttons = h(
      "div",
      { class: "order-buttons", lang: "en" },
      ...kOrders.map(({ code, text }) =>
        h(
          "button",
          {
            class: "plain",
            type: "button",
            "data-order": BridgeOrderCode[code],
            onclick: () => this.touch(code, text),
          },
          orderUnit(code) ? `${text} \u2026` : text,
        ),
      ),
    );
    const say = h(
      "form",
      {
        class: "row say",
        onsubmit: (event: Event) => {
          event.preventDefault();
          const text = this.words.value.trim();
          if (text) void this.give(C.BRIDGE_ORDER_TEXT, 0, text).then((given) => given && this.typed.clear());
        },
      },
      this.words,
      h("button", { class: "plain" }, t("Say")),
      this.typed.element,
    );
    this.element = h(
      "section",
      { class: "orders", "aria-label": t("orders and reports") },
      h(
        "div",
        { class: "row to" },
        h("h2", {}, t("Order to")),
        h("div", { class: "sides", role: "group", "aria-label": t("which anchor") }, ...this.sides),
      ),
      this.vhf,
      this.buttons,
      this.pad,
      say,
      this.refusal,
      this.list,
      this.news,
    );
    this.choose(0);
    line.onChange(() => this.later());
    link.onMessage("hello", () => this.later());
    showsTopic(this.vhf, link, "BridgeView");
    link.on("SceneDescription", ({ tackle }) => {
      if (tackle.length === 1) this.choose(tackle[0]!.side);
      this.sides.forEach((button, k) => {
        const side = [0, -1, 1][k]!;
        button.disabled = side === -1 ? tackle.length < 2 : !tackle.some((t) => t.side === side);
      });
    });
    this.show();
  }

  /** The side that orders are for: 0, 1, or -1 for both. */
  private choose(side: number): void {
    this.side = side;
    this.sides.forEach((button, k) => setAttribute(button, "aria-pressed", `${[0, -1, 1][k] === side}`));
  }

  private touch(code: BridgeOrderCode, text: string): void {
    const unit = orderUnit(code);
    if (!unit) {
      this.pad.hidden = true;
      void this.give(code, 0);
      return;
    }
    const open = this.pad.dataset.order !== BridgeOrderCode[code] || this.pad.hidden;
    this.pad.hidden = !open;
    if (!open) return;
    this.pad.dataset.order = BridgeOrderCode[code];
    setAttribute(this.pad, "aria-label", `${text}, ${unit.written}`);
    const choice = (value: number, name: string): HTMLElement =>
      h(
        "button",
        {
          class: "plain",
          type: "button",
          "aria-label": value ? `${text} ${figureText(value, unit)}` : `${text} ${name}`,
          onclick: () => {
            this.pad.hidden = true;
            void this.give(code, value);
          },
        },
        name,
      );
    this.pad.replaceChildren(
      h("p", {}, `${text} \u2026 ${unit.written}`),
      ...(orderMayBeBare(code) ? [choice(0, t("now"))] : []),
      ...(unit.one === "metre" ? kMetres : kShackles).map((value) => choice(value, inHalves(value))),
    );
    (this.pad.querySelector("button") as HTMLElement).focus();
    this.pad.scrollIntoView({ block: "nearest" }); // all of it, and not its first row alone
  }

  /** Whether it went out; what did not is told. */
  private async give(code: BridgeOrderCode, value: number, text = "", cancels = 0): Promise<boolean> {
    setText(this.refusal, "");
    try {
      await this.link.order("BridgeOrderCommand", {
        code: BridgeOrderCode[code],
        side: this.side,
        value,
        text,
        cancels,
      });
      return true;
    } catch (why) {
      setText(this.refusal, t("Not given: {why}", { why: (why as Error).message }));
      return false;
    }
  }

  /** The list is built anew at most once a frame. */
  private later(): void {
    if (this.due) return;
    this.due = true;
    requestAnimationFrame(() => {
      this.due = false;
      this.show();
    });
  }

  private show(): void {
    const granted = this.link.hello?.commands.includes("BridgeOrderCommand") ?? false;
    const works = this.line.works();
    setAttribute(this.element, "data-granted", granted ? "" : undefined);
    setAttribute(this.vhf, "data-dead", works ? undefined : "");
    setText(
      this.vhf,
      !works
        ? `\u26a0 ${t(
            "VHF is dead: no word gets through. Hand signals do in clear sight: let go, check, hold on, " +
              "walk back, heave, stop heaving, stand clear, without a figure.",
          )}`
        : !this.line.known()
          ? t("VHF: waiting …")
          : granted
            ? t("VHF works")
            : t("VHF works. This seat gives no orders: the conning seat or the instructor does."),
    );
    for (const control of this.element.querySelectorAll<HTMLButtonElement | HTMLInputElement>(
      ".order-buttons button, .figure-pad button, .say button, .say input",
    ))
      control.disabled = !granted;
    const said = this.line.log();
    this.list.replaceChildren(...said.slice(0, 100).map((s) => this.row(s, granted)));
    const newest = said.find((s) => s.kind === "report" && !s.left);
    const news = newest && `${clock(newest.time)} ${newest.text}`;
    if (news && this.told !== undefined && news !== this.told)
      setText(this.news, t("report: {text}", { text: newest.text }));
    this.told = news ?? "";
  }

  private row(said: Said, granted: boolean): HTMLElement {
    const { order } = said;
    const past = order && isQuestion(order) && this.line.saidOfBefore(order) !== "";
    const cancellable = order && granted && !past && canBeCancelled(order, this.line.orders(), this.line.heard());
    return h(
      "li",
      {
        "data-kind": said.kind,
        "data-state": order && BridgeOrderState[order.state],
        class: said.left ? "left" : undefined,
        title: said.left ? kLeft : undefined,
      },
      h("span", { class: "time" }, clock(said.time)),
      h(
        "span",
        { class: "sign", "aria-label": kinds[said.kind], role: "img" },
        { order: "\u25b8", report: "\u25c2", notice: "\u26a0" }[said.kind],
      ),
      h(
        "span",
        { class: "text" },
        order?.code === C.BRIDGE_ORDER_CANCEL ? orderText(order.code, order.side, 0) : said.text,
        order && h("small", {}, this.stateOf(said)),
      ),
      cancellable &&
        h(
          "button",
          {
            class: "plain",
            type: "button",
            "aria-label": t("cancel order {number}: {text}", { number: order.number, text: said.text }),
            onclick: () => void this.give(C.BRIDGE_ORDER_CANCEL, 0, "", order.number),
          },
          t("Cancel"),
        ),
    );
  }

  private stateOf({ order }: Said): string {
    if (!order) return "";
    const number = t("no. {number}", { number: order.number });
    const words = `${number} ${stateWords(order, this.line.orders())}`;
    if (order.state !== BridgeOrderState.ORDER_GIVEN) return words;
    if (isQuestion(order) && isAnswered(order, this.line.heard())) return `${number} \u2713 ${t("answered")}`;
    const before = isQuestion(order) && this.line.saidOfBefore(order);
    if (before) return `${number} ${before}`;
    if (order.repeat_by === 0) return number;
    return t("{order}, by {time}", { order: words, time: clock(order.repeat_by) });
  }
}
