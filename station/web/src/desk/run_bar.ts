// The run of the exercise: which, start and pause, how fast, back to a checkpoint, recording, bookmarks.

import { h, setAttribute } from "../kit/dom";
import { holdButton } from "../kit/hold_button";
import { pageAddress } from "../kit/page";
import { figure } from "../kit/units";
import { RunState } from "../wire/generated";
import { DebriefButton } from "./debrief";
import type { Desk } from "./desk";
import { Restore } from "./restore";
import { t, writtenFigure } from "../kit/language";

const scales = [0.1, 0.25, 0.5, 1, 2, 5, 10, 20];

export class RunBar {
  readonly element: HTMLElement;
  private readonly exercise = h("select", { "aria-label": t("exercise"), onchange: () => this.open() });
  private readonly start = h("button", { class: "plain", onclick: () => this.run("EXERCISE_START") }, t("Start"));
  private readonly pause = h("button", { class: "plain", onclick: () => this.run("EXERCISE_PAUSE") }, t("Pause"));
  private readonly scale = h("select", { "aria-label": t("time scale"), onchange: () => this.setScale() });
  private readonly restore: Restore;
  private readonly file = h("input", {
    class: "file",
    "aria-label": t("exercise file"),
    placeholder: t("file, e.g. walk_back_60m"),
  });
  private readonly word = h("input", {
    class: "word",
    "aria-label": t("bookmark"),
    placeholder: t("Bookmark (F4)"),
    maxLength: 128,
  });
  private readonly record = h(
    "button",
    { class: "plain rec", "aria-pressed": "false", "data-gives": "files", onclick: () => this.toggleRecord() },
    t("REC"),
  );
  private readonly debrief: DebriefButton;

  constructor(private readonly desk: Desk) {
    const gives = { "data-gives": "ExerciseCommand" };
    this.debrief = new DebriefButton(desk);
    this.restore = new Restore(desk);
    const button = (text: string, action: string, title: string): HTMLButtonElement =>
      h("button", { class: "plain", title, onclick: () => this.run(action) }, text);
    for (const scale of scales) this.scale.append(h("option", { value: `${scale}` }, `x${writtenFigure(`${scale}`)}`));
    const markNow = h(
      "form",
      { class: "row", ...gives, onsubmit: (e: Event) => this.bookmark(e) },
      this.word,
      h("button", { class: "plain", title: "F4" }, t("Mark")),
    );
    this.element = h(
      "div",
      { class: "run-bar", role: "toolbar", "aria-label": t("exercise control") },
      this.exercise,
      h("span", { class: "group", ...gives }, this.start, this.pause, this.scale),
      h(
        "span",
        { class: "group", ...gives },
        button(t("Snapshot"), "EXERCISE_SNAPSHOT", t("a checkpoint now, beside those every 10 s")),
        this.restore.element,
      ),
      h(
        "span",
        { class: "group", ...gives },
        holdButton(t("Reset"), 0.8, () => void this.run("EXERCISE_RESET"), { class: "plain" }),
        holdButton(t("End"), 0.8, () => void this.run("EXERCISE_STOP"), { class: "plain" }),
      ),
      h(
        "span",
        { class: "group load", ...gives },
        this.file,
        holdButton(t("Load"), 0.8, () => this.load(), { class: "plain" }),
      ),
      h("span", { class: "group" }, this.record, this.debrief.element),
      markNow,
    );
    desk.link.on("ExerciseStatus", () => this.update());
    desk.link.onMessage("hello", () => this.update());
    addEventListener("keydown", (event) => {
      if (event.key !== "F4" || event.altKey || event.ctrlKey || !desk.may("ExerciseCommand")) return;
      event.preventDefault();
      this.word.focus();
    });
  }

  /** Puts a time into the field from which one restores. */
  suggest(time: number): void {
    this.restore.suggest(time);
  }

  private run(action: string, more: object = {}): Promise<boolean> {
    return this.desk.give("ExerciseCommand", { action, ...more });
  }
  private setScale(): void {
    void this.run("EXERCISE_TIME_SCALE", { time_scale: Number(this.scale.value) });
  }
  private load(): void {
    const file = this.file.value.trim();
    if (file) void this.run("EXERCISE_LOAD", { exercise: file });
    else this.desk.say(t("Load: name a file of the server's exercise folder"));
  }
  private async bookmark(event: Event): Promise<void> {
    event.preventDefault();
    if (!(await this.run("EXERCISE_BOOKMARK", { text: this.word.value.trim() }))) return;
    this.word.value = "";
    this.word.blur();
  }
  private toggleRecord(): void {
    const on = !this.desk.link.hello?.recording;
    void this.desk.ask(() => this.desk.link.ask({ op: "record", on, name: "" }));
  }
  private open(): void {
    location.assign(pageAddress("/instructor", { exercise: this.exercise.value }));
  }

  private update(): void {
    const { link } = this.desk;
    const status = link.latest("ExerciseStatus");
    const hello = link.hello;
    if (hello) this.showExercises([...new Set([hello.exercise, ...hello.live])].sort(), hello.exercise);
    setAttribute(this.record, "aria-pressed", `${Boolean(hello?.recording)}`);
    this.record.title = hello?.recording
      ? t("recording {name}; press to end", { name: hello.recording })
      : t("record this exercise");
    this.debrief.recording = hello?.recorded ?? "";
    if (!status) return;
    const running = status.state === RunState.RUN_RUNNING;
    this.start.disabled = running || status.state >= RunState.RUN_FINISHED;
    this.pause.disabled = !running;
    this.start.textContent = status.state === RunState.RUN_PAUSED ? t("Go on") : t("Start");
    const asked = `${status.time_scale}`;
    if (document.activeElement !== this.scale) {
      if (!scales.includes(status.time_scale) && !this.scale.querySelector(`[value="${asked}"]`))
        this.scale.append(
          h("option", { value: asked }, status.time_scale ? `x${figure(status.time_scale, 2)}` : t("fastest")),
        );
      this.scale.value = asked;
    }
  }

  private showExercises(names: string[], chosen: string): void {
    if (names.join() !== [...this.exercise.options].map((o) => o.value).join())
      this.exercise.replaceChildren(...names.map((name) => h("option", { value: name }, name)));
    this.exercise.value = chosen;
  }
}
