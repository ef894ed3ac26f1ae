// The hull's upper edge, of the mesh that the server sends, and the strake that carries it up to the forecastle deck:
// the mesh ends where contact ends.

import type { SceneDescription } from "../wire/generated";
import { type V3, along, sub } from "./vec";

/** A place of the port edge, m body frame, and its flare: how x and y go on for each m upwards. */
export interface EdgePoint {
  x: number;
  y: number;
  z: number;
  flareX: number;
  flareY: number;
}

/** m, of the bulwark over the forecastle deck. */
export const kBulwark = 1.15;

const kSame = 1e-3; // m

/** The port half of the hull's upper edge, from the stern to the stem. */
export function portEdge(scene: SceneDescription): EdgePoint[] {
  const c = scene.hull_corners;
  const levels: number[] = [];
  for (let i = 2; i < c.length; i += 3) if (!levels.some((z) => Math.abs(z - c[i]!) < kSame)) levels.push(c[i]!);
  levels.sort((a, b) => b - a);
  const row = (z: number): V3[] => {
    const points: V3[] = [];
    for (let i = 0; i + 2 < c.length; i += 3)
      if (Math.abs(c[i + 2]! - z) < kSame && c[i + 1]! > -kSame) points.push([c[i]!, c[i + 1]!, c[i + 2]!]);
    return points.sort((a, b) => a[0] - b[0] || b[1] - a[1]);
  };
  const top = row(levels[0] ?? 0);
  const below = row(levels[1] ?? 0);
  const height = (levels[0] ?? 0) - (levels[1] ?? 0);
  return top.map(([x, y, z], i) => {
    const under = below.length === top.length ? below[i]! : ([x, y, z] as V3);
    const share = below.length === top.length && height > 0 ? 1 / height : 0;
    return { x, y, z, flareX: share * (x - under[0]), flareY: share * (y - under[1]) };
  });
}

/** That edge carried up by so many m, flare going on at a share. */
export function raised(edge: readonly EdgePoint[], up: number, share = 0.6): V3[] {
  return edge.map((p) => [p.x + share * up * p.flareX, p.y + share * up * p.flareY, p.z + up]);
}

/** The part of a line ahead of x, beginning there. */
export function aheadOf(line: readonly V3[], x: number): V3[] {
  const found: V3[] = [];
  line.forEach((p, i) => {
    if (p[0] < x) return;
    const before = line[i - 1];
    if (found.length === 0 && before && before[0] < x) {
      const t = (x - before[0]) / (p[0] - before[0] || 1);
      found.push([x, before[1] + t * (p[1] - before[1]), before[2] + t * (p[2] - before[2])]);
    }
    found.push(p);
  });
  return found;
}

/** A line again, with so many points at the same distance from each other. */
export function evenly(line: readonly V3[], points: number): V3[] {
  const lengths = [0];
  for (let i = 1; i < line.length; ++i) lengths.push(lengths[i - 1]! + Math.hypot(...sub(line[i]!, line[i - 1]!)));
  const whole = lengths.at(-1) ?? 0;
  const found: V3[] = [];
  for (let k = 0, i = 0; k < points && line.length > 1; ++k) {
    const at = (whole * k) / (points - 1);
    while (i < line.length - 2 && lengths[i + 1]! < at) ++i;
    const t = (at - lengths[i]!) / (lengths[i + 1]! - lengths[i]! || 1);
    found.push(along(line[i]!, t, sub(line[i + 1]!, line[i]!)));
  }
  return found;
}

/** Half the breadth of a line at x. */
export function breadthAt(line: readonly V3[], x: number): number {
  for (let i = 1; i < line.length; ++i) {
    const a = line[i - 1]!;
    const b = line[i]!;
    if (b[0] < x) continue;
    const t = (x - a[0]) / (b[0] - a[0] || 1);
    return a[1] + Math.min(1, Math.max(0, t)) * (b[1] - a[1]);
  }
  return 0;
}

/** Starboard's twin of a line. */
export const mirrored = (line: readonly V3[]): V3[] => line.map((p) => [p[0], -p[1], p[2]]);
