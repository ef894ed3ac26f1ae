// The marks of a lesson as they come to stand, and the assessor's word beside them.

import { h, setText } from "../kit/dom";
import { inChosenUnits } from "../kit/figures_in_text";
import { showsTopic } from "../kit/live";
import { clock, measures } from "../kit/units";
import { practiceSaid } from "../kit/own_marks";
import { earnedSaid, pointsFigure, pointsSaid, rowSaid, shareSaid, soFar } from "../kit/points_said";
import { TypedCount, kMostWords } from "../kit/typed_count";
import { endingSaid, outcomeSaid, saidOf, stateSaid } from "../kit/words";
import {
  type Assessment,
  AssessorVerdict,
  type Criterion,
  CriterionKind,
  CriterionState,
  LessonEnding,
} from "../wire/generated";
import { AssessorsWords, type Word } from "./assessors_words";
import type { Desk } from "./desk";
import { t } from "../kit/language";

const verdicts = [AssessorVerdict.VERDICT_MET, AssessorVerdict.VERDICT_NOT_MET, AssessorVerdict.VERDICT_NOT_APPLICABLE];
const verdictSaid = (verdict: AssessorVerdict): string => saidOf("AssessorVerdict", verdict);
/** What the assessor has said of a criterion. */
function verdictWords({ counts, counted, met }: Criterion): string {
  if (!counts) return verdictSaid(AssessorVerdict.VERDICT_NOT_APPLICABLE);
  if (!met && counted > 0) return t("in part");
  return verdictSaid(met ? AssessorVerdict.VERDICT_MET : AssessorVerdict.VERDICT_NOT_MET);
}

/** "2:05 anna: stood well clear of the cable". */
function wordWords({ time, earlier, by, note }: Word): string {
  return `${earlier ? t("before {time}", { time: clock(time) }) : clock(time)} ${by}: ${note}`;
}

const kNoteMin = 10; // characters, as the server asks for

export class MarksPanel {
  readonly element: HTMLElement;
  private readonly head = h("p", { class: "marks-head" }, t("This exercise has no lesson."));
  private readonly list = h("ul", { class: "marks scroll", tabIndex: 0, "aria-label": t("criteria") });
  private readonly criterion = h("select", { "aria-label": t("criterion") });
  private readonly verdict = h(
    "select",
    { "aria-label": t("verdict") },
    ...verdicts.map((verdict) => h("option", { value: AssessorVerdict[verdict] }, verdictSaid(verdict))),
  );
  private readonly note = h("input", {
    "aria-label": t("note"),
    placeholder: t("why, {least} to {most} characters", { least: kNoteMin, most: kMostWords.note }),
    minLength: kNoteMin,
    required: true,
    class: "note",
  });
  private readonly typed = new TypedCount(this.note, kMostWords.note);
  private readonly form = h(
    "form",
    {
      class: "order-form",
      "data-gives": "AssessmentCommand",
      "aria-label": t("assessor's word"),
      hidden: true,
      onsubmit: (event: Event) => this.say(event),
    },
    this.criterion,
    this.verdict,
    this.note,
    h("button", { class: "plain primary" }, t("Set")),
    this.typed.element,
  );
  private readonly words = new AssessorsWords();
  private run = -1;

  constructor(private readonly desk: Desk) {
    this.element = h("div", { class: "talk-panel" }, this.head, this.list, this.form);
    showsTopic(this.element, desk.link, "ExerciseStatus"); // Assessment itself ends with the lesson
    desk.link.on("Assessment", (assessment) => {
      const now = desk.link.latest("ExerciseStatus")?.time ?? assessment.time; // the marks' own ends with the lesson
      this.words.take(assessment, now, desk.replay);
      this.show(assessment);
    });
    // Where the seat hears it; the one that this page gives it knows anyhow.
    desk.link.on("AssessmentCommand", ({ origin, criterion, note }) =>
      this.words.give({ by: origin.source, criterion, note }),
    );
    desk.link.onState((state) => state === "lost" && this.words.miss());
    desk.link.onAnotherServer(() => this.words.miss());
    for (const measure of measures)
      measure.onChoice(() => {
        const assessment = desk.link.latest("Assessment");
        if (assessment && this.list.childElementCount) this.show(assessment);
      });
    desk.link.on("ExerciseStatus", (status) => {
      // The marks of a state that was gone back to may be heard before the status that tells of it.
      const ofThis = desk.link.latest("Assessment")?.time === status.time;
      if (this.run !== -1 && status.run !== this.run && !desk.replay && !ofThis) this.clear();
      this.run = status.run;
    });
  }

