// Light by the time of day: sun or moon, sky, and how much of it; one set of colours for sky, sea and fog.

import { Color, Vector2, Vector3 } from "three";
import { clamp } from "./vec";

const kSunrise = 6; // h
const kDay = 12; // h, of light
const kNoonHeight = 52 * (Math.PI / 180);

export interface Daylight {
  /** Towards the sun, or at night the moon; world. */
  towards: Vector3;
  /** rad above the horizon; negative at night. */
  sunHeight: number;
  sun: Color;
  sunStrength: number;
  skyStrength: number;
  zenith: Color;
  /** All round, for the light that comes of it; where the sun stands or went down, and across from there. */
  horizon: Color;
  glow: Color;
  away: Color;
  /** Unit vector to below the sun, level; world. */
  sunwards: Vector2;
  ground: Color;
  /** Of the sea, straight down; and how much light falls on it. */
  deep: Color;
  onWater: number;
  /** 0 day .. 1 night: lamps are lit above 0.4. */
  dark: number;
}

/** Stops by the sun's height, degrees: zenith; horizon all round, below the sun, across from it; sun, strengths. */
const kStops: readonly (readonly [number, number, number, number, number, number, number, number])[] = [
  [-12, 0x050a16, 0x111a28, 0x161f2d, 0x0d1523, 0x9fb2d6, 0.14, 0.9],
  [-6, 0x0e1c38, 0x343645, 0x6f5149, 0x1c2a42, 0x9fb2d6, 0.16, 0.9],
  [-1, 0x2b4670, 0x9c8272, 0xf79e54, 0x56678a, 0xff9a5a, 0.25, 0.85],
  [4, 0x3a6299, 0xd2b594, 0xf6c486, 0x9db0c0, 0xffc48a, 1.2, 0.9],
  [14, 0x3f76b5, 0xc4d3da, 0xced7d5, 0xb9ccd9, 0xffe6c4, 2.3, 1.25],
  [40, 0x2f6bb0, 0xb9d0e0, 0xb9d0e0, 0xb9d0e0, 0xfff3e2, 2.9, 1.5],
];

/** seconds since local midnight; visibility: m, low ones make sky and sun grey; overcast: 0..1, of the sky. */
export function daylight(seconds: number, visibility: number, overcast = 0, out: Daylight = empty()): Daylight {
  const hour = seconds / 3600;
  const share = (hour - kSunrise) / kDay; // 0 at sunrise, 1 at sunset
  const height = kNoonHeight * Math.sin(Math.PI * share);
  const azimuth = Math.PI * (0.5 + share); // from east over south to west, clockwise from north
  out.sunHeight = height;
  const degrees = (height * 180) / Math.PI;
  let i = 1;
  while (i < kStops.length - 1 && degrees > kStops[i]![0]) ++i;
  const a = kStops[i - 1]!;
  const b = kStops[i]!;
  const t = clamp((degrees - a[0]) / (b[0] - a[0]), 0, 1);
  out.zenith.set(a[1]).lerp(kScratch.set(b[1]), t);
  out.horizon.set(a[2]).lerp(kScratch.set(b[2]), t);
  out.glow.set(a[3]).lerp(kScratch.set(b[3]), t);
  out.away.set(a[4]).lerp(kScratch.set(b[4]), t);
  out.sun.set(a[5]).lerp(kScratch.set(b[5]), t);
  out.sunStrength = a[6] + t * (b[6] - a[6]);
  out.skyStrength = a[7] + t * (b[7] - a[7]);
  const haze = clamp(1 - (visibility - 300) / 6000, 0, 1); // 1 in thick fog
  const grey = kScratch.setRGB(1, 1, 1).multiplyScalar(0.55 * luminance(out.horizon) + 0.45 * luminance(out.zenith));
  const dull = Math.max(haze, 0.7 * overcast); // what is left of colours
  for (const colour of [out.horizon, out.glow, out.away]) colour.lerp(grey, 0.8 * dull);
  out.zenith.lerp(out.horizon, Math.max(0.9 * haze, 0.35 * overcast));
  out.sunStrength *= 1 - 0.85 * Math.max(haze, 0.9 * overcast);
  out.skyStrength *= 1 + 0.25 * haze;
  out.ground.copy(out.horizon).multiply(kScratch.setRGB(0.42, 0.46, 0.46));
  const light = luminance(out.horizon) + 0.06 * out.sunStrength * Math.max(0, Math.sin(height));
  out.onWater = light;
  out.deep.setRGB(0.007, 0.04, 0.052).multiplyScalar(0.15 + 1.9 * light);
  out.dark = clamp(-(degrees - 1) / 7, 0, 1);
  out.sunwards.set(Math.sin(azimuth), Math.cos(azimuth));
  if (height > -0.03) direction(azimuth, Math.max(height, 0.02), out.towards);
  else direction(azimuth + Math.PI, clamp(-height, 0.35, 0.8), out.towards); // the moon stands across
  return out;
}

function direction(azimuth: number, height: number, out: Vector3): void {
  out.set(Math.sin(azimuth) * Math.cos(height), Math.cos(azimuth) * Math.cos(height), Math.sin(height));
}

/** A colour as it comes out on the screen's scale: fog is mixed behind the tone mapping (Khronos neutral). */
export function toneMapped(from: Color, out: Color): Color {
  const x = Math.min(from.r, from.g, from.b);
  const offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
  out.setRGB(from.r - offset, from.g - offset, from.b - offset);
  const start = 0.8 - 0.04;
  const peak = Math.max(out.r, out.g, out.b);
  if (peak < start) return out;
  const d = 1 - start;
  const now = 1 - (d * d) / (peak + d - start);
  out.multiplyScalar(now / peak);
  const grey = 1 - 1 / (0.15 * (peak - now) + 1);
  return out.lerp(kScratch.setRGB(now, now, now), grey);
}

const luminance = (c: Color): number => 0.21 * c.r + 0.72 * c.g + 0.07 * c.b;
const kScratch = new Color();

export function empty(): Daylight {
  return {
    towards: new Vector3(0, 0, 1),
    sunHeight: 1,
    sun: new Color(),
    sunStrength: 1,
    skyStrength: 1,
    zenith: new Color(),
    horizon: new Color(),
    glow: new Color(),
    away: new Color(),
    sunwards: new Vector2(0, 1),
    ground: new Color(),
    deep: new Color(),
    onWater: 1,
    dark: 0,
  };
}
