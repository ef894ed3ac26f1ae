// One exercise of a classroom at a glance.

import { priorityName, priorityWords } from "../kit/alerts";
import { h, setAttribute, setText, setVariable } from "../kit/dom";
import { holdButton } from "../kit/hold_button";
import { pageAddress } from "../kit/page";
import { runStateWords } from "../kit/run_state";
import { clock, figure, sideWord } from "../kit/units";
import { type AlertPriority, type ClassroomExercise, RunState } from "../wire/generated";
import { t } from "../kit/language";
import { alertWords } from "../kit/words";

/** The most urgent alert of an exercise that waits to be acknowledged, as the gateway tells it. */
export interface TileAlert {
  code: string;
  priority: AlertPriority;
  side: number;
  text: string;
  raised_time: number;
  /** How many wait. */
  waiting: number;
}

export interface TileWishes {
  run: (id: string, action: "EXERCISE_START" | "EXERCISE_PAUSE") => void;
  remove: (server: string, id: string) => void;
}

export class Tile {
  readonly element: HTMLElement;
  private readonly check: HTMLInputElement;
  private readonly title = h("p", { class: "title" });
  private readonly state = h("strong", { class: "state" });
  private readonly time = h("span", { class: "time" });
  private readonly scale = h("span", {});
  private readonly load = h("b", {});
  private readonly bar = h("i", { class: "load", "aria-hidden": "true" });
  private readonly late = h("b", {});
  private readonly overruns = h("b", {});
  private readonly alert: HTMLAnchorElement;
  private readonly failure = h("p", { class: "failure", role: "status" });
  private readonly start: HTMLButtonElement;
  private readonly pause: HTMLButtonElement;

  constructor(
    readonly server: string,
    readonly id: string,
    wishes: TileWishes,
    picture: HTMLElement,
  ) {
    this.check = h("input", { type: "checkbox", "aria-label": t("choose {id}", { id }) });
    this.start = h(
      "button",
      { class: "plain", "aria-label": t("start {id}", { id }), onclick: () => wishes.run(id, "EXERCISE_START") },
      t("Start"),
    );
    this.pause = h(
      "button",
      { class: "plain", "aria-label": t("pause {id}", { id }), onclick: () => wishes.run(id, "EXERCISE_PAUSE") },
      t("Pause"),
    );
    this.alert = h("a", { class: "tile-alert", hidden: true, href: pageAddress("/instructor", { exercise: id }) });
    const desk = h(
      "a",
      { class: "button", "aria-label": t("desk of {id}", { id }), href: pageAddress("/instructor", { exercise: id }) },
      t("Desk"),
    );
    const remove = holdButton(t("Remove"), 1, () => wishes.remove(server, id), {
      class: "plain",
      "aria-label": t("remove {id}", { id }),
    });
    const figures = h(
      "dl",
      {},
      h("div", {}, h("dt", {}, t("speed")), h("dd", {}, this.scale)),
      h("div", {}, h("dt", {}, t("load of a core")), h("dd", {}, this.load, h("small", {}, " %")), this.bar),
      h("div", {}, h("dt", {}, t("late")), h("dd", {}, this.late, h("small", {}, " ms"))),
      h("div", {}, h("dt", {}, t("overruns")), h("dd", {}, this.overruns)),
    );
    this.element = h(
      "li",
      { class: "tile panel", "data-id": id },
      h("header", {}, this.check, h("h3", {}, id), this.state, this.time),
      this.alert,
      this.title,
      h("div", { class: "glance" }, picture, figures),
      this.failure,
      h("footer", {}, desk, this.start, this.pause, remove),
    );
  }

  get chosen(): boolean {
    return this.check.checked;
  }
  set chosen(on: boolean) {
    this.check.checked = on;
  }

  /** undefined: none waits. The whole line leads to the desk. */
  showAlert(alert: TileAlert | undefined): void {
    this.alert.hidden = !alert;
    if (!alert) return;
    const priority = priorityWords(alert.priority);
    setAttribute(this.alert, "data-priority", priorityName(alert.priority));
    const side = alert.side >= 0 ? `, ${sideWord(alert.side)}` : "";
    const { text } = alertWords({ ...alert, explanation: "" });
    const more = alert.waiting > 1 ? `, ${t("and {count} more", { count: alert.waiting - 1 })}` : "";
    setText(this.alert, `${priority}: ${text}${side}, ${clock(alert.raised_time)}${more}`);
    setAttribute(this.alert, "title", t("to the desk of {id}", { id: this.id }));
  }

  show(exercise: ClassroomExercise): void {
    const running = exercise.state === RunState.RUN_RUNNING;
    setText(this.title, exercise.title || exercise.exercise);
    setText(this.state, runStateWords(exercise.state));
    setAttribute(this.element, "data-state", RunState[exercise.state]);
    setText(this.time, clock(exercise.time));
    const asked =
      exercise.time_scale > 0 ? `x${figure(exercise.time_scale, exercise.time_scale % 1 ? 2 : 0)}` : t("fastest");
    setText(
      this.scale,
      running ? t("{speed} of {asked}", { speed: `x${figure(exercise.time_scale_achieved, 2)}`, asked }) : asked,
    );
    setText(this.load, figure(100 * exercise.load, 1));
    setVariable(this.bar, "--load", `${Math.min(1, exercise.load)}`);
    setText(this.late, figure(1000 * exercise.lateness, 1));
    setText(this.overruns, figure(exercise.overruns));
    setText(this.failure, exercise.failure);
    this.start.disabled = running || exercise.state >= RunState.RUN_FINISHED;
    this.pause.disabled = !running;
  }
}
