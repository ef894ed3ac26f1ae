// What is stirred up by what happens: rust dust, splash, mud, smoke and sparks, each by the field that says so.

import { Color, type Vector3 } from "three";
import { LiningSeen } from "../wire/generated";
import type { TackleFrame } from "./frame";
import type { Links } from "./links";
import { random } from "./noise";
import { Particles, type Puff } from "./particles";

const kDust: Puff = { life: 0.9, size: 0.06, grows: 0.45, lift: -0.6, drag: 1.2, r: 0.3, g: 0.17, b: 0.1, alpha: 0.2 };
const kStorm: Puff = {
  life: 2.4,
  size: 0.16,
  grows: 0.75,
  lift: 0.15,
  drag: 1.1,
  r: 0.34,
  g: 0.2,
  b: 0.12,
  alpha: 0.34,
};
const kSplash: Puff = { life: 0.9, size: 0.12, grows: 0.7, lift: -7, drag: 0.3, r: 0.9, g: 0.95, b: 0.97, alpha: 0.55 };
const kFoam: Puff = { life: 3.5, size: 0.5, grows: 0.55, lift: 0, drag: 2, r: 0.85, g: 0.92, b: 0.93, alpha: 0.32 };
const kSmoke: Puff = {
  life: 3.2,
  size: 0.12,
  grows: 0.55,
  lift: 0.9,
  drag: 0.8,
  r: 0.42,
  g: 0.42,
  b: 0.44,
  alpha: 0.4,
};
const kBlack: Puff = { life: 4, size: 0.2, grows: 0.75, lift: 1.3, drag: 0.8, r: 0.08, g: 0.08, b: 0.09, alpha: 0.5 };
const kFlame: Puff = { life: 0.5, size: 0.2, grows: -0.2, lift: 4, drag: 1, r: 1, g: 0.3, b: 0.02, alpha: 0.6 };
const kSpark: Puff = {
  life: 0.7,
  size: 0.012,
  grows: 0,
  lift: -8,
  drag: 0.2,
  r: 1,
  g: 0.62,
  b: 0.14,
  alpha: 1,
  trail: 0.04,
};

const kRunsAway = 5.5; // m/s

export class Effects {
  readonly cover = new Particles(false);
  readonly shine = new Particles(true);
  next = random(11);
  private owed = 0;
  private readonly mud: Puff = { life: 7, size: 0.5, grows: 0.45, lift: 0.02, drag: 1.2, r: 0, g: 0, b: 0, alpha: 0.4 };
  private readonly before = new Map<number, { x: number; y: number; z: number; time: number }>();
  private readonly paint = new Color();

  /**
   * What one side stirs up in so many seconds. places: m from the origin; surface: m, world, height of the sea; bed:
   * m, world, height of the ground, -Infinity where it is not seen; soil: its colour.
   */
  stir(
    tackle: TackleFrame,
    links: Links,
    origin: readonly number[],
    time: number,
    seconds: number,
    places: { lining: Vector3; gypsy: Vector3; pipe: Vector3 },
    surface: (x: number, y: number) => number,
    bed: (x: number, y: number) => number,
    soil: (x: number, y: number) => number,
  ): void {
    const r = (): number => this.next() - 0.5;
    const many = (rate: number): number => {
      this.owed = rate * seconds + this.next();
      return Math.min(12, Math.floor(this.owed));
    };
    const speed = Math.abs(tackle.cable_speed);
    if (speed > 1.2) {
      // Rust and mud fly off at the gypsy and where the pipe takes the cable: a cloud of it where she runs away.
      for (let n = many(9 * (speed - 1)); n > 0; --n) {
        const at = this.next() < 0.6 ? places.gypsy : places.pipe;
        this.cover.add(
          kDust,
          at.x + 0.5 * r(),
          at.y + 0.5 * r(),
          at.z + 0.3 * r() + 0.2,
          1.2 * r(),
          1.2 * r(),
          0.8 + r(),
        );
      }
    }
    if (speed > kRunsAway) {
      for (let n = many(30 * (speed - kRunsAway + 0.5)); n > 0; --n) {
        const at = this.next() < 0.5 ? places.gypsy : places.pipe;
        this.cover.add(kStorm, at.x + r(), at.y + r(), at.z + 0.3 * r(), 2.4 * r(), 2.4 * r(), 1.2 + 1.4 * r());
      }
      // steel on steel
      for (let n = many(14 * (speed - kRunsAway + 0.5)); n > 0; --n) {
        const at = this.next() < 0.5 ? places.gypsy : places.pipe;
        this.shine.add(kSpark, at.x + 0.3 * r(), at.y + 0.3 * r(), at.z + 0.1, 6 * r(), 6 * r(), 1.5 + 3 * r());
      }
    }
    this.entry(tackle, links, origin, speed, many, r, surface);
    if (tackle.lining >= LiningSeen.LINING_SMOKES) {
      const burns = tackle.lining >= LiningSeen.LINING_BURNS;
      const at = places.lining;
      for (let n = many(burns ? 26 : 14); n > 0; --n)
        this.cover.add(
          burns ? kBlack : kSmoke,
          at.x + 0.7 * r(),
          at.y + 0.7 * r(),
          at.z + 0.3 * r(),
          0.4 * r(),
          0.4 * r(),
          0.7,
        );
      if (burns) {
        for (let n = many(60); n > 0; --n)
          this.shine.add(kFlame, at.x + 0.9 * r(), at.y + 0.7 * r(), at.z - 0.35 + 0.5 * r(), 0.5 * r(), 0.5 * r(), 1);
        if (speed > 0.2)
          for (let n = many(90); n > 0; --n)
            this.shine.add(kSpark, at.x + 0.3 * r(), at.y + 0.3 * r(), at.z - 0.1, 5 * r(), 5 * r(), 2.5 + 3 * r());
      }
    } else if (tackle.brake_noise >= 3 && speed > 0.2) {
      const at = places.lining;
      for (let n = many(25); n > 0; --n)
        this.shine.add(kSpark, at.x + 0.3 * r(), at.y + 0.3 * r(), at.z - 0.2, 4 * r(), 4 * r(), 2 + 2 * r());
    }
    this.onBottom(tackle, origin, time, many, r, bed, soil);
  }

