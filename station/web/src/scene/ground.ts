// The ground as the server has it: a slope, and over it a quadratic B-spline of the grid's points. Pure.

import type { SeabedDescription } from "../wire/generated";
import { clamp } from "./vec";

/** m, height of the bed at x, y (world) over the chart's datum. */
export function bedHeight(bed: SeabedDescription, x: number, y: number): number {
  const rise = Math.tan(bed.slope);
  let z = -bed.depth + rise * (Math.sin(bed.slope_towards) * x + Math.cos(bed.slope_towards) * y);
  if (bed.columns === 0 || bed.heights.length === 0) return z;
  const across = axis((x - bed.origin_x) / bed.spacing, bed.columns);
  const up = axis((y - bed.origin_y) / bed.spacing, bed.rows);
  for (let r = 0; r < 3; ++r)
    for (let c = 0; c < 3; ++c) z += up[3 + r]! * across[3 + c]! * bed.heights[up[r]! * bed.columns + across[c]!]!;
  return z;
}

/** Soil at x, y. */
export function soilAt(bed: SeabedDescription, x: number, y: number): number {
  if (bed.soils.length === 0) return bed.soil;
  const column = clamp(Math.round((x - bed.origin_x) / bed.spacing), 0, bed.columns - 1);
  const row = clamp(Math.round((y - bed.origin_y) / bed.spacing), 0, bed.rows - 1);
  return bed.soils[row * bed.columns + column] ?? bed.soil;
}

/** Three neighbours on one axis and their shares. */
function axis(at: number, count: number): number[] {
  const u = at > -1 ? Math.min(at, count) : -1;
  const middle = Math.floor(u + 0.5);
  const t = u - middle;
  const within = (k: number): number => clamp(k, 0, count - 1);
  return [
    within(middle - 1),
    within(middle),
    within(middle + 1),
    0.5 * (0.5 - t) ** 2,
    0.75 - t * t,
    0.5 * (0.5 + t) ** 2,
  ];
}
