// The cable of one side as stud links: in full where one could count the studs, simpler farther away.

import {
  type Camera,
  Color,
  DynamicDrawUsage,
  Frustum,
  Group,
  InstancedBufferAttribute,
  InstancedMesh,
  type Material,
  Matrix4,
  type PerspectiveCamera,
  Sphere,
} from "three";
import type { TackleFrame } from "./frame";
import { farLink, linkStreaks, seizing, studLink } from "./link_shapes";
import { LinkKind, type Links } from "./links";
import { kPaint, type Materials } from "./materials";
import { kPitch } from "./rig";
import type { TensionScale } from "./tension_scale";

/** px of a link's length on the screen, from which it is drawn at that level. */
const kLevels = [70, 20, 5, 0];
const kMost = [200, 400, 1400, 2400]; // links of a level
const kStreaks = 400; // links, at most, that are drawn as streaks
const kBlurs = 3; // m/s of the cable, from which streaks lie between its links
const kBlurred = 5.5; // m/s, from which nothing else is seen of plain links
const kShort = 6; // of a link's length, in diameters

export class ChainMesh {
  readonly group = new Group();
  private readonly levels: InstancedMesh[];
  private readonly wire: InstancedMesh;
  private readonly streaks: InstancedMesh;
  private readonly material: Material;
  private readonly frustum = new Frustum();
  private readonly matrix = new Matrix4();
  private readonly sphere = new Sphere();
  private readonly colour = new Color();
  private readonly paints: Color[];

  constructor(
    materials: Materials,
    private linksFull: number,
  ) {
    this.material = materials.make({ roughness: 0.75, metalness: 0.35 });
    const shapes = [studLink(28, 8, 8), studLink(14, 5, 4), studLink(10, 3, 0), farLink()];
    this.levels = shapes.map((shape, level) => this.instanced(shape, kMost[level]!));
    this.wire = this.instanced(seizing(), 40);
    this.streaks = this.instanced(linkStreaks(), kStreaks);
    this.group.add(...this.levels, this.wire, this.streaks);
    // by LinkKind
    this.paints = [kPaint.chain, 0xf2f1ea, 0xc21f14, kPaint.yellow].map((c) => new Color(c));
  }

  private instanced(shape: ConstructorParameters<typeof InstancedMesh>[0], most: number): InstancedMesh {
    const mesh = new InstancedMesh(shape, this.material, most);
    mesh.instanceMatrix.setUsage(DynamicDrawUsage);
    mesh.instanceColor = new InstancedBufferAttribute(new Float32Array(3 * most), 3);
    mesh.instanceColor.setUsage(DynamicDrawUsage);
    mesh.frustumCulled = false;
    mesh.count = 0;
    return mesh;
  }

  set full(links: number) {
    this.linksFull = links;
  }
  set shadows(on: boolean) {
    for (const mesh of [...this.levels.slice(0, 3), this.streaks]) {
      mesh.castShadow = on;
      mesh.receiveShadow = on;
    }
  }

  /**
   * Draws links as placed from the scene's origin; those that run fast over the water as streaks, but for painted ones,
   * by which one counts. pixels: of one radian at the middle of the picture; seaLevel: m,
   * below which chain is wet; deepest: m, below which the water
   * hides it.
   */
  show(
    links: Links,
    tackle: TackleFrame,
    d: number,
    camera: Camera,
    pixels: number,
    loads: TensionScale | undefined,
    wetTo: number,
    deepest: number,
  ): void {
    this.frustum.setFromProjectionMatrix(
      this.matrix.multiplyMatrices((camera as PerspectiveCamera).projectionMatrix, camera.matrixWorldInverse),
    );
    const eye = camera.matrixWorld.elements;
    const counts = [0, 0, 0, 0];
    let wires = 0;
    let streaks = 0;
    const speed = Math.abs(tackle.cable_speed);
    this.sphere.radius = 3 * d;
    const { middle, along, across, kind } = links;
    for (let i = 0; i < links.count; ++i) {
      const a = 3 * i;
      const x = middle[a]!;
      const y = middle[a + 1]!;
      const z = middle[a + 2]!;
      if (z < deepest) continue;
      this.sphere.center.set(x, y, z);
      if (!this.frustum.intersectsSphere(this.sphere)) continue;
      const distance = Math.hypot(x - eye[12], y - eye[13], z - eye[14]);
      const size = (kShort * d * pixels) / Math.max(distance, 0.1);
      let level = 0;
      while (size < kLevels[level]!) ++level;
      if (level === 0 && counts[0]! >= this.linksFull) level = 1;
      while (level < 3 && counts[level]! >= kMost[level]!) ++level;
      const runs = speed > kBlurs && z > 0 && level < 3;
      if (runs && kind[i] === LinkKind.plain && streaks < kStreaks) {
        this.put(this.streaks, streaks, along, across, a, x, y, z, d);
        this.streaks.instanceColor!.setXYZ(streaks++, kBlur.r, kBlur.g, kBlur.b);
        if (speed > kBlurred) continue;
      }
      const at = counts[level]!;
      if (at >= kMost[level]!) continue;
      counts[level] = at + 1;
      const joining = kind[i] === LinkKind.joining;
      const k = joining || runs ? 1.06 * d : d; // painted ones stand out of the streaks
      this.put(this.levels[level]!, at, along, across, a, x, y, z, k);
      this.paint(links, tackle, i, loads, wetTo, deepest, z);
      this.levels[level]!.instanceColor!.setXYZ(at, this.colour.r, this.colour.g, this.colour.b);
      if (kind[i] === LinkKind.white && level < 2 && wires < 40) {
        this.put(this.wire, wires, along, across, a, x, y, z, d);
        this.wire.instanceColor!.setXYZ(wires++, 0.42, 0.27, 0.1);
      }
    }
    this.levels.forEach((mesh, level) => this.upload(mesh, counts[level]!));
    this.upload(this.wire, wires);
    this.upload(this.streaks, streaks);
  }