  /** Splash where cable or anchor goes through the surface. */
  private entry(
    tackle: TackleFrame,
    links: Links,
    origin: readonly number[],
    speed: number,
    many: (rate: number) => number,
    r: () => number,
    surface: (x: number, y: number) => number,
  ): void {
    if (speed > 1) {
      for (let i = 1; i < links.count; ++i) {
        const z = links.middle[3 * i + 2]! + origin[2]!;
        if (z > 0.4) continue;
        const x = links.middle[3 * i]!;
        const y = links.middle[3 * i + 1]!;
        const eta = surface(x + origin[0]!, y + origin[1]!);
        if (z > eta) continue;
        if (i > 1) this.splash(x, y, eta - origin[2]!, 0.25 * speed, many(16 * speed), r);
        break;
      }
    }
    const a = tackle.anchor;
    const was = this.before.get(tackle.side);
    if (!a || !was) return;
    const eta = surface(a.x, a.y);
    const through = (was.z - eta) * (a.z - eta) <= 0 && was.z !== a.z;
    if (through) this.splash(a.x - origin[0]!, a.y - origin[1]!, eta - origin[2]!, 1.6, 60, r);
  }

  private splash(x: number, y: number, z: number, up: number, n: number, r: () => number): void {
    for (let k = 0; k < n; ++k) {
      this.cover.add(
        kSplash,
        x + 0.8 * r(),
        y + 0.8 * r(),
        z + 0.05,
        1.5 * up * r(),
        1.5 * up * r(),
        up * (1.2 + 2 * r()) + 1,
      );
      if (k % 6 === 0) this.cover.add(kFoam, x + 1.6 * r(), y + 1.6 * r(), z + 0.06, 0.4 * r(), 0.4 * r(), 0);
    }
  }

  /** Mud where the anchor strikes or is dragged. */
  private onBottom(
    tackle: TackleFrame,
    origin: readonly number[],
    time: number,
    many: (rate: number) => number,
    r: () => number,
    bed: (x: number, y: number) => number,
    soil: (x: number, y: number) => number,
  ): void {
    const a = tackle.anchor;
    if (!a) {
      this.before.delete(tackle.side);
      return;
    }
    const was = this.before.get(tackle.side);
    const dt = was ? time - was.time : 0;
    if (was && dt > 0 && dt < 1) {
      const speed = Math.hypot(a.x - was.x, a.y - was.y, a.z - was.z) / dt;
      const z = bed(a.x, a.y);
      if (speed > 0.05 && a.z - z < 1.6) {
        this.paint.set(soil(a.x, a.y));
        const puff: Puff = { ...this.mud, r: this.paint.r, g: this.paint.g, b: this.paint.b };
        for (let n = many(Math.min(60, 25 * speed)); n > 0; --n)
          this.cover.add(
            puff,
            a.x - origin[0]! + 2 * r(),
            a.y - origin[1]! + 2 * r(),
            z - origin[2]! + 0.3 * this.next(),
            0.8 * r() * (1 + speed),
            0.8 * r() * (1 + speed),
            0.3 + 0.2 * speed * this.next(),
          );
      }
    }
    this.before.set(tackle.side, { x: a.x, y: a.y, z: a.z, time });
  }

  /** As at the beginning: for still pictures. */
  restart(): void {
    this.next = random(11);
    this.before.clear();
    this.cover.clear();
    this.shine.clear();
  }

  dispose(): void {
    this.cover.dispose();
    this.shine.dispose();
  }
}
