// Spray that comes over the bow where a sea meets it, and how wet it leaves the steel. Neither is on the wire: both are
// made of the wind and the waves that one sees.

import type { SeaState } from "../wire/generated";
import { Vector3 } from "three";
import type { SceneFrame } from "./frame";
import type { Particles, Puff } from "./particles";
import { clamp } from "./vec";
import { significantHeight, surface } from "./waves";

const kSpray: Puff = {
  life: 1.8,
  size: 0.35,
  grows: 1.3,
  lift: -4.5,
  drag: 1.5,
  r: 0.78,
  g: 0.83,
  b: 0.85,
  alpha: 0.3,
};
const kWind = [11, 19] as const; // m/s, from which the wind carries spray, and at which it carries all
const kHeight = [0.7, 1.8] as const; // m, of seas that send any
const kRises = 0.7; // m/s, of the water against the bow, that throws some up
const kReach = 13; // m abaft the stem, along which it comes over the rail
const kStep = 0.2; // s

const share = (x: number, [none, all]: readonly [number, number]): number => clamp((x - none) / (all - none), 0, 1);

/** 0..1: how much of it the wind brings over the bow. */
export function sprayed({ ship, wind_from, wind_speed, time }: SceneFrame, sea: SeaState | undefined): number {
  const ahead = Math.max(0, Math.cos(wind_from - ship.heading));
  return ahead * share(wind_speed, kWind) * share(significantHeight(sea, time), kHeight);
}

export class Spray {
  private owed = 0;
  private was: { time: number; z: number } | undefined; // m, world, of the bow
  private readonly at = new Vector3();

  /** bow: m, body frame, of the stem's rail; rail: m, half the breadth over the bulwark at x. */
  constructor(
    private readonly bow: readonly [number, number, number],
    private readonly rail: (x: number) => number,
  ) {}

  /** As at the beginning: for still pictures. */
  restart(): void {
    this.owed = 0;
    this.was = undefined;
  }

  /**
   * What comes over in so many seconds, at s of exercise time: most a second of them; toScene: from the body frame to m
   * from the origin.
   */
  stir(
    into: Particles,
    frame: SceneFrame,
    time: number,
    seconds: number,
    sea: SeaState | undefined,
    origin: readonly number[],
    toScene: (p: Vector3) => Vector3,
    most: number,
    next: () => number,
  ): void {
    const much = sprayed(frame, sea);
    if (much <= 0) return;
    const [x, , z] = this.bow;
    const stem = toScene(this.at.set(x, 0, z));
    const [wx, wy, wz] = [stem.x + origin[0]!, stem.y + origin[1]!, stem.z + origin[2]!];
    const since = this.was ? frame.time - this.was.time : 0;
    const sinks = since > 0 && since < 1 ? (this.was!.z - wz) / since : 0;
    this.was = { time: frame.time, z: wz };
    const rises = sinks + (surface(sea, wx, wy, time) - surface(sea, wx, wy, time - kStep)) / kStep;
    this.owed = Math.min(this.owed + seconds * most * much * share(rises, [kRises, kRises + 1]), 20);
    for (; this.owed >= 1; --this.owed) {
      const back = kReach * next() ** 1.5;
      const side = next() < 0.5 ? 1 : -1;
      const p = toScene(this.at.set(x - back, side * this.rail(x - back), z + 0.3 * next()));
      const up = (1.5 + 6 * next() * next()) * clamp(rises, 0.5, 2);
      into.add(kSpray, p.x, p.y, p.z, 2 * next() - 1, 2 * next() - 1, up);
    }
  }
}
