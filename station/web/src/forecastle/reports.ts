// Reports to the bridge in two touches. Nothing is filled in: a report says what the trainee touched, and no more.

import { Refused, type Connection } from "../wire/connection";
import { CableWeight, Growing, ReportCode, StayGiven } from "../wire/generated";
import { h, setAttribute, svg } from "../kit/dom";
import { growings, stays, weights } from "../kit/orders";
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
}

// The pad has them in the order of the drill: letting go, the cable, bringing up, weighing.
const lettingGo: readonly [string, ReportCode][] = [
  ["Standing by", ReportCode.REPORT_STANDING_BY],
  ["Ready", ReportCode.REPORT_ANCHOR_READY],
  ["Let go", ReportCode.REPORT_LET_GO],
  ["On the bottom", ReportCode.REPORT_ON_THE_BOTTOM],
];
const bringingUpAndWeighing: readonly [string, ReportCode][] = [
  ["Brought up", ReportCode.REPORT_BROUGHT_UP],
  ["Secured", ReportCode.REPORT_SECURED],
  ["Heaving", ReportCode.REPORT_HEAVING],
  ["Short stay", ReportCode.REPORT_SHORT_STAY],
  ["Up and down", ReportCode.REPORT_UP_AND_DOWN],
  ["Aweigh", ReportCode.REPORT_ANCHOR_AWEIGH],
  ["Clear", ReportCode.REPORT_CLEAR_ANCHOR],
  ["Foul", ReportCode.REPORT_FOUL_ANCHOR],
  ["Home", ReportCode.REPORT_ANCHOR_HOME],
];
const counted: readonly [string, ReportCode][] = [
  ["in water", ReportCode.REPORT_SHACKLES_IN_WATER],
  ["on deck", ReportCode.REPORT_SHACKLES_ON_DECK],
  ["in pipe", ReportCode.REPORT_SHACKLES_IN_PIPE],
];
const troubles: readonly [string, ReportCode][] = [
  ["Cable does not run", ReportCode.REPORT_DOES_NOT_RUN],
  ["Brake does not hold", ReportCode.REPORT_BRAKE_DOES_NOT_HOLD],
  ["No power", ReportCode.REPORT_NO_POWER],
  ["She is dragging", ReportCode.REPORT_DRAGGING],
  ["Stand clear", ReportCode.REPORT_STAND_CLEAR],
];

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
    const simple = (all: readonly [string, ReportCode][]): HTMLButtonElement[] =>
      all.map(([text, code]) => h("button", { onclick: () => this.say(code) }, text));
    const first = simple(lettingGo);
    this.first = first[0]!;
    this.element = h(
      "section",
      { class: "panel reports", "aria-label": "reports" },
      h("h2", {}, "Report"),
      h(
        "div",
        { class: "report-pad" },
        ...first,
        ...counted.map(([text, code]) => this.opens(`n ${text}`, `shackles ${text}`, () => [this.counts(code)])),
        this.opens("Lead", "how the cable leads", () => [this.leads()]),
        this.opens("Growing, weight", "how the cable grows, or what weight is on it", () => [
          this.choices(growings, (growing) => this.say(ReportCode.REPORT_GROWING, { growing: Growing[growing] })),
          this.choices(weights, (weight) => this.say(ReportCode.REPORT_WEIGHT, { weight: CableWeight[weight] })),
        ]),
        ...simple(bringingUpAndWeighing),
        this.opens("Trouble", "trouble", () => [
          h(
            "div",
            { class: "choices" },
            ...troubles.map(([text, code]) => h("button", { onclick: () => this.say(code) }, text)),
            this.opens("Turns in the cable", "turns in the cable", () => [this.counts(ReportCode.REPORT_TURNS)]),
          ),
        ]),
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

  private choices<E extends number>(words: Record<E, string>, chosen: (choice: E) => void): HTMLElement {
    const given = Object.entries<string>(words).filter(([, text]) => text);
    return h(
      "div",
      { class: "choices" },
      ...given.map(([value, text]) => h("button", { onclick: () => chosen(Number(value) as E) }, text)),
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
        stays[given],
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
