// What stands still on deck: forecastle with bulwark, bitts, fairleads, mast and lights; aft of it hatches and the
// house, for those who look from outside.

import { BufferAttribute, BufferGeometry, DoubleSide, Group, Mesh, type Texture } from "three";
import type { SceneDescription } from "../wire/generated";
import { aheadOf, breadthAt, evenly, kBulwark, mirrored, portEdge, raised } from "./hull_outline";
import { type Shade, contactShade } from "./contact_shade";
import { type Foremast, foremast } from "./foremast";
import { type Materials, kPaint, weathered } from "./materials";
import type { Lamp } from "./lamp_halos";
import type { Rig } from "./rig";
import { Solid } from "./solid";
import { type V3, add, along, scale, unit } from "./vec";

const kCoaming = 0x8d5242;
const kCover = 0x8f938a;

export interface Deck {
  group: Group;
  mast: Foremast;
  /** What is seen of them and of the house's by night. */
  halos: Lamp[];
  /** m, body frame: the flag's hoist. */
  flag: V3;
}

/** m: half the breadth over the forecastle's bulwark, at x. */
export function railBreadth(scene: SceneDescription, deck: number): (x: number) => number {
  const edge = portEdge(scene);
  const rail = raised(edge, deck - (edge[0]?.z ?? 0) + kBulwark);
  return (x) => breadthAt(rail, x);
}

export function deckGear(
  scene: SceneDescription,
  rigs: readonly Rig[],
  materials: Materials,
  noise: Texture,
  foc: number,
  deck: number,
): Deck {
  const group = new Group();
  const edge = portEdge(scene);
  const top = edge[0]?.z ?? 0;
  const line = evenly(aheadOf(raised(edge, deck - top), foc), 34);
  const rail = evenly(aheadOf(raised(edge, deck - top + kBulwark), foc), 34);
  const whole = raised(edge, 0);
  const main = [...whole.filter((p) => p[0] < foc), ...aheadOf(whole, foc).slice(0, 1)];
  const solid = new Solid();
  const abaft = new Solid(); // apart, so that nothing of it is drawn where one looks ahead from the forecastle

  deckPlate(solid, line, deck, kPaint.deck);
  deckPlate(abaft, main, top + 0.01, kPaint.deckMain);
  breakOfForecastle(solid, line[0]!, top, deck);
  for (const side of [1, -1]) bulwark(solid, side > 0 ? line : mirrored(line), side > 0 ? rail : mirrored(rail), side);
  const stem = line.at(-1)!;
  bitts(solid, line, deck, foc);
  const staff: V3 = [stem[0] - 0.9, 0, deck];
  const mast = foremast(solid, [foc + 2.2, 0, deck], along(staff, 1.6, [0, 0, 1]));
  const flag = jackstaff(solid, staff);
  for (const r of rigs) onDeck(solid, r, deck);
  ventilators(solid, foc, deck, line);
  walkway(solid, deck, foc);
  const house = aft(abaft, scene, top, foc);
  guardRails(abaft, main, top);

  const paint = materials.make({ vertexColors: true, roughness: 0.8, side: DoubleSide }, weathered(noise, 0.16));
  const meshes = [solid, abaft].map((each) => new Mesh(each.build(), paint));
  meshes[0]!.name = "deck";
  group.add(...meshes, contactShade(shades(rigs, line, deck, foc)));
  const warm: V3 = [1, 0.82, 0.55];
  const halos = [
    ...mast.lamps.map((at): Lamp => ({ at: along(at, 0.12, [1, 0, 0]), size: 2.6, colour: warm })),
    ...house.map((at): Lamp => ({ at, size: 3.2, colour: warm })),
  ];
  return { group, mast, halos, flag };
}

/** Where something heavy stands. */
function shades(rigs: readonly Rig[], line: readonly V3[], deck: number, foc: number): Shade[] {
  const z = deck + 0.012;
  const found: Shade[] = [];
  for (const r of rigs) {
    const k = r.d / 0.078;
    const turn = Math.atan2(r.lead[1], r.lead[0]);
    const at = (aft: number, outboard: number): { x: number; y: number } => ({
      x: r.gypsy[0] + k * (aft * r.lead[0] + outboard * r.out[0]),
      y: r.gypsy[1] + k * (aft * r.lead[1] + outboard * r.out[1]),
    });
    found.push({ ...at(0.1, 1.4), z, halfX: 1.0 * k, halfY: 2.7 * k, turn, dark: 0.75 });
    found.push({ ...at(1.15, 2.4), z, halfX: 0.5 * k, halfY: 1.1 * k, turn, dark: 0.6 });
    found.push({ ...at(-2.0, 0), z, halfX: 2.0 * k, halfY: 0.35 * k, turn, dark: 0.55 });
    found.push({ x: r.deckPipe[0], y: r.deckPipe[1], z, halfX: 0.7 * k, halfY: 0.7 * k, turn, dark: 0.7 });
  }
  for (const x of [foc + 4, foc + 15.5]) {
    const y = breadthAt(line, x) - 2.3;
    if (y > 0.7)
      for (const side of [1, -1]) found.push({ x, y: side * y, z, halfX: 0.9, halfY: 0.35, turn: 0, dark: 0.6 });
  }
  for (const side of [1, -1])
    found.push({ x: foc + 4.2, y: side * 1.9, z, halfX: 0.55, halfY: 0.55, turn: 0, dark: 0.6 });
  found.push({ x: foc + 2.2, y: 0, z, halfX: 0.3, halfY: 0.3, turn: 0, dark: 0.6 });
  return found;
}

