// What the trainees of a lesson read before it begins. It comes in pieces, as events; the dialog opens by itself while
// the exercise waits at its start, or at a moment from which it goes on, and later when it is asked for; its figures
// are in the units of the gauges. That the lesson is over stands under the top bar.

import type { Connection, Seat } from "../wire/connection";
import { type ExerciseStatus, RunState } from "../wire/generated";
import { h, setText } from "./dom";
import { inChosenUnits } from "./figures_in_text";
import { type OwnSeat, onInstruction } from "./instructions";
import { noticedAt } from "./noticed";
import { type OwnMarks, judgedBy } from "./own_marks";
import { clock, measures } from "./units";
import { capital } from "./words";
import { t, translated } from "./language";

const kLate = 30; // s of exercise time, from which who opens a page comes in the middle
const kAtItsStart = 1; // s of exercise time from there, up to which a paused exercise has not begun, or not gone on

const kBriefed = "windlass.briefed"; // exercise, run and seat whose briefing this browser has had
const seats: Record<Seat, string> = {
  forecastle: t("Your seat: the forecastle. You have the windlass, repeat the bridge's orders back and report."),
  conning: t("Your seat: the bridge. You have the helm, and the line to the forecastle."),
  trainee: t("Your seats: the forecastle and the bridge. You have windlass and helm."),
  watcher: t("You watch both seats, and give no orders."),
  observer: t("You are here as an observer."),
  assessor: t("You are here as an assessor."),
  instructor: t("You are here as the instructor."),
};
const staff = new Set<Seat>(["observer", "assessor", "instructor"]);

export class Briefing {
  /** Opens it; hidden while there is none. */
  readonly button: HTMLButtonElement;
  readonly element: HTMLDialogElement;
  /** Says that the lesson is over, and why; hidden until then. To who came in the middle: that there is a briefing. */
  readonly lessonOver = h("p", { class: "lesson-over", role: "status", hidden: true });
  private readonly title = h("h2", { lang: "en" });
  private readonly text = h("p", { class: "text", lang: "en" });
  private readonly own: Record<OwnSeat, HTMLElement> = {
    forecastle: h("p", { class: "text own", hidden: true }),
    bridge: h("p", { class: "text own", hidden: true }),
  };
  private readonly goesOn = h("p", { class: "text goes-on", hidden: true });
  private readonly seat = h("p", {});
  private readonly over = h("p", { class: "over", role: "status" });
  private pieces: string[] = [];
  private readonly ownPieces: Record<OwnSeat, string[]> = { forecastle: [], bridge: [] };
  private shownIn: number | undefined; // the run in which it has opened by itself
  private byItself = false;
  private why = ""; // the lesson is over
  private late = false; // came in the middle of it
  private from: number | undefined; // s of exercise time, at which it was taken up; undefined: it began at its start

  /** at: the seat of its page. */
  constructor(
    private readonly link: Connection,
    private readonly marks: OwnMarks,
    at: OwnSeat,
  ) {
    this.element = h(
      "dialog",
      { class: "briefing panel" },
      h(
        "div",
        { class: "row" },
        this.title,
        h("button", { class: "plain", onclick: () => this.element.close() }, t("Close")),
      ),
      this.goesOn,
      this.text,
      this.own.forecastle,
      this.own.bridge,
      this.seat,
      this.over,
    );
    this.element.setAttribute("aria-label", t("briefing"));
    this.button = h(
      "button",
      { class: "plain", type: "button", hidden: true, onclick: () => this.open() },
      t("Briefing"),
    );
    link.on(noticedAt[at], ({ code, value, text, time }) => {
      if (code === "exercise.ready" || code === "exercise.restored" || code === "exercise.taken_up") {
        this.from = code === "exercise.restored" ? time : undefined;
        this.take([]);
        this.end("");
      } else if (code === "lesson.over") this.end(text);
      else if (code === "exercise.briefing" && value === 1) this.take([text]);
      else if (code === "exercise.briefing" && value === this.pieces.length + 1) this.take([...this.pieces, text]);
    });
    onInstruction(
      link,
      (seat, number, text) => {
        const before = this.ownPieces[seat];
        if (number <= 1) this.ownPieces[seat] = number === 1 ? [text] : [];
        else if (number === before.length + 1) this.ownPieces[seat] = [...before, text];
        this.show();
      },
      () => {}, // the hint's line has it
    );
    link.on("ExerciseStatus", () => this.show());
    for (const measure of measures) measure.onChoice(() => this.show());
    marks.onTold(() => this.say());
  }

