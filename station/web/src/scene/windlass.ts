// The windlass of one side. What turns: gypsy with brake drum and the fixed claws; the shaft with its warping end;
// what moves: band, hand-wheel, sliding claws with their lever, stopper bar.
//
// Local frame: x along the cable inboard (aft), y along z cross x, z up from the deck; the gypsy's middle is at x = 0,
// y = 0. Outboard along the shaft is -sign y.

import {
  type BufferGeometry,
  CylinderGeometry,
  DoubleSide,
  ExtrudeGeometry,
  Group,
  type Material,
  Matrix4,
  Mesh,
  Shape,
  type Texture,
} from "three";
import type { TackleFrame } from "./frame";
import { type Materials, kPaint, weathered } from "./materials";
import { type Rig, pocketAngle } from "./rig";
import { Solid } from "./solid";
import type { V3 } from "./vec";

const kWheelTurns = 5; // from open to hard on
const kClaws = 6;
const kPockets = 5;

export class Windlass {
  readonly group = new Group();
  /** m, body frame: where a hot lining smokes. */
  readonly lining: V3;
  private readonly turning: Mesh;
  private readonly shaft: Mesh;
  private readonly sleeve: Group;
  private readonly fork: Mesh;
  private readonly band: Mesh;
  private readonly wheel: Mesh;
  private readonly bar: Mesh;
  private readonly lever: Mesh;
  private readonly meshes: Mesh[] = [];
  private readonly side: number; // y of one m outboard along the shaft
  private readonly k: number;
  private readonly h: number; // m of the shaft above deck
  private clutchIn = 0; // 0..1, shown
  private stopper = 0;

  constructor(
    private readonly rig: Rig,
    materials: Materials,
    noise: Texture,
  ) {
    const k = (this.k = rig.d / 0.078);
    this.side = -rig.sign;
    this.h = rig.gypsy[2] - rig.deck;
    const look = { vertexColors: true, roughness: 0.6, metalness: 0.25 };
    const paint = materials.make(look, weathered(noise, 0.45));
    const sheet = materials.make({ ...look, side: DoubleSide }, weathered(noise, 0.45));
    this.group.position.set(rig.gypsy[0], rig.gypsy[1], rig.deck);
    this.group.rotation.z = Math.atan2(rig.lead[1], rig.lead[0]);
    const ground = materials.make(look, weathered(noise, 0.45, 0.8 * k));
    const still = this.mesh(this.fixed().build(), ground);
    this.turning = this.mesh(this.gypsyAndDrum().build(), paint);
    this.turning.position.z = this.h;
    this.shaft = this.mesh(this.shaftAndEnd().build(), paint);
    this.shaft.position.z = this.h;
    this.sleeve = new Group();
    this.sleeve.add(this.mesh(this.slidingClaws().build(), paint));
    this.sleeve.position.z = this.h;
    this.fork = this.mesh(this.clutchFork().build(), paint);
    this.band = this.mesh(this.brakeBand().build(), sheet);
    this.band.position.z = this.h;
    this.wheel = this.mesh(this.handWheel().build(), paint);
    this.wheel.position.set(0.93 * k, this.y(-0.5), 1.58 * k);
    this.bar = this.mesh(this.stopperBar().build(), paint);
    const at = this.local(rig.stopper);
    this.bar.position.set(at[0], at[1] + 0.42 * k, at[2] + 0.14 * k);
    this.lever = this.mesh(this.speedLever().build(), paint);
    this.lever.position.set(2.0 * k, this.y(0.35), 1.06 * k);
    this.group.add(
      this.lever,
      still,
      this.turning,
      this.shaft,
      this.sleeve,
      this.fork,
      this.band,
      this.wheel,
      this.bar,
    );
    this.lining = this.body([0.3 * k, this.y(-0.5), this.h + 0.7 * k]);
  }

  /** y of a place so many m (of 78 mm gear) outboard along the shaft from the gypsy's middle. */
  private y(outboard: number): number {
    return this.side * outboard * this.k;
  }
  private local(p: V3): V3 {
    const { gypsy, lead, deck } = this.rig;
    const dx = p[0] - gypsy[0];
    const dy = p[1] - gypsy[1];
    return [dx * lead[0] + dy * lead[1], -dx * lead[1] + dy * lead[0], p[2] - deck];
  }
  private body(p: V3): V3 {
    const { gypsy, lead, deck } = this.rig;
    return [gypsy[0] + p[0] * lead[0] - p[1] * lead[1], gypsy[1] + p[0] * lead[1] + p[1] * lead[0], p[2] + deck];
  }

