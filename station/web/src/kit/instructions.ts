// What is told to this seat alone: its own part of the briefing, and the hints of an attempt for practice. A server
// that tells a seat its briefing begins anew: what was told before is of another run.

import type { Connection } from "../wire/connection";
import type { SeatEvent } from "../wire/generated";
import { h, setAttribute, setText } from "./dom";
import { t } from "./language";
import { clock } from "./units";
import { eventText } from "./words";

export type OwnSeat = "forecastle" | "bridge";
const kShown = 60; // s of exercise time for which a hint stands there

/** Calls back for each piece of own briefing (number 1: the first; 0: there is none any more) and each hint. */
export function onInstruction(
  link: Connection,
  briefing: (seat: OwnSeat, number: number, text: string) => void,
  hint: (event: SeatEvent) => void,
): void {
  const hear = (event: SeatEvent): void => {
    const seat = event.forecastle ? "forecastle" : "bridge";
    if (event.code.startsWith("briefing.")) briefing(seat, event.value, event.text);
    else if (event.code.startsWith("hint.")) hint(event);
  };
  link.on("ForecastleInstruction", hear);
  link.on("BridgeInstruction", hear);
}

/** The newest hint to the seat of this page, for a minute, beside its orders. */
export class HintLine {
  readonly element = h("p", { class: "hint", role: "status", hidden: true });
  private readonly text = h("span", { lang: "en" });
  private readonly head = h("strong", {});
  private newest: SeatEvent | undefined;

  constructor(
    private readonly link: Connection,
    seat: OwnSeat,
  ) {
    this.element.append(this.head, this.text);
    onInstruction(
      link,
      (to) => to === seat && this.take(undefined),
      (event) => event[seat] && this.take(event),
    );
    link.on("ExerciseStatus", () => this.show());
  }

  private take(hint: SeatEvent | undefined): void {
    this.newest = hint;
    this.show();
  }

  private show(): void {
    const ago = this.newest ? (this.link.latest("ExerciseStatus")?.time ?? 0) - this.newest.time : Infinity;
    this.element.hidden = ago > kShown;
    if (!this.newest || this.element.hidden) return;
    setText(this.head, `${t("{time} hint:", { time: clock(this.newest.time) })} `);
    const text = eventText(this.newest);
    setText(this.text, text);
    setAttribute(this.text, "lang", text === this.newest.text ? "en" : undefined); // a lesson's own are its author's
  }
}
