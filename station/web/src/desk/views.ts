// The pictures of the desk: the scene from anywhere, and the plan; one of them, or both.

import { h, setAttribute } from "../kit/dom";
import type { Desk } from "./desk";
import { PlanFeed } from "./plan_feed";

type Mode = "both" | "scene" | "plan";
const modes: readonly (readonly [Mode, string])[] = [
  ["both", "3D and plan"],
  ["scene", "3D"],
  ["plan", "Plan"],
];

export class Views {
  readonly element: HTMLElement;
  /** Chooses what is shown. */
  readonly choice: HTMLElement;

  constructor(desk: Desk, still: boolean) {
    const plan = h("div", { class: "view plan-view" });
    const scene = h("div", { class: "scene-place" });
    this.element = h("div", { class: "views" }, scene, plan);
    new PlanFeed(plan, desk.link, desk.events);
    // The scene's code is most of the page: the desk does not wait for it.
    void import("./scene_view").then(({ SceneView }) => scene.append(new SceneView(desk, still).element));
    const buttons = modes.map(([mode, text]) => h("button", { class: "chip", "data-mode": mode, onclick: () => show(mode) }, text));
    const show = (mode: Mode): void => {
      scene.hidden = mode === "plan";
      plan.hidden = mode === "scene";
      for (const button of buttons) setAttribute(button, "aria-pressed", `${button.dataset.mode === mode}`);
    };
    show("both");
    this.choice = h("div", { class: "chips", role: "group", "aria-label": "pictures shown" }, ...buttons);
  }
}
