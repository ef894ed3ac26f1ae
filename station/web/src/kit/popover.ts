// What opens over the picture for a choice: one at a time, shut by Escape, a touch elsewhere or the choice.

import { h } from "./dom";
import { t } from "./language";

export class Popover {
  private open: HTMLElement | undefined;
  private from: HTMLElement | undefined;

  /** host: where it is put, a positioned element. */
  constructor(private readonly host: HTMLElement) {
    document.addEventListener("pointerdown", (event) => {
      const target = event.target as Node;
      if (this.open && !this.open.contains(target) && !this.from?.contains(target)) this.close();
    });
  }

  /** Opens it with a title, or shuts it where the same button has opened it. */
  show(title: string, from: HTMLElement, ...content: HTMLElement[]): void {
    const again = this.open !== undefined && this.from === from;
    this.close();
    if (again) return;
    this.from = from;
    from.setAttribute("aria-expanded", "true");
    this.open = h(
      "section",
      { class: "popover panel", role: "dialog", "aria-label": title },
      h(
        "div",
        { class: "row" },
        h("h2", {}, title),
        h("button", { class: "plain", "aria-label": t("close"), onclick: () => this.close() }, "\u2715"),
      ),
      ...content,
    );
    this.open.addEventListener("keydown", (event) => {
      if (event.key !== "Escape") return;
      event.stopPropagation();
      this.close();
    });
    this.host.append(this.open);
    this.open.querySelector<HTMLElement>("input, .row ~ * button")?.focus();
  }

  /** Shuts it and gives the focus back. */
  close(): void {
    if (!this.open) return;
    const inside = this.open.contains(document.activeElement);
    this.open.remove();
    this.open = undefined;
    this.from?.setAttribute("aria-expanded", "false");
    if (inside) this.from?.focus();
    this.from = undefined;
  }
}
