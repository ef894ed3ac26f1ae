// Textures that are computed: the same on every machine, nothing to load.

import {
  DataTexture,
  LinearFilter,
  LinearMipmapNearestFilter,
  RGBAFormat,
  RepeatWrapping,
  UnsignedByteType,
} from "three";

/** Numbers that look random, 0..1, the same each time. */
export function random(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = state;
    t = Math.imul(t ^ (t >>> 15), t | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

/** One level of its pyramid a pixel, not two: half the work of a processor, and few see it. */
function texture(data: Uint8Array, size: number): DataTexture {
  const made = new DataTexture(data, size, size, RGBAFormat, UnsignedByteType);
  made.wrapS = made.wrapT = RepeatWrapping;
  made.magFilter = LinearFilter;
  made.minFilter = LinearMipmapNearestFilter;
  made.generateMipmaps = true;
  made.needsUpdate = true;
  return made;
}

/** Tiling noise: red smooth (several octaves), green single dots, blue coarse. */
export function noiseTexture(size = 256): DataTexture {
  const next = random(7);
  const data = new Uint8Array(4 * size * size);
  const smooth = octaves(size, next, 4, 5);
  const coarse = octaves(size, next, 8, 3);
  for (let i = 0; i < size * size; ++i) {
    data[4 * i] = 255 * smooth[i]!;
    data[4 * i + 1] = next() > 0.985 ? 255 : 0;
    data[4 * i + 2] = 255 * coarse[i]!;
    data[4 * i + 3] = 255 * next();
  }
  return texture(data, size);
}

function octaves(size: number, next: () => number, cells: number, count: number): Float32Array {
  const sum = new Float32Array(size * size);
  let weight = 1;
  let total = 0;
  for (let o = 0, n = cells; o < count; ++o, n *= 2, weight *= 0.5) {
    const values = Float32Array.from({ length: n * n }, next);
    total += weight;
    for (let y = 0; y < size; ++y)
      for (let x = 0; x < size; ++x) {
        const u = (x / size) * n;
        const v = (y / size) * n;
        const i = Math.floor(u);
        const j = Math.floor(v);
        const ease = (t: number): number => t * t * (3 - 2 * t);
        const fu = ease(u - i);
        const fv = ease(v - j);
        const at = (a: number, b: number): number => values[(b % n) * n + (a % n)]!;
        const low = at(i, j) + fu * (at(i + 1, j) - at(i, j));
        const high = at(i, j + 1) + fu * (at(i + 1, j + 1) - at(i, j + 1));
        sum[y * size + x]! += weight * (low + fv * (high - low));
      }
  }
  for (let i = 0; i < sum.length; ++i) sum[i]! /= total;
  return sum;
}

/** Ripples that tile: red and green the slope (128 is none), blue the height. */
export function rippleTexture(size = 256): DataTexture {
  const next = random(23);
  const data = new Uint8Array(4 * size * size);
  const waves = Array.from({ length: 36 }, () => {
    const k = 2 + Math.floor(next() * 15);
    const angle = (next() - 0.5) * 2.4;
    const kx = Math.round(k * Math.cos(angle));
    const ky = Math.round(k * Math.sin(angle));
    return { kx, ky, a: 1 / (1 + Math.hypot(kx, ky)), phase: 2 * Math.PI * next() };
  });
  for (let y = 0; y < size; ++y)
    for (let x = 0; x < size; ++x) {
      let h = 0;
      let sx = 0;
      let sy = 0;
      for (const w of waves) {
        const p = (2 * Math.PI * (w.kx * x + w.ky * y)) / size + w.phase;
        h += w.a * Math.cos(p);
        sx -= w.a * w.kx * Math.sin(p);
        sy -= w.a * w.ky * Math.sin(p);
      }
      const i = 4 * (y * size + x);
      data[i] = Math.max(0, Math.min(255, 128 + 22 * sx));
      data[i + 1] = Math.max(0, Math.min(255, 128 + 22 * sy));
      data[i + 2] = Math.max(0, Math.min(255, 128 + 60 * h));
      data[i + 3] = 255;
    }
  return texture(data, size);
}
