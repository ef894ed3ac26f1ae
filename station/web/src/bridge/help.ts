// The page's help: keys and gamepad.

import { h } from "../kit/dom";
import { kKeys } from "./keys";
import { t } from "../kit/language";

/** A dialog that is not yet in the page. */
export function helpDialog(): HTMLDialogElement {
  const row = (cell: "th" | "td", texts: readonly string[]): HTMLElement =>
    h("tr", {}, ...texts.map((text) => h(cell, {}, text)));
  return h(
    "dialog",
    { class: "help", "aria-label": t("keys and gamepad") },
    h(
      "table",
      {},
      h("thead", {}, row("th", [t("Key"), t("Does"), "Gamepad"])),
      h("tbody", {}, ...kKeys.map((texts) => row("td", texts))),
    ),
    h("form", { method: "dialog" }, h("button", { class: "primary" }, t("Close"))),
  );
}
