// Fewer of a chart's soundings, so that they can be read however small it is shown.

import type { PlanSounding } from "./picture";

let thinned: { of: PlanSounding[]; apart: number; left: PlanSounding[] } | undefined;

/** Those of a chart's soundings that stand so far apart, m: the first that fit, so that a grid stays a grid. */
export function thin(all: PlanSounding[], apart: number): PlanSounding[] {
  if (thinned?.of === all && thinned.apart === apart) return thinned.left;
  const cells = new Map<string, PlanSounding[]>();
  const left = all.filter((s) => {
    const [column, row] = [Math.floor(s.x / apart), Math.floor(s.y / apart)];
    for (let i = column - 1; i <= column + 1; ++i)
      for (let j = row - 1; j <= row + 1; ++j)
        if (cells.get(`${i}/${j}`)?.some((t) => Math.hypot(s.x - t.x, s.y - t.y) < apart)) return false;
    const cell = `${column}/${row}`;
    cells.set(cell, [...(cells.get(cell) ?? []), s]);
    return true;
  });
  thinned = { of: all, apart, left };
  return left;
}