  private mesh(geometry: BufferGeometry, material: Material): Mesh {
    const made = new Mesh(geometry, material);
    this.meshes.push(made);
    return made;
  }
  set shadows(on: boolean) {
    for (const mesh of this.meshes) {
      mesh.castShadow = on;
      mesh.receiveShadow = on;
    }
  }

  /** Moves what moves; seconds since the last frame, for parts that take their time. */
  show(tackle: TackleFrame, seconds: number): void {
    const turn = pocketAngle(this.rig, tackle.gypsy_turn);
    this.turning.rotation.y = turn;
    const pitch = (2 * Math.PI) / kClaws;
    this.sleeve.rotation.y = turn + tackle.clutch_offset * pitch;
    this.shaft.rotation.y = this.sleeve.rotation.y;
    const ease = Math.min(1, 6 * seconds);
    const wanted = tackle.clutch === 2 ? 1 : tackle.clutch === 1 ? 0.45 : 0;
    this.clutchIn += (wanted - this.clutchIn) * ease;
    this.sleeve.position.y = this.y(0.2 * (1 - this.clutchIn));
    this.fork.position.y = this.sleeve.position.y;
    const open = 1 + 0.035 * (1 - tackle.brake);
    this.band.scale.set(open, 1, open);
    this.wheel.rotation.set(0, 0, 0);
    this.wheel.rotateY(0.15); // the spindle leans to the man who turns it
    this.wheel.rotateZ(-2 * Math.PI * kWheelTurns * tackle.brake);
    const lifted = tackle.stopper_sprung ? 0.7 : tackle.stopper_closed ? 0 : 1;
    this.stopper += (lifted - this.stopper) * ease;
    this.bar.rotation.x = this.stopper * 1.75;
    this.lever.rotation.y = -0.7 * tackle.speed_lever; // heave: towards the man
  }

  /** Gypsy, brake drum, fixed claws: about the shaft, pocket 0 upwards. */
  private gypsyAndDrum(): Solid {
    const d = this.rig.d;
    const k = this.k;
    const solid = new Solid();
    // Two rings of teeth, a groove between them for links on edge.
    const teeth = new Shape();
    const seat = 5.5 * d; // of the pocket's floor from the shaft
    const half = (29 * Math.PI) / 180; // rad, of a pocket
    for (let pocket = 0; pocket < kPockets; ++pocket) {
      const middle = (2 * Math.PI * pocket) / kPockets;
      const point = (angle: number, radius: number, first = false): void => {
        const x = radius * Math.sin(middle + angle);
        const z = radius * Math.cos(middle + angle);
        if (first) teeth.moveTo(x, z);
        else teeth.lineTo(x, z);
      };
      point(-half, 6.25 * d, pocket === 0);
      for (const a of [-0.5, 0, 0.5]) point(a * half, (seat / Math.cos(a * half)) * 1.0);
      point(half, 6.25 * d);
      point(half + 0.03, 6.95 * d);
      point(Math.PI / kPockets, 7.15 * d);
      point((2 * Math.PI) / kPockets - half - 0.03, 6.95 * d);
    }
    const ring = new ExtrudeGeometry(teeth, { depth: 1.75 * d, bevelEnabled: false, curveSegments: 1 });
    ring.applyMatrix4(new Matrix4().makeRotationX(Math.PI / 2)); // x z stay, depth towards -y
    solid.add(ring, kPaint.castIron, new Matrix4().makeTranslation(0, 2.45 * d, 0));
    solid.add(ring, kPaint.castIron, new Matrix4().makeTranslation(0, -0.7 * d, 0));
    this.disc(solid, 0, 1.5 * d, 3.8 * d, kPaint.castIron, 20);
    for (const side of [1, -1]) {
      this.disc(solid, side * 2.7 * d, 0.5 * d, 7.9 * d, kPaint.machinery, 32);
      for (let h = 0; h < 5; ++h) {
        const a = (2 * Math.PI * (h + 0.5)) / 5;
        this.spot(
          solid,
          side * (2.96 * d),
          5.2 * d * Math.sin(a),
          5.2 * d * Math.cos(a),
          0.7 * d,
          kPaint.machineryDark,
        );
      }
    }
    // Brake drum, with spokes to see it turn by.
    const drum = this.y(-0.5);
    this.disc(solid, drum, 0.36 * k, 0.6 * k, kPaint.worn, 40);
    this.disc(solid, this.y(-0.29), 0.04 * k, 0.66 * k, kPaint.machinery, 40);
    this.disc(solid, this.y(-0.71), 0.04 * k, 0.66 * k, kPaint.machinery, 40);
    for (let h = 0; h < 6; ++h) {
      const a = (2 * Math.PI * h) / 6;
      const spoke = new Matrix4().makeRotationY(a).multiply(new Matrix4().makeTranslation(0, this.y(-0.735), 0.38 * k));
      solid.add(boxGeometry(0.06 * k, 0.05 * k, 0.46 * k), kPaint.machineryDark, spoke);
    }
    this.claws(solid, 0.3, 0.1, kPaint.worn, 0);
    return solid;
  }

