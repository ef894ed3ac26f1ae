// What the pages of the door have around them: the bar on top, and forms that say what went wrong.

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

/** A field of a form with its label. */
export function field(label: string, input: HTMLElement, hint = ""): HTMLElement {
  return h("label", { class: "field" }, h("span", {}, label), input, hint && h("small", { class: "quiet" }, hint));
}

/** A form with one button. send may throw: the reason stands below, and what was typed stays. */
export function form(words: string, fields: Node[], send: () => Promise<void>): HTMLFormElement {
  const why = h("p", { class: "why", role: "alert" });
  const button = h("button", { class: "primary" }, words);
  return h(
    "form",
    {
      class: "panel",
      onsubmit: (event: Event) => {
        event.preventDefault();
        setText(why, "");
        button.disabled = true;
        send()
          .catch((error: Error) => setText(why, error.message))
          .finally(() => (button.disabled = false));
      },
    },
    ...fields,
    button,
    why,
  );
}
