// Figures at the bow that tell how deep she lies: even metres, 10 cm high with their foot at the mark.

import {
  BufferAttribute,
  BufferGeometry,
  CanvasTexture,
  LinearMipmapLinearFilter,
  SRGBColorSpace,
  type Texture,
} from "three";
import type { SceneDescription } from "../wire/generated";
import type { V3 } from "./vec";

const kHigh = 0.34; // m; larger than painted, so that they are read from the water
const kWide = 0.62;
const kRows = 16;

/** A texture of the figures 0..15, one below the other. */
function figures(): Texture {
  const canvas = document.createElement("canvas");
  canvas.width = 64;
  canvas.height = 32 * kRows;
  const g = canvas.getContext("2d")!;
  g.fillStyle = "#fff";
  g.font = "bold 30px sans-serif";
  g.textAlign = "center";
  g.textBaseline = "middle";
  for (let n = 0; n < kRows; ++n) g.fillText(`${2 * n}M`, 32, 32 * n + 17, 60);
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  texture.minFilter = LinearMipmapLinearFilter;
  return texture;
}

/** m, body frame: the hull's port side at x and z, and its normal there; undefined off the hull. */
export function portSide(scene: SceneDescription, x: number, z: number): { y: number; normal: V3 } | undefined {
  const { hull_corners: c, hull_triangles: t } = scene;
  let best: { y: number; normal: V3 } | undefined;
  for (let i = 0; i + 2 < t.length; i += 3) {
    const [a, b, d] = [3 * t[i]!, 3 * t[i + 1]!, 3 * t[i + 2]!];
    const ux = c[b]! - c[a]!;
    const uz = c[b + 2]! - c[a + 2]!;
    const vx = c[d]! - c[a]!;
    const vz = c[d + 2]! - c[a + 2]!;
    const area = ux * vz - uz * vx;
    if (Math.abs(area) < 1e-9) continue;
    const p = ((x - c[a]!) * vz - (z - c[a + 2]!) * vx) / area;
    const q = (ux * (z - c[a + 2]!) - uz * (x - c[a]!)) / area;
    if (p < -1e-6 || q < -1e-6 || p + q > 1 + 1e-6) continue;
    const uy = c[b + 1]! - c[a + 1]!;
    const vy = c[d + 1]! - c[a + 1]!;
    const y = c[a + 1]! + p * uy + q * vy;
    if (y < 0 || (best && y <= best.y)) continue;
    const n: V3 = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    const l = Math.hypot(...n) * (n[1] < 0 ? -1 : 1) || 1;
    best = { y, normal: [n[0] / l, n[1] / l, n[2] / l] };
  }
  return best;
}

/** Quadrilaterals for both bows; their texture has white figures on nothing. */
export function draughtMarks(scene: SceneDescription): { geometry: BufferGeometry; texture: Texture } {
  const position: number[] = [];
  const uv: number[] = [];
  const index: number[] = [];
  for (let n = 1; n < kRows; ++n) {
    const z = 2 * n - scene.draught;
    if (z < -1.5 || z > 5) continue;
    const x = 0.5 * scene.length_overall - 6.5;
    const at = portSide(scene, x, z + kHigh / 2);
    if (!at) continue;
    const [nx, ny, nz] = at.normal;
    const l = Math.hypot(nx, ny) || 1;
    const right: V3 = [-ny / l, nx / l, 0]; // seen from outside to port: towards the stern
    const up: V3 = [-(nz * nx) / l, -(nz * ny) / l, l];
    for (const side of [1, -1]) {
      const from = position.length / 3;
      for (const [u, v] of [
        [0, 0],
        [1, 0],
        [1, 1],
        [0, 1],
      ] as const) {
        const a = (u - 0.5) * kWide * side;
        const b = (v - 0.5) * kHigh;
        const p = [0, 1, 2].map(
          (k) => [x, at.y, z + kHigh / 2][k]! + a * right[k]! + b * up[k]! + 0.02 * at.normal[k]!,
        );
        position.push(p[0]!, side * p[1]!, p[2]!);
        uv.push(u, 1 - (n + 1 - v) / kRows);
      }
      index.push(from, from + 1, from + 2, from, from + 2, from + 3);
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(position), 3));
  geometry.setAttribute("uv", new BufferAttribute(new Float32Array(uv), 2));
  geometry.setIndex(index);
  return { geometry, texture: figures() };
}
