// The picture from the forecastle, with its cameras and what ear and nose say over it.

import { showsTopic } from "../kit/live";
import { everyFrame, type Page } from "../kit/page";
import { h, setAttribute, setShown } from "../kit/dom";
import { onPalette } from "../kit/palette";
import { Cry } from "../kit/cry";
import { frameOfSeat } from "../scene/from_seat";
import { type CameraName, ShipScene } from "../scene/ship_scene";
import type { SceneDescription } from "../wire/generated";
import { t } from "../kit/language";

const kCameras: readonly (readonly [CameraName, string])[] = [
  ["stand", t("Stand")],
  ["bow", t("Over the bow")],
  ["brake", t("At the brake")],
  ["aft", t("Aft")],
];

const kCloser = 0.75; // of the angle that is seen, a touch
const kLight = 6.5; // h, before and until which a lamp helps

const drawnOn = (): HTMLCanvasElement => h("canvas", { "aria-label": t("the forecastle, drawn"), role: "img" });

export class SceneView {
  readonly element: HTMLElement;
  /** For what lies over the picture. */
  readonly over = h("div", { class: "over" });
  private canvas = drawnOn();
  private readonly buttons: HTMLButtonElement[];
  private readonly underWater: HTMLButtonElement;
  private readonly lamp: HTMLButtonElement;
  private readonly message = h("p", { class: "scene-message" }, t("Waiting for the ship ..."));
  /** Over the bow nothing in the picture says where ahead is; who stands there feels it. */
  private readonly ahead = h(
    "p",
    { class: "ahead", hidden: true },
    h("span", { "aria-hidden": "true" }, "\u2191"),
    t("Ahead"),
  );
  /** As two fingers or the mouse's wheel do it, which nobody sees. */
  private readonly closer = h(
    "div",
    { class: "closer", role: "group", "aria-label": t("look"), hidden: true },
    this.looks("+", t("look closer"), kCloser),
    this.looks("\u2212", t("look wider"), 1 / kCloser),
  );
  private scene: ShipScene | undefined;
  private drawn: bigint | undefined; // definition of what the scene shows
  private camera: CameraName = "stand";
  private side = 0;
  private lampOn = false;
  private readonly cry: Cry;

  constructor(private readonly page: Page) {
    this.cry = new Cry(page.link, "forecastle");
    this.buttons = kCameras.map(([name, text], i) =>
      h(
        "button",
        { class: "plain", "aria-pressed": `${i === 0}`, onclick: () => this.look(name) },
        h("kbd", { "aria-hidden": "true" }, i + 1),
        ` ${text}`,
      ),
    );
    this.underWater = h(
      "button",
      { class: "plain", "aria-pressed": "false", hidden: true, onclick: () => this.look("water") },
      h("kbd", { "aria-hidden": "true" }, 7),
      ` ${t("Under water")}`,
    );
    this.lamp = h(
      "button",
      { class: "plain", "aria-pressed": "false", hidden: true, onclick: () => this.switchLamp() },
      h("kbd", { "aria-hidden": "true" }, "l"),
      ` ${t("Hand lamp")}`,
    );
    this.element = h(
      "section",
      { class: "scene", "aria-label": t("picture") },
      this.canvas,
      this.message,
      this.ahead,
      this.closer,
      h(
        "div",
        { class: "scene-top" },
        h("div", { class: "cameras", role: "group", "aria-label": t("camera") }, ...this.buttons, this.underWater),
        h("div", { class: "cameras" }, this.lamp),
        this.over,
      ),
    );
    if (new URLSearchParams(location.search).get("picture") === "off") {
      this.message.textContent = t("The picture is off."); // for a computer that is too slow to draw it
      return;
    }
    page.link.on("SceneDescription", (description) => this.build(description));
    page.link.on("Daylight", ({ time_of_day }) => {
      const hour = time_of_day / 3600;
      this.lamp.hidden = hour > kLight && hour < 24 - kLight && !this.lampOn;
    });
    page.link.on("SeaState", (sea) => this.scene?.setSea(sea));
    page.link.on("Landmarks", (landmarks) => this.scene?.setLandmarks(landmarks));
    showsTopic(this.element, page.link, "ForecastleView");
    new ResizeObserver(() => this.scene?.resize()).observe(this.element);
    onPalette(() => this.scene?.resize());
    everyFrame((now) => this.draw(now));
  }

