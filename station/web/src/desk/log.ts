// The log of the exercise: every event, newest on top, filtered, to be copied.

import { begins, kLeft } from "../kit/branch";
import { h, setText } from "../kit/dom";
import { clock, measures, sideName } from "../kit/units";
import { allSaid, saidOf, nameOf } from "../kit/words";
import { EventSeverity } from "../wire/generated";
import type { Desk } from "./desk";
import { type Logged, eventWords } from "./events";
import { t } from "../kit/language";

const kShown = 400;

export class LogPanel {
  readonly element: HTMLElement;
  private readonly list = h("ol", { class: "log scroll", "aria-label": t("events"), tabindex: 0 });
  private readonly filter = h("input", {
    type: "search",
    "aria-label": t("filter"),
    placeholder: t("Filter: code or word"),
    oninput: () => this.fill(),
  });
  private readonly least = h("select", { "aria-label": t("least severity"), onchange: () => this.fill() });
  private readonly state = h("span", { class: "quiet", role: "status" });

  constructor(
    private readonly desk: Desk,
    private readonly pick: (time: number) => void,
  ) {
    for (const [value, name] of allSaid("EventSeverity").entries())
      this.least.append(
        h("option", { value }, value === EventSeverity.EVENT_INFO ? t("all") : t("{name} and up", { name })),
      );
    this.element = h(
      "div",
      { class: "log-panel" },
      h(
        "div",
        { class: "row" },
        this.filter,
        this.least,
        h("button", { class: "plain", onclick: () => this.copy() }, t("Copy")),
        this.state,
      ),
      this.list,
    );
    desk.events.onChange((event) => (event && event === desk.events.all.at(-1) ? this.add(event) : this.fill()));
    for (const measure of measures) measure.onChoice(() => this.fill());
    this.fill();
  }

  private matches(event: Logged): boolean {
    const text = this.filter.value.trim().toLowerCase();
    return (
      event.severity >= Number(this.least.value) &&
      (!text || event.code.includes(text) || event.text.toLowerCase().includes(text))
    );
  }

  private fill(): void {
    const shown = this.desk.events.all
      .filter((event) => this.matches(event))
      .slice(-kShown)
      .reverse();
    this.list.replaceChildren(...shown.map((event) => this.row(event)));
  }

  private add(event: Logged): void {
    if (begins(event)) return this.fill(); // others are left aside now
    if (!this.matches(event)) return;
    this.list.prepend(this.row(event));
    if (this.list.children.length > kShown) this.list.lastElementChild!.remove();
  }

  private row(event: Logged): HTMLElement {
    const severity = saidOf("EventSeverity", event.severity);
    const goes = this.desk.may("ExerciseCommand") || this.desk.may("ReplayCommand");
    return h(
      "li",
      {
        "data-severity": nameOf("EventSeverity", event.severity),
        "data-code": event.code,
        class: event.left ? "left" : "",
        title: event.left ? `${event.code}; ${kLeft}` : event.code,
      },
      h(
        "button",
        {
          class: "time",
          ...(goes ? { title: t("to this moment") } : { disabled: true }),
          onclick: () => this.pick(event.time),
        },
        clock(event.time),
      ),
      h("span", { class: "severity" }, event.severity === EventSeverity.EVENT_INFO ? "" : severity),
      h("span", { class: "text" }, eventWords(event)),
    );
  }

  /** As a table of tabs, oldest first. */
  private async copy(): Promise<void> {
    const lines = this.desk.events.all
      .filter((event) => this.matches(event))
      .map((e) =>
        [
          e.time.toFixed(2),
          nameOf("EventSeverity", e.severity),
          e.code,
          e.side < 0 ? "" : sideName(e.side),
          e.text,
        ].join("\t"),
      );
    try {
      await navigator.clipboard.writeText(["time (s)\tseverity\tcode\tside\ttext", ...lines].join("\n"));
      setText(this.state, t("{count} lines copied", { count: lines.length }));
    } catch {
      setText(this.state, t("the browser does not let this page copy"));
    }
  }
}
