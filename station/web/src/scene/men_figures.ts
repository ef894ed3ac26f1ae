// The men on deck as figures: boiler suit, helmet, life vest. All of one kind of piece are drawn with one call.

import { type BufferGeometry, Color, Group, InstancedMesh, Matrix4, Quaternion, SphereGeometry, Vector3 } from "three";
import type { SceneFrame } from "./frame";
import type { Materials } from "./materials";
import { type Bearing, type Known, type Place, kMen, Stations, Walker, Warned } from "./men";
import type { Rig } from "./rig";
import { Solid } from "./solid";
import type { V3 } from "./vec";

const kSuit = 0x1f3a5c;
const kVest = 0xe8641b;
const kBand = 0xd9dcd2;
const kSkin = 0xb98464;
const kBoot = 0x1c1c1d;
const kHelmets = [0xe9e6da, 0xd9a514, 0x2f7d46, 0xf4f4f0]; // bosun, fitter, cadet; the mate
const kMate = kMen;
const kLeg = 0.86; // m
const kShoulder = 1.42; // m over the deck
const kRoom = 1.3; // m, nearer than which to who looks nobody is drawn
const kJump = 3; // s of exercise time, after which they are where they are

/** rad: lean of the body, and m that it is lower. */
const kPostures: Record<Bearing, { lean: number; low: number }> = {
  stands: { lean: 0.02, low: 0 },
  watches: { lean: 0.3, low: 0.02 },
  crouches: { lean: 0.6, low: 0.42 },
  hammers: { lean: 0.25, low: 0.05 },
  calls: { lean: 0, low: 0 },
};

export class MenFigures {
  readonly group = new Group();
  private readonly stations: Stations;
  private readonly warned = new Warned();
  private readonly walkers = Array.from({ length: kMen + 1 }, () => new Walker());
  private readonly bodies: InstancedMesh;
  private readonly helmets: InstancedMesh;
  private readonly legs: InstancedMesh;
  private readonly arms: InstancedMesh;
  private time = NaN; // s, of the last frame

  /** rail: m, half the breadth over the bulwark at x. deck: m, body frame. */
  constructor(
    rigs: readonly Rig[],
    rail: (x: number) => number,
    private readonly deck: number,
    materials: Materials,
  ) {
    this.stations = new Stations(rigs, rail);
    const paint = materials.make({ vertexColors: true, roughness: 0.9, metalness: 0, dry: true });
    const most = kMen + 1;
    const many = (geometry: BufferGeometry, count: number): InstancedMesh => {
      const mesh = new InstancedMesh(geometry, paint, count);
      mesh.frustumCulled = false;
      this.group.add(mesh);
      return mesh;
    };
    this.bodies = many(body(), most);
    this.helmets = many(helmet(), most);
    this.legs = many(leg(), 2 * most);
    this.arms = many(arm(), 2 * most);
    for (const mesh of [this.bodies, this.legs, this.arms])
      for (let i = 0; i < mesh.count; ++i) mesh.setColorAt(i, kWhite);
    kHelmets.forEach((colour, i) => this.helmets.setColorAt(i, new Color(colour)));
    this.group.visible = false;
  }

  set shadows(on: boolean) {
    for (const mesh of [this.bodies, this.helmets, this.legs, this.arms]) {
      mesh.castShadow = on;
      mesh.receiveShadow = on;
    }
  }

  /**
   * Puts them where they are. side: the windlass that is worked; byOthers: it is not worked by who looks; still: each
   * is at his place at once; eye: m, body frame, of who looks.
   */
  show(frame: SceneFrame, side: number, byOthers: boolean, still: boolean, eye: V3): void {
    const since = frame.time - this.time;
    this.time = frame.time;
    const goes = !still && since >= 0 && since < kJump;
    const back = this.warned.back(frame.time, frame.tackle, frame.cried);
    const known: Known = { tackle: frame.tackle, side, back };
    const places = this.stations.places(known);
    const mate = byOthers && places.length > 0 ? this.stations.atBrake(side) : undefined;
    const all = mate ? [...places, mate] : places;
    this.group.visible = all.length > 0;
    if (!this.group.visible) return;
    const lead = frame.tackle[side]?.lead;
    all.forEach((place, i) => {
      this.walkers[i]!.go(place, goes ? since : undefined, back);
      const { at } = this.walkers[i]!;
      const isSeen = Math.hypot(at[0] - eye[0], at[1] - eye[1]) > kRoom;
      this.put(i, place, i === 0 ? lead : undefined, i !== kMate && back, isSeen ? 1 : 0);
    });
    for (const [mesh, each] of [
      [this.bodies, 1],
      [this.helmets, 1],
      [this.legs, 2],
      [this.arms, 2],
    ] as const) {
      mesh.count = each * all.length;
      mesh.instanceMatrix.needsUpdate = true;
    }
  }

