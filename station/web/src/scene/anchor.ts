// An anchor: shank with its shackle, and crown with flukes that turn on their pin. Frame as in the physics: x from the
// crown to the shackle, y along the crown, z out of the flukes' plane, origin at the centre of mass.

import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DoubleSide,
  Group,
  Matrix4,
  Mesh,
  Shape,
  ExtrudeGeometry,
  type Texture,
} from "three";
import type { SceneTackle } from "../wire/generated";
import type { AnchorFrame } from "./frame";
import { type Materials, weathered } from "./materials";
import { Solid } from "./solid";

const kPaintWork = 0x545a5c; // bituminous paint, weathered
const kMud = new Color(0x5d5138);

/** Crown's width and what the flukes look like, as shares of shank and fluke lengths (common drawings). */
interface Pattern {
  crownOfShank: number;
  /**
   * Of a fluke: breadth at the crown, where it is widest and how far along, of the crown's width and fluke's length.
   */
  root: number;
  widest: number;
  widestAt: number;
  /** Depth of the crown, of its width. */
  crownDepth: number;
}

const kPatterns: Record<string, Pattern> = {
  hall: { crownOfShank: 2.1 / 2.9, root: 0.25, widest: 0.25, widestAt: 0.2, crownDepth: 0.3 },
  spek: { crownOfShank: 2.1 / 2.9, root: 0.22, widest: 0.29, widestAt: 0.35, crownDepth: 0.34 },
  ac14: { crownOfShank: 2.9 / 3.1, root: 0.28, widest: 0.34, widestAt: 0.25, crownDepth: 0.26 },
  hhp: { crownOfShank: 2.6 / 3.1, root: 0.28, widest: 0.33, widestAt: 0.25, crownDepth: 0.26 },
  shhp: { crownOfShank: 3.0 / 3.4, root: 0.28, widest: 0.36, widestAt: 0.3, crownDepth: 0.24 },
  stock: { crownOfShank: 1.2 / 3.6, root: 0.2, widest: 0.3, widestAt: 0.5, crownDepth: 0.2 },
};

/** m, of the crown's pin from the centre of mass, along the shank: as anchor_shape of the physics. */
export function crownPlace(t: SceneTackle): { x: number; z: number } {
  if (t.anchor === "stock") return { x: -0.4025 * t.shank_length, z: -0.008 * t.shank_length };
  return { x: -0.175 * (t.shank_length + t.fluke_length), z: 0 };
}

/** m, of the shackle's pin from the centre of mass. */
export const shacklePlace = (t: SceneTackle): number => crownPlace(t).x + t.shank_length;

export class AnchorMesh {
  readonly group = new Group();
  private readonly flukes = new Group();
  private readonly meshes: Mesh[];
  private readonly material;
  private readonly bare = new Color(0xffffff);

  constructor(tackle: SceneTackle, materials: Materials, noise: Texture) {
    this.material = materials.make(
      { vertexColors: true, roughness: 0.7, metalness: 0.3, side: DoubleSide },
      weathered(noise, 0.83),
    );
    const pattern = kPatterns[tackle.anchor] ?? kPatterns.hall!;
    const crown = crownPlace(tackle);
    const shank = new Mesh(shankOf(tackle, pattern).build(), this.material);
    shank.position.set(crown.x, 0, crown.z);
    const arms = new Mesh(
      (tackle.anchor === "stock" ? stockArms(tackle) : flukesOf(tackle, pattern)).build(),
      this.material,
    );
    this.flukes.position.set(crown.x, 0, crown.z);
    this.flukes.add(arms);
    this.meshes = [shank, arms];
    this.group.add(shank, this.flukes);
  }

  set shadows(on: boolean) {
    for (const mesh of this.meshes) {
      mesh.castShadow = on;
      mesh.receiveShadow = on;
    }
  }

  /** origin: m, world, of the scene; wetTo: m, world height below which it is wet. */
  show(anchor: AnchorFrame | undefined, origin: readonly number[], wetTo: number): void {
    this.group.visible = anchor !== undefined;
    if (!anchor) return;
    this.group.position.set(anchor.x - origin[0]!, anchor.y - origin[1]!, anchor.z - origin[2]!);
    this.group.quaternion.set(anchor.qx, anchor.qy, anchor.qz, anchor.qw);
    this.flukes.rotation.y = anchor.fluke_angle;
    this.material.color.copy(this.bare).lerp(kMud, 0.85 * anchor.mud);
    if (anchor.z < wetTo) this.material.color.multiplyScalar(0.7);
  }

