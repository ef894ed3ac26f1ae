// What came of a class: who sat where, the marks, and the way to each debriefing.

import { capital, endingSaid, outcomeSaid } from "../kit/words";
import { h, setShown, setText } from "../kit/dom";
import { pointsFigure, pointsSaid } from "../kit/points_said";
import { clock, figure } from "../kit/units";
import {
  Denied,
  type Again,
  type ClassExercise,
  type From,
  type Next,
  type NextOfClass,
  type Part,
  type PlaceName,
  type ToDo,
  type TrainingClass,
  type Word,
  type Words,
  act,
  ask,
  partWords,
  placeWords,
} from "./ask";
import { doorSaid } from "./door_sentences";
import { field, form } from "./form";
import { TypedCount, kMostWords } from "../kit/typed_count";
import { language, t } from "../kit/language";

/** In words: points, and what they mean once the lesson is over; why it was before it was done. */
export function marksOf({ points, lost, outcome, abort }: ClassExercise): string {
  if (points === null) return t("not marked");
  const said = pointsSaid(points, lost ?? 0, outcome === "practice" ? t("for practice") : outcomeSaid(outcome));
  return abort ? `${said}, ${t("ended: {what}", { what: endingSaid(abort) })}` : said;
}

/** Of a seat whose work is not what the marks are of. */
const notJudged = ({ bridge_judged }: TrainingClass): string =>
  bridge_judged ? t("not judged: the bridge is") : t("only watched");

const kLook = 2000; // ms

/**
 * From where a class goes on, and why: '10 s before "fall" went wrong, at 0:33'. Behind it what stands then:
 * "already lost by then: orders".
 */
export function whyFrom({ before, seconds, lost, lost_at, standing }: From): string {
  const why = whyBefore(before, { seconds: figure(seconds), lost, at: clock(lost_at) });
  if (standing.length === 0) return why;
  return `${why}; ${t("already lost by then: {standing}", { standing: standing.join(", ") })}`;
}
function whyBefore(before: From["before"], its: { seconds: string; lost: string; at: string }): string {
  switch (before) {
    case "levers":
      return t('{seconds} s before the levers were moved and "{lost}" went wrong, at {at}', its);
    case "order":
      return t('{seconds} s before the order after which "{lost}" went wrong, at {at}', its);
    case "due":
      return t('{seconds} s before it was time for "{lost}", which went wrong at {at}', its);
    case "loss":
      return t('{seconds} s before "{lost}" went wrong, at {at}', its);
  }
}

/** What a class is made of that goes on from there: of whom beside him, and what the exercise was called. */
export function momentOf(name: string, from: From, it: TrainingClass): Again {
  const exercise = it.exercises.find(({ recording }) => recording === from.recording)?.exercise ?? from.recording;
  return { ...from, exercise, crew: it.crew, places: placesBeside(name, it) };
}

/** Begins a class of him and whoever sat beside him, each where he sat, some seconds before what lost it. */
const againFrom = (one: Next, from: From, it: TrainingClass, open: Open): Node[] => [
  h(
    "button",
    { onclick: () => open([one], momentOf(one.name, from, it)) },
    t("Again from {time}", { time: clock(from.time) }),
  ),
  h("span", { class: "quiet" }, whyFrom(from)),
];

/** Who sat last in the exercise of that name, and where. */
export function placesBeside(name: string, { exercises }: TrainingClass): Record<string, PlaceName> {
  const its = exercises.find(({ parts }) => parts.some((part) => part.name === name));
  const last = new Map((its?.parts ?? []).map((part) => [part.place, part])); // the later of a seat behind the earlier
  const places = Object.fromEntries([...last.values()].map((part) => [part.name, part.place]));
  return name in places ? places : { [name]: its?.parts.find((part) => part.name === name)?.place ?? "ship" };
}

