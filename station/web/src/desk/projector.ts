// The desk as a room is shown it: pictures and plots fill the screen, with the loads and forces of one windlass in
// large figures above them and the timeline below. Levers, faults and talk stay with the instructor.

import { h, setAttribute, setText } from "../kit/dom";
import { showsTopic } from "../kit/live";
import { everySecond } from "../kit/page";
import { Measure, clock, sideWord, unitWritten } from "../kit/units";
import type { PlotBoard } from "../plots/board";
import type { Desk } from "./desk";
import type { Timeline } from "./timeline";
import { truthRows } from "./truth";
import { t } from "../kit/language";

const kLarge = 1.4; // times the usual size of what plots and timeline write

export class Projector {
  /** Turns it on and off. */
  readonly button = h(
    "button",
    { class: "chip", "aria-pressed": "false", onclick: () => this.toggle() },
    t("Full screen"),
  );
  /** What is in the picture beside the views; shown while it is on. */
  readonly choice: HTMLElement;
  /** The large figures; shown while it is on. */
  readonly figures: HTMLElement;
  private readonly what = h("strong", {});
  private readonly plotsShown = this.part(t("Plots"), "without-plots");
  private readonly figuresShown = this.part(t("Figures"), "without-figures");
  private on = false;

  /** root: the page's main element; plots and timeline write larger while it is on. */
  constructor(
    desk: Desk,
    private readonly root: HTMLElement,
    private readonly plots: PlotBoard,
    private readonly timeline: Timeline,
  ) {
    this.choice = h(
      "div",
      { class: "chips projected", role: "group", "aria-label": t("beside the picture") },
      this.plotsShown,
      this.figuresShown,
    );
    const cells = truthRows
      .filter(({ projected }) => projected)
      .map((row) => ({ row, value: h("b", {}), unit: h("small", {}) }));
    this.figures = h(
      "section",
      { class: "projected figures-large", "aria-label": t("loads and forces") },
      h("p", {}, this.what),
      h(
        "dl",
        {},
        ...cells.map(({ row, value, unit }) => h("div", {}, h("dt", {}, row.label), h("dd", {}, value, " ", unit))),
      ),
    );
    showsTopic(this.figures, desk.link, "WindlassLoad", () => desk.side);
    document.addEventListener("fullscreenchange", () => {
      if (this.on && !document.fullscreenElement) this.show(false); // by Escape
    });
    everySecond(4, () => {
      if (!this.on) return;
      const status = desk.link.latest("ExerciseStatus");
      if (status) setText(this.what, `${clock(status.time)}  ${sideWord(desk.side)}`);
      for (const { row, value, unit } of cells) {
        setText(value, row.is(desk.link, desk.side));
        setText(unit, row.unit instanceof Measure ? unitWritten(row.unit.unit) : row.unit);
        setAttribute(value, "data-warns", row.warns?.(desk.link, desk.side) ? "" : undefined);
      }
    });
  }

  private part(text: string, without: string): HTMLButtonElement {
    const button = h(
      "button",
      {
        class: "chip",
        "aria-pressed": "true",
        onclick: () => {
          const hidden = this.root.classList.toggle(without);
          setAttribute(button, "aria-pressed", `${!hidden}`);
        },
      },
      text,
    );
    return button;
  }

  private toggle(): void {
    this.show(!this.on);
    // A browser that does not give the screen away shows it in its window.
    if (this.on) void this.root.requestFullscreen?.().catch((why: Error) => console.info(why.message));
    else if (document.fullscreenElement) void document.exitFullscreen();
  }

  private show(on: boolean): void {
    this.on = on;
    this.root.classList.toggle("projecting", on);
    setAttribute(this.button, "aria-pressed", `${on}`);
    setText(this.button, on ? t("Leave full screen") : t("Full screen"));
    this.plots.enlarge(on ? kLarge : 1);
    this.timeline.enlarge(on ? kLarge : 1);
  }
}
