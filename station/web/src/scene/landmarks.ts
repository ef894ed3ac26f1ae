// The coast in the distance: hills with a lighthouse, and a ship at anchor, to see the own ship swing by.

import { Mesh } from "three";
import { type Materials } from "./materials";
import { random } from "./noise";
import { Solid } from "./solid";

/** In the world's axes, about the place where the exercise begins; m. */
export function landmarks(materials: Materials): Mesh {
  const solid = new Solid();
  const next = random(5);
  hills(solid, next, 5200, -0.9, 0.55, 130, 0x4c5f4e);
  hills(solid, next, 7600, 0.3, 1.35, 260, 0x5d6d70);
  // a lighthouse on the point
  const lx = 4700 * Math.sin(0.56);
  const ly = 4700 * Math.cos(0.56);
  solid.bar([lx, ly, 0], [lx, ly, 46], 6, 0xe8e6de, 12, 4);
  solid.bar([lx, ly, 24], [lx, ly, 32], 5.3, 0xa8281e, 12, 5);
  solid.bar([lx, ly, 46], [lx, ly, 52], 3.2, 0x30363a, 10, 2.4);
  anchored(solid, 900, 1500, 0.5);
  anchored(solid, -1300, 1100, -0.3);
  const mesh = new Mesh(solid.build(), materials.make({ vertexColors: true, roughness: 1, metalness: 0 }));
  mesh.name = "landmarks";
  mesh.frustumCulled = false;
  return mesh;
}

/** A range of hills, bearings rad clockwise from north. */
function hills(
  solid: Solid,
  next: () => number,
  range: number,
  from: number,
  to: number,
  height: number,
  colour: number,
): void {
  const n = 26;
  let before: [number, number, number] | undefined;
  for (let i = 0; i <= n; ++i) {
    const t = i / n;
    const bearing = from + t * (to - from);
    const h = height * Math.sin(Math.PI * t) ** 0.7 * (0.45 + 0.55 * next());
    const r = range * (0.95 + 0.1 * next());
    const here: [number, number, number] = [r * Math.sin(bearing), r * Math.cos(bearing), h];
    if (before) {
      const foot = (p: readonly number[]): [number, number, number] => [p[0]! * 0.93, p[1]! * 0.93, -2];
      solid.quad(before, foot(before), foot(here), here, colour);
    }
    before = here;
  }
}

function anchored(solid: Solid, x: number, y: number, heading: number): void {
  solid.box([x, y, 3.5], [26, 150, 11], 0x20262c, -heading);
  const s = Math.sin(heading);
  const c = Math.cos(heading);
  solid.box([x - 58 * s, y - 58 * c, 17], [22, 18, 16], 0xdcdcd4, -heading);
  solid.box([x - 62 * s, y - 62 * c, 27], [7, 8, 6], 0xc0562a, -heading);
  for (const k of [-25, 10, 45]) solid.bar([x + k * s, y + k * c, 9], [x + k * s, y + k * c, 24], 1, 0xb8a040, 6);
}
