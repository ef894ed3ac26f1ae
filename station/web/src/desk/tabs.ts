// Some panels in one place, one shown at a time.

import { h, setAttribute } from "../kit/dom";

export interface Tab {
  id: string;
  title: string;
  content: HTMLElement;
}

/** An element with a bar of tabs and the panels; the first one is shown. */
export function tabs(label: string, list: readonly Tab[]): HTMLElement {
  const buttons = list.map((tab) =>
    h(
      "button",
      {
        class: "tab",
        role: "tab",
        id: `tab-${tab.id}`,
        "aria-controls": `panel-${tab.id}`,
        onclick: () => show(tab.id),
      },
      tab.title,
    ),
  );
  const panels = list.map((tab) =>
    h(
      "div",
      { class: "tab-panel", role: "tabpanel", id: `panel-${tab.id}`, "aria-labelledby": `tab-${tab.id}` },
      tab.content,
    ),
  );
  const bar = h("div", { class: "tab-bar", role: "tablist", "aria-label": label }, ...buttons);
  const show = (id: string): void => {
    list.forEach((tab, i) => {
      const chosen = tab.id === id;
      panels[i]!.hidden = !chosen;
      setAttribute(buttons[i]!, "aria-selected", `${chosen}`);
      buttons[i]!.tabIndex = chosen ? 0 : -1;
    });
  };
  bar.addEventListener("keydown", (event) => {
    const step = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
    if (!step) return;
    event.preventDefault();
    event.stopPropagation();
    const at = buttons.findIndex((button) => button.getAttribute("aria-selected") === "true");
    const next = buttons[(at + step + buttons.length) % buttons.length]!;
    next.focus();
    next.click();
  });
  show(list[0]!.id);
  return h("div", { class: "tabs" }, bar, ...panels);
}
