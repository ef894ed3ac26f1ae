// Small vectors and the ship's pose, without a graphics library, so that places can be tested by themselves.

export type V3 = readonly [number, number, number];

export const add = (a: V3, b: V3): V3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const sub = (a: V3, b: V3): V3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scale = (k: number, a: V3): V3 => [k * a[0], k * a[1], k * a[2]];
export const along = (a: V3, k: number, b: V3): V3 => [a[0] + k * b[0], a[1] + k * b[1], a[2] + k * b[2]];
export const dot = (a: V3, b: V3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a: V3, b: V3): V3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
export const length = (a: V3): number => Math.hypot(a[0], a[1], a[2]);
export const unit = (a: V3): V3 => scale(1 / (length(a) || 1), a);
/** Its share along the deck, unit length. */
export const level = (a: V3): V3 => unit([a[0], a[1], 0]);
export const vec = (p: { x: number; y: number; z: number }): V3 => [p.x, p.y, p.z];

export const clamp = (x: number, min: number, max: number): number => Math.min(max, Math.max(min, x));
/** x modulo m, 0 <= x < m. */
export const wrap = (x: number, m: number): number => x - m * Math.floor(x / m);

/** Where the ship is and how she lies. */
export interface ShipPose {
  x: number;
  y: number;
  z: number;
  heading: number;
  roll: number;
  pitch: number;
}

/**
 * Rotation from the body frame (x forward, y to port, z up) to the world, row by row: heading, then pitch bow up,
 * then roll starboard down.
 */
export function shipAxes(pose: ShipPose, out: Float64Array = new Float64Array(9)): Float64Array {
  const ch = Math.cos(pose.heading);
  const sh = Math.sin(pose.heading);
  const cp = Math.cos(pose.pitch);
  const sp = Math.sin(pose.pitch);
  const cr = Math.cos(pose.roll);
  const sr = Math.sin(pose.roll);
  // forward, port and up in the world, before roll
  const fx = sh * cp;
  const fy = ch * cp;
  const px = -ch;
  const py = sh;
  const ux = -sh * sp;
  const uy = -ch * sp;
  // a roll about the forward axis lowers starboard: port rises
  out[0] = fx;
  out[3] = fy;
  out[6] = sp;
  out[1] = cr * px + sr * ux;
  out[4] = cr * py + sr * uy;
  out[7] = sr * cp;
  out[2] = -sr * px + cr * ux;
  out[5] = -sr * py + cr * uy;
  out[8] = cr * cp;
  return out;
}

/** A body vector in the world. */
export const turned = (axes: Float64Array, b: V3): V3 => [
  axes[0]! * b[0] + axes[1]! * b[1] + axes[2]! * b[2],
  axes[3]! * b[0] + axes[4]! * b[1] + axes[5]! * b[2],
  axes[6]! * b[0] + axes[7]! * b[1] + axes[8]! * b[2],
];
