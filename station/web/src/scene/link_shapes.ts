// A stud link as geometry, chain diameter 1: x along the cable, y across the link, z through it. Outside length 6,
// width 3.6.

import { BufferAttribute, BufferGeometry } from "three";

const kHalfStraight = 1.2; // of the bars' centre lines
const kRound = 1.3; // radius of the ends' centre lines

/** A tube along a closed line. around: points of the line, section: of the tube; stud: sides of the stud, 0 none. */
export function studLink(around: number, section: number, stud: number, wire = 0.5): BufferGeometry {
  const positions: number[] = [];
  const normals: number[] = [];
  const indices: number[] = [];
  for (let i = 0; i < around; ++i) {
    const { x, y, nx, ny } = centreLine(i / around);
    for (let k = 0; k < section; ++k) {
      const a = (2 * Math.PI * (k + 0.5)) / section;
      const c = Math.cos(a);
      const s = Math.sin(a);
      positions.push(x + wire * c * nx, y + wire * c * ny, wire * s);
      normals.push(c * nx, c * ny, s);
      const here = i * section + k;
      const next = ((i + 1) % around) * section + k;
      const kNext = k + 1 === section ? 1 - section : 1;
      indices.push(here, next, next + kNext, here, next + kNext, here + kNext);
    }
  }
  const from = positions.length / 3;
  const last = stud > 0 ? stud : -1;
  for (let k = 0; k <= last; ++k) {
    const a = (2 * Math.PI * k) / stud;
    const c = Math.cos(a);
    const s = Math.sin(a);
    // thicker where it meets the bars
    for (const [y, radius] of [
      [-1.1, 0.48],
      [0, 0.3],
      [1.1, 0.48],
    ] as const) {
      positions.push(radius * c, y, radius * s);
      normals.push(c, 0, s);
    }
    if (k === 0) continue;
    const here = from + 3 * k;
    for (const row of [0, 1])
      indices.push(here - 3 + row, here - 2 + row, here + 1 + row, here - 3 + row, here + 1 + row, here + row);
  }
  return geometry(positions, normals, indices);
}

/** Place and outward direction of a link's centre line, t 0..1 round it, with more points on the ends. */
function centreLine(t: number): { x: number; y: number; nx: number; ny: number } {
  const ends = 0.76; // share of the points that lie on the round ends
  const half = t < 0.5 ? t * 2 : t * 2 - 1;
  const sign = t < 0.5 ? 1 : -1;
  if (half < ends) {
    const a = (half / ends - 0.5) * Math.PI;
    return {
      x: sign * (kHalfStraight + kRound * Math.cos(a)),
      y: sign * kRound * Math.sin(a),
      nx: sign * Math.cos(a),
      ny: sign * Math.sin(a),
    };
  }
  const share = (half - ends) / (1 - ends);
  return { x: sign * kHalfStraight * (1 - 2 * share), y: sign * kRound, nx: 0, ny: sign };
}

/** What is left of a link far away: a flat bar with eight sides at most. */
export function farLink(): BufferGeometry {
  const positions: number[] = [];
  const normals: number[] = [];
  const indices: number[] = [];
  const corners = [
    [1.5, 0.45],
    [-1.5, 0.45],
    [-1.5, -0.45],
    [1.5, -0.45],
  ] as const;
  for (const x of [-2.1, 2.1])
    for (const [y, z] of corners) {
      const l = Math.hypot(y, z);
      positions.push(x, y, z);
      normals.push(0, y / l, z / l);
    }
  for (let k = 0; k < 4; ++k) {
    const next = (k + 1) % 4;
    indices.push(k, next, next + 4, k, next + 4, k + 4);
  }
  return geometry(positions, normals, indices);
}

/** What the eye keeps of plain links that run by: streaks of their bars, flat and on edge, one pitch long. */
export function linkStreaks(sides = 5): BufferGeometry {
  const positions: number[] = [];
  const normals: number[] = [];
  const indices: number[] = [];
  const bars = [
    [kRound, 0, 0.38],
    [-kRound, 0, 0.38],
    [0, kRound, 0.38],
    [0, -kRound, 0.38],
    [0, 0, 0.85], // studs and bows
  ] as const;
  for (const [y, z, wire] of bars) {
    const from = positions.length / 3;
    for (let k = 0; k < sides; ++k) {
      const [c, s] = [Math.cos((2 * Math.PI * k) / sides), Math.sin((2 * Math.PI * k) / sides)];
      for (const x of [-2.05, 2.05]) {
        positions.push(x, y + wire * c, z + wire * s);
        normals.push(0, c, s);
      }
      const [here, next] = [from + 2 * k, from + 2 * ((k + 1) % sides)];
      indices.push(here, here + 1, next + 1, here, next + 1, next);
    }
  }
  return geometry(positions, normals, indices);
}

/** Seizing wire, a few turns round the stud of a white link. */
export function seizing(): BufferGeometry {
  const positions: number[] = [];
  const normals: number[] = [];
  const indices: number[] = [];
  const sides = 8;
  const rings = 6;
  for (let r = 0; r <= rings; ++r)
    for (let k = 0; k < sides; ++k) {
      const a = (2 * Math.PI * k) / sides;
      const radius = r % 2 === 0 ? 0.5 : 0.43;
      positions.push(radius * Math.cos(a), -0.55 + (1.1 * r) / rings, radius * Math.sin(a));
      normals.push(Math.cos(a), 0, Math.sin(a));
      if (r === 0) continue;
      const here = r * sides + k;
      const kNext = k + 1 === sides ? 1 - sides : 1;
      indices.push(here - sides, here, here + kNext, here - sides, here + kNext, here - sides + kNext);
    }
  return geometry(positions, normals, indices);
}

function geometry(positions: number[], normals: number[], indices: number[]): BufferGeometry {
  const made = new BufferGeometry();
  made.setAttribute("position", new BufferAttribute(new Float32Array(positions), 3));
  made.setAttribute("normal", new BufferAttribute(new Float32Array(normals), 3));
  made.setIndex(indices);
  return made;
}