  private clear(): void {
    setText(this.head, t("This exercise has no lesson."));
    this.list.replaceChildren();
    this.form.hidden = true;
  }

  private show(assessment: Assessment): void {
    const { finished, score, score_computed } = assessment;
    const now = finished ? { points: score, lost: 0 } : soFar(assessment);
    const alone = finished ? score_computed : soFar(assessment, true).points;
    const points = pointsSaid(now.points, now.lost, finished ? outcomeSaid(assessment.outcome) : "");
    const computed = now.points === alone ? "" : ` (${t("computed {score}", { score: pointsFigure(alone) })})`;
    const early = assessment.ending === LessonEnding.LESSON_ENDED_EARLY; // which is a whole sentence
    const why = endingSaid(assessment.abort);
    const abort = assessment.abort && `, ${early ? why : t("ended: {what}", { what: why })}`;
    const practice = assessment.practice ? `; ${practiceSaid(assessment)}` : "";
    setText(this.head, `${clock(assessment.time)}  ${points}${computed}${abort}${practice}`);
    this.list.replaceChildren(...assessment.criteria.map((criterion) => this.row(criterion, assessment)));
    this.form.hidden = false;
    const names = assessment.criteria.map((criterion) => criterion.code);
    if (names.join() !== [...this.criterion.options].map((option) => option.value).join())
      this.criterion.replaceChildren(...names.map((name) => h("option", { value: name }, name)));
  }

  private row(criterion: Criterion, assessment: Assessment): HTMLElement {
    const open = criterion.state === CriterionState.CRITERION_OPEN && criterion.counts;
    const state = open
      ? t("{state}, {points} so far", {
          state: stateSaid(criterion),
          points: earnedSaid(criterion, criterion.counted, assessment),
        })
      : stateSaid(criterion);
    const rubric = criterion.kind === CriterionKind.CRITERION_RUBRIC;
    const set = criterion.state === CriterionState.CRITERION_OVERRIDDEN;
    const word = this.words.of(criterion);
    const verdict = set ? verdictWords(criterion) : "";
    const told = !set
      ? state
      : rubric // of which nothing is computed
        ? `${state}: ${verdict}`
        : t("{state}: {verdict}; computed {points}", {
            state,
            verdict,
            points: shareSaid(criterion, criterion.milli, assessment),
          });
    // What an assessor judges stands there to be read while he looks.
    const about = rubric ? criterion.text : (word?.computed ?? criterion.reason);
    return h(
      "li",
      { "data-state": CriterionState[criterion.state] },
      h("span", { class: "code" }, `${criterion.code}${criterion.must ? ` ${t("(must)")}` : ""}`),
      h("span", { class: "figure" }, rowSaid(criterion, assessment)),
      h("span", { class: "quiet" }, told),
      about && h("span", { class: "quiet", lang: "en" }, inChosenUnits(about)), // the judge speaks English
      word && h("span", { class: "word" }, wordWords(word)),
    );
  }

  private async say(event: Event): Promise<void> {
    event.preventDefault();
    const criterion = this.criterion.value;
    const note = this.note.value.trim();
    const by = this.desk.link.hello?.name ?? "";
    this.words.give({ by, criterion, note });
    const sent = await this.desk.give("AssessmentCommand", { criterion, verdict: this.verdict.value, milli: 0, note });
    if (sent) this.typed.clear();
  }
}
