// The foremast: platform with two floodlights that shine forward and down, and where the stay leads on which a ball
// is hoisted.

import { kPaint } from "./materials";
import type { Solid } from "./solid";
import type { V3 } from "./vec";

/** Places on it, m, body frame. */
export interface Foremast {
  /** Its top, where a light burns. */
  head: V3;
  /** Both ends of the stay forward: at the mast, at the stem. */
  stay: readonly [V3, V3];
  /** Floodlights. */
  lamps: V3[];
}

/** A place on the stay; share 0 at the mast .. 1 at the stem. */
export function stayPlace({ stay }: Foremast, share: number): V3 {
  const [a, b] = stay;
  return [a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]), a[2] + share * (b[2] - a[2])];
}

/** at: its foot; stem: where the stay comes down. */
export function foremast(solid: Solid, at: V3, stem: V3): Foremast {
  const [x, y, z] = at;
  solid.bar([x, y, z], [x, y, z + 9.5], 0.32, kPaint.bulwark, 14, 0.2);
  solid.bar([x, y, z + 9.5], [x, y, z + 12.5], 0.12, kPaint.bulwark, 8, 0.07);
  solid.box([x + 0.1, y, z + 7.4], [1.3, 2.4, 0.06], kPaint.bulwark);
  for (const dy of [-1.2, 1.2])
    solid.bar([x - 0.5, y + dy, z + 8.3], [x + 0.75, y + dy, z + 8.3], 0.025, kPaint.bulwark, 5);
  solid.bar([x + 0.75, y - 1.2, z + 8.3], [x + 0.75, y + 1.2, z + 8.3], 0.025, kPaint.bulwark, 5);
  for (const dy of [-1, -0.3, 0.3, 1].map((k) => 1.2 * k))
    solid.bar([x + 0.75, y + dy, z + 7.4], [x + 0.75, y + dy, z + 8.3], 0.02, kPaint.bulwark, 4);
  for (let k = 0; k < 18; ++k)
    solid.bar([x - 0.42, y - 0.2, z + 0.4 * k + 0.4], [x - 0.42, y + 0.2, z + 0.4 * k + 0.4], 0.015, kPaint.steel, 4);
  for (const dy of [-0.2, 0.2]) solid.bar([x - 0.42, y + dy, z], [x - 0.42, y + dy, z + 7.4], 0.02, kPaint.steel, 4);
  const lamps: V3[] = [
    [x + 0.85, y + 0.85, z + 7.15],
    [x + 0.85, y - 0.85, z + 7.15],
  ];
  for (const lamp of lamps) {
    solid.box([lamp[0] - 0.12, lamp[1], lamp[2]], [0.25, 0.42, 0.34], kPaint.black);
    solid.box([lamp[0] + 0.01, lamp[1], lamp[2] - 0.02], [0.03, 0.36, 0.28], kPaint.white);
  }
  const high: V3 = [x, y, z + 11.8];
  return { head: [x, y, z + 12.6], stay: [high, stem], lamps };
}
