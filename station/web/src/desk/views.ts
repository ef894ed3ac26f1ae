// The pictures of the desk: the scene from anywhere, and the plan; one of them, or both.

import { h, setAttribute } from "../kit/dom";
import type { Desk } from "./desk";
import { PlanFeed } from "./plan_feed";
import type { SceneView } from "./scene_view";
import { t } from "../kit/language";
import type { Prediction } from "../wire/generated";

type Mode = "both" | "scene" | "plan";
const modes: readonly (readonly [Mode, string])[] = [
  ["both", t("3D and plan")],
  ["scene", "3D"],
  ["plan", t("Plan")],
];

const kMode = "windlass.views";

function remembered(): Mode {
  try {
    return modes.find(([mode]) => mode === localStorage.getItem(kMode))?.[0] ?? "both";
  } catch {
    return "both"; // a browser that keeps nothing
  }
}

export class Views {
  readonly element: HTMLElement;
  /** Chooses what is shown. */
  readonly choice: HTMLElement;
  private readonly scenePlace = h("div", { class: "scene-place" });
  private readonly plan = h("div", { class: "view plan-view" });
  private readonly buttons: HTMLButtonElement[];
  private scene: Promise<SceneView> | undefined;

  constructor(
    private readonly desk: Desk,
    private readonly still: boolean,
    ahead: () => Prediction | undefined,
  ) {
    this.element = h("div", { class: "views" }, this.scenePlace, this.plan);
    desk.past.add(new PlanFeed(this.plan, desk.link, desk.events, ahead));
    this.buttons = modes.map(([mode, text]) =>
      h("button", { class: "chip", "data-mode": mode, onclick: () => this.show(mode) }, text),
    );
    this.choice = h("div", { class: "chips", role: "group", "aria-label": t("pictures shown") }, ...this.buttons);
    this.show(remembered());
  }

  private show(mode: Mode): void {
    this.scenePlace.hidden = mode === "plan";
    this.plan.hidden = mode === "scene";
    for (const button of this.buttons) setAttribute(button, "aria-pressed", `${button.dataset.mode === mode}`);
    if (mode !== "plan") this.scene ??= this.makeScene();
    void this.scene?.then((scene) => (scene.visible = !this.scenePlace.hidden));
    try {
      localStorage.setItem(kMode, mode);
    } catch {
      // the first choice comes back
    }
  }

  /** The scene's code is most of the page: the desk does not wait for it. */
  private async makeScene(): Promise<SceneView> {
    const { SceneView } = await import("./scene_view");
    const scene = new SceneView(this.desk, this.still);
    this.scenePlace.append(scene.element);
    return scene;
  }
}
