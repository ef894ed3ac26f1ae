// All buoys of a chart as one mesh, each riding on the sea that is drawn: it rises with the water and leans with its
// slope, less than the water does, as its chain holds it.

import { Mesh } from "three";
import type { Buoy } from "../surroundings/buoyage";
import type { Landmark, SeaState } from "../wire/generated";
import { buoy } from "./buoy";
import type { Painted } from "./materials";
import { Solid } from "./solid";
import { type V3, clamp } from "./vec";
import { surface } from "./waves";

const kRides = 1500; // m from the eye, beyond which a wave's height is less than a pixel or two
const kSpan = 2; // m either way, over which the water's slope is taken
const kLeans = 0.6; // of the water's slope
const kLeansMost = 0.35; // rad

/** How a buoy rides at one moment: m up, and its slope to east and north. */
interface Ride {
  up: number;
  east: number;
  north: number;
}

export class Buoys {
  readonly mesh: Mesh;
  private readonly upright: Float32Array; // corners in still water
  private readonly floats: { mark: Landmark; from: number; to: number }[] = [];

  constructor(marks: readonly { mark: Landmark; looks: Buoy }[], paint: Painted) {
    const solid = new Solid();
    for (const { mark, looks } of marks) {
      const from = solid.corners;
      buoy(solid, mark, looks);
      this.floats.push({ mark, from, to: solid.corners });
    }
    this.mesh = new Mesh(solid.build(), paint);
    this.mesh.name = "buoys";
    this.mesh.frustumCulled = false;
    this.upright = Float32Array.from(this.mesh.geometry.getAttribute("position").array);
  }

  /**
   * Puts those near the eye where the sea has them. x, y: m, world, of the eye; time: s, of the exercise; lamp: is told
   * where the lamp of each is now, at that height in still water.
   */
  ride(sea: SeaState | undefined, x: number, y: number, time: number, lamp: (mark: Landmark, at: V3) => void): void {
    const position = this.mesh.geometry.getAttribute("position");
    for (const { mark, from, to } of this.floats) {
      if (Math.hypot(mark.x - x, mark.y - y) > kRides) continue;
      const ride = rideOf(sea, mark, time);
      for (let i = from; i < to; ++i) {
        const corner: V3 = [this.upright[3 * i]!, this.upright[3 * i + 1]!, this.upright[3 * i + 2]!];
        position.setXYZ(i, ...ridden(corner, mark, ride));
      }
      position.needsUpdate = true;
      lamp(mark, ridden([mark.x, mark.y, mark.height + 0.3], mark, ride));
    }
  }

  dispose(): void {
    this.mesh.geometry.dispose();
  }
}

function rideOf(sea: SeaState | undefined, { x, y }: Landmark, time: number): Ride {
  const at = (east: number, north: number): number => surface(sea, x + east, y + north, time);
  const leans = (slope: number): number => clamp(kLeans * slope, -kLeansMost, kLeansMost);
  return {
    up: at(0, 0),
    east: leans((at(kSpan, 0) - at(-kSpan, 0)) / (2 * kSpan)),
    north: leans((at(0, kSpan) - at(0, -kSpan)) / (2 * kSpan)),
  };
}

/** A place of the buoy that it has upright in still water, m, world. */
function ridden([x, y, z]: V3, mark: Landmark, { up, east, north }: Ride): V3 {
  return [x - east * z, y - north * z, z + up + east * (x - mark.x) + north * (y - mark.y)];
}
