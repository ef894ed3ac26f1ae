// Reports to the bridge in two touches. Nothing is filled in: a report says what the trainee touched, and no more.

import { Refused, type Connection } from "../wire/connection";
import { BridgeOrderCode, CableWeight, Growing, ReportCode, StayGiven } from "../wire/generated";
import { h, setAttribute, svg } from "../kit/dom";
import { allSaid, capital, orderRows, reportRows, saidOf } from "../kit/words";
import { figurePad } from "./pad";
import type { Popover } from "./popover";

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
  /** Its figure is asked for. */
  counts: boolean;
}
/** The reports of a part of the pad, in the order of the drill. */
const onPad = (part: string): Choice[] =>
  reportRows.flatMap(({ label, pad, unit }, code: ReportCode) =>
    pad === part && label ? [{ code, label, counts: unit !== undefined }] : [],
  );

export class Reports {
  readonly element: HTMLElement;
  private readonly first: HTMLButtonElement;

  /** side: the windlass in hand; tell: for what became of it. */
  constructor(
    private readonly link: Connection,
    private readonly side: () => number,
    private readonly popover: Popover,
    private readonly tell: (text: string) => void,
  ) {
    const labelled = (part: string): string => onPad(part)[0]!.label;
    const first = this.buttons("letting_go");
    this.first = first[0]!;
    this.element = h(
      "section",
      { class: "panel reports", "aria-label": "reports" },
      h("h2", {}, "Report"),
      h(
        "div",
        { class: "report-pad" },
        ...first,
        ...onPad("cable").map(({ code, label }) =>
          this.opens(`n ${label}`, `shackles ${label}`, () => [this.counts(code)]),
        ),
        this.opens(capital(labelled("lead")), "how the cable leads", () => [this.leads()]),
        this.opens(
          capital(`${labelled("growing")}, ${labelled("weight")}`),
          "how the cable grows, or what weight is on it",
          () => [
            this.choices("Growing", (growing) => this.say(ReportCode.REPORT_GROWING, { growing: Growing[growing] })),
            this.choices("CableWeight", (weight) =>
              this.say(ReportCode.REPORT_WEIGHT, { weight: CableWeight[weight] }),
            ),
          ],
        ),
        ...this.buttons("weighing"),
        this.opens("Trouble", "trouble", () => [h("div", { class: "choices" }, ...this.buttons("trouble"))]),
        this.opens(capital(labelled("proposal")), "unsafe: what you propose", () => [this.proposals()]),
        this.opens("Own words", "in own words", () => [this.words()]),
      ),
    );
  }

  /** The first button, for the keyboard. */
  focus(): void {
    this.first.focus();
  }

  /** Sends a report of the windlass in hand; what is refused is told. */
  say(code: ReportCode, said: Said = {}): void {
    this.popover.close();
    this.link
      .order("Report", { code: ReportCode[code], side: this.side(), ...said })
      .catch((why: unknown) => this.tell(why instanceof Refused ? `report refused: ${why.message}` : `${why}`));
  }

  /** A button for each report of a part of the pad: it says it, or asks for its figure first. */
  private buttons(part: string): HTMLButtonElement[] {
    return onPad(part).map(({ code, label, counts }) =>
      counts
        ? this.opens(capital(label), label, () => [this.counts(code)])
        : h("button", { onclick: () => this.say(code) }, capital(label)),
    );
  }

  private opens(text: string, title: string, content: () => HTMLElement[]): HTMLButtonElement {
    const button = h(
      "button",
      {
        "aria-haspopup": "dialog",
        "aria-expanded": "false",
        onclick: () => this.popover.show(title, button, ...content()),
      },
      text,
    );
    return button;
  }

  private counts(code: ReportCode): HTMLElement {
    return figurePad("how many", (value) => this.say(code, { value }));
  }

  private choices(of: "Growing" | "CableWeight", chosen: (choice: number) => void): HTMLElement {
    const given = [...allSaid(of).entries()].filter(([, text]) => text);
    return h(
      "div",
      { class: "choices" },
      ...given.map(([value, text]) => h("button", { onclick: () => chosen(value) }, text)),
    );
  }

  /** What may be ordered instead, as far as it needs no figure; nothing: the order is unsafe, and that is all. */
  private proposals(): HTMLElement {
    const propose = (text: string, order_code?: string): HTMLElement =>
      h("button", { onclick: () => this.say(ReportCode.REPORT_UNSAFE, order_code ? { order_code } : {}) }, text);
    return h(
      "div",
      { class: "choices" },
      ...orderRows.flatMap(({ label, unit, said_bare, repeat }, code: BridgeOrderCode) =>
        label && repeat > 0 && (!unit || said_bare)
          ? [propose(label.replace(/ (at|to)$/, ""), BridgeOrderCode[code])]
          : [],
      ),
      propose("nothing"),
    );
  }

  /** A clock face and the stay: it goes out when both are touched, up and down without an hour. */
  private leads(): HTMLElement {
    let hour = 0;
    let stay = StayGiven.STAY_NOT_GIVEN;
    const marks: SVGElement[] = [];
    const say = (): void => {
      if (stay !== StayGiven.STAY_NOT_GIVEN && (hour || stay === StayGiven.STAY_GIVEN_UP_AND_DOWN))
        this.say(ReportCode.REPORT_LEAD, { lead: hour, stay: StayGiven[stay] });
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
            "aria-label": `${n} o'clock`,
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
        saidOf("StayGiven", given),
      ),
    );
    return h(
      "div",
      { class: "lead" },
      svg(
        "svg",
        { viewBox: "-100 -100 200 200", class: "clock", role: "group", "aria-label": "hour, 12 ahead" },
        svg("path", { d: "M 0 -46 C 16 -30 18 0 16 34 L -16 34 C -18 0 -16 -30 0 -46 Z", class: "ship" }),
        ...marks,
      ),
      h("div", { class: "choices" }, ...stayButtons),
    );
  }

  private words(): HTMLElement {
    const field = h("input", { type: "text", maxLength: 120, "aria-label": "report in own words" });
    const say = (code: ReportCode): void => {
      const text = field.value.trim();
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
      h("button", { class: "primary", onclick: () => say(ReportCode.REPORT_TEXT) }, "Report"),
      h("button", { onclick: () => say(ReportCode.REPORT_DEFECT) }, "Report a defect"),
    );
  }
}
