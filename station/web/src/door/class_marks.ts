// What came of a class: who sat where, the marks, and the way to each debriefing.

import { outcomeSaid } from "../kit/words";
import { h } from "../kit/dom";
import { clock } from "../kit/units";
import {
  type Again,
  type ClassExercise,
  type From,
  type Next,
  type NextOfClass,
  type PlaceName,
  type TrainingClass,
  ask,
  partWords,
  placeWords,
} from "./ask";
import { t } from "../kit/language";

/** In words: points, and what they mean once the lesson is over. */
export function marksOf({ points, outcome }: ClassExercise): string {
  if (points === null) return t("not marked");
  const whole = points.toFixed(0);
  if (!outcome) return t("{points} points so far", { points: whole });
  return t("{points} points, {outcome}", {
    points: whole,
    outcome: outcome === "practice" ? t("for practice") : outcomeSaid(outcome),
  });
}

/** Of a seat whose work is not what the marks are of. */
const notJudged = ({ bridge_judged }: TrainingClass): string =>
  bridge_judged ? t("not judged: the bridge is") : t("only watched");

const kLook = 2000; // ms

/** Begins a class of him and whoever sat beside him, each where he sat, ten seconds before it went wrong. */
const againFrom = (one: Next, from: From, it: TrainingClass, open: Open): HTMLElement =>
  h(
    "button",
    {
      title: t("ten seconds before {lost} was lost", { lost: from.lost }),
      onclick: () => open([one], { ...from, crew: it.crew, places: placesBeside(one.name, it) }),
    },
    t("Again from {time}", { time: clock(from.time) }),
  );

/** Who sat last in the exercise of that name, and where. */
export function placesBeside(name: string, { exercises }: TrainingClass): Record<string, PlaceName> {
  const its = exercises.find(({ parts }) => parts.some((part) => part.name === name));
  const last = new Map((its?.parts ?? []).map((part) => [part.place, part])); // the later of a seat behind the earlier
  const places = Object.fromEntries([...last.values()].map((part) => [part.name, part.place]));
  return name in places ? places : { [name]: its?.parts.find((part) => part.name === name)?.place ?? "ship" };
}

/** "Let go in 25 m, for practice". */
export const lessonWords = (title: string, practice: boolean): (Node | string)[] => [
  h("span", { lang: "en" }, title),
  ...(practice ? [`, ${t("for practice")}`] : []),
];

/** The same, and why. */
const nextWords = ({ title, why, practice }: Next): (Node | string)[] => [
  ...lessonWords(title, practice),
  h("span", { class: "quiet", lang: "en" }, why),
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

/** Fills the cells by name, and the list of classes that would do, once the history has the class. */
async function fillNext(
  it: TrainingClass,
  cells: Map<string, HTMLElement>,
  list: HTMLElement,
  open?: Open,
): Promise<void> {
  const { waits, next } = await ask<NextOfClass>(`next?class=${it.id}`);
  if (waits) {
    const shown = (): boolean => [...cells.values()].some((cell) => cell.isConnected);
    setTimeout(() => shown() && tellNext(it, cells, list, open), kLook);
    return;
  }
  for (const one of next) {
    const again = one.from && open ? [againFrom(one, one.from, it, open)] : [];
    cells.get(one.name)?.replaceChildren(...nextWords(one), ...again);
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

/** The list stands without it, too. */
const tellNext: typeof fillNext = (...of) => fillNext(...of).catch(() => {});

/** Begins a class of those who are to do the same next. */
export type Open = (group: Next[], from?: Again) => void;

/** A class that is over. title: of its lesson. open: nothing, for who may open none. */
export function classMarks(it: TrainingClass, title: string, open?: Open): HTMLElement {
  const cells = new Map<string, HTMLElement>();
  const list = h("p", { class: "row next" });
  const nextOf = (name: string): HTMLElement => {
    const cell = h("td", { class: "next" });
    if (!cells.has(name)) cells.set(name, cell); // who had two seats is told once
    return cell;
  };
  const rows = it.exercises.flatMap((each) =>
    each.parts.map((part) =>
      h(
        "tr",
        { "data-exercise": each.exercise },
        h("th", { scope: "row" }, part.name),
        h("td", {}, [each.exercise, placeWords[part.place], partWords(part)].filter(Boolean).join(", ")),
        h("td", { class: "marks" }, part.judged ? marksOf(each) : notJudged(it)),
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
  if (rows.length === 0) return h("p", { class: "quiet" }, t("Nobody sat in this class."));
  const heads = [t("Trainee"), t("Seat"), t("Marks"), t("Talk it over"), t("What next")];
  void tellNext(it, cells, list, open);
  return h(
    "section",
    { class: "panel class-marks" },
    h("h2", {}, `${it.id}: `, ...lessonWords(title, it.practice)),
    h(
      "table",
      {},
      h("thead", {}, h("tr", {}, ...heads.map((text) => h("th", { scope: "col" }, text)))),
      h("tbody", {}, ...rows),
    ),
    open ? list : "",
    h(
      "p",
      { class: "row" },
      h("a", { href: `/door/side_by_side?class=${it.id}`, target: "_blank" }, t("The class side by side")),
      h("a", { href: `/door/marks.csv?class=${it.id}`, download: `${it.id}.csv` }, t("As a table (CSV)")),
    ),
  );
}
