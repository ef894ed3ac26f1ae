// What came of a class: who sat where, the marks, and the way to each debriefing.

import { outcomeSaid } from "../kit/words";
import { h } from "../kit/dom";
import { type ClassExercise, type TrainingClass, placeWords } from "./ask";
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

/** A class that is over. */
export function classMarks(it: TrainingClass): HTMLElement {
  const rows = it.exercises.flatMap((each) =>
    each.seats
      .filter(({ name }) => name !== null)
      .map(({ name, place }) =>
        h(
          "tr",
          { "data-exercise": each.exercise },
          h("th", { scope: "row" }, name),
          h("td", {}, `${each.exercise}, ${placeWords[place]}`),
          h("td", { class: "marks" }, marksOf(each)),
          h(
            "td",
            {},
            each.recording
              ? h("a", { href: `/door/debriefing?recording=${each.recording}`, target: "_blank" }, t("Debriefing"))
              : t("not recorded"),
          ),
        ),
      ),
  );
  if (rows.length === 0) return h("p", { class: "quiet" }, t("Nobody sat in this class."));
  const heads = [t("Trainee"), t("Seat"), t("Marks"), t("Talk it over")];
  return h(
    "section",
    { class: "panel class-marks" },
    h("h2", {}, `${it.id}: ${it.practice ? t("{lesson} for practice", { lesson: it.lesson }) : it.lesson}`),
    h(
      "table",
      {},
      h("thead", {}, h("tr", {}, ...heads.map((text) => h("th", { scope: "col" }, text)))),
      h("tbody", {}, ...rows),
    ),
    h("p", {}, h("a", { href: `/door/marks.csv?class=${it.id}`, download: `${it.id}.csv` }, t("As a table (CSV)"))),
  );
}
