// Reports to the bridge in two touches: those that the phase of the work asks for lie open, the others a touch farther.
// Nothing is filled in: a report says what the trainee touched, and no more.

import { Refused, type Connection } from "../wire/connection";
import { type BridgeOrder, BridgeOrderCode, CableWeight, Growing, ReportCode, StayGiven } from "../wire/generated";
import { h, setAttribute, setText, svg } from "../kit/dom";
import { reportsOf } from "../kit/order_done";
import { written } from "../kit/orders";
import { type PadLeaf, allSaid, capital, orderRows, padLeaves, placeOf, reportRows, saidOf } from "../kit/words";
import { figurePad } from "../kit/pad";
import { Popover } from "../kit/popover";
import { TypedCount, kMostWords } from "../kit/typed_count";
import type { Work } from "./work";
import { t, translated } from "../kit/language";

/** What a report says beside its code; enumerators by name. */
export interface Said {
  value?: number;
  lead?: number;
  stay?: string;
  growing?: string;
  weight?: string;
  text?: string;
  /** Proposed instead of what is unsafe. */
  order_code?: string;
}

interface Choice {
  code: ReportCode;
  label: string;
  /** What its figure counts, where it is asked for one. */
  unit: string | undefined;
}
/** The reports of a leaf of the pad, in the order of the drill. */
const onLeaf = ({ reports }: PadLeaf): Choice[] => reports.flatMap((name) => choiceOf(placeOf("ReportCode", name)));
function choiceOf(code: ReportCode): Choice[] {
  const { label, unit } = reportRows[code] ?? {};
  return label ? [{ code, label, unit }] : [];
}
/** Reports that are said by a touch of what they tell. */
const kOfChoices = new Set([ReportCode.REPORT_LEAD, ReportCode.REPORT_GROWING, ReportCode.REPORT_WEIGHT]);
/** What the lead says too, with the hour to it. */
const kOfTheLead = new Set([ReportCode.REPORT_SHORT_STAY, ReportCode.REPORT_UP_AND_DOWN]);
const labelOf = (code: ReportCode): string => reportRows[code]!.label!;

export class Reports {
  readonly element: HTMLElement;
  private readonly pad = h("div", { class: "report-pad", lang: "en" });
  private readonly leaves: HTMLButtonElement[];
  private readonly popover: Popover;
  private turnedTo: PadLeaf | undefined; // by a touch, until the work goes on
  private shown: PadLeaf | undefined;

  /** side: the windlass in hand; tell: for what became of it. */
  constructor(
    private readonly link: Connection,
    private readonly work: Work,
    private readonly side: () => number,
    private readonly tell: (text: string) => void,
  ) {
    this.leaves = padLeaves.map((leaf) =>
      h(
        "button",
        { class: "plain", "data-leaf": leaf.const, onclick: () => this.turn(leaf) },
        capital(translated(leaf.said)),
      ),
    );
    this.element = h(
      "section",
      { class: "panel reports", "aria-label": t("reports") },
      h(
        "div",
        { class: "row" },
        h("h2", {}, t("Report")),
        h(
          "div",
          { class: "leaves", role: "group", "aria-label": t("reports of") },
          ...this.leaves,
          this.opens(t("Own words"), t("in own words"), () => [this.words()], "plain"),
        ),
      ),
      this.pad,
    );
    this.popover = new Popover(this.element); // here: what is reported is to be seen in the picture meanwhile
    work.onTurn(() => this.turn(undefined));
    link.on("ForecastleView", (view) => view.side === this.side() && this.show()); // of the anchor, at first
    this.show();
  }

  /** Shows the leaf of the windlass that was taken in hand. */
  showSide(): void {
    this.turn(undefined);
  }

  private turn(leaf: PadLeaf | undefined): void {
    this.turnedTo = leaf;
    this.show();
  }

  private show(): void {
    const wanted = this.work.leaf(this.side());
    const leaf = this.turnedTo ?? wanted;
    for (const button of this.leaves) {
      setAttribute(button, "aria-pressed", `${button.dataset.leaf === leaf.const}`);
      setAttribute(button, "data-wanted", button.dataset.leaf === wanted.const ? "" : undefined);
    }
    if (leaf === this.shown) return;
    this.shown = leaf;
    const within = this.pad.contains(document.activeElement);
    this.pad.replaceChildren(...this.buttons(leaf));
    if (within) this.focus();
  }

