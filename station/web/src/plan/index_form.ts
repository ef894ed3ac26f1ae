// The form of the parallel index: course, distance and side of each line, as they are typed.

import { h, setText } from "../kit/dom";
import { t } from "../kit/language";
import { radians } from "../kit/units";
import { type IndexUnit, type ParallelIndex, indexFigures, kIndexMost, kIndexUnits } from "./parallel_index";

/** The rows of a popover. fresh: a line of which nothing was set yet is laid so, course rad and distance m. */
export function indexForm(index: ParallelIndex, fresh: () => { course: number; off: number }): HTMLElement[] {
  const said = h("p", { class: "quiet", role: "status" });
  const rows = ([0, 1] as const).map((which) => row(index, which, fresh, said));
  const unit = h(
    "select",
    { "aria-label": t("unit of the distance") },
    h("option", { value: "nm" }, t("NM")),
    h("option", { value: "cable" }, t("cables, tenths of a mile")),
  );
  unit.onchange = () => {
    index.setUnit(unit.value as IndexUnit);
    show();
  };
  const show = (): void => {
    unit.value = index.unit;
    for (const each of rows) each.show();
  };
  show();
  return [
    ...rows.map(({ element }) => element),
    unit,
    said,
    h(
      "p",
      { class: "quiet" },
      t("Drag a line to its distance, or its square to its course. What is charted runs along it on that course."),
    ),
  ];
}

function row(
  index: ParallelIndex,
  which: 0 | 1,
  fresh: () => { course: number; off: number },
  said: HTMLElement,
): { element: HTMLElement; show: () => void } {
  const number = which + 1;
  const on = h("input", { type: "checkbox", "aria-label": t("line {which}", { which: number }) });
  const course = h("input", {
    type: "number",
    min: "0",
    max: "360",
    step: "0.1",
    "aria-label": t("course of line {which}, degrees", { which: number }),
  });
  const far = h("input", {
    type: "number",
    min: "0",
    step: "0.01",
    "aria-label": t("distance of line {which}", { which: number }),
  });
  const side = h(
    "select",
    { "aria-label": t("side of line {which}", { which: number }) },
    h("option", { value: "-1" }, t("port")),
    h("option", { value: "1" }, t("starboard")),
  );
  const show = (): void => {
    const line = index.lines[which];
    const figures = indexFigures(line, index.unit);
    on.checked = line.on;
    course.value = line.on ? figures.course : "";
    far.value = line.on ? figures.far : "";
    side.value = line.off < 0 ? "-1" : "1";
  };
  on.onchange = () => {
    const line = index.lines[which];
    index.set(which, { ...(line.off === 0 && line.course === 0 ? fresh() : {}), on: on.checked });
    setText(said, "");
    show();
  };
  // What is typed lays the line as soon as it is whole; until then it stands as it was.
  const typed = (): void => {
    const most = kIndexMost / kIndexUnits[index.unit];
    const [degree, distance] = [course.valueAsNumber, far.valueAsNumber];
    setText(said, "");
    if (degree < 0 || degree > 360) setText(said, t("Course {value}: 0 to 360 degrees", { value: degree }));
    else if (distance < 0 || distance > most)
      setText(said, t("Distance {value}: 0 to {most}", { value: distance, most }));
    else if (Number.isFinite(degree) && Number.isFinite(distance)) {
      const off = Number(side.value) * distance * kIndexUnits[index.unit];
      index.set(which, { on: true, course: radians(degree), off });
      on.checked = true;
    }
  };
  for (const field of [course, far]) field.oninput = typed;
  side.onchange = typed;
  const element = h(
    "div",
    { class: "row index-row" },
    h("label", { class: "row" }, on, h("b", {}, `${number}`)),
    h("label", { class: "row" }, course, "\u00b0"),
    far,
    side,
  );
  return { element, show };
}