const kAcross = 10; // pieces of a plate, so that lamps light it evenly

/** A plate between a line of the port side and its twin. */
function deckPlate(solid: Solid, line: readonly V3[], z: number, colour: number): void {
  const position: number[] = [];
  const index: number[] = [];
  line.forEach(([x, y], i) => {
    for (let k = 0; k <= kAcross; ++k) position.push(x, y * (1 - (2 * k) / kAcross), z);
    if (i === 0) return;
    const here = i * (kAcross + 1);
    for (let k = 0; k < kAcross; ++k) {
      const a = here + k;
      const b = a - kAcross - 1;
      index.push(b, b + 1, a + 1, b, a + 1, a);
    }
  });
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(position), 3));
  const up = position.map((_, i) => (i % 3 === 2 ? 1 : 0));
  geometry.setAttribute("normal", new BufferAttribute(new Float32Array(up), 3));
  geometry.setIndex(index);
  solid.add(geometry, colour);
}

function breakOfForecastle(solid: Solid, at: V3, from: number, to: number): void {
  solid.quad([at[0], at[1], from], [at[0], -at[1], from], [at[0], -at[1], to], [at[0], at[1], to], kPaint.bulwark);
  for (const y of [3.2, -3.2]) {
    solid.box([at[0] - 0.06, y, from + 1.1], [0.1, 0.9, 1.9], kPaint.machineryDark);
    // a ladder up
    for (let k = 0; k < 8; ++k)
      solid.box([at[0] - 0.4 - 0.12 * k, y * 1.9, to - (k + 1) * ((to - from) / 9)], [0.22, 0.8, 0.04], kPaint.steel);
  }
}

function bulwark(solid: Solid, line: readonly V3[], rail: readonly V3[], side: number): void {
  const n = Math.min(line.length, rail.length);
  for (let i = 0; i + 1 < n; ++i) {
    const a = line[i]!;
    const b = line[i + 1]!;
    const c = rail[i + 1]!;
    const d = rail[i]!;
    const inwards = (p: V3): V3 => [p[0], p[1] - side * 0.04, p[2]];
    // The outside is the hull's.
    if (side > 0) solid.quad(inwards(b), inwards(c), inwards(d), inwards(a), kPaint.bulwark);
    else solid.quad(inwards(a), inwards(d), inwards(c), inwards(b), kPaint.bulwark);
    solid.bar(d, c, 0.075, kPaint.bulwark, 6);
    // stays
    const across = unit([b[1] - a[1], a[0] - b[0], 0]); // square to the side
    const inboard: V3 = across[1] * side > 0 ? scale(-1, across) : across;
    if (Math.abs(a[1]) > 0.6) solid.bar(along(a, 0.7, inboard), along(d, 0.03, inboard), 0.04, kPaint.bulwark, 5);
  }
}

/** Pairs of bollards and roller fairleads along the sides. */
function bitts(solid: Solid, line: readonly V3[], deck: number, foc: number): void {
  for (const x of [foc + 4, foc + 15.5]) {
    const breadth = breadthAt(line, x);
    if (breadth < 3) continue;
    for (const side of [1, -1]) {
      const y = side * (breadth - 2.3);
      solid.box([x, y, deck + 0.08], [1.9, 0.75, 0.16], kPaint.black);
      for (const dx of [-0.55, 0.55]) {
        solid.bar([x + dx, y, deck], [x + dx, y, deck + 0.85], 0.24, kPaint.black, 14);
        solid.bar([x + dx, y, deck + 0.85], [x + dx, y, deck + 0.92], 0.29, kPaint.black, 14);
      }
    }
  }
  for (const x of [foc + 7.2, foc + 12.4]) {
    const breadth = breadthAt(line, x);
    if (breadth < 3) continue;
    for (const side of [1, -1]) {
      const y = side * (breadth - 0.75);
      solid.box([x, y, deck + 0.3], [1.5, 0.55, 0.6], kPaint.black);
      for (const dx of [-0.38, 0.38])
        solid.bar([x + dx, y, deck + 0.6], [x + dx, y, deck + 0.95], 0.17, kPaint.steel, 12);
    }
  }
}

