// What was noticed on the forecastle, with its time.

import type { Connection } from "../wire/connection";
import { EventSeverity, type SeatEvent } from "../wire/generated";
import { h } from "../kit/dom";
import { clock, sideName } from "../kit/units";

const kShown = 200;

const words: Record<EventSeverity, string> = {
  [EventSeverity.EVENT_INFO]: "",
  [EventSeverity.EVENT_CAUTION]: "caution",
  [EventSeverity.EVENT_WARNING]: "warning",
  [EventSeverity.EVENT_ALARM]: "alarm",
};

export class Log {
  readonly element = h("ol", { class: "log", "aria-label": "log", tabindex: 0 });
  private readonly seen = new Set<string>();

  constructor(link: Connection) {
    const isNews = (event: SeatEvent): boolean => event.forecastle && event.code !== "exercise.briefing"; // has its dialog
    link.on("SeatEvent", (event) => isNews(event) && this.add(event, link.latest("ExerciseStatus")?.run));
    link.onState((state) => {
      if (state !== "open") return;
      this.seen.clear(); // all of it comes again
      this.element.replaceChildren();
    });
  }

  private add(event: SeatEvent, run: number | undefined): void {
    const key = `${run}/${event.number}`;
    if (this.seen.has(key)) return;
    this.seen.add(key);
    const side = event.side >= 0 && !event.text.includes(sideName(event.side)) ? `${sideName(event.side)}: ` : "";
    const severity = words[event.severity];
    this.element.prepend(
      h(
        "li",
        { "data-code": event.code, "data-severity": severity || "info" },
        h("time", {}, clock(event.time)),
        h("span", {}, severity ? `${severity}: ` : "", side, event.text),
      ),
    );
    while (this.element.childElementCount > kShown) this.element.lastElementChild?.remove();
  }
}
