// A ship's outline at her waterline, cut from the hull's own mesh.

/**
 * The waterline of a hull mesh, body frame (x forward, y to port, z up from the waterline), as x, y, x, y ...
 * counterclockwise from above: the convex hull of where triangles cross z = 0. Empty where none does.
 * corners: x, y, z of each; triangles: three corners each.
 */
export function waterline(corners: Float32Array, triangles: Uint32Array): Float32Array {
  const points: [number, number][] = [];
  for (let t = 0; t + 2 < triangles.length; t += 3)
    for (let edge = 0; edge < 3; ++edge) {
      const a = 3 * triangles[t + edge]!;
      const b = 3 * triangles[t + ((edge + 1) % 3)]!;
      const za = corners[a + 2]!;
      const zb = corners[b + 2]!;
      if (za > 0 === zb > 0) continue;
      const share = za / (za - zb);
      points.push([
        corners[a]! + share * (corners[b]! - corners[a]!),
        corners[a + 1]! + share * (corners[b + 1]! - corners[a + 1]!),
      ]);
    }
  return new Float32Array(convex(points).flat());
}

/** Andrew's monotone chain. */
function convex(points: [number, number][]): [number, number][] {
  if (points.length < 3) return [];
  points.sort((p, q) => p[0] - q[0] || p[1] - q[1]);
  const half = (ordered: [number, number][]): [number, number][] => {
    const line: [number, number][] = [];
    for (const p of ordered) {
      while (line.length > 1 && turn(line.at(-2)!, line.at(-1)!, p) <= 0) line.pop();
      line.push(p);
    }
    line.pop();
    return line;
  };
  return [...half(points), ...half(points.slice().reverse())];
}

const turn = (a: [number, number], b: [number, number], c: [number, number]): number =>
  (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