  /** A round plate square to the shaft. */
  private disc(solid: Solid, y: number, thick: number, radius: number, colour: number, sides: number): void {
    solid.bar([0, y - thick / 2, 0], [0, y + thick / 2, 0], radius, colour, sides);
  }
  private spot(solid: Solid, y: number, x: number, z: number, radius: number, colour: number): void {
    solid.bar([x, y - 0.01, z], [x, y + 0.01, z], radius, colour, 10);
  }

  /** Claws that stand out by so much from outboard place at, on a disc. */
  private claws(solid: Solid, at: number, deep: number, colour: number, phase: number): void {
    const k = this.k;
    for (let c = 0; c < kClaws; ++c) {
      const a = (2 * Math.PI * c) / kClaws + phase;
      const matrix = new Matrix4()
        .makeRotationY(a)
        .multiply(new Matrix4().makeTranslation(0, this.y(at + deep / 2), 0.23 * k));
      solid.add(boxGeometry(0.17 * k, deep * k, 0.16 * k), colour, matrix);
    }
    this.disc(solid, this.y(at - 0.04), 0.1 * k, 0.32 * k, colour, 24);
  }

  private slidingClaws(): Solid {
    const k = this.k;
    const solid = new Solid();
    // Teeth towards the gypsy, in the gaps of the fixed ones.
    for (let c = 0; c < kClaws; ++c) {
      const a = (2 * Math.PI * (c + 0.5)) / kClaws;
      const matrix = new Matrix4().makeRotationY(a).multiply(new Matrix4().makeTranslation(0, this.y(0.36), 0.23 * k));
      solid.add(boxGeometry(0.17 * k, 0.11 * k, 0.16 * k), kPaint.yellow, matrix);
    }
    this.disc(solid, this.y(0.45), 0.08 * k, 0.32 * k, kPaint.yellow, 24);
    this.disc(solid, this.y(0.53), 0.1 * k, 0.24 * k, kPaint.worn, 20);
    this.disc(solid, this.y(0.6), 0.06 * k, 0.3 * k, kPaint.yellow, 24);
    return solid;
  }

  private clutchFork(): Solid {
    const k = this.k;
    const solid = new Solid();
    const y = this.y(0.53);
    solid.bar([0.3 * k, y, this.h], [0.62 * k, y, 0.3 * k], 0.035 * k, kPaint.yellow, 8);
    solid.bar([0.3 * k, y, this.h], [0.28 * k, y, this.h + 0.02 * k], 0.06 * k, kPaint.yellow, 8);
    solid.bar([0.5 * k, y, 0.7 * k], [0.75 * k, y, 1.45 * k], 0.028 * k, kPaint.yellow, 8);
    solid.ball([0.75 * k, y, 1.45 * k], 0.05 * k, kPaint.black);
    return solid;
  }

  private shaftAndEnd(): Solid {
    const k = this.k;
    const solid = new Solid();
    solid.bar([0, this.y(-1.1), 0], [0, this.y(4.2), 0], 0.13 * k, kPaint.worn, 14);
    // Warping end: waisted, with whelps to see it turn by.
    const at = [3.15, 3.25, 3.5, 3.75, 4.0, 4.1];
    const radius = [0.42, 0.36, 0.29, 0.29, 0.36, 0.42];
    for (let i = 0; i + 1 < at.length; ++i)
      solid.bar(
        [0, this.y(at[i]!), 0],
        [0, this.y(at[i + 1]!), 0],
        radius[i]! * k,
        kPaint.machinery,
        24,
        radius[i + 1]! * k,
      );
    for (let w = 0; w < kClaws; ++w) {
      const a = (2 * Math.PI * w) / kClaws;
      const m = new Matrix4().makeRotationY(a).multiply(new Matrix4().makeTranslation(0, this.y(3.62), 0.3 * k));
      solid.add(boxGeometry(0.07 * k, 0.62 * k, 0.05 * k), kPaint.worn, m);
    }
    return solid;
  }

