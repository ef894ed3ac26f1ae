// What a phone keeps folded: a button unfolds it over the page; a touch elsewhere, a button in it or Escape folds it
// again. Style sheets say what is folded, by data-unfolded; where nothing is, they hide the button.

import { h } from "./dom";

/** The button of what is folded. label: what it unfolds, sign: what is written on it. */
export function unfoldButton(folded: HTMLElement, label: string, sign: string): HTMLButtonElement {
  const turn = (open: boolean): void => {
    folded.toggleAttribute("data-unfolded", open);
    button.setAttribute("aria-expanded", `${open}`);
  };
  const toggle = (): void => turn(!folded.hasAttribute("data-unfolded"));
  const button = h(
    "button",
    { class: "plain unfold", type: "button", "aria-label": label, "aria-expanded": "false", onclick: toggle },
    sign,
  );
  folded.addEventListener("click", ({ target }) => {
    const other = (target as Element).closest("button");
    if (other && other !== button) turn(false);
  });
  document.addEventListener("pointerdown", ({ target }) => {
    if (!folded.contains(target as Node)) turn(false);
  });
  document.addEventListener("keydown", (event) => {
    if (event.key === "Escape") turn(false);
  });
  return button;
}