/** Returns the place of the flag's hoist. */
function jackstaff(solid: Solid, at: V3): V3 {
  const head: V3 = [at[0] + 0.5, at[1], at[2] + 4.2];
  solid.bar(at, head, 0.045, kPaint.white, 8, 0.03);
  solid.ball(head, 0.07, kPaint.brass);
  return along(head, -0.1, [0, 0, 1]);
}

/** Hawse pipe's opening on deck with its bolster, at the ship's side its ring. */
function onDeck(solid: Solid, rig: Rig, deck: number): void {
  const k = rig.d / 0.078;
  const { bore, mouth } = rig.tackle;
  const pipe: V3 = [bore.x, bore.y, bore.z];
  const radius = 0.52 * k;
  const at: V3 = [rig.deckPipe[0], rig.deckPipe[1], deck];
  solid.bar(along(at, -0.2, pipe), along(at, 0.28 * k, pipe), radius + 0.06, kPaint.deck, 20);
  solid.ring(along(at, 0.28 * k, pipe), pipe, radius, 0.13 * k, kPaint.machineryDark, 24, 8);
  solid.bar(along(at, 0.27 * k, pipe), along(at, 0.285 * k, pipe), radius, kPaint.black, 20);
  // at the side
  const out = scale(-1, pipe);
  const face = add([mouth.x, mouth.y, mouth.z], scale(0.02, out));
  const flat = unit([out[0], out[1], out[2] * 0.5]);
  solid.bar(along(face, -1.6, flat), face, 0.84 * k, kPaint.topsides, 28);
  solid.ring(face, flat, 0.68 * k, 0.16 * k, kPaint.topsides, 28, 10);
  solid.bar(along(face, -0.1, flat), along(face, 0.015, flat), 0.64 * k, kPaint.black, 24);
}

/** Painted on deck: where to walk, clear of the cables. */
function walkway(solid: Solid, deck: number, foc: number): void {
  const z = deck + 0.006;
  for (const y of [0.4, -0.4])
    for (let x = foc + 3.2; x < foc + 22; ++x)
      solid.quad([x, y - 0.05, z], [x + 1, y - 0.05, z], [x + 1, y + 0.05, z], [x, y + 0.05, z], 0xc9a83a);
}

function ventilators(solid: Solid, foc: number, deck: number, line: readonly V3[]): void {
  for (const side of [1, -1]) {
    const y = side * Math.min(5.4, breadthAt(line, foc + 1.6) - 2);
    solid.bar([foc + 1.6, y, deck], [foc + 1.6, y, deck + 1.3], 0.28, kPaint.bulwark, 14);
    solid.bar([foc + 1.6, y, deck + 1.3], [foc + 1.6, y, deck + 1.55], 0.48, kPaint.bulwark, 16);
    // a store's hatch with its lid
    solid.box([foc + 4.2, side * 1.9, deck + 0.35], [1.1, 1.1, 0.7], kPaint.deck);
    solid.box([foc + 4.2, side * 1.9, deck + 0.75], [1.25, 1.25, 0.1], kPaint.bulwark);
  }
}

const kStays = 2.4; // m between a coaming's stays

/** A hatch, so long and wide, m: its coaming with stays, and on it two covers that roll to the sides. */
function hatch(solid: Solid, [x, , top]: V3, long: number, wide: number): void {
  const coaming = top + 1.6;
  solid.box([x, 0, top + 0.8], [long, wide, 1.6], kCoaming);
  solid.box([x, 0, coaming - 0.06], [long + 0.5, wide + 0.5, 0.12], kCoaming);
  const stays = Math.floor(long / kStays);
  for (let i = 0; i <= stays; ++i)
    for (const side of [1, -1])
      solid.box(
        [x + (i / stays - 0.5) * (long - 0.4), side * (0.5 * wide + 0.2), top + 0.75],
        [0.1, 0.5, 1.5],
        kCoaming,
      );
  for (const side of [1, -1]) {
    const y = side * (0.25 * wide + 0.1);
    solid.box([x, y, coaming + 0.35], [long + 0.6, 0.5 * wide + 0.1, 0.62], kCover);
    // stiffeners across, and the wheels' boxes at the corners
    for (let i = 0; i < 4; ++i)
      solid.box([x + (i / 3 - 0.5) * (long - 1), y, coaming + 0.7], [0.22, 0.5 * wide - 0.2, 0.1], kCover);
    for (const end of [1, -1])
      solid.box(
        [x + end * (0.5 * long + 0.15), side * (0.5 * wide + 0.25), coaming + 0.2],
        [0.7, 0.35, 0.5],
        kPaint.black,
      );
  }
}

