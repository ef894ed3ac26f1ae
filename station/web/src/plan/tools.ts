// The plan's buttons, and what its bearing lines and ruler read.

import { h, setAttribute, setText } from "../kit/dom";
import { radians } from "../kit/units";
import type { Box } from "./lettering";
import type { Measuring } from "./measuring";
import type { ParallelIndex } from "./parallel_index";
import { t } from "../kit/language";

/** What the buttons act on: the plan. */
export interface PlanActions {
  follows: boolean;
  headUp: boolean;
  rings: boolean;
  readonly measuring: Measuring;
  readonly index?: ParallelIndex | undefined;
  readonly ship: { heading: number } | undefined;
  zoom(factor: number): void;
  fit(): void;
  toggleBearing(which: 0 | 1): void;
  toggleRuler(): void;
  showIndex(from: HTMLElement): void;
  redraw(): void;
}

export class PlanTools {
  readonly element: HTMLElement;
  private readonly shown: (() => void)[] = [];

  constructor(private readonly plan: PlanActions) {
    const bearingButton = (which: 0 | 1): HTMLElement => {
      const button = this.toggle(
        `EBL ${which + 1}`,
        t("bearing line and range ring {which}; arrow keys turn it and change its range", { which: which + 1 }),
        () => this.plan.measuring.lines[which].on,
        () => this.plan.toggleBearing(which),
        () => this.plan.measuring.text(which, this.plan.ship?.heading),
      );
      button.addEventListener("keydown", (event) => this.turn(which, event));
      return button;
    };
    this.element = h(
      "div",
      { class: "plan-tools", role: "toolbar", "aria-label": t("plan") },
      this.button("+", t("zoom in"), () => plan.zoom(1.25)),
      this.button("\u2212", t("zoom out"), () => plan.zoom(0.8)),
      this.button(t("Fit"), t("fit: own ship, anchors and circles in sight"), () => plan.fit()),
      this.toggle(
        t("Own ship"),
        t("own ship in the middle"),
        () => plan.follows,
        () => (plan.follows = !plan.follows),
      ),
      this.toggle(
        t("Head up"),
        t("heading up instead of north up"),
        () => plan.headUp,
        () => (plan.headUp = !plan.headUp),
      ),
      this.toggle(
        t("Rings"),
        t("range rings"),
        () => plan.rings,
        () => (plan.rings = !plan.rings),
      ),
      bearingButton(0),
      bearingButton(1),
      this.toggle(
        t("Ruler"),
        t("ruler"),
        () => plan.measuring.ruler.on,
        () => plan.toggleRuler(),
        () => plan.measuring.rulerText(),
      ),
      ...(plan.index ? [this.indexButton(plan.index)] : []),
    );
  }

  private indexButton(index: ParallelIndex): HTMLElement {
    const button = this.toggle(
      "PI",
      t("parallel index: lines parallel to a course, at a distance from own ship"),
      () => index.lines.some(({ on }) => on),
      () => this.plan.showIndex(button),
    );
    setAttribute(button, "aria-haspopup", "dialog");
    return button;
  }

  /** Where the buttons lie on the plan, px. */
  boxes(): Box[] {
    const { offsetLeft, offsetTop } = this.element;
    return Array.from(this.element.children as HTMLCollectionOf<HTMLElement>, (button) => {
      const [left, top] = [offsetLeft + button.offsetLeft, offsetTop + button.offsetTop];
      return { left, top, right: left + button.offsetWidth, bottom: top + button.offsetHeight };
    });
  }

  /** Follows the plan's state. */
  update(): void {
    for (const show of this.shown) show();
  }

  private button(text: string, name: string, act: () => void): HTMLButtonElement {
    return h("button", { class: "plain", type: "button", "aria-label": name, title: name, onclick: act }, text);
  }

  private toggle(
    text: string,
    name: string,
    on: () => boolean,
    act: () => void,
    reads: () => string = () => "",
  ): HTMLButtonElement {
    const figure = h("span", { class: "reads" });
    const button = h("button", { class: "plain", type: "button", title: name, onclick: act }, text, figure);
    this.shown.push(() => {
      setAttribute(button, "aria-pressed", `${on()}`);
      setText(figure, reads() && ` ${reads()}`);
    });
    return button;
  }

  /** Left and right turn a bearing line by a degree, up and down change its range by a hundredth. */
  private turn(which: 0 | 1, event: KeyboardEvent): void {
    const line = this.plan.measuring.lines[which];
    const turns: Record<string, number> = { ArrowLeft: -1, ArrowRight: 1 };
    const ranges: Record<string, number> = { ArrowUp: 1.01, ArrowDown: 1 / 1.01 };
    if (!line.on || !(event.key in turns || event.key in ranges)) return;
    line.bearing = (line.bearing + radians(turns[event.key] ?? 0) + 2 * Math.PI) % (2 * Math.PI);
    line.range *= ranges[event.key] ?? 1;
    event.preventDefault();
    event.stopPropagation();
    this.plan.redraw();
  }
}
