// Depth contours, from a chart's soundings.

import assert from "node:assert/strict";
import { test } from "node:test";

import { type Contour, contours } from "../../src/plan/contours";
import type { PlanSounding } from "../../src/plan/picture";

/** Soundings 50 m apart, row by row. */
const chart = (columns: number, rows: number, depth: (x: number, y: number) => number): PlanSounding[] =>
  Array.from({ length: columns * rows }, (_, k) => {
    const x = 50 * (k % columns);
    const y = 50 * Math.floor(k / columns);
    return { x, y, depth: depth(x, y), letter: "S" };
  });
const of = (lines: Contour[], depth: number): Contour[] => lines.filter((line) => line.depth === depth);

test("a slope has one straight line for each depth, where it has that depth", () => {
  const lines = contours(chart(11, 6, (x) => 8 + x / 50)); // 8 m to 18 m
  assert.deepEqual(
    lines.map(({ depth }) => depth),
    [10, 15],
  );
  for (const { depth, points } of lines) {
    assert.ok(points.every(({ x }) => Math.abs(x - 50 * (depth - 8)) < 1e-9));
    assert.deepEqual(
      points.map(({ y }) => y).sort((a, b) => a - b),
      [0, 50, 100, 150, 200, 250],
    );
  }
  const steep = contours(chart(3, 2, (x) => 4 + 0.08 * x)); // between soundings: 5 m at x = 12.5
  assert.ok(of(steep, 5)[0]!.points.every(({ x }) => Math.abs(x - 12.5) < 1e-9));
});

test("a slope across the grid has a line across it", () => {
  const [line] = of(contours(chart(5, 5, (x, y) => 9.95 + (x + y - 200) / 100)), 10);
  assert.ok(line!.points.length > 4);
  for (const { x, y } of line!.points) assert.ok(Math.abs(x + y - 205) < 1e-9, `${x} ${y}`);
});

test("a level bed has none, nor has one of just a contour's depth", () => {
  for (const depth of [20, 23, 0, -1]) assert.deepEqual(contours(chart(6, 6, () => depth)), []);
  assert.deepEqual(contours([]), []);
});

test("a hole is one closed line", () => {
  const [line, ...others] = of(contours(chart(5, 5, (x, y) => (x === 100 && y === 100 ? 12 : 8))), 10);
  assert.equal(others.length, 0);
  assert.equal(line!.points.length, 5);
  assert.deepEqual(line!.points[0], line!.points[4]);
  for (const { x, y } of line!.points) assert.equal(Math.hypot(x - 100, y - 100), 25);
});

test("a saddle has two lines, round the corners that its middle parts", () => {
  const saddle = (diagonal: number, others: number): Contour[] =>
    contours(chart(2, 2, (x, y) => (x === y ? diagonal : others)));
  const keepsTo = (lines: Contour[], side: (x: number, y: number) => number): void => {
    assert.equal(lines.length, 2);
    for (const { points } of lines)
      assert.equal(Math.abs(points.reduce((sum, { x, y }) => sum + Math.sign(side(x, y)), 0)), points.length);
  };
  // South-west and north-east hang together, deep in the first and shallow in the second: none crosses their diagonal.
  keepsTo(saddle(12, 9), (x, y) => x - y);
  keepsTo(saddle(8, 11), (x, y) => x - y);
  // They are parted: none crosses the other diagonal.
  keepsTo(saddle(11, 8), (x, y) => x + y - 50);
  keepsTo(saddle(9, 12), (x, y) => x + y - 50);
});

test("soundings of just a contour's depth bear the line, and it runs through each once", () => {
  const [line, ...others] = of(contours(chart(5, 4, (x) => 8 + x / 50)), 10); // at x = 100
  assert.equal(others.length, 0);
  assert.deepEqual(
    line!.points,
    [0, 50, 100, 150].map((y) => ({ x: 100, y })),
  );
  // A single sounding of it among shallower ones: the line has shrunk to a point, and is none.
  assert.deepEqual(contours(chart(3, 3, (x, y) => (x === 50 && y === 50 ? 10 : 8))), []);
});

test("no line is drawn where a sounding is missing", () => {
  const holed = chart(4, 4, (x) => 8 + x / 50).filter(({ x, y }) => !(x === 100 && y === 100));
  for (const { points } of contours(holed)) for (const { x, y } of points) assert.ok(Number.isFinite(x + y));
});
