// What was noticed on the forecastle, with its time.

import type { Connection } from "../wire/connection";
import { EventSeverity, type SeatEvent } from "../wire/generated";
import { begins, kLeft, leave } from "../kit/branch";
import { h, setAttribute } from "../kit/dom";
import { clock } from "../kit/units";
import { eventLine, nameOf, saidOf } from "../kit/words";
import { t } from "../kit/language";

const kShown = 200;

/** Whether an order that was repeated back tells all of what a report's line does: its repeat, at the same tick. */
export const tellsOf = (order: SeatEvent, report: SeatEvent): boolean =>
  order.code === "order.repeated" &&
  report.code === "report.made" &&
  order.tick === report.tick &&
  /^reported: repeats: .*, to order (\d+)$/s.exec(report.text)?.[1] === `${order.value}`;

/** A line and its element. */
interface Line {
  event: SeatEvent;
  time: number; // s, exercise time
  left: boolean;
  element: HTMLElement;
}

export class Log {
  readonly element = h("ol", { class: "log", "aria-label": t("log"), tabindex: 0 });
  private readonly seen = new Set<string>();
  private lines: Line[] = []; // the newest first

  constructor(link: Connection) {
    link.on("ForecastleEvent", (event) => event.code !== "exercise.briefing" && this.add(event)); // has its dialog
    link.on("ForecastleInstruction", (event) => event.code === "hint.forecastle" && this.add(event));
    link.onState((state) => {
      if (state !== "open") return;
      this.seen.clear(); // all of it comes again
      this.lines = [];
      this.element.replaceChildren();
    });
  }

  private add(event: SeatEvent): void {
    // A run of a restore counts from 1 again.
    const key = `${event.number}/${event.time}/${event.code}/${event.side}/${event.text}`;
    if (this.seen.has(key)) return;
    this.seen.add(key);
    this.strike(event);
    this.leaveOut(event);
    const info = event.severity === EventSeverity.EVENT_INFO;
    const severity = saidOf("EventSeverity", event.severity);
    const element = h(
      "li",
      { "data-code": event.code, "data-severity": nameOf("EventSeverity", event.severity) },
      h("time", {}, clock(event.time)),
      h("span", { class: "text" }, info ? "" : `${severity}: `, eventLine(event)),
    );
    this.element.prepend(element);
    this.lines.unshift({ event, time: event.time, left: false, element });
    for (const { element: oldest } of this.lines.splice(kShown)) oldest.remove();
  }

  /** One act has one line. */
  private leaveOut(event: SeatEvent): void {
    const told = this.lines.findIndex((line) => tellsOf(event, line.event));
    if (told >= 0) for (const { element } of this.lines.splice(told, 1)) element.remove();
  }

  /** What a restore has left has not happened. */
  private strike(event: SeatEvent): void {
    if (!begins(event)) return;
    leave(this.lines, event);
    for (const { left, element } of this.lines) {
      element.classList.toggle("left", left);
      setAttribute(element, "title", left ? kLeft : undefined);
    }
  }
}