  /** Two halves of a steel band, hinged at the bottom, drawn together by the spindle. */
  private brakeBand(): Solid {
    const k = this.k;
    const solid = new Solid();
    const y = this.y(-0.5);
    const strap = (from: number, to: number): void => {
      for (const [radius, colour] of [
        [0.655 * k, kPaint.machineryDark],
        [0.622 * k, 0x3a2f28],
      ] as const) {
        const shell = new CylinderGeometry(radius, radius, 0.3 * k, 36, 1, true, from, to - from);
        solid.add(shell, colour, new Matrix4().makeTranslation(0, y, 0));
      }
    };
    // three's cylinder begins at +z and turns towards +x: the gap is aft, at the height of the shaft
    strap(1.95, 2 * Math.PI + 1.25);
    for (const a of [1.25, 1.95]) {
      const lug = new Matrix4().makeRotationY(a).multiply(new Matrix4().makeTranslation(0, y, 0.74 * k));
      solid.add(boxGeometry(0.07 * k, 0.2 * k, 0.22 * k), kPaint.machineryDark, lug);
    }
    return solid;
  }

  private handWheel(): Solid {
    const k = this.k;
    const solid = new Solid();
    solid.ring([0, 0, 0], [0, 0, 1], 0.36 * k, 0.024 * k, kPaint.red, 32, 8);
    for (let s = 0; s < 5; ++s) {
      const a = (2 * Math.PI * s) / 5;
      solid.bar([0, 0, 0], [0.36 * k * Math.cos(a), 0.36 * k * Math.sin(a), 0], 0.016 * k, kPaint.red, 6);
    }
    solid.bar([0, 0, -0.04 * k], [0, 0, 0.05 * k], 0.055 * k, kPaint.worn, 12);
    solid.bar([0.36 * k, 0, 0], [0.36 * k, 0, 0.11 * k], 0.02 * k, kPaint.black, 8); // a grip, to count turns by
    return solid;
  }

  /** The bar, hinged at its outer end, over the cable; x along the cable. */
  private stopperBar(): Solid {
    const k = this.k;
    const solid = new Solid();
    if (this.rig.tackle.stopper === "pawl") {
      solid.box([0, -0.42 * k, 0.06 * k], [0.5 * k, 0.34 * k, 0.12 * k], kPaint.yellow);
      solid.box([0, -0.2 * k, 0.04 * k], [0.2 * k, 0.4 * k, 0.1 * k], kPaint.yellow);
    } else {
      solid.box([0, -0.42 * k, 0.06 * k], [0.2 * k, 0.98 * k, 0.13 * k], kPaint.yellow);
      solid.bar([0, -0.86 * k, 0.06 * k], [0, -1.02 * k, 0.06 * k], 0.03 * k, kPaint.steel, 8);
    }
    solid.bar([-0.16 * k, 0, 0.04 * k], [0.16 * k, 0, 0.04 * k], 0.05 * k, kPaint.steel, 10);
    return solid;
  }

  /** On the stand's top. */
  private speedLever(): Solid {
    const k = this.k;
    const solid = new Solid();
    solid.bar([0, 0, 0], [0, 0, 0.26 * k], 0.016 * k, kPaint.steel, 8);
    solid.ball([0, 0, 0.28 * k], 0.042 * k, kPaint.black);
    return solid;
  }

  /** A pillar aft of the windlass with lever, lamps and emergency stop. */
  private stand(solid: Solid): void {
    const k = this.k;
    const at = (x: number, o: number, z: number): V3 => [(2.0 + x) * k, this.y(0.35 + o), z * k];
    solid.box(at(0, 0, 0.48), [0.3 * k, 0.5 * k, 0.96 * k], kPaint.machinery);
    solid.box(at(0, 0, 1.01), [0.42 * k, 0.66 * k, 0.12 * k], kPaint.machineryDark);
    solid.box(at(0, 0, 0.03), [0.5 * k, 0.7 * k, 0.06 * k], kPaint.machineryDark);
    solid.bar(at(-0.02, -0.22, 1.06), at(-0.02, -0.22, 1.1), 0.06 * k, kPaint.yellow, 16);
    solid.bar(at(-0.02, -0.22, 1.1), at(-0.02, -0.22, 1.15), 0.04 * k, kPaint.red, 16);
    [0x2f9e44, 0xe8e6da, 0xc92a2a].forEach((lamp, i) =>
      solid.bar(at(-0.1 + 0.1 * i, 0.22, 1.065), at(-0.1 + 0.1 * i, 0.22, 1.085), 0.025 * k, lamp, 10),
    );
  }