  private put(
    mesh: InstancedMesh,
    at: number,
    along: Float32Array,
    across: Float32Array,
    a: number,
    x: number,
    y: number,
    z: number,
    k: number,
  ): void {
    const m = mesh.instanceMatrix.array as Float32Array;
    const o = 16 * at;
    const ax = along[a]!;
    const ay = along[a + 1]!;
    const az = along[a + 2]!;
    const bx = across[a]!;
    const by = across[a + 1]!;
    const bz = across[a + 2]!;
    m[o] = k * ax;
    m[o + 1] = k * ay;
    m[o + 2] = k * az;
    m[o + 3] = 0;
    m[o + 4] = k * bx;
    m[o + 5] = k * by;
    m[o + 6] = k * bz;
    m[o + 7] = 0;
    m[o + 8] = k * (ay * bz - az * by);
    m[o + 9] = k * (az * bx - ax * bz);
    m[o + 10] = k * (ax * by - ay * bx);
    m[o + 11] = 0;
    m[o + 12] = x;
    m[o + 13] = y;
    m[o + 14] = z;
    m[o + 15] = 1;
  }

  private paint(
    links: Links,
    tackle: TackleFrame,
    i: number,
    loads: TensionScale | undefined,
    wetTo: number,
    deepest: number,
    z: number,
  ): void {
    const kind = links.kind[i]!;
    if (loads && tackle.tension) {
      loads.colour(tensionAt(tackle, links, links.s[i]!), this.colour);
      return;
    }
    this.colour.copy(this.paints[kind]!);
    // No two links weather alike; their number keeps its shade as it moves.
    const n = links.number[i]!;
    const shade = n >= 0 ? 0.86 + 0.28 * fraction(n * 0.618034) : 1;
    if (kind === LinkKind.plain) {
      this.colour.r *= shade;
      this.colour.g *= shade * (0.97 + 0.05 * fraction(n * 0.7548));
      this.colour.b *= shade * (0.93 + 0.1 * fraction(n * 0.7548));
    }
    if (z < wetTo) this.colour.multiplyScalar(0.62);
    if (deepest > -100 && z < 0) this.colour.lerp(kWater, 1 - Math.exp(0.9 * z));
  }

  private upload(mesh: InstancedMesh, count: number): void {
    mesh.count = count;
    mesh.visible = count > 0;
    if (count === 0) return;
    for (const [attribute, each] of [
      [mesh.instanceMatrix, 16],
      [mesh.instanceColor!, 3],
    ] as const) {
      attribute.clearUpdateRanges();
      attribute.addUpdateRange(0, count * each);
      attribute.needsUpdate = true;
    }
  }

  dispose(): void {
    for (const mesh of [...this.levels, this.wire, this.streaks]) {
      mesh.geometry.dispose();
      mesh.dispose();
    }
  }
}

const kBlur = new Color(kPaint.chain).multiplyScalar(0.9);
const kWater = new Color(0.01, 0.06, 0.07);
const fraction = (x: number): number => x - Math.floor(x);

/** N, at s m outboard of the lip; inboard as at the lip. */
function tensionAt(tackle: TackleFrame, links: Links, s: number): number {
  const tension = tackle.tension!;
  const nodes = tackle.nodes.length / 3;
  if (s <= 0 || nodes < 2) return tension[0] ?? 0;
  // Nodes are evenly spaced but for the top: near enough for a colour.
  const i = Math.min(tension.length - 1, Math.floor((s / Math.max(links.path.end, 4 * kPitch)) * tension.length));
  return tension[i] ?? 0;
}
