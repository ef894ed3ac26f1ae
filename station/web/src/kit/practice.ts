// What this seat may ask for in an attempt for practice: a hint, and the lesson's model hands shown over its own
// levers. The server says what there is, by an event to this seat alone.

import type { Connection } from "../wire/connection";
import type { SeatEvent } from "../wire/generated";
import { h, setAttribute, setShown, setText } from "./dom";
import { t } from "./language";

/** Of the event's value. */
const kGhost = 1;
const kGhostOn = 2;
const kHints = 4;
const kHintWanted = 8;

const kFresh = 1500; // ms, after which hands that are not shown any more are gone: ten a second come
const kLate = 1; // s of exercise, by which hands may be late without a word about it

const kOf = {
  forecastle: { told: "ForecastleInstruction", asks: "ForecastleAnswer", ghost: "ForecastleGhost" },
  bridge: { told: "BridgeInstruction", asks: "BridgeAnswer", ghost: "BridgeGhost" },
} as const;

export class Practice<Seat extends keyof typeof kOf> {
  readonly element: HTMLElement;
  private readonly hint = h("button", { class: "plain", onclick: () => void this.ask("hint", 1) }, t("Hint"));
  private readonly ghost: HTMLButtonElement;
  private readonly words = h("span", { class: "figures" });
  private readonly state = h("span", { role: "status" });
  private offered = 0;

  constructor(
    private readonly link: Connection,
    private readonly seat: Seat,
  ) {
    const toggle = (): void => void this.ask("ghost", this.isOn ? 0 : 1);
    this.ghost = h("button", { class: "plain", "aria-pressed": "false", onclick: toggle }, t("Model hands"));
    this.element = h(
      "div",
      { class: "row practice", role: "group", "aria-label": t("for practice"), hidden: true },
      this.hint,
      this.ghost,
      this.state,
      this.words,
    );
    link.on(kOf[seat].told, (event) => this.take(event));
    link.onState(() => this.show());
  }

  /** What the model's hands do now, of one windlass or of the helm; undefined: they are not shown. now: ms. */
  hands(now: number, side?: number) {
    if (!this.isOn) return undefined;
    const ghost = kOf[this.seat].ghost as (typeof kOf)[Seat]["ghost"];
    const hands = this.link.latest(ghost, side); // which is what subscribes to it
    return now - this.link.heardAt(ghost, side) > kFresh ? undefined : hands;
  }

  /** What is said of them: figures, and by how much they are late. */
  tell(hands: { time: number } | undefined, figures: string): void {
    const now = this.link.latest("ExerciseStatus")?.time ?? 0;
    const late = hands ? Math.round(now - hands.time) : 0;
    setText(this.words, hands ? figures : "");
    const wait = hands
      ? late > kLate
        ? t("{late} s behind you, where it waits for your lesson", { late })
        : ""
      : t("catching up …");
    setText(this.state, this.isSearching ? t("looking for a hint …") : this.isOn ? wait : "");
  }

  private get isOn(): boolean {
    return (this.offered & kGhostOn) !== 0;
  }
  private get isSearching(): boolean {
    return (this.offered & kHintWanted) !== 0;
  }

  private take({ code, value }: SeatEvent): void {
    if (code !== `practice.${this.seat}`) return;
    this.offered = value;
    this.show();
  }

  /** Whoever looks on may ask for nothing. */
  private show(): void {
    const may = this.link.hello?.commands.includes(kOf[this.seat].asks) ?? false;
    this.element.hidden = this.offered === 0;
    this.hint.disabled = !may || (this.offered & kHints) === 0 || this.isSearching;
    this.ghost.disabled = !may;
    setShown(this.ghost, (this.offered & kGhost) !== 0);
    setAttribute(this.ghost, "aria-pressed", `${this.isOn}`);
    this.tell(undefined, "");
  }

  private async ask(what: "hint" | "ghost", choice: number): Promise<void> {
    try {
      const question = `practice/${what}/${this.seat}`;
      await this.link.order(kOf[this.seat].asks, { question, kind: "ANSWER_CHOICE", choice });
    } catch (why) {
      setText(this.state, t("Not taken: {why}", { why: (why as Error).message }));
    }
  }
}
