// A new class: of which lesson, how many exercises, how many to each.

import { h, setText } from "../kit/dom";
import { type Classes, type Again, type ExerciseFile, type Lessons, act } from "./ask";
import { type Open, whyFrom } from "./class_marks";
import { field, form } from "./form";
import { freeName, nameAfter } from "./free_name";
import { namesOf } from "./names";
import { t } from "../kit/language";
import { clock } from "../kit/units";

const crews: [number, string][] = [
  [1, t("one: both seats")],
  [2, t("two: forecastle and bridge")],
  [3, t("three: and one who watches")],
];

/**
 * The crew that suits a lesson: as few as can play it. One that the person has chosen since the form was opened stays,
 * where that lesson can be played by so many; where it cannot, it comes back with the next lesson that can.
 */
export function crewFor(bridgeJudged: boolean, chosen?: number): number {
  const least = bridgeJudged ? 2 : 1; // a lesson whose bridge is judged is none for one alone
  return chosen !== undefined && chosen >= least ? chosen : least;
}

/** What a class may be of: lessons first, then exercises without one. An accident is offered once, as its lesson. */
export const offered = (files: readonly ExerciseFile[]): ExerciseFile[] =>
  files.filter(({ taught_as }) => taught_as === null).sort((a, b) => Number(!!b.lesson) - Number(!!a.lesson));

export interface NewClass {
  /** The form, with a name that is free. */
  shown(): HTMLElement;
  /** Of these alone, with what they are to do next. before: name of the class from which they come. */
  fill: (before: string, ...what: Parameters<Open>) => void;
  /** Whoever has the code may join, unless a file is given. */
  anybody(): void;
}

/** taken: names of classes, also of those that are over. */
export function newClass(
  lessons: Promise<Lessons>,
  taken: () => string[],
  opened: (classes: Classes) => void,
): NewClass {
  const today = new Date().toLocaleDateString("en", { weekday: "short" }).toLowerCase();
  const name = h("input", { required: true, maxLength: 24, pattern: "[A-Za-z0-9][A-Za-z0-9\\-]*", value: today });
  const lesson = h("select", { required: true });
  const count = h("input", { type: "number", required: true, min: 1, max: 64, value: "12" });
  const crew = h("select", {}, ...crews.map(([value, text]) => h("option", { value }, text)));
  const practice = h("input", { type: "checkbox" });
  const list = h("input", { type: "file", accept: ".csv,.txt,text/csv,text/plain" });
  let fixed: string[] = []; // who goes on from another class
  let from: Again | undefined; // its exercises begin there; nothing: anew
  let chosenCrew: number | undefined; // by the person, since the form was opened
  const whose = h("p", { class: "quiet" });
  const anybody = (): void => {
    fixed = [];
    from = undefined;
    chosenCrew = undefined;
    practice.checked = false; // for which the class before was
    lesson.disabled = practice.disabled = crew.disabled = false;
    setText(whose, "");
    void suit();
  };
  const names = async (): Promise<string[]> => {
    const given = await list.files?.[0]?.text();
    return given === undefined ? fixed : namesOf(given);
  };
  const enough = async (): Promise<void> => {
    const seats = Math.ceil((await names()).length / Number(crew.value));
    if (seats > 0) count.value = `${Math.min(64, seats)}`;
  };
  list.onchange = () => void enough();
  crew.onchange = () => {
    chosenCrew = Number(crew.value);
    void enough();
  };
  const suit = async (): Promise<void> => {
    await listed;
    const { files } = await lessons;
    if (from) return; // as many as there were
    const judged = files.some((file) => file.name === lesson.value && file.bridge_judged);
    for (const option of crew.options) option.disabled = Number(option.value) < crewFor(judged);
    const suits = `${crewFor(judged, chosenCrew)}`;
    if (crew.value === suits) return;
    crew.value = suits;
    void enough();
  };
  lesson.onchange = () => void suit();
  const listed = lessons.then(({ files }) =>
    lesson.append(...offered(files).map((file) => h("option", { value: file.name }, file.title || file.name))),
  );
  const choose = async (file?: string): Promise<void> => {
    await listed;
    lesson.value = file ?? lesson.value;
    await suit();
  };
  const fill: NewClass["fill"] = (before, group, moment, crewBefore) => {
    anybody();
    chosenCrew = crewBefore;
    fixed = moment ? Object.keys(moment.places) : group.map((one) => one.name);
    from = moment;
    if (from) crew.value = String(from.crew);
    crew.disabled = !!from;
    name.value = nameAfter(before, from || crewBefore ? "again" : "next");
    const names = fixed.join(", ");
    setText(
      whose,
      from
        ? t("For {names} alone, unless you give a file; from {time} of {exercise}, {why}", {
            names,
            time: clock(from.time),
            exercise: from.exercise,
            why: whyFrom(from),
          })
        : t("For {names} alone, unless you give a file", { names }),
    );
    list.value = "";
    practice.checked = !!from || group.some((one) => one.practice);
    lesson.disabled = practice.disabled = !!from; // the recording says which, and it is no test
    void enough();
    void choose(group[0]?.file);
  };
  void suit();
  const element = h(
    "div",
    { class: "narrow" },
    h("h2", {}, t("New class")),
    form(
      t("Open the class"),
      [
        field(t("Name of the class"), name, t("exercises are called NAME-1, NAME-2 and so on")),
        field(t("Lesson"), lesson),
        h("label", { class: "row" }, practice, t("for practice, with hints")),
        field(t("Exercises"), count),
        field(t("Trainees to each"), crew),
        field(t("Names"), list, t("a file (CSV) with a name to a line: then nobody else may join")),
        whose,
      ],
      async () => {
        const classes = await act<Classes>("class", {
          do: "open",
          class: name.value,
          lesson: lesson.value,
          practice: practice.checked,
          exercises: count.valueAsNumber,
          crew: Number(crew.value),
          names: await names(),
          ...(from && { from: { recording: from.recording, position: from.position }, places: from.places }),
        });
        anybody();
        name.value = today;
        opened(classes);
      },
    ),
  );
  const shown = (): HTMLElement => {
    name.value = freeName(name.value, taken());
    return element;
  };
  return { shown, fill, anybody };
}