  /** Bed, bearings, gear, motor, brake spindle's stand, stopper's frame, spurling pipe. */
  private fixed(): Solid {
    const k = this.k;
    const h = this.h;
    const solid = new Solid();
    const paint = kPaint.machinery;
    // bed
    for (const x of [-0.55, 0.55])
      solid.box([x * k, this.y(1.3), 0.1 * k], [0.28 * k, 5.4 * k, 0.2 * k], kPaint.machineryDark);
    // bearings
    for (const o of [-0.98, 0.92, 2.86]) {
      solid.add(pedestal(k, h), paint, new Matrix4().makeTranslation(0, this.y(o) + 0.11 * k, 0));
      solid.bar([0, this.y(o) - 0.16 * k, h], [0, this.y(o) + 0.16 * k, h], 0.23 * k, kPaint.machineryDark, 18);
    }
    // gear case
    solid.bar([0, this.y(1.22), h], [0, this.y(1.72), h], 0.78 * k, paint, 36);
    for (const o of [1.2, 1.72]) solid.bar([0, this.y(o), h], [0, this.y(o + 0.02), h], 0.82 * k, paint, 36);
    solid.bar([0, this.y(1.17), h], [0, this.y(1.2), h], 0.4 * k, kPaint.machineryDark, 24);
    for (let b = 0; b < 16; ++b) {
      const a = (2 * Math.PI * b) / 16;
      const at: V3 = [0.73 * k * Math.sin(a), this.y(1.2), h + 0.73 * k * Math.cos(a)];
      solid.bar(at, [at[0], this.y(1.175), at[2]], 0.03 * k, kPaint.machineryDark, 6);
    }
    solid.box([0.55 * k, this.y(1.47), 0.62 * k], [1.1 * k, 0.5 * k, 1.0 * k], paint);
    solid.box([0, this.y(1.47), 0.3 * k], [1.5 * k, 0.5 * k, 0.6 * k], paint);
    solid.box([1.15 * k, this.y(1.95), 0.62 * k], [0.75 * k, 0.65 * k, 0.85 * k], paint);
    solid.box([1.15 * k, this.y(1.95), 0.15 * k], [0.9 * k, 0.8 * k, 0.3 * k], kPaint.machineryDark);
    this.motor(solid);
    this.stand(solid);
    this.brakeStand(solid);
    this.stopperFrame(solid);
    // spurling pipe
    const down = this.local(this.rig.spurling);
    solid.bar([down[0], down[1], -0.1], [down[0], down[1], 0.34 * k], 0.4 * k, kPaint.deck, 22);
    solid.ring([down[0], down[1], 0.34 * k], [0, 0, 1], 0.38 * k, 0.06 * k, kPaint.machineryDark, 22, 8);
    solid.bar([down[0], down[1], 0.33 * k], [down[0], down[1], 0.345 * k], 0.36 * k, kPaint.black, 22);
    return solid;
  }

