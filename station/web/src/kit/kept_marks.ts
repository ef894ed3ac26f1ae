// Marks that are read when the class is over: a page that is loaded anew then has no seat any more to hear them from,
// so that this tab keeps them until they are closed.

import { h } from "./dom";
import { t } from "./language";

const kKept = "windlass.marks";

/** As they stand there: their headline and their body. */
export function keepMarks(head: Element, body: Element): void {
  try {
    sessionStorage.setItem(kKept, JSON.stringify([head.textContent, body.innerHTML]));
  } catch {
    // a browser that keeps nothing has them on the page alone
  }
}

export const dropMarks = (): void => sessionStorage.removeItem(kKept);

/** Headline and body of those that are kept; what is damaged is none. */
function keptMarks(): string[] {
  try {
    const kept: unknown = JSON.parse(sessionStorage.getItem(kKept) ?? "[]");
    return Array.isArray(kept) ? kept.filter((part) => typeof part === "string") : [];
  } catch {
    return [];
  }
}

/** Opens those that were read when the page was loaded anew. */
export function showKeptMarks(): void {
  const [head, marks] = keptMarks();
  if (head === undefined || marks === undefined) return;
  const body = h("div", { class: "scroll", tabIndex: 0, role: "group", "aria-label": t("marks"), innerHTML: marks });
  const dialog = h(
    "dialog",
    { class: "briefing own-marks panel", "aria-label": t("what came of it"), onclose: dropMarks },
    h(
      "div",
      { class: "row" },
      h("h2", {}, head),
      h("button", { class: "plain", onclick: () => dialog.close() }, t("Close")),
    ),
    h("p", { class: "row class-over" }, t("The class is over.")),
    body,
  );
  document.body.append(dialog);
  dialog.showModal();
}