/** What stands between two hatches: a house for the winches' and hatches' oil, ventilators, the rails of the covers. */
function between(solid: Solid, [x, , top]: V3, wide: number): void {
  solid.box([x, 0, top + 1.2], [1.7, 2.6, 2.4], kPaint.white);
  solid.box([x - 0.87, 0.5, top + 1.05], [0.04, 0.75, 1.8], kPaint.machineryDark);
  for (const side of [1, -1]) {
    const y = side * 0.36 * wide;
    solid.bar([x, y, top], [x, y, top + 1.5], 0.3, kPaint.white, 10);
    solid.bar([x, y, top + 1.5], [x, y, top + 1.8], 0.5, kPaint.white, 10);
  }
}

const kPosts = 3; // m between a rail's posts

/** Along both edges of the main deck. */
function guardRails(solid: Solid, edge: readonly V3[], top: number): void {
  const line = evenly(edge, Math.max(2, Math.round(edge.length > 1 ? (edge.at(-1)![0] - edge[0]![0]) / kPosts : 2)));
  const at = ([x, y]: V3, side: number, up: number): V3 => [x, side * (y - 0.15), top + up];
  for (const side of [1, -1])
    line.forEach((p, i) => {
      if (p[1] < 1) return;
      solid.bar(at(p, side, 0), at(p, side, 1.1), 0.035, kPaint.white, 4);
      const before = line[i - 1];
      if (!before || before[1] < 1) return;
      for (const up of [0.4, 0.75, 1.1]) solid.bar(at(before, side, up), at(p, side, up), 0.025, kPaint.white, 4);
    });
}

/** Hatches and the house; returns the places of its lamps. */
function aft(solid: Solid, scene: SceneDescription, top: number, foc: number): V3[] {
  const length = scene.length_overall;
  const stern = -0.5 * length;
  const half = 0.5 * scene.beam;
  const house = stern + 0.055 * length;
  const houseEnd = house + 0.075 * length;
  const hatches = 7;
  const pitch = (foc - 4 - houseEnd - 4) / hatches;
  for (let k = 0; k < hatches; ++k) {
    const x = houseEnd + 4 + (k + 0.5) * pitch;
    const width = Math.min(half * 1.15, 2 * half - 8);
    hatch(solid, [x, 0, top], 0.72 * pitch, width);
    if (k > 0) between(solid, [x - 0.5 * pitch, 0, top], width);
  }
  const wide = 2 * half - 1.5;
  const decks = 5;
  const tier = 2.8;
  for (let k = 0; k < decks; ++k) {
    const deep = (houseEnd - house) * (1 - 0.08 * k);
    solid.box(
      [house + deep / 2, 0, top + tier * (k + 0.5)],
      [deep, wide * (k === 0 ? 1 : 0.86), tier - 0.12],
      kPaint.white,
    );
    if (k > 0)
      for (let w = 0; w < 9; ++w)
        solid.box([house + deep + 0.02, (w - 4) * (wide * 0.09), top + tier * (k + 0.6)], [0.06, 0.7, 0.75], 0x24313a);
  }
  const bridge = top + tier * decks;
  solid.box([house + 6.5, 0, bridge + 1.4], [8, wide * 0.6, 2.7], kPaint.white);
  solid.box([house + 10.55, 0, bridge + 1.75], [0.08, wide * 0.58, 1.1], 0x24313a);
  solid.box([house + 8.5, 0, bridge + 0.1], [3.4, scene.beam, 0.25], kPaint.white); // wings
  solid.bar([house + 5, 0, bridge + 2.7], [house + 5, 0, bridge + 10], 0.35, kPaint.white, 10, 0.2);
  solid.box([house + 5, 0, bridge + 7], [0.5, 5, 0.3], kPaint.white);
  solid.box([stern + 0.035 * length, 0, top + 9], [0.03 * length, 6, 15], 0x2a4a66); // funnel
  solid.box([stern + 0.035 * length, 0, top + 15.4], [0.0302 * length, 6.05, 1.8], kPaint.white);
  const front = houseEnd + 0.3;
  const lamps: V3[] = [-0.75, -0.25, 0.25, 0.75].map((y) => [front, y * half, top + 2.5 * tier]);
  return [...lamps, [houseEnd - 1, half - 1, top + 1.2 * tier], [houseEnd - 1, 1 - half, top + 1.2 * tier]];
}