  private motor(solid: Solid): void {
    const k = this.k;
    const z = 0.72 * k;
    if (this.rig.tackle.drive === "hydraulic") {
      solid.bar([1.15 * k, this.y(2.25), z], [1.15 * k, this.y(2.8), z], 0.36 * k, kPaint.machineryDark, 20);
      solid.bar([1.15 * k, this.y(2.8), z], [1.15 * k, this.y(2.95), z], 0.27 * k, kPaint.machineryDark, 20);
      for (const dx of [-0.16, 0.16]) {
        solid.bar(
          [(1.15 + dx) * k, this.y(2.6), z],
          [(1.15 + dx) * k, this.y(2.6), z + 0.45 * k],
          0.05 * k,
          kPaint.steel,
          8,
        );
        solid.bar(
          [(1.15 + dx) * k, this.y(2.6), z + 0.45 * k],
          [(1.75 + dx) * k, this.y(2.6), z + 0.45 * k],
          0.05 * k,
          kPaint.steel,
          8,
        );
        solid.bar(
          [(1.75 + dx) * k, this.y(2.6), z + 0.45 * k],
          [(1.75 + dx) * k, this.y(2.6), 0],
          0.05 * k,
          kPaint.steel,
          8,
        );
      }
      return;
    }
    solid.bar([1.15 * k, this.y(2.25), z], [1.15 * k, this.y(3.35), z], 0.37 * k, kPaint.machineryDark, 20);
    for (let f = 0; f < 9; ++f)
      solid.bar([1.15 * k, this.y(2.38 + 0.1 * f), z], [1.15 * k, this.y(2.42 + 0.1 * f), z], 0.41 * k, paintOf(f), 20);
    solid.bar([1.15 * k, this.y(3.35), z], [1.15 * k, this.y(3.5), z], 0.3 * k, kPaint.black, 20);
    solid.box([1.15 * k, this.y(2.75), z + 0.46 * k], [0.4 * k, 0.42 * k, 0.2 * k], kPaint.machinery);
    solid.box([1.15 * k, this.y(2.85), 0.18 * k], [0.7 * k, 0.9 * k, 0.36 * k], kPaint.machineryDark);
  }

  private brakeStand(solid: Solid): void {
    const k = this.k;
    const y = this.y(-0.5);
    // The spindle goes through the lugs at the band's ends; a bracket on the bed holds its foot.
    solid.bar([0.7 * k, y, 0.25 * k], [0.925 * k, y, 1.56 * k], 0.034 * k, kPaint.worn, 10);
    solid.box([0.66 * k, y, 0.28 * k], [0.3 * k, 0.28 * k, 0.2 * k], kPaint.machinery);
    for (const dy of [-0.12, 0.12])
      solid.bar([0.5 * k, y + dy * k, 0.05 * k], [0.68 * k, y + dy * k, 0.4 * k], 0.04 * k, kPaint.machinery, 8);
    solid.box([0.76 * k, y, 0.62 * k], [0.12 * k, 0.12 * k, 0.1 * k], kPaint.worn);
    solid.box([0.84 * k, y, 1.16 * k], [0.12 * k, 0.12 * k, 0.08 * k], kPaint.worn);
  }

  private stopperFrame(solid: Solid): void {
    const k = this.k;
    const at = this.local(this.rig.stopper);
    const z = at[2];
    for (const side of [1, -1]) {
      solid.box(
        [at[0], at[1] + side * 0.32 * k, (z + 0.12 * k) / 2],
        [0.75 * k, 0.1 * k, z + 0.12 * k],
        kPaint.machinery,
      );
      solid.box(
        [at[0], at[1] + side * 0.44 * k, z / 2 - 0.1 * k],
        [0.14 * k, 0.16 * k, z - 0.1 * k],
        kPaint.machineryDark,
      );
    }
    solid.box([at[0], at[1], (z - 0.3 * k) / 2], [1.1 * k, 0.6 * k, z - 0.3 * k], kPaint.machineryDark);
    solid.box([at[0], at[1], 0.05 * k], [1.5 * k, 1.3 * k, 0.1 * k], kPaint.machineryDark);
    // a roller under the cable
    solid.bar(
      [at[0] + 0.45 * k, at[1] - 0.3 * k, z - 0.2 * k],
      [at[0] + 0.45 * k, at[1] + 0.3 * k, z - 0.2 * k],
      0.13 * k,
      kPaint.worn,
      14,
    );
  }

  dispose(): void {
    for (const mesh of this.meshes) mesh.geometry.dispose();
  }
}

const paintOf = (fin: number): number => (fin % 2 === 0 ? kPaint.machinery : kPaint.machineryDark);

function boxGeometry(x: number, y: number, z: number): BufferGeometry {
  return new Solid().box([0, 0, 0], [x, y, z], 0).build();
}

/** A bearing's foot, widening to the bed. */
function pedestal(k: number, h: number): BufferGeometry {
  const shape = new Shape();
  shape.moveTo(-0.55 * k, 0.15 * k);
  shape.lineTo(0.55 * k, 0.15 * k);
  shape.lineTo(0.24 * k, h);
  shape.lineTo(-0.24 * k, h);
  const solid = new ExtrudeGeometry(shape, { depth: 0.22 * k, bevelEnabled: false });
  return solid.applyMatrix4(new Matrix4().makeRotationX(Math.PI / 2));
}