/** The attempt of this class that is done again from a moment; undefined: from none, or from one of a class since. */
const momentHere = ({ from }: Next, { exercises }: Pick<TrainingClass, "exercises">): From | undefined =>
  from && exercises.some(({ recording }) => recording === from.recording) ? from : undefined;

/** Why what somebody missed is not done again from a moment here; empty: it is, or nothing was missed. */
export function whyNotAgain(one: Next, it: Pick<TrainingClass, "exercises">): string {
  if (!one.practice || momentHere(one, it)) return "";
  if (one.from) return t("Again from its moment: under the class of that attempt");
  return t("Again from no moment: {why}", { why: doorSaid(one.no_from) });
}

/** The same lesson from its beginning, for all who had a seat at the end. */
export const allAgain = ({ exercises, lesson, practice }: TrainingClass): ToDo[] =>
  exercises
    .flatMap(({ parts }) => parts.filter(({ until }) => until === null))
    .map(({ name }) => ({ name, file: lesson, practice }));

/** "Let go in 25 m, for practice". */
export const lessonWords = (title: string, practice: boolean): (Node | string)[] => [
  h("span", { lang: "en" }, title),
  ...(practice ? [`, ${t("for practice")}`] : []),
];

const kObjective = /^(not yet|not shown): (.*)$/s;

/** Why it is to be done: the history's own words, or objectives of a lesson, which are its author's. */
export function whyNext(why: string): { said: string; objective: string }[] {
  const parts = why.split(/; (?=not yet: |not shown: )/).map((part) => kObjective.exec(part));
  if (!parts.every((part) => part !== null)) return [{ said: doorSaid(why), objective: "" }];
  return parts.map((part) => ({ said: `${outcomeSaid(part[1]!)}: `, objective: part[2]! }));
}

/** "after L02 on 30 November: ", where that is of no attempt of this class; else empty. */
export function afterSaid({ after }: Pick<Next, "after">, { exercises }: Pick<TrainingClass, "exercises">): string {
  if (!after || exercises.some(({ recording }) => recording === after.recording)) return "";
  const locale = language === "en" ? "en-GB" : language; // the day before the month
  const date = new Date(after.began_at).toLocaleDateString(locale, { day: "numeric", month: "long" });
  return `${t("after {lesson} on {date}", { lesson: after.lesson, date })}: `;
}

/** The same, and why. */
const nextWords = (next: Next, it: TrainingClass): (Node | string)[] => [
  ...lessonWords(next.title, next.practice),
  h(
    "span",
    { class: "quiet" },
    afterSaid(next, it),
    ...whyNext(next.why).flatMap(({ said, objective }, k) => [
      `${k > 0 ? "; " : ""}${said}`,
      objective && h("span", { lang: "en" }, objective),
    ]),
  ),
];

/** Those who are to do the same next, in the order of their lessons. */
export function together(all: Next[]): Next[][] {
  const groups = new Map<string, Next[]>();
  for (const one of all) {
    const key = `${one.file} ${one.practice}`;
    groups.set(key, [...(groups.get(key) ?? []), one]);
  }
  return [...groups].sort(([a], [b]) => a.localeCompare(b)).map(([, group]) => group);
}

/** "bo: 80.0 points, achieved. The load cell had failed". */
export function wordSaid({ by, points, outcome, note }: Word): string {
  const said = outcomeSaid(outcome);
  const marks =
    points === null ? said : t("{points} points, {outcome}", { points: pointsFigure(points), outcome: said });
  return [`${by}: ${marks}`, capital(note)].filter(Boolean).join(". ");
}

/** What is asked before an attempt is called achieved with fewer points than its lesson needs; empty: nothing. */
export function doubtOf(outcome: string, points: number | null, pass: number | null): string {
  if (outcome !== "achieved" || points === null || pass === null || points >= pass) return "";
  return t("{points} points are below the {pass} that the lesson needs. Once more, if it is achieved all the same.", {
    points: pointsFigure(points),
    pass,
  });
}

