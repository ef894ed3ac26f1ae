// Samples that come at their own times, drawn at another: which two to draw between.

import type { Heard } from "../wire/connection";

const kBreak = 0.5; // s of wall or exercise time, across which nothing is interpolated

/** Two samples of a stream and how far between them, 0..1; the same one twice where there is nothing between. */
export interface Between<T> {
  from: T;
  to: T;
  share: number;
  /** s, exercise time that is drawn. */
  time: number;
}

interface Timed {
  time: number;
  tick: number;
}

/** now: ms of performance.now(). Drawn late by one and a half of the intervals at which samples come. */
export function between<T extends Timed>(track: readonly Heard<T>[], now: number): Between<T> | undefined {
  const n = track.length;
  if (n === 0) return undefined;
  const last = track[n - 1]!;
  const only = { from: last.sample, to: last.sample, share: 0, time: last.sample.time };
  // The unbroken run at the end: no tick back (restore, seek), no gap.
  let first = n - 1;
  while (first > 0 && n - first < 40 && joined(track[first - 1]!, track[first]!)) --first;
  const count = n - first;
  if (count < 2) return only;
  // Exercise time against the clock on the wall, evened out over the run: samples come in bunches.
  let at = 0;
  let time = 0;
  for (let i = first; i < n; ++i) {
    at += track[i]!.at / count;
    time += track[i]!.sample.time / count;
  }
  let both = 0;
  let square = 0;
  for (let i = first; i < n; ++i) {
    both += (track[i]!.at - at) * (track[i]!.sample.time - time);
    square += (track[i]!.at - at) ** 2;
  }
  const rate = square > 0 ? Math.max(0, both / square) : 0; // s a ms
  const span = (last.sample.time - track[first]!.sample.time) / (count - 1);
  const drawn = Math.min(last.sample.time, time + rate * (now - at) - 1.5 * span);
  for (let i = n - 1; i > first; --i) {
    const from = track[i - 1]!.sample;
    const to = track[i]!.sample;
    if (from.time > drawn) continue;
    const share = to.time > from.time ? Math.min(1, (drawn - from.time) / (to.time - from.time)) : 1;
    return { from, to, share, time: drawn };
  }
  const begin = track[first]!.sample;
  return { from: begin, to: begin, share: 0, time: begin.time };
}

function joined(a: Heard<Timed>, b: Heard<Timed>): boolean {
  return b.sample.tick >= a.sample.tick && b.at - a.at < 1000 * kBreak && b.sample.time - a.sample.time <= kBreak;
}

/** The sample at an exercise time that another stream is drawn at. */
export function atTime<T extends Timed>(track: readonly Heard<T>[], time: number): Between<T> | undefined {
  const n = track.length;
  if (n === 0) return undefined;
  for (let i = n - 1; i > 0; --i) {
    const a = track[i - 1]!;
    const b = track[i]!;
    if (!joined(a, b)) break;
    if (a.sample.time > time) continue;
    const share =
      b.sample.time > a.sample.time ? Math.min(1, (time - a.sample.time) / (b.sample.time - a.sample.time)) : 1;
    return { from: a.sample, to: b.sample, share, time };
  }
  const last = track[n - 1]!.sample;
  return { from: last, to: last, share: 0, time: last.time };
}

export const mix = (a: number, b: number, t: number): number => a + t * (b - a);

/** Angles the short way. */
export function mixAngle(a: number, b: number, t: number): number {
  const turn = 2 * Math.PI;
  const by = b - a - turn * Math.round((b - a) / turn);
  return a + t * by;
}

/** Angles of what turned by about `expected` (rad) meanwhile: more than half a turn, where samples are far apart. */
export function mixTurning(a: number, b: number, t: number, expected: number): number {
  const turn = 2 * Math.PI;
  const by = b - a;
  return a + t * (by + turn * Math.round((expected - by) / turn));
}

/** Nodes between two samples; as many as the later one has. Kept in `out` where it is long enough. */
export function mixNodes(a: Float32Array, b: Float32Array, t: number, out: Float32Array): Float32Array {
  if (a.length !== b.length) return b;
  const to = out.length === b.length ? out : new Float32Array(b.length);
  for (let i = 0; i < b.length; ++i) to[i] = a[i]! + t * (b[i]! - a[i]!);
  return to;
}

interface Turn {
  w: number;
  x: number;
  y: number;
  z: number;
}

/** Between two attitudes a little apart; unit length. */
export function mixTurn(a: Turn, b: Turn, t: number): Turn {
  const same = a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z < 0 ? -1 : 1;
  const w = mix(a.w, same * b.w, t);
  const x = mix(a.x, same * b.x, t);
  const y = mix(a.y, same * b.y, t);
  const z = mix(a.z, same * b.z, t);
  const l = Math.hypot(w, x, y, z) || 1;
  return { w: w / l, x: x / l, y: y / l, z: z / l };
}
