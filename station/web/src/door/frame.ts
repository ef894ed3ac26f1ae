// What the pages of the door have around them: the bar on top.

import { byId, h, setText } from "../kit/dom";
import { nextPalette, paletteLabel, paletteWord } from "../kit/palette";
import { languageButton } from "../kit/language_choice";
import { t, titlePage } from "../kit/language";

/** A page of no exercise: a bar with the title and what else stands in it; returns where the page puts itself. */
export function frame(title: string, ...inBar: Node[]): HTMLElement {
  titlePage(title);
  document.body.classList.add("obc-component-size-regular", "door");
  const turn = h("button", { class: "plain", title: t("palette") });
  const tell = (): void => {
    setText(turn, paletteWord());
    turn.setAttribute("aria-label", paletteLabel());
  };
  turn.onclick = () => {
    nextPalette();
    tell();
  };
  tell();
  document.body.prepend(
    h(
      "header",
      { class: "top-bar" },
      h("span", { class: "title" }, "Windlass"),
      h("h1", { class: "seat" }, title),
      h("div", { class: "middle" }, ...inBar),
      h("div", { class: "row" }, languageButton(), turn),
    ),
  );
  return byId("page");
}