const kNoteMin = 10; // characters, as the history asks for

/** The assessor's word on an attempt, and the way to give one. */
class WordOn {
  readonly element = h("div", { class: "word", hidden: true });
  private readonly said = h("p", { class: "quiet", role: "status" });
  private points: number | null; // as they stand
  private asked = ""; // what was asked last; whoever sets the same again means it

  /** judges: who looks at it may give one. */
  constructor(
    private readonly of: ClassExercise,
    judges: boolean,
  ) {
    this.points = of.points;
    this.element.append(this.said);
    if (judges && of.outcome !== "practice") this.element.append(this.form()); // that shows no competence
  }

  /** Once the history has the attempt. */
  take({ words }: Words): void {
    const word = words.find(({ recording }) => recording === this.of.recording);
    setText(this.said, word ? wordSaid(word) : "");
    this.points = word?.points ?? this.of.points;
    this.element.hidden = false;
  }

  private form(): HTMLElement {
    const outcome = h(
      "select",
      {},
      ...["achieved", "not_yet", "not_shown"].map((each) => h("option", { value: each }, capital(outcomeSaid(each)))),
    );
    if (this.of.outcome) outcome.value = this.of.outcome;
    const points = h("input", { type: "number", min: 0, max: 100, step: "any" });
    const note = h("input", { required: true, minLength: kNoteMin, autocomplete: "off" });
    const typed = new TypedCount(note, kMostWords.note);
    const details = h(
      "details",
      {},
      h("summary", {}, t("Your word on it")),
      form(
        t("Set"),
        [
          field(t("Outcome"), outcome),
          field(t("Points"), points, t("of 100; none: as they stand")),
          field(t("Why"), note, t("{least} to {most} characters", { least: kNoteMin, most: kMostWords.note })),
          typed.element,
        ],
        async () => {
          const given = points.value === "" ? null : points.valueAsNumber;
          this.askOnce(doubtOf(outcome.value, given ?? this.points, this.of.pass));
          const recording = this.of.recording;
          const word = { recording, outcome: outcome.value, points: given, note: note.value.trim() };
          this.take(await act<Words>("word", word));
          this.asked = "";
          typed.clear();
          details.open = false;
        },
      ),
    );
    return details;
  }

  /** The form says what is thrown. */
  private askOnce(doubt: string): void {
    if (doubt === this.asked) return;
    this.asked = doubt;
    if (doubt) throw new Error(doubt);
  }
}

/** Of the table, what the history fills. */
interface ToCome {
  /** What next, by name. */
  cells: Map<string, HTMLElement>;
  words: WordOn[];
  /** Of classes that would do. */
  list: HTMLElement;
  /** Says that all this is not there yet. */
  coming: HTMLElement;
}

/** Fills it once the history has the class. */
async function fillNext(it: TrainingClass, toCome: ToCome, open?: Open): Promise<void> {
  const { cells, words, list, coming } = toCome;
  const told = await ask<NextOfClass>(`next?class=${it.id}`);
  if (told.waits) {
    const shown = (): boolean => [...cells.values()].some((cell) => cell.isConnected);
    setTimeout(() => shown() && tellNext(it, toCome, open), kLook);
    return;
  }
  setShown(coming, false);
  for (const word of words) word.take(told);
  const { next } = told;
  for (const one of next) {
    const from = momentHere(one, it);
    const again = from && open ? againFrom(one, from, it, open) : [];
    const whyNot = open ? whyNotAgain(one, it) : "";
    cells
      .get(one.name)
      ?.replaceChildren(...nextWords(one, it), ...again, ...(whyNot ? [h("span", { class: "quiet" }, whyNot)] : []));
  }
  const classOf = (group: Next[], { title, practice }: Next): HTMLElement =>
    h(
      "button",
      { onclick: () => open?.(group) },
      t("Class of {count}: {title}", {
        count: group.length,
        title: practice ? `${title}, ${t("for practice")}` : title,
      }),
    );
  list.replaceChildren(...together(next).flatMap((group) => (group[0] ? [classOf(group, group[0])] : [])));
}