  dispose(): void {
    for (const mesh of this.meshes) mesh.geometry.dispose();
  }
}

/** From the crown's pin at the origin. */
function shankOf(t: SceneTackle, pattern: Pattern): Solid {
  const l = t.shank_length;
  const w = pattern.crownOfShank * l;
  const solid = new Solid();
  const rod = t.anchor === "stock" ? 0.05 * l : 0;
  if (rod > 0) {
    solid.bar([0, 0, 0], [0.96 * l, 0, 0], rod, kPaintWork, 14, 0.7 * rod);
    solid.bar([0.95 * l, -0.5 * l, 0.04 * l], [0.95 * l, 0.5 * l, 0.04 * l], 0.022 * l, kPaintWork, 12);
    for (const side of [1, -1]) solid.ball([0.95 * l, side * 0.5 * l, 0.04 * l], 0.038 * l, kPaintWork);
  } else {
    // A bar of rectangular section, tapering towards the shackle.
    solid.add(taper(0, 0.17 * w, 0.2 * w, 0.97 * l, 0.105 * w, 0.15 * w), kPaintWork);
    solid.bar([0.955 * l, 0, -0.09 * w], [0.955 * l, 0, 0.09 * w], 0.075 * w, kPaintWork, 16);
  }
  // The shackle: a bow through the eye, in line with the shank.
  const d = 1.35 * t.chain_diameter;
  solid.bar([l - 0.02 * l, -1.6 * d, 0], [l - 0.02 * l, 1.6 * d, 0], 0.55 * d, 0x55504a, 10);
  for (const side of [1, -1]) {
    solid.bar([l - 0.02 * l, side * 1.25 * d, 0], [l + 2.0 * d, side * 0.9 * d, 0], 0.5 * d, 0x55504a, 8);
    solid.bar([l + 2.0 * d, side * 0.9 * d, 0], [l + 2.6 * d, 0, 0], 0.5 * d, 0x55504a, 8);
  }
  return solid;
}

/** Crown and both flukes in the plane z = 0, from the pin at the origin towards +x. */
function flukesOf(t: SceneTackle, pattern: Pattern): Solid {
  const length = t.fluke_length;
  const w = pattern.crownOfShank * t.shank_length;
  const depth = pattern.crownDepth * w;
  const solid = new Solid();
  // Crown: a heavy head with a sloping foot, cut so that the shank passes.
  const half = 0.5 * w;
  for (const side of [1, -1]) {
    solid.add(crownHalf(side, half, depth, 0.13 * t.shank_length, 0.11 * w), kPaintWork);
    solid.add(fluke(side, length, w, pattern), kPaintWork);
  }
  solid.bar([0, -0.16 * w, 0], [0, 0.16 * w, 0], 0.3 * depth, kPaintWork, 14);
  solid.box([-0.1 * t.shank_length, 0, 0], [0.09 * t.shank_length, 0.3 * w, 0.75 * depth], kPaintWork);
  return solid;
}

function crownHalf(side: number, half: number, depth: number, back: number, inner: number): BufferGeometry {
  const shape = new Shape(); // seen from the side: x along the shank, z
  shape.moveTo(-back, -0.42 * depth);
  shape.lineTo(-back, 0.42 * depth);
  shape.lineTo(-0.2 * back, 0.5 * depth);
  shape.lineTo(0.9 * back, 0.3 * depth);
  shape.lineTo(0.9 * back, -0.3 * depth);
  shape.lineTo(-0.2 * back, -0.5 * depth);
  const block = new ExtrudeGeometry(shape, { depth: half - inner, bevelEnabled: false });
  block.applyMatrix4(new Matrix4().makeRotationX(Math.PI / 2)); // z of the shape up, depth towards -y
  return block.applyMatrix4(new Matrix4().makeTranslation(0, side > 0 ? half : -inner, 0));
}