  /** The first button, for the keyboard. */
  focus(): void {
    this.pad.querySelector("button")?.focus();
  }

  /** Sends a report of the windlass in hand, or of that side; what is refused is told. */
  say(code: ReportCode, said: Said = {}, side = this.side()): void {
    this.popover.close();
    this.link
      .order("Report", { code: ReportCode[code], side, ...said })
      .catch((why: unknown) =>
        this.tell(why instanceof Refused ? t("report refused: {why}", { why: why.message }) : `${why}`),
      );
  }

  /** Offers what the bridge takes for an answer to its question, and no other reports. from: the question's button. */
  answer(question: BridgeOrder, from: HTMLElement): void {
    const side = question.side < 0 ? this.side() : question.side;
    const codes = reportsOf[question.code] ?? [];
    const asksLead = codes.includes(ReportCode.REPORT_LEAD);
    const plain: HTMLElement[] = codes.flatMap(choiceOf).flatMap(({ code, label, unit }) => {
      if (kOfChoices.has(code) || (asksLead && kOfTheLead.has(code))) return [];
      if (!unit) return [h("button", { onclick: () => this.say(code, {}, side) }, capital(label))];
      const pad = (): void => {
        this.popover.close(); // else the same button would only shut it
        this.popover.show(`shackles ${label}`, from, this.counts(code, side));
      };
      return [h("button", { "aria-haspopup": "dialog", onclick: pad }, `n ${label}`)];
    });
    this.popover.show(
      written(question),
      from,
      ...(plain.length > 0 ? [h("div", { class: "choices" }, ...plain)] : []),
      ...(codes.includes(ReportCode.REPORT_GROWING) ? [this.growing(side)] : []),
      ...(codes.includes(ReportCode.REPORT_WEIGHT) ? [this.weights(side)] : []),
      ...(asksLead ? [this.leads(side)] : []),
    );
  }

  /** A button for each report of a leaf: it says it, or asks first for what is to be said. */
  private buttons(leaf: PadLeaf): HTMLButtonElement[] {
    return onLeaf(leaf).flatMap(({ code, label, unit }) => {
      if (code === ReportCode.REPORT_WEIGHT) return []; // is asked for with how she grows
      if (code === ReportCode.REPORT_LEAD)
        return this.opens(capital(label), t("how the cable leads"), () => [this.leads()]);
      if (code === ReportCode.REPORT_GROWING)
        return this.opens(
          capital(`${label}, ${labelOf(ReportCode.REPORT_WEIGHT)}`),
          t("how the cable grows, or what weight is on it"),
          () => [this.growing(), this.weights()],
        );
      if (code === ReportCode.REPORT_UNSAFE)
        return this.opens(capital(label), t("unsafe: what you propose"), () => [this.proposals()]);
      if (unit === "shackle") return this.opens(`n ${label}`, `shackles ${label}`, () => [this.counts(code)]);
      if (unit) return this.opens(capital(label), label, () => [this.counts(code)]);
      return h("button", { onclick: () => this.say(code) }, capital(label));
    });
  }

  private opens(text: string, title: string, content: () => HTMLElement[], kind = ""): HTMLButtonElement {
    const button = h(
      "button",
      {
        class: kind,
        "aria-haspopup": "dialog",
        "aria-expanded": "false",
        onclick: () => this.popover.show(title, button, ...content()),
      },
      text,
    );
    return button;
  }

  private counts(code: ReportCode, side?: number): HTMLElement {
    return figurePad(t("how many"), (value) => this.say(code, { value }, side));
  }

  private growing(side?: number): HTMLElement {
    return this.choices("Growing", (growing) =>
      this.say(ReportCode.REPORT_GROWING, { growing: Growing[growing] }, side),
    );
  }

  private weights(side?: number): HTMLElement {
    return this.choices("CableWeight", (weight) =>
      this.say(ReportCode.REPORT_WEIGHT, { weight: CableWeight[weight] }, side),
    );
  }

  private choices(of: "Growing" | "CableWeight", chosen: (choice: number) => void): HTMLElement {
    const given = [...allSaid(of).entries()].filter(([, text]) => text);
    return h(
      "div",
      { class: "choices" },
      ...given.map(([value, text]) => h("button", { onclick: () => chosen(value) }, capital(text))),
    );
  }