/** The list stands without it, too; a door without a history has nothing of it. */
const tellNext: typeof fillNext = (it, toCome, open) =>
  fillNext(it, toCome, open).catch((why: unknown) => {
    if (why instanceof Denied && why.status === 404)
      setText(toCome.coming, t("No history is kept here, which would say what next, and again from when."));
    else setText(toCome.coming, t("What next and assessors' words were not to be had."));
  });

/** Begins a class of those who are to do the same next. crew: trainees to each exercise; none: as suits it. */
export type Open = (group: ToDo[], from?: Again, crew?: number) => void;

export interface ClassMarks {
  element: HTMLElement;
  /** So many words have been given: by another one what is to be practised next may be another thing, too. */
  heard: (words: number) => void;
}

/**
 * A class that is over. title: of its lesson. judges: who looks at it may say what an attempt comes to. open: nothing,
 * for who may open none.
 */
export function classMarks(it: TrainingClass, title: string, judges: boolean, open?: Open): ClassMarks {
  const cells = new Map<string, HTMLElement>();
  const words: WordOn[] = [];
  const list = h("p", { class: "row next" });
  const coming = h("p", { class: "quiet", role: "status" }, t("What next and assessors' words are coming."));
  const nextOf = (name: string): HTMLElement => {
    const cell = h("td", { class: "next" });
    if (!cells.has(name)) cells.set(name, cell); // who had two seats is told once
    return cell;
  };
  /** One is said of all who worked in it: with the first whose marks they are. */
  const wordOn = (each: ClassExercise, part: Part): Node[] => {
    if (!each.recording || part !== each.parts.find(({ judged }) => judged)) return [];
    const word = new WordOn(each, judges);
    words.push(word);
    return [word.element];
  };
  const rows = it.exercises.flatMap((each) =>
    each.parts.map((part) =>
      h(
        "tr",
        { "data-exercise": each.exercise },
        h("th", { scope: "row" }, part.name),
        h("td", {}, [each.exercise, placeWords[part.place], partWords(part)].filter(Boolean).join(", ")),
        h("td", { class: "marks" }, part.judged ? marksOf(each) : notJudged(it), ...wordOn(each, part)),
        h(
          "td",
          {},
          each.recording
            ? h("a", { href: `/door/debriefing?recording=${each.recording}`, target: "_blank" }, t("Debriefing"))
            : t("not recorded"),
        ),
        nextOf(part.name),
      ),
    ),
  );
  if (rows.length === 0)
    return { element: h("p", { class: "quiet" }, t("Nobody sat in this class.")), heard: () => {} };
  const heads = [t("Trainee"), t("Seat"), t("Marks"), t("Talk it over"), t("What next")];
  const look = (): void => void tellNext(it, { cells, words, list, coming }, open);
  look();
  let known = it.words;
  const element = h(
    "section",
    { class: "panel class-marks" },
    h("h2", {}, `${it.id}: `, ...lessonWords(title, it.practice)),
    h(
      "table",
      {},
      h("thead", {}, h("tr", {}, ...heads.map((text) => h("th", { scope: "col" }, text)))),
      h("tbody", {}, ...rows),
    ),
    coming,
    open ? list : "",
    h(
      "p",
      { class: "row" },
      open && h("button", { onclick: () => open(allAgain(it), undefined, it.crew) }, t("The same class again")),
      h("a", { href: `/door/side_by_side?class=${it.id}`, target: "_blank" }, t("The class side by side")),
      h("a", { href: `/door/marks.csv?class=${it.id}`, download: `${it.id}.csv` }, t("As a table (CSV)")),
    ),
  );
  const heard = (given: number): void => {
    if (given === known) return;
    known = given;
    look();
  };
  return { element, heard };
}
