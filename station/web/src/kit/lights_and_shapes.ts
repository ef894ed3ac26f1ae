// Anchor ball and anchor lights: what she shows, and, for a seat that may, the switch of each.

import type { Connection } from "../wire/connection";
import { h, setAttribute, setText } from "./dom";
import { showsTopic } from "./live";
import { t } from "./language";

const kSignals = [
  ["anchor_ball", t("Anchor ball"), t("hoisted"), t("down|of the anchor ball")],
  ["anchor_lights", t("Anchor lights"), t("on|lights"), t("off|lights")],
] as const;

export class LightsAndShapesPanel {
  readonly element: HTMLElement;
  private readonly buttons: { button: HTMLButtonElement; state: HTMLElement }[];
  private readonly refusal = h("small", { role: "status" });

  constructor(private readonly link: Connection) {
    this.buttons = kSignals.map(([field, name]) => {
      const state = h("strong", {});
      const button = h(
        "button",
        { class: "plain", type: "button", "aria-pressed": "false", onclick: () => void this.change(field) },
        `${name}: `,
        state,
      );
      return { button, state };
    });
    this.element = h(
      "div",
      { class: "lights-and-shapes", role: "group", "aria-label": t("lights and shapes") },
      ...this.buttons.map(({ button }) => button),
      this.refusal,
    );
    showsTopic(this.element, link, "LightsAndShapes");
    link.on("LightsAndShapes", () => this.update());
    link.onState(() => this.update());
    this.update();
  }

  private update(): void {
    const shown = this.link.latest("LightsAndShapes");
    const granted = this.link.hello?.commands.includes("LightsAndShapesCommand") ?? false;
    kSignals.forEach(([field, , yes, no], i) => {
      const { button, state } = this.buttons[i]!;
      setAttribute(button, "aria-pressed", `${shown?.[field] ?? false}`);
      setText(state, shown ? (shown[field] ? yes : no) : "-");
      button.disabled = !granted || !shown;
    });
  }

  private async change(field: (typeof kSignals)[number][0]): Promise<void> {
    const shown = this.link.latest("LightsAndShapes");
    if (!shown) return;
    const { anchor_ball, anchor_lights } = shown;
    try {
      await this.link.order("LightsAndShapesCommand", { anchor_ball, anchor_lights, [field]: !shown[field] });
      setText(this.refusal, "");
    } catch (why) {
      setText(this.refusal, t("Not done: {why}", { why: (why as Error).message }));
    }
  }
}
