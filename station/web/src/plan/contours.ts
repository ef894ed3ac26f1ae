// Depth contours of a chart, from the grid of its soundings.

import type { Place, PlanSounding } from "./picture";

/** m, of which lines are drawn. */
export const kContours = [2, 5, 10, 15, 20, 30, 50, 100] as const;

/** A line of equal depth. */
export interface Contour {
  depth: number; // m
  points: Place[];
}

/** Soundings by column and row. A place that was not sounded has none. */
interface Grid {
  columns: number;
  rows: number;
  at: (PlanSounding | undefined)[];
}

const found = new WeakMap<PlanSounding[], Contour[]>();

/** Those of a chart; worked out once. */
export function contours(soundings: PlanSounding[]): Contour[] {
  let lines = found.get(soundings);
  if (!lines) {
    const grid = gridOf(soundings);
    lines = kContours.flatMap((depth) => contoursOf(grid, depth));
    found.set(soundings, lines);
  }
  return lines;
}

function gridOf(soundings: PlanSounding[]): Grid {
  const numbers = (values: number[]): Map<number, number> =>
    new Map([...new Set(values)].sort((a, b) => a - b).map((value, k) => [value, k]));
  const xs = numbers(soundings.map(({ x }) => x));
  const ys = numbers(soundings.map(({ y }) => y));
  const at: Grid["at"] = [];
  for (const s of soundings) at[ys.get(s.y)! * xs.size + xs.get(s.x)!] = s;
  return { columns: xs.size, rows: ys.size, at };
}

/**
 * By marching squares: each edge of the grid between a sounding that is shallower and one that is not is crossed once,
 * and each cell joins the crossings of its edges two by two. Edges are numbered.
 */
function contoursOf({ columns, rows, at }: Grid, depth: number): Contour[] {
  const crossings = new Map<number, Place>();
  const joined = new Map<number, number[]>(); // an edge's neighbours on the line
  const join = (a: number, b: number): void => {
    joined.set(a, [...(joined.get(a) ?? []), b]);
    joined.set(b, [...(joined.get(b) ?? []), a]);
  };
  for (let row = 0; row + 1 < rows; ++row)
    for (let column = 0; column + 1 < columns; ++column) {
      const southWest = row * columns + column;
      const northWest = southWest + columns;
      // Counterclockwise; the edge of that number goes from a corner to the next one.
      const corners = [southWest, southWest + 1, northWest + 1, northWest].map((corner) => at[corner]);
      const edges = [2 * southWest, 2 * (southWest + 1) + 1, 2 * northWest, 2 * southWest + 1];
      if (!corners.every((corner) => corner !== undefined)) continue;
      for (const [a, b] of pairs(
        corners.map((corner) => corner.depth),
        depth,
      )) {
        for (const k of [a, b]) crossings.set(edges[k]!, crossing(corners[k]!, corners[(k + 1) % 4]!, depth));
        join(edges[a]!, edges[b]!);
      }
    }
  return chains(joined)
    .map((edges) => ({ depth, points: withoutRepeats(edges.map((edge) => crossings.get(edge)!)) }))
    .filter(({ points }) => points.length > 1);
}

/** Which edges of a cell, 0 to 3, its lines of that depth join. */
function pairs(corners: number[], depth: number): (readonly [number, number])[] {
  const deep = corners.map((corner) => corner >= depth);
  const crossed = [0, 1, 2, 3].filter((k) => deep[k] !== deep[(k + 1) % 4]);
  if (crossed.length === 0) return [];
  if (crossed.length === 2) return [[crossed[0]!, crossed[1]!]];
  // A saddle: its middle says which two of its corners hang together. The lines go round the other two.
  const middle = corners.reduce((sum, corner) => sum + corner, 0) / 4;
  return middle >= depth === deep[0] ? [[0, 1], [2, 3]] : [[3, 0], [1, 2]]; // prettier-ignore
}

/** Where an edge has that depth. From its deep end, so that a sounding of just that depth is hit exactly. */
function crossing(a: PlanSounding, b: PlanSounding, depth: number): Place {
  const [deep, shallow] = a.depth >= depth ? [a, b] : [b, a];
  const share = (deep.depth - depth) / (deep.depth - shallow.depth);
  return { x: deep.x + share * (shallow.x - deep.x), y: deep.y + share * (shallow.y - deep.y) };
}

/** Edges as they follow each other: lines that end at the grid's border first, then closed ones. */
function chains(joined: Map<number, number[]>): number[][] {
  const done = new Set<number>();
  const lines: number[][] = [];
  const starts = [...joined.keys()].sort((a, b) => joined.get(a)!.length - joined.get(b)!.length);
  for (const start of starts) {
    if (done.has(start)) continue;
    const line: number[] = [];
    for (let edge: number | undefined = start; edge !== undefined;) {
      line.push(edge);
      done.add(edge);
      edge = joined.get(edge)!.find((next) => !done.has(next));
    }
    if (joined.get(start)!.length === 2) line.push(start);
    lines.push(line);
  }
  return lines;
}

const withoutRepeats = (points: Place[]): Place[] =>
  points.filter((p, k) => k === 0 || p.x !== points[k - 1]!.x || p.y !== points[k - 1]!.y);
