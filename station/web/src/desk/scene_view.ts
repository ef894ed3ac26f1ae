// The scene from anywhere, with the loads drawn on the chain and forces as arrows: the truth, as only an instructor
// sees it.

import { h, setAttribute } from "../kit/dom";
import { everyFrame } from "../kit/page";
import { onPalette } from "../kit/palette";
import { frameOfTruth } from "../scene/from_truth";
import { type CameraName, ShipScene } from "../scene/ship_scene";
import type { SceneDescription } from "../wire/generated";
import type { Desk } from "./desk";
import { ForceArrows, forces } from "./forces";
import { language, t } from "../kit/language";

const cameras: readonly (readonly [CameraName, string])[] = [
  ["outside", t("Outside")],
  ["bow", t("Over the bow")],
  ["stand", t("Stand")],
  ["brake", t("Brake")],
  ["aft", t("Aft")],
  ["water", t("Under water")],
  ["free", t("Free")],
];

export class SceneView {
  readonly element: HTMLElement;
  /** Whether anybody sees it: else it draws nothing. */
  visible = true;
  private canvas = h("canvas", { role: "img" });
  private readonly message = h("p", { class: "scene-message" }, t("Waiting for the ship ..."));
  private readonly loads: HTMLButtonElement;
  private readonly forces: HTMLButtonElement;
  private readonly arrows = new ForceArrows();
  private scene: ShipScene | undefined;
  private shown: bigint | undefined; // definition of what the scene shows
  private camera: CameraName = "outside";

  constructor(
    private readonly desk: Desk,
    private readonly still: boolean,
  ) {
    const buttons = cameras.map(([name, text]) =>
      h("button", { class: "chip", "data-camera": name, onclick: () => look(name) }, text),
    );
    const look = (name: CameraName): void => {
      this.camera = name;
      this.scene?.setCamera(name);
      for (const button of buttons) setAttribute(button, "aria-pressed", `${button.dataset.camera === name}`);
      setAttribute(
        this.canvas,
        "aria-label",
        t("the ship, camera {name}; drag looks round, the wheel zooms", {
          name: language === "en" ? name : (cameras.find(([each]) => each === name)?.[1] ?? name),
        }),
      );
    };
    this.loads = h(
      "button",
      { class: "chip", "aria-pressed": "true", onclick: () => this.toggleLoads() },
      t("Loads on chain"),
    );
    this.forces = h(
      "button",
      { class: "chip", "aria-pressed": "false", onclick: () => this.toggleForces() },
      t("Forces"),
    );
    this.arrows.element.hidden = true;
    this.element = h(
      "div",
      { class: "view scene-view" },
      this.canvas,
      this.arrows.element,
      this.message,
      h("div", { class: "chips over", role: "group", "aria-label": t("camera") }, ...buttons, this.loads, this.forces),
    );
    look("outside");
    desk.link.on("SceneDescription", (description) => this.build(description));
    desk.link.on("SeaState", (sea) => this.scene?.setSea(sea));
    desk.link.on("SeabedDescription", (bed) => this.scene?.setSeabed(bed));
    desk.link.on("Landmarks", (landmarks) => this.scene?.setLandmarks(landmarks));
    desk.onSide((side) => this.scene?.setSide(side));
    new ResizeObserver(() => this.scene?.resize()).observe(this.element);
    onPalette(() => this.scene?.resize());
    const known = desk.link.latest("SceneDescription"); // this part of the page may come after it
    if (known) this.build(known);
    everyFrame((now) => this.draw(now));
  }

  private toggleLoads(): void {
    const on = this.loads.getAttribute("aria-pressed") !== "true";
    setAttribute(this.loads, "aria-pressed", `${on}`);
    if (this.scene) this.scene.showLoads = on;
  }

  private toggleForces(): void {
    const on = this.forces.getAttribute("aria-pressed") !== "true";
    setAttribute(this.forces, "aria-pressed", `${on}`);
    this.arrows.element.hidden = !on;
  }

  private build(description: SceneDescription): void {
    if (this.scene && this.shown === description.definition_hash) return; // heard again after a reconnection
    this.scene?.dispose();
    // no scene has used it
    const canvas = h("canvas", { role: "img", "aria-label": this.canvas.getAttribute("aria-label") });
    this.canvas.replaceWith(canvas);
    this.canvas = canvas;
    this.shown = description.definition_hash;
    this.message.hidden = true;
    try {
      this.scene = new ShipScene(canvas, description);
    } catch (why) {
      this.scene = undefined;
      this.message.hidden = false;
      this.message.textContent = t("This browser draws no WebGL picture; the desk works without it.");
      console.warn(`${why}`);
      return;
    }
    this.scene.still = this.still;
    this.scene.showLoads = this.loads.getAttribute("aria-pressed") === "true";
    this.scene.setSeabed(this.desk.link.latest("SeabedDescription"));
    this.scene.setLandmarks(this.desk.link.latest("Landmarks"));
    this.scene.setSea(this.desk.link.latest("SeaState"));
    this.scene.setSide(this.desk.side);
    this.scene.setCamera(this.camera);
    this.scene.resize();
  }

  private draw(now: number): void {
    if (!this.scene || !this.visible || this.desk.link.state !== "open") return;
    const frame = frameOfTruth(this.desk.link, now);
    if (!frame) return;
    this.scene.draw(frame);
    if (!this.arrows.element.hidden) this.arrows.draw(this.scene, forces(this.desk.link, this.scene, frame));
  }
}
