// A pad of figures: one touch says it. For what the trainee has counted himself.

import { h, setAttribute } from "./dom";
import { t, typedFigure, writtenFigure } from "./language";

const kMost = 12; // shackles

/** 0 to 12, with a half before the touch where halves are wanted; chosen is called with the figure. */
export function figurePad(label: string, chosen: (value: number) => void): HTMLElement {
  let half = 0;
  const halfButton = h("button", { "aria-pressed": "false", title: t("and a half") }, "+ \u00bd");
  const keys: HTMLButtonElement[] = [];
  for (let n = 0; n <= kMost; ++n) keys.push(h("button", { onclick: () => chosen(n + half) }, n));
  halfButton.addEventListener("click", () => {
    half = half ? 0 : 0.5;
    setAttribute(halfButton, "aria-pressed", `${half > 0}`);
    keys.forEach((key, n) => (key.textContent = half ? `${n || ""}\u00bd` : `${n}`));
  });
  return h("div", { class: "pad", role: "group", "aria-label": label }, ...keys, halfButton);
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
