// A pad of figures: one touch says it, or it is typed and Enter says it. For what the trainee has counted himself.

import { h } from "./dom";
import { inHalves } from "./units";
import { t, typedFigure, writtenFigure } from "./language";

const kMost = 12; // shackles

/** What the pad has a key for: 0, a half, 1 and so on, as near as cable is counted between two marks. */
export const padFigures: readonly number[] = Array.from({ length: 2 * kMost + 1 }, (_, halves) => halves / 2);

const isOfFigure = (key: string): boolean => /^[\d.,]$/.test(key);
const isTyped = ({ ctrlKey, altKey, metaKey }: KeyboardEvent): boolean => !ctrlKey && !altKey && !metaKey;

/** The figure that text stands for, in halves: "10", "1.", "1.5". */
const figureOf = (text: string): number => Math.floor(Number(text) || 0) + (text.includes(".") ? 0.5 : 0);
const fits = (text: string): boolean => /^\d{0,2}(\.5?)?$/.test(text) && figureOf(text) <= kMost;

/** What is typed after one more key: a digit that does not fit begins anew. undefined: it is no key of a figure. */
export function typedOn(typed: string, key: string): string | undefined {
  if (key === "Backspace") return typed.slice(0, -1);
  if (!isOfFigure(key)) return undefined;
  const sign = key === "," ? "." : key;
  if (fits(typed + sign)) return typed + sign;
  return sign === "." ? typed : sign;
}

/** A key says at one touch what stands on it; chosen is called with the figure. */
export function figurePad(label: string, chosen: (value: number) => void): HTMLElement {
  const keys = padFigures.map((value) =>
    h("button", { class: value % 1 ? "" : "whole", onclick: () => chosen(value) }, inHalves(value)),
  );
  let typed = "";
  const type = (event: KeyboardEvent): void => {
    const text = isTyped(event) ? typedOn(typed, event.key) : undefined;
    if (text === undefined) return;
    event.preventDefault();
    event.stopPropagation(); // a lever's key is none here
    typed = text;
    keys[padFigures.indexOf(figureOf(typed))]?.focus(); // Enter presses it
  };
  return h(
    "div",
    { class: "pad", role: "group", "aria-label": label, "data-takes-figures": "", onkeydown: type },
    ...keys,
  );
}

/** Gives a key of a figure to the pad that lies open, wherever the focus is; false: there is none, or no such key. */
export function typeIntoOpenPad(event: KeyboardEvent): boolean {
  const pad = isOfFigure(event.key) ? document.querySelector("[data-takes-figures]") : null;
  if (!pad) return false;
  event.preventDefault();
  pad.dispatchEvent(new KeyboardEvent("keydown", { key: event.key }));
  return true;
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
  const type = (event: KeyboardEvent): void => {
    if (event.target === field || !isTyped(event) || !isOfFigure(event.key)) return;
    event.preventDefault();
    event.stopPropagation();
    field.value += event.key;
    field.focus();
  };
  return h(
    "div",
    { class: "field-pad", "data-takes-figures": "", onkeydown: type },
    h("div", { class: "row" }, field, h("span", {}, unit), h("button", { class: "primary", onclick: say }, t("Say"))),
    h(
      "div",
      { class: "pad", role: "group", "aria-label": label },
      ...Array.from(`0123456789${writtenFigure(".")}`, digit),
    ),
  );
}