/** A blade that tapers to its bill, thick at the crown. */
function fluke(side: number, length: number, w: number, pattern: Pattern): BufferGeometry {
  const middle = 0.31 * w;
  const outline: [number, number][] = [
    [0, middle - 0.5 * pattern.root * w],
    [pattern.widestAt * length, middle - 0.42 * pattern.widest * w],
    [0.75 * length, middle - 0.2 * pattern.widest * w],
    [length, middle + 0.02 * w],
    [0.8 * length, middle + 0.24 * pattern.widest * w],
    [pattern.widestAt * length, middle + 0.58 * pattern.widest * w],
    [0, middle + 0.5 * pattern.root * w],
  ];
  const positions: number[] = [];
  const push = (x: number, y: number, z: number): void => void positions.push(x, side * y, z);
  const thick = (x: number): number => 0.055 * w * (1.25 - (0.85 * x) / length);
  const face = (a: [number, number], b: [number, number], c: [number, number], up: number): void => {
    const order = up * side > 0 ? [a, b, c] : [a, c, b];
    for (const [x, y] of order) push(x, y, up * thick(x));
  };
  for (let i = 1; i + 1 < outline.length; ++i) {
    face(outline[0]!, outline[i]!, outline[i + 1]!, 1);
    face(outline[0]!, outline[i]!, outline[i + 1]!, -1);
  }
  outline.forEach((p, i) => {
    const q = outline[(i + 1) % outline.length]!;
    const corners: [number, number, number][] = [
      [...p, -thick(p[0])],
      [...q, -thick(q[0])],
      [...q, thick(q[0])],
      [...p, thick(p[0])],
    ];
    const order = side > 0 ? [0, 1, 2, 0, 2, 3] : [0, 2, 1, 0, 3, 2];
    for (const k of order) push(...corners[k]!);
  });
  // a rib along its back
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(positions), 3));
  geometry.computeVertexNormals();
  return geometry;
}

/** Fixed arms with palms, across the stock: in the plane y = 0. */
function stockArms(t: SceneTackle): Solid {
  const arm = t.fluke_length;
  const l = t.shank_length;
  const solid = new Solid();
  for (const side of [1, -1]) {
    solid.bar([-0.02 * l, 0, 0], [0.06 * l, 0, side * 0.5 * arm], 0.05 * l, kPaintWork, 12, 0.042 * l);
    solid.bar([0.06 * l, 0, side * 0.5 * arm], [0.2 * l, 0, side * 0.95 * arm], 0.042 * l, kPaintWork, 12, 0.02 * l);
    const palm = new Shape();
    palm.moveTo(-0.14 * l, -0.02 * l);
    palm.lineTo(-0.02 * l, -0.09 * l);
    palm.lineTo(0.1 * l, 0);
    palm.lineTo(-0.02 * l, 0.09 * l);
    palm.lineTo(-0.14 * l, 0.02 * l);
    const plate = new ExtrudeGeometry(palm, { depth: 0.015 * l, bevelEnabled: false });
    const lie = new Matrix4()
      .makeTranslation(0.15 * l, 0, side * 0.76 * arm)
      .multiply(new Matrix4().makeRotationY(side * -1.25));
    solid.add(plate, kPaintWork, lie);
  }
  return solid;
}

/** A bar along x from x0 to x1, y and z as given at either end. */
function taper(x0: number, y0: number, z0: number, x1: number, y1: number, z1: number): BufferGeometry {
  const solid = new Solid();
  const corner = (x: number, y: number, z: number, a: number, b: number): [number, number, number] => [
    x,
    (a * y) / 2,
    (b * z) / 2,
  ];
  const ring = [
    [1, 1],
    [-1, 1],
    [-1, -1],
    [1, -1],
  ] as const;
  for (let i = 0; i < 4; ++i) {
    const [a, b] = ring[i]!;
    const [c, e] = ring[(i + 1) % 4]!;
    solid.quad(
      corner(x0, y0, z0, a, b),
      corner(x0, y0, z0, c, e),
      corner(x1, y1, z1, c, e),
      corner(x1, y1, z1, a, b),
      0,
    );
  }
  solid.quad(...(ring.map(([a, b]) => corner(x1, y1, z1, a, b)) as [never, never, never, never]), 0);
  return solid.build();
}