  /** What may be ordered instead, as far as it needs no figure; nothing: the order is unsafe, and that is all. */
  private proposals(): HTMLElement {
    const propose = (text: string, order_code?: string): HTMLElement =>
      h(
        "button",
        { onclick: () => this.say(ReportCode.REPORT_UNSAFE, order_code ? { order_code } : {}) },
        capital(text),
      );
    return h(
      "div",
      { class: "choices" },
      ...orderRows.flatMap(({ label, unit, said_bare, repeat }, code: BridgeOrderCode) =>
        label && repeat > 0 && (!unit || said_bare)
          ? [propose(label.replace(/ (at|to)$/, ""), BridgeOrderCode[code])]
          : [],
      ),
      propose(t("nothing")),
    );
  }

  /** A clock face and the stay: it goes out when both are touched, up and down without an hour. */
  private leads(side?: number): HTMLElement {
    let hour = 0;
    let stay = StayGiven.STAY_NOT_GIVEN;
    const marks: SVGElement[] = [];
    const hint = h(
      "p",
      { class: "quiet", role: "status" },
      t("Touch hour and stay: both go out together. Up and down needs no hour."),
    );
    const say = (): void => {
      if (stay === StayGiven.STAY_NOT_GIVEN) setText(hint, t("Not sent yet: touch the stay."));
      else if (!hour && stay !== StayGiven.STAY_GIVEN_UP_AND_DOWN)
        setText(hint, t("Not sent yet: touch the hour to which it leads."));
      else this.say(ReportCode.REPORT_LEAD, { lead: hour, stay: StayGiven[stay] }, side);
    };
    const touch = (n: number): void => {
      hour = n;
      marks.forEach((mark, i) => setAttribute(mark, "aria-pressed", `${i + 1 === n}`));
      say();
    };
    for (let n = 1; n <= 12; ++n) {
      const angle = (n * Math.PI) / 6;
      const [x, y] = [76 * Math.sin(angle), -76 * Math.cos(angle)];
      marks.push(
        svg(
          "g",
          {
            class: "hour",
            role: "button",
            tabindex: 0,
            "aria-label": t("{hour} o'clock", { hour: n }),
            "aria-pressed": "false",
            onclick: () => touch(n),
            onkeydown: (event: KeyboardEvent) => (event.key === "Enter" || event.key === " ") && touch(n),
          },
          svg("circle", { cx: x, cy: y, r: 19 }),
          svg("text", { x, y: y + 5 }, n),
        ),
      );
    }
    const stayButtons = ([1, 2, 3, 4] as StayGiven[]).map((given) =>
      h(
        "button",
        {
          "aria-pressed": "false",
          onclick: () => {
            stay = given;
            stayButtons.forEach((button, i) => setAttribute(button, "aria-pressed", `${i + 1 === given}`));
            say();
          },
        },
        capital(saidOf("StayGiven", given)),
      ),
    );
    return h(
      "div",
      { class: "lead" },
      svg(
        "svg",
        { viewBox: "-100 -100 200 200", class: "clock", role: "group", "aria-label": t("hour, 12 ahead") },
        svg("path", { d: "M 0 -46 C 16 -30 18 0 16 34 L -16 34 C -18 0 -16 -30 0 -46 Z", class: "ship" }),
        ...marks,
      ),
      h("div", { class: "choices" }, ...stayButtons),
      hint,
    );
  }

  private words(): HTMLElement {
    const field = h("input", { type: "text", "aria-label": t("report in own words") });
    const typed = new TypedCount(field, kMostWords.report);
    const say = (code: ReportCode): void => {
      const text = typed.text();
      if (text) this.say(code, { text });
      else field.focus();
    };
    field.addEventListener("keydown", (event) => {
      if (event.key !== "Enter") return;
      event.preventDefault(); // else it presses what has the focus afterwards
      say(ReportCode.REPORT_TEXT);
    });
    return h(
      "div",
      { class: "own-words" },
      field,
      h("button", { class: "primary", onclick: () => say(ReportCode.REPORT_TEXT) }, t("Report")),
      h("button", { onclick: () => say(ReportCode.REPORT_DEFECT) }, t("Report a defect")),
      typed.element,
    );
  }
}
