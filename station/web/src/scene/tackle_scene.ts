// All that belongs to one side: windlass, cable, anchor.

import { type Group, type PerspectiveCamera, type Texture, Vector3 } from "three";
import type { SceneTackle } from "../wire/generated";
import { AnchorMesh } from "./anchor";
import { ChainMesh } from "./chain";
import type { TackleFrame } from "./frame";
import { Links } from "./links";
import type { Materials } from "./materials";
import { type Rig, rig } from "./rig";
import type { ShipPose } from "./vec";
import { Windlass } from "./windlass";
import type { TensionScale } from "./tension_scale";

export class TackleScene {
  readonly rig: Rig;
  readonly links = new Links();
  readonly windlass: Windlass;
  readonly chain: ChainMesh;
  readonly anchor: AnchorMesh;
  /** m from the origin, this frame: where smoke and dust come from. */
  readonly places = { lining: new Vector3(), gypsy: new Vector3(), pipe: new Vector3() };
  private readonly wetTo = 0; // m, world: what has been under water in this picture

  constructor(
    tackle: SceneTackle,
    deck: number,
    materials: Materials,
    noise: Texture,
    linksFull: number,
    onShip: Group,
    inWorld: Group,
  ) {
    this.rig = rig(tackle, deck);
    this.windlass = new Windlass(this.rig, materials, noise);
    this.chain = new ChainMesh(materials, linksFull);
    this.anchor = new AnchorMesh(tackle, materials, noise);
    onShip.add(this.windlass.group);
    inWorld.add(this.chain.group, this.anchor.group);
  }

  get side(): number {
    return this.rig.tackle.side;
  }

  set shadows(on: boolean) {
    this.windlass.shadows = on;
    this.chain.shadows = on;
    this.anchor.shadows = on;
  }

  /** Places what moves; seconds since the last frame. Nothing is drawn of a side that is not heard of. */
  place(
    tackle: TackleFrame | undefined,
    pose: ShipPose,
    origin: readonly number[],
    seconds: number,
    onShip: Group,
  ): void {
    this.chain.group.visible = tackle !== undefined;
    this.anchor.group.visible = false;
    if (!tackle) return;
    this.links.place(this.rig, tackle, pose, origin);
    this.windlass.show(tackle, seconds);
    this.anchor.show(tackle.anchor, origin, this.wetTo);
    const toScene = (p: readonly [number, number, number], out: Vector3): void => {
      out.set(...p).applyMatrix4(onShip.matrixWorld);
    };
    toScene(this.windlass.lining, this.places.lining);
    const { gypsy, deckPipe, radius } = this.rig;
    toScene([gypsy[0], gypsy[1], gypsy[2] + radius], this.places.gypsy);
    toScene([deckPipe[0], deckPipe[1], this.rig.deck + 0.4], this.places.pipe);
  }

  /** deepest: m, world z below which the water hides everything; -Infinity from under water. */
  draw(
    tackle: TackleFrame,
    camera: PerspectiveCamera,
    pixels: number,
    loads: TensionScale | undefined,
    deepest: number,
  ): void {
    this.chain.show(this.links, tackle, this.rig.d, camera, pixels, loads, this.wetTo, deepest);
  }

  dispose(): void {
    this.windlass.dispose();
    this.chain.dispose();
    this.anchor.dispose();
  }
}
