// Out of the bridge's windows, and the camera on the forecastle.

import { Cry } from "../kit/cry";
import { h, setAttribute, setShown, setText } from "../kit/dom";
import { showsTopic } from "../kit/live";
import { type Page, everyFrame } from "../kit/page";
import type { ShipScene } from "../scene/ship_scene";
import type { SceneDescription } from "../wire/generated";
import { LookingOut } from "./from_bridge";
import { CameraPicture } from "./from_camera";
import { Pelorus } from "./pelorus";
import { t } from "../kit/language";

const kPictures = { ahead: t("Ahead"), cctv: t("CCTV") };
type Picture = keyof typeof kPictures;

const drawnOn = (): HTMLCanvasElement => h("canvas", { "aria-label": t("view ahead, drawn"), role: "img" });

export class ViewOut {
  readonly element: HTMLElement;
  private canvas = drawnOn();
  private readonly message = h("p", { class: "no-picture" }, t("Waiting for the ship …"));
  private readonly buttons: Record<Picture, HTMLButtonElement>;
  private readonly camera = new CameraPicture(new LookingOut());
  private readonly cry: Cry;
  private readonly pelorus: Pelorus;
  private scene: ShipScene | undefined;
  private wanted: SceneDescription | undefined; // what is to be shown
  private drawn: bigint | undefined; // definition of what is shown, or being made
  private picture: Picture = "ahead";

  /** more: what stands beside the choice of pictures; lay: a bearing that was taken, rad clockwise from north. */
  constructor(
    private readonly page: Page,
    more: HTMLElement,
    lay: (bearing: number) => void,
  ) {
    this.pelorus = new Pelorus(lay, (by) => this.scene?.turn(by));
    const button = (picture: Picture): HTMLButtonElement =>
      h("button", { class: "plain", type: "button", onclick: () => this.look(picture) }, kPictures[picture]);
    this.buttons = { ahead: button("ahead"), cctv: button("cctv") };
    this.element = h(
      "section",
      { class: "panel view-out", "aria-label": t("view") },
      this.canvas,
      this.message,
      h(
        "div",
        { class: "pictures", role: "group", "aria-label": t("picture") },
        this.buttons.ahead,
        this.buttons.cctv,
        this.pelorus.button,
        more,
      ),
      this.pelorus.element,
    );
    this.cry = new Cry(page.link, "bridge");
    page.link.on("SceneDescription", (description) => (this.wanted = description));
    page.link.on("SeaState", (sea) => this.scene?.setSea(sea));
    page.link.on("Landmarks", (landmarks) => this.scene?.setLandmarks(landmarks));
    showsTopic(this.element, page.link, "BridgeView");
    new ResizeObserver(() => this.scene?.resize()).observe(this.element);
    everyFrame((now) => this.draw(now));
    this.look("ahead");
  }

  private look(picture: Picture): void {
    this.picture = picture;
    this.scene?.setCamera(picture === "ahead" ? "bridge" : "cctv");
    for (const name of ["ahead", "cctv"] as const)
      setAttribute(this.buttons[name], "aria-pressed", `${name === picture}`);
    this.pelorus.stands = picture === "ahead";
    setAttribute(
      this.canvas,
      "aria-label",
      picture === "ahead" ? t("view ahead, drawn") : t("camera on the forecastle, drawn"),
    );
  }

  /** Made when it is looked at first: a bridge that only works the plan loads no scene. */
  private async build(description: SceneDescription): Promise<void> {
    this.drawn = description.definition_hash;
    this.scene?.dispose();
    this.scene = undefined;
    const canvas = drawnOn(); // one that no scene has used
    this.canvas.replaceWith(canvas);
    this.canvas = canvas;
    try {
      const { ShipScene } = await import("../scene/ship_scene");
      if (this.canvas !== canvas) return; // another ship has come meanwhile
      this.scene = new ShipScene(canvas, description);
    } catch (why) {
      setText(this.message, t("This browser draws no WebGL picture; the rest works without it."));
      console.warn(`${why}`);
      return;
    }
    setText(this.message, "");
    this.scene.still = this.page.still;
    this.scene.setSea(this.page.link.latest("SeaState"));
    this.scene.setLandmarks(this.page.link.latest("Landmarks"));
    this.scene.resize();
    this.look(this.picture);
  }

  private draw(now: number): void {
    const { link } = this.page;
    if (link.state !== "open" || this.element.offsetParent === null) return;
    if (this.wanted && this.wanted.definition_hash !== this.drawn) void this.build(this.wanted);
    if (!this.scene) return;
    const dead = this.picture === "cctv" && link.latest("BridgeView")?.cctv_works === false;
    const frame = dead ? undefined : this.camera.frame(link, now);
    this.pelorus.show(this.scene.turned, link.latest("BridgeView"));
    setShown(this.canvas, !dead);
    setShown(this.message, dead);
    if (dead) setText(this.message, `\u26a0 ${t("No picture")}`);
    if (!frame) return;
    if (this.camera.worked.side !== undefined) this.scene.setSide(this.camera.worked.side);
    this.scene.draw({ ...frame, cried: this.cry.time });
  }
}