  private take(pieces: string[]): void {
    this.pieces = pieces;
    this.marks.judge(judgedBy(pieces.join(" ")));
    this.show();
  }

  private end(why: string): void {
    this.why = why;
    this.say();
  }

  private say(): void {
    const { why } = this;
    this.lessonOver.hidden = !why && !this.late;
    const hidden = this.marks.button.hidden;
    const over = capital(translated(why));
    setText(
      this.lessonOver,
      !why
        ? t("You have come here in the middle of it: what is wanted stands under Briefing.")
        : hidden
          ? t("{over}. What came of it your instructor tells you.", { over })
          : t("{over}. What came of it stands under Marks.", { over }),
    );
  }

  private open(): void {
    this.byItself = false;
    this.seen();
    if (!this.element.open) this.element.showModal();
  }

  /** This browser has had the briefing of this run and seat: a page that is loaded anew says nothing of it. */
  private seen(): void {
    this.late = false;
    this.say();
    try {
      sessionStorage.setItem(kBriefed, this.here());
    } catch {
      // a browser that keeps nothing is told again
    }
  }

  private here(): string {
    const { hello } = this.link;
    return `${hello?.exercise ?? ""}/${this.link.latest("ExerciseStatus")?.run ?? ""}/${hello?.seat ?? ""}`;
  }

  private isLate(status: ExerciseStatus): boolean {
    if (status.state !== RunState.RUN_RUNNING || status.time < (this.from ?? 0) + kLate) return false;
    try {
      return sessionStorage.getItem(kBriefed) !== this.here();
    } catch {
      return true;
    }
  }

  private show(): void {
    const status = this.link.latest("ExerciseStatus");
    const { hello } = this.link;
    this.button.hidden = this.pieces.length === 0;
    if (!status || !hello || this.pieces.length === 0) return;
    setText(this.title, status.title || status.exercise);
    setText(this.text, inChosenUnits(this.pieces.join(" ")));
    for (const seat of ["forecastle", "bridge"] as const) {
      const text = this.ownPieces[seat].join(" ");
      this.own[seat].hidden = !text;
      this.own[seat].replaceChildren(
        h("strong", {}, seat === "forecastle" ? t("For the forecastle alone:") : t("For the bridge alone:")),
        " ",
        h("span", { lang: "en" }, inChosenUnits(text)),
      );
    }
    setText(this.seat, seats[hello.seat]);
    const over = status.state === RunState.RUN_FINISHED;
    setText(this.over, over ? t("The exercise is over.") : "");
    this.goesOn.hidden = this.from === undefined;
    const words = t("It goes on at {time}, for practice: levers, cable, orders and marks are as they stood then.", {
      time: clock(this.from ?? 0),
    });
    setText(this.goesOn, words);
    const waits =
      status.state === RunState.RUN_READY ||
      (status.state === RunState.RUN_PAUSED && status.time < (this.from ?? 0) + kAtItsStart);
    if (this.shownIn !== status.run && !staff.has(hello.seat) && this.isLate(status)) {
      this.shownIn = status.run;
      this.late = true;
      this.say();
    }
    if (waits && this.shownIn !== status.run && !staff.has(hello.seat)) {
      this.shownIn = status.run;
      this.open();
      this.byItself = true;
    } else if (status.state === RunState.RUN_RUNNING && this.byItself) {
      this.byItself = false;
      this.element.close(); // hands are needed now
    }
  }
}
