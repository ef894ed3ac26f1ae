// The choice of the language: among the units, and where there are none, in the bar.

import { h, setText } from "./dom";
import { type Language, chooseLanguage, language, languages, t } from "./language";

const all = Object.entries(languages) as [Language, string][];

/** Radio buttons. The page is loaded anew with the choice; not out of a hand that is on levers. */
export class LanguageChoice {
  readonly element: HTMLElement;
  private readonly boxes: readonly HTMLInputElement[];
  private readonly refusal = h("small", { role: "status" });

  /** inHand: whether a hand of this page is on levers. */
  constructor(private readonly inHand: () => boolean) {
    this.boxes = all.map(([code]) =>
      h("input", { type: "radio", name: "language", checked: code === language, onchange: () => this.choose(code) }),
    );
    this.element = h(
      "fieldset",
      {},
      h("legend", {}, t("Language")),
      ...all.map(([code, name], i) => h("label", {}, this.boxes[i], h("span", { lang: code }, name))),
      this.refusal,
    );
  }

  private choose(code: Language): void {
    const held = this.inHand();
    if (!held) chooseLanguage(code);
    this.boxes.forEach((box, i) => (box.checked = all[i]![0] === language));
    setText(this.refusal, held ? t("You have levers in hand: leave them first. The page is loaded anew.") : "");
  }
}

/** A button that turns to the next language, by its own name. */
export function languageButton(): HTMLButtonElement {
  const [code, name] = all[(all.findIndex(([each]) => each === language) + 1) % all.length]!;
  return h("button", { class: "plain", type: "button", lang: code, onclick: () => chooseLanguage(code) }, name);
}
