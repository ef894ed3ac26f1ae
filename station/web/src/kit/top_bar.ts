// The bar on top of every page: where one is, exercise time and state, alerts, units, palette.

import type { Connection } from "../wire/connection";
import { type ExerciseStatus, RunState } from "../wire/generated";
import type { AlertPanel } from "./alerts";
import { h, setAttribute, setShown, setText } from "./dom";
import { runStateWords } from "./run_state";
import { nextPalette, onPalette, paletteLabel, paletteWord } from "./palette";
import { UnitChoice } from "./unit_choice";
import { clock, figure } from "./units";
import { t } from "./language";
import { languageButton } from "./language_choice";
import { unfoldButton } from "./unfold";

/** As many digits as a scale has: 1, 0.5, 0.25. */
const scaleDigits = (scale: number): number =>
  Math.min(2, `${Math.round(100 * scale) / 100}`.split(".")[1]?.length ?? 0);

export class TopBar {
  readonly element: HTMLElement;
  /** For what a page adds: who has the levers, buttons. */
  readonly middle = h("div", { class: "middle" });
  private readonly seat = h("h1", { class: "seat" });
  private readonly exercise = h("span", { class: "exercise" });
  private readonly time = h("span", { class: "time", role: "timer", "aria-label": t("exercise time") });
  /** A replay has another clock beside it, of its recording. */
  private readonly whose = h("span", { class: "quiet", "aria-hidden": "true", hidden: true }, t("exercise time"));
  private readonly state = h("span", { class: "state" });
  private latest = (): ExerciseStatus | undefined => undefined;
  private silent = false;

  /** alerts: of the exercise that the page is of; without, the bar shows none. */
  constructor(link: Connection, title: string, alerts?: AlertPanel) {
    const choice = h(
      "button",
      {
        class: "plain",
        onclick: nextPalette,
      },
      paletteWord(),
    );
    choice.setAttribute("aria-label", paletteLabel());
    onPalette(() => {
      setText(choice, paletteWord());
      choice.setAttribute("aria-label", paletteLabel());
    });
    const units = alerts && new UnitChoice(() => link.holdsAny());
    this.element = h(
      "header",
      { class: "top-bar" },
      h("span", { class: "title" }, "Windlass"),
      this.seat,
      ...(alerts ? [this.exercise, this.whose, this.time, this.state] : []),
      this.middle,
      alerts?.sound.button,
      alerts?.button,
      units?.button,
      units?.element,
      !units && languageButton(),
      choice,
    );
    this.name(title);
    if (!alerts) return;
    choice.before(unfoldButton(this.element, t("more buttons"), "\u2630"));
    this.follow(link);
  }

  /** Whose page it is. */
  name(title: string): void {
    setText(this.seat, title);
  }

  private follow(link: Connection): void {
    link.on("ReplayStatus", () => {
      if (link.latest("ExerciseStatus")) return;
      setText(this.state, runStateWords(RunState.RUN_REPLAY)); // paused before the exercise's first word
      this.state.dataset.state = "RUN_REPLAY";
    });
    link.on("ExerciseStatus", (status) => this.show(status));
    this.latest = () => link.latest("ExerciseStatus");
  }

  /** While nothing is heard, nobody knows what the exercise does. */
  showSilent(silent: boolean): void {
    if (silent === this.silent) return;
    this.silent = silent;
    const status = this.latest();
    if (status) this.show(status);
  }

  private show(status: ExerciseStatus): void {
    setText(this.exercise, status.title || status.exercise);
    setAttribute(this.exercise, "title", status.title || status.exercise); // in full where there is no room for it
    setText(this.time, clock(status.time));
    setShown(this.whose, status.state === RunState.RUN_REPLAY);
    this.time.toggleAttribute("data-old", this.silent);
    const running = status.state === RunState.RUN_RUNNING;
    const achieved = status.time_scale_achieved;
    const slow = running && status.time_scale > 0 && achieved < 0.9 * status.time_scale;
    const scale = running ? ` x${figure(status.time_scale, scaleDigits(status.time_scale))}` : "";
    const falls = slow ? ` ${t("(x{scale} achieved)", { scale: figure(achieved, 1) })}` : "";
    const words = `${runStateWords(status.state)}${scale}${falls}`;
    setText(this.state, this.silent ? t("not heard") : words);
    this.state.dataset.state = this.silent ? "silent" : RunState[status.state];
  }
}
