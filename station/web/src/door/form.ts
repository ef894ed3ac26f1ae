// Forms that say what went wrong.

import { h, setText } from "../kit/dom";

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
