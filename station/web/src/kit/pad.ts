// A pad of figures: one touch says it. For what the trainee has counted himself.

import { h } from "./dom";
import { inHalves } from "./units";
import { t, typedFigure, writtenFigure } from "./language";

const kMost = 12; // shackles

/** What the pad has a key for: 0, a half, 1 and so on, as near as cable is counted between two marks. */
export const padFigures: readonly number[] = Array.from({ length: 2 * kMost + 1 }, (_, halves) => halves / 2);

/** A key says at one touch what stands on it; chosen is called with the figure. */
export function figurePad(label: string, chosen: (value: number) => void): HTMLElement {
  const key = (value: number): HTMLElement =>
    h("button", { class: value % 1 ? "" : "whole", onclick: () => chosen(value) }, inHalves(value));
  return h("div", { class: "pad", role: "group", "aria-label": label }, ...padFigures.map(key));
}

/** A figure of any size, typed or tapped; chosen is called with it. unit: beside the field. */
export function figureField(label: string, unit: string, chosen: (value: number) => void): HTMLElement {
  const field = h("input", { type: "text", inputMode: "decimal", "aria-label": `${label}, ${unit}`, size: 5 });
  const say = (): void => {
    const value = Number(typedFigure(field.value));
    if (field.value.trim() && Number.isFinite(value)) chosen(value);
    else field.focus();
  };
  field.addEventListener("keydown", (event) => {
    if (event.key !== "Enter") return;
    event.preventDefault(); // else it presses what has the focus afterwards
    say();
  });
  const digit = (text: string): HTMLButtonElement =>
    h("button", { "aria-label": t("figure {text}", { text }), onclick: () => (field.value += text) }, text);
  return h(
    "div",
    { class: "field-pad" },
    h("div", { class: "row" }, field, h("span", {}, unit), h("button", { class: "primary", onclick: say }, t("Say"))),
    h(
      "div",
      { class: "pad", role: "group", "aria-label": label },
      ...Array.from(`0123456789${writtenFigure(".")}`, digit),
    ),
  );
}