  /** lead: rad clockwise from ahead, to where he points; runs: he was sent back; size: 1, 0 where nobody sees him. */
  private put(i: number, { bearing }: Place, lead: number | undefined, runs: boolean, size: number): void {
    const man = this.walkers[i]!;
    const { lean, low } = man.walks ? { lean: runs ? 0.3 : 0.08, low: 0 } : kPostures[bearing];
    const root = kRoot.makeRotationZ(man.faces).setPosition(man.at[0], man.at[1], this.deck - low);
    root.scale(kTo.setScalar(size));
    const trunk = kTrunk.copy(root).multiply(kPart.makeRotationY(lean).setPosition(0, 0, kLeg));
    this.bodies.setMatrixAt(i, trunk);
    this.helmets.setMatrixAt(i, trunk);
    const swing = man.walks ? 0.55 * Math.sin(man.gone * 3.6) : 0;
    const bent = Math.acos(1 - low / kLeg);
    for (const foot of [1, -1]) {
      const turn = -bent * (foot > 0 ? 1 : 0.4) + foot * swing;
      const at = kPart.makeRotationY(turn).setPosition(0, foot * 0.1, kLeg);
      this.legs.setMatrixAt(2 * i + (foot > 0 ? 0 : 1), kLimb.copy(root).multiply(at));
    }
    for (const hand of [1, -1]) {
      if (man.walks) kTo.set(Math.sin(-hand * swing) + (runs ? 0.5 : 0), 0.12 * hand, -1);
      else this.reach(bearing, hand, man.faces, lead);
      const turn = kTurn.setFromUnitVectors(kDown, kTo.normalize());
      const at = kPart.makeRotationFromQuaternion(turn).setPosition(0, hand * 0.23, kShoulder - kLeg);
      this.arms.setMatrixAt(2 * i + (hand > 0 ? 0 : 1), kLimb.copy(trunk).multiply(at));
    }
  }

  /** Where an arm goes, of a man who stands; hand: 1 the left, -1 the right. */
  private reach(bearing: Bearing, hand: number, faces: number, lead: number | undefined): void {
    kTo.set(0.05, 0.14 * hand, -1);
    if (bearing === "watches" && lead !== undefined) {
      const to = -lead - faces; // from where he faces, towards his left
      if (Math.sin(to) * hand >= 0) kTo.set(Math.cos(to), Math.sin(to), -0.25);
      else kTo.set(0.8, 0.1 * hand, -0.7); // on the rail
    } else if (bearing === "crouches") kTo.set(0.75, -0.12 * hand, -0.75);
    else if (bearing === "hammers" && hand < 0) kTo.set(0.7, 0, 0.5);
    else if (bearing === "calls") kTo.set(0.25, 0.75 * hand, 0.85);
  }

  dispose(): void {
    for (const mesh of [this.bodies, this.helmets, this.legs, this.arms]) {
      mesh.geometry.dispose();
      mesh.dispose();
    }
  }
}

const kWhite = new Color(1, 1, 1);
const kDown = new Vector3(0, 0, -1);
const kTo = new Vector3();
const kTurn = new Quaternion();
const kRoot = new Matrix4();
const kTrunk = new Matrix4();
const kPart = new Matrix4();
const kLimb = new Matrix4();

// Each about its joint: x to where he looks, y to his left, z up; m.

/** Trunk and head, from the hips. */
function body(): BufferGeometry {
  const solid = new Solid();
  const flat = new Matrix4().makeScale(0.68, 1, 1);
  const trunk = new Solid().bar([0, 0, -0.06], [0, 0, 0.58], 0.17, kSuit, 8, 0.21).build();
  solid.add(trunk, kSuit, flat);
  solid.box([0.09, 0, 0.36], [0.13, 0.36, 0.4], kVest);
  solid.box([-0.1, 0, 0.36], [0.1, 0.36, 0.4], kVest);
  solid.box([0, 0, 0.27], [0.34, 0.38, 0.05], kBand);
  solid.bar([0, 0, 0.56], [0.01, 0, 0.68], 0.055, kSkin, 6);
  return solid.ball([0.02, 0, 0.75], 0.105, kSkin).build();
}

/** In white, for the man's own colour. */
function helmet(): BufferGeometry {
  const dome = new SphereGeometry(0.135, 10, 5, 0, 2 * Math.PI, 0, Math.PI / 2).rotateX(Math.PI / 2);
  const solid = new Solid().add(dome, 0xffffff, new Matrix4().makeTranslation(0.01, 0, 0.78));
  return solid.bar([0.03, 0, 0.775], [0.03, 0, 0.79], 0.165, 0xffffff, 12).build();
}

function leg(): BufferGeometry {
  const solid = new Solid().bar([0, 0, -0.8], [0, 0, 0.02], 0.075, kSuit, 6, 0.1);
  return solid.box([0.05, 0, -kLeg + 0.05], [0.28, 0.11, 0.1], kBoot).build();
}

function arm(): BufferGeometry {
  const solid = new Solid().bar([0, 0, -0.52], [0, 0, 0.02], 0.05, kSuit, 6, 0.075);
  return solid.ball([0, 0, -0.57], 0.06, kBand).build();
}
