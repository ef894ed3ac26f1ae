// A new class: of which lesson, how many exercises, how many to each.

import { h } from "../kit/dom";
import { type Classes, act, ask } from "./ask";
import { field, form } from "./frame";
import { namesOf } from "./names";
import { t } from "../kit/language";

interface Lessons {
  files: { name: string; title: string; lesson: string | null }[];
}

const crews: [number, string][] = [
  [1, t("one: both seats")],
  [2, t("two: forecastle and bridge")],
  [3, t("three: and one who watches")],
];

export function newClass(opened: (classes: Classes) => void): HTMLElement {
  const today = new Date().toLocaleDateString("en", { weekday: "short" }).toLowerCase();
  const name = h("input", { required: true, maxLength: 24, pattern: "[A-Za-z0-9][A-Za-z0-9\\-]*", value: today });
  const lesson = h("select", { required: true });
  const count = h("input", { type: "number", required: true, min: 1, max: 64, value: "12" });
  const crew = h("select", {}, ...crews.map(([value, text]) => h("option", { value }, text)));
  const practice = h("input", { type: "checkbox" });
  const list = h("input", { type: "file", accept: ".csv,.txt,text/csv,text/plain" });
  const names = async (): Promise<string[]> => namesOf((await list.files?.[0]?.text()) ?? "");
  const enough = async (): Promise<void> => {
    const seats = Math.ceil((await names()).length / Number(crew.value));
    if (seats > 0) count.value = `${Math.min(64, seats)}`;
  };
  list.onchange = crew.onchange = () => void enough();
  void ask<Lessons>("lessons").then(({ files }) =>
    lesson.append(
      ...files
        .sort((a, b) => Number(!!b.lesson) - Number(!!a.lesson))
        .map((file) => h("option", { value: file.name }, file.title || file.name)),
    ),
  );
  return h(
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
      ],
      async () =>
        opened(
          await act<Classes>("class", {
            do: "open",
            class: name.value,
            lesson: lesson.value,
            practice: practice.checked,
            exercises: count.valueAsNumber,
            crew: Number(crew.value),
            names: await names(),
          }),
        ),
    ),
  );
}
