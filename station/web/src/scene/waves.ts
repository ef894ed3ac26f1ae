// The surface as the server has it: a sum of components. Pure: eta and its slopes at a place, and the phases for a
// shader that counts from the scene's origin.

import type { SeaState } from "../wire/generated";
import { clamp } from "./vec";

/** m, amplitude of a component at t: a straight line over the ramp. */
export function amplitude(sea: SeaState, i: number, t: number): number {
  const c = sea.components[i]!;
  const long = sea.ramp_end - sea.ramp_begin;
  const share = long > 0 ? clamp((t - sea.ramp_begin) / long, 0, 1) : t >= sea.ramp_end ? 1 : 0;
  return c.amplitude_before + share * (c.amplitude_after - c.amplitude_before);
}

/** m, height of the surface at x, y (world) and t (s). */
export function surface(sea: SeaState | undefined, x: number, y: number, t: number): number {
  if (!sea) return 0;
  let eta = 0;
  sea.components.forEach((c, i) => {
    eta += amplitude(sea, i, t) * Math.cos(c.k_x * x + c.k_y * y - c.omega * t + c.phase);
  });
  return eta;
}

/** m, significant height: four times the standard deviation. */
export function significantHeight(sea: SeaState | undefined, t: number): number {
  const energy = sea?.components.reduce((sum, _, i) => sum + amplitude(sea, i, t) ** 2, 0) ?? 0;
  return 4 * Math.sqrt(energy / 2);
}

/**
 * Components for a shader, four numbers each: k_x, k_y, phase at the origin (reduced, so that single precision holds
 * it), amplitude. The largest first; returns how many.
 */
export function shaderWaves(sea: SeaState | undefined, x0: number, y0: number, t: number, out: Float32Array): number {
  if (!sea) return 0;
  const most = Math.floor(out.length / 4);
  let n = 0;
  for (let i = 0; i < sea.components.length && n < most; ++i) {
    const c = sea.components[i]!;
    const a = amplitude(sea, i, t);
    if (a === 0) continue;
    const phase = c.k_x * x0 + c.k_y * y0 - c.omega * t + c.phase;
    out[4 * n] = c.k_x;
    out[4 * n + 1] = c.k_y;
    out[4 * n + 2] = phase - 2 * Math.PI * Math.round(phase / (2 * Math.PI));
    out[4 * n + 3] = a;
    ++n;
  }
  return n;
}