  /** Which windlass is looked at: 0, 1. */
  setSide(side: number): void {
    this.side = side;
    this.scene?.setSide(side);
  }

  /** By the number on its key. */
  lookNumber(number: number): void {
    if (number >= 1 && number <= kCameras.length) this.look(kCameras[number - 1]![0]);
    else if (number === 7 && !this.underWater.hidden) this.look("water");
  }

  /** Turns the lamp in the hand on or off. */
  switchLamp(): void {
    this.lampOn = !this.lampOn;
    this.scene?.setHandLamp(this.lampOn);
    setAttribute(this.lamp, "aria-pressed", `${this.lampOn}`);
  }

  /** Of the scene, for measurements; undefined before the first picture. */
  stats(): ReturnType<ShipScene["stats"]> | undefined {
    return this.scene?.stats();
  }

  /** Of who looks; undefined: there is no picture, or it is one from under water. */
  ears(): ReturnType<ShipScene["ears"]> | undefined {
    return this.camera === "water" ? undefined : this.scene?.ears();
  }

  private looks(text: string, title: string, factor: number): HTMLButtonElement {
    return h("button", { title, "aria-label": title, onclick: () => this.scene?.zoom(factor) }, text);
  }

  private look(camera: CameraName): void {
    this.camera = camera;
    this.scene?.setCamera(camera);
    kCameras.forEach(([name], i) => setAttribute(this.buttons[i]!, "aria-pressed", `${name === camera}`));
    setAttribute(this.underWater, "aria-pressed", `${camera === "water"}`);
  }

  private build(description: SceneDescription): void {
    if (this.scene && this.drawn === description.definition_hash) return; // heard again after a reconnection
    this.scene?.dispose();
    const canvas = drawnOn(); // one that no scene has used
    this.canvas.replaceWith(canvas);
    this.canvas = canvas;
    this.drawn = description.definition_hash;
    try {
      this.scene = new ShipScene(this.canvas, description);
    } catch (why) {
      this.message.hidden = false;
      this.closer.hidden = true;
      this.scene = undefined;
      this.message.textContent = t("This browser draws no WebGL picture; the stand works without it.");
      console.warn(`${why}`);
      return;
    }
    this.message.hidden = true;
    this.closer.hidden = false;
    this.underWater.hidden = !description.underwater_camera;
    if (this.underWater.hidden && this.camera === "water") this.look("stand");
    this.scene.still = this.page.still;
    const sea = this.page.link.latest("SeaState");
    if (sea) this.scene.setSea(sea);
    this.scene.setLandmarks(this.page.link.latest("Landmarks"));
    this.scene.setSide(this.side);
    this.scene.setCamera(this.camera);
    this.scene.setHandLamp(this.lampOn);
    this.scene.resize();
  }

  private draw(now: number): void {
    if (!this.scene || this.page.link.state !== "open") return;
    const frame = frameOfSeat(this.page.link, now);
    if (!frame) return;
    this.scene.draw(this.cry.time === undefined ? frame : { ...frame, cried: this.cry.time });
    this.showAhead(this.scene);
  }

  private showAhead(scene: ShipScene): void {
    const lip = this.camera === "bow" ? scene.gear(this.side)?.tackle.lip : undefined;
    const here = lip && scene.onCanvas([lip.x, lip.y, 0], "ship");
    const there = lip && scene.onCanvas([lip.x + 2, lip.y, 0], "ship");
    setShown(this.ahead, here !== undefined && there !== undefined);
    if (!here || !there) return;
    const turned = Math.round((Math.atan2(there.x - here.x, here.y - there.y) * 180) / Math.PI);
    setAttribute(this.ahead, "style", `--turned: ${turned}deg`);
  }
}
