// The sea: a grid round the eye that is raised by the server's waves, with ripples for looks.

import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  Mesh,
  ShaderMaterial,
  type Texture,
  Vector2,
  Vector3,
} from "three";
import type { SeaState } from "../wire/generated";
import { kToScreen } from "./materials";
import type { Quality } from "./quality";
import { kSkyColour, type SkyUniforms } from "./sky";
import { shaderWaves } from "./waves";

const kFar = 14000; // m
const kNear = 0.6; // m, of the innermost ring
const kWaves = 64;

export class Sea {
  readonly mesh: Mesh<BufferGeometry, ShaderMaterial>;
  private readonly waves = new Float32Array(4 * kWaves);
  private readonly uniforms;

  constructor(sky: SkyUniforms, ripples: Texture, noise: Texture, quality: Quality) {
    const full = quality.sea === "full";
    this.uniforms = {
      ...sky,
      ripples: { value: ripples },
      noise: { value: noise },
      waves: { value: this.waves },
      waveCount: { value: 0 },
      cell: { value: 0 },
      middle: { value: new Vector2() },
      time: { value: 0 },
      wind: { value: new Vector2(0, -1) },
      windSpeed: { value: 5 },
      origin: { value: new Vector2() },
      shipMiddle: { value: new Vector2() },
      shipAhead: { value: new Vector2(0, 1) },
      shipHalf: { value: new Vector3(1, 1, 0) },
      lamp: { value: new Vector3() },
      lampStrength: { value: 0 },
      light: { value: 1 },
      cover: { value: 1 },
    };
    const sectors = full ? 128 : 80;
    const rings = full ? 84 : 52;
    this.uniforms.cell.value = (2 * Math.PI) / sectors;
    this.mesh = new Mesh(
      polar(rings, sectors),
      new ShaderMaterial({
        uniforms: this.uniforms,
        defines: full ? { FULL: 1 } : {},
        vertexShader: kVertex,
        fragmentShader: kFragment,
        transparent: true,
        side: DoubleSide,
      }),
    );
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = 2;
  }

  /** The ship that lies in it: m from the origin, rad clockwise from north; half length, half breadth and height, m. */
  setShip(x: number, y: number, heading: number, half: readonly [number, number, number]): void {
    this.uniforms.shipMiddle.value.set(x, y);
    this.uniforms.shipAhead.value.set(Math.sin(heading), Math.cos(heading));
    this.uniforms.shipHalf.value.set(...half);
  }

  /**
   * eye: m, from the origin; origin: m, world; time: exercise s; drift: s, that drive the ripples; wind: m/s and rad
   * from; lamp: m from the origin, of the deck lights, and their strength; light: that falls on
   * the water, 1 about noon; cover: 1, less where one is to see through.
   */
  show(
    sea: SeaState | undefined,
    eye: Vector3,
    origin: readonly number[],
    time: number,
    drift: number,
    windSpeed: number,
    windFrom: number,
    lamp: Vector3,
    lampStrength: number,
    light: number,
    cover: number,
  ): void {
    const u = this.uniforms;
    u.waveCount.value = shaderWaves(sea, origin[0]!, origin[1]!, time, this.waves);
    u.middle.value.set(eye.x, eye.y);
    u.time.value = drift % 4096;
    u.wind.value.set(-Math.sin(windFrom), -Math.cos(windFrom));
    u.windSpeed.value = windSpeed;
    u.origin.value.set(origin[0]! % 512, origin[1]! % 512);
    u.lamp.value.copy(lamp);
    u.lampStrength.value = lampStrength;
    u.light.value = light;
    u.cover.value = cover;
    this.mesh.position.set(0, 0, -origin[2]!);
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }
}

/** Rings ever wider apart; x and y in position, z the cell's size. */
function polar(rings: number, sectors: number): BufferGeometry {
  const position = new Float32Array(3 * (rings * sectors + 1));
  const growth = Math.pow(kFar / kNear, 1 / (rings - 1));
  for (let r = 0; r < rings; ++r) {
    const radius = kNear * Math.pow(growth, r);
    for (let s = 0; s < sectors; ++s) {
      const a = (2 * Math.PI * (s + 0.5 * (r % 2))) / sectors;
      const i = 3 * (1 + r * sectors + s);
      position[i] = radius * Math.cos(a);
      position[i + 1] = radius * Math.sin(a);
      position[i + 2] = radius * Math.max(growth - 1, (2 * Math.PI) / sectors);
    }
  }
  const index: number[] = [];
  for (let s = 0; s < sectors; ++s) index.push(0, 1 + s, 1 + ((s + 1) % sectors));
  for (let r = 0; r + 1 < rings; ++r)
    for (let s = 0; s < sectors; ++s) {
      const next = (s + 1) % sectors;
      const a = 1 + r * sectors + s;
      const b = 1 + r * sectors + next;
      const c = 1 + (r + 1) * sectors + s;
      const d = 1 + (r + 1) * sectors + next;
      if (r % 2 === 0) index.push(a, c, b, b, c, d);
      else index.push(a, c, d, a, d, b);
    }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(position, 3));
  geometry.setIndex(index);
  return geometry;
}

const kVertex = `
uniform vec4 waves[${kWaves}];
uniform int waveCount;
uniform vec2 middle;
varying vec3 vPlace;
varying vec2 vSlope;
varying float vCrest;
void main() {
  vec2 at = middle + position.xy;
  float eta = 0.0;
  float energy = 0.0;
  vec2 slope = vec2(0.0);
  for (int i = 0; i < waveCount; ++i) {
    vec4 w = waves[i];
    // a wave shorter than two cells is left to the ripples
    float lambda = 6.2832 / max(length(w.xy), 1e-4);
    float keep = clamp((lambda / position.z - 2.0) * 0.5, 0.0, 1.0);
    float p = dot(w.xy, at) + w.z;
    float a = keep * w.w;
    eta += a * cos(p);
    slope -= a * w.xy * sin(p);
    energy += w.w * w.w;
  }
  vSlope = slope;
  vCrest = energy > 0.0 ? eta / sqrt(energy) : 0.0;
  vPlace = vec3(at, eta);
  gl_Position = projectionMatrix * viewMatrix * (modelMatrix * vec4(vPlace, 1.0));
}
`;

const kFragment = `
varying vec3 vPlace;
varying vec2 vSlope;
varying float vCrest;
uniform sampler2D ripples;
uniform sampler2D noise;
uniform float time;
uniform vec2 wind;
uniform float windSpeed;
uniform vec2 origin;
uniform float fogDensity;
uniform float dark;
uniform float light;
uniform float cover;
uniform vec3 lamp;
uniform vec3 deepWater;
uniform float lampStrength;
uniform vec2 shipMiddle;
uniform vec2 shipAhead;
uniform vec3 shipHalf;
${kSkyColour}
${kToScreen}
// how much of the light from there the ship keeps off: she is an upright wall round an ellipse
float behindShip(vec3 towards) {
  vec2 from = vPlace.xy - shipMiddle;
  vec2 port = vec2(-shipAhead.y, shipAhead.x);
  vec2 o = vec2(dot(from, shipAhead), dot(from, port)) / shipHalf.xy;
  vec2 d = vec2(dot(towards.xy, shipAhead), dot(towards.xy, port)) / shipHalf.xy;
  float a = max(dot(d, d), 1e-9), b = dot(o, d), o2 = dot(o, o);
  float passes = b < 0.0 ? o2 - b * b / a : o2; // the least distance from her middle, squared
  float far = max(0.0, (-b - sqrt(max(b * b - a * (o2 - 1.0), 0.0))) / a);
  return (1.0 - smoothstep(0.6, 1.0, passes)) *
    (1.0 - smoothstep(0.7, 1.3, (vPlace.z + far * towards.z) / max(shipHalf.z, 0.01)));
}
void main() {
  vec2 p = vPlace.xy + origin;
  vec2 across = vec2(-wind.y, wind.x);
  vec2 q = vec2(dot(p, wind), dot(p, across));
  vec2 r1 = texture2D(ripples, q * vec2(0.085, 0.06) - vec2(time * 0.055, 0.0)).rg - 0.5;
  vec2 r2 = texture2D(ripples, q.yx * vec2(0.021, 0.026) + vec2(0.0, -time * 0.021)).gr - 0.5;
#ifdef FULL
  r1 += 0.6 * (texture2D(ripples, q * 0.31 - vec2(time * 0.11, time * 0.03)).rg - 0.5);
#endif
  float rough = 0.22 + 0.06 * windSpeed;
  vec2 ripple = rough * (0.55 * r1 + 0.75 * r2);
  ripple = wind * ripple.x + across * ripple.y;
  vec3 toEye = cameraPosition - vPlace;
  float distance = length(toEye);
  vec3 v = toEye / distance;
  bool below = !gl_FrontFacing;
  vec3 n = normalize(vec3(-(vSlope + ripple), 1.0));
  if (below) n = -n;
  float facing = max(dot(n, v), 0.02);
  float low = 1.0 - facing;
  float low2 = low * low;
  float fresnel = 0.02 + 0.98 * low2 * low2 * low;
  // from afar one sees the waves' near faces, not the mirror
  fresnel *= 1.0 - 0.38 * clamp((distance - 30.0) * 0.0014, 0.0, 1.0);
  vec3 mirrored = reflect(-v, n);
  mirrored.z = abs(mirrored.z) + 0.02;
  mirrored = normalize(mirrored);
  float hull = behindShip(mirrored);
  vec3 sky = mix(skyColour(mirrored), deepWater * 0.8, hull);
  vec3 deep = deepWater * (1.0 - 0.4 * (1.0 - dark) * behindShip(sunTowards));
  deep += vec3(0.0, 0.03, 0.026) * light * clamp(0.5 + 0.7 * vCrest, 0.0, 1.5) * 0.6;
  // slopes towards the light are brighter, even straight down
  deep *= 1.0 + 1.6 * clamp(dot(ripple + vSlope, -sunTowards.xy), -0.35, 0.5);
  vec3 c = mix(deep, sky, fresnel);
  float glint = exp2(260.0 * (dot(mirrored, sunTowards) - 1.0));
  c += sunColour * sunStrength * glint * 0.9 * (1.0 - hull);
  // foam where it blows
  float caps = smoothstep(6.0, 20.0, windSpeed);
  if (caps > 0.0) {
    // crests that topple, and from force 7 threads of foam along the wind; from afar, what they come to
    float gusts = texture2D(noise, q * vec2(0.011, 0.019) - vec2(time * 0.004, 0.0)).r;
    float fine = texture2D(noise, (q + 1.4 * r1) * vec2(0.06, 0.36)).b;
    float lace = 0.5 * texture2D(noise, p * 0.29 + 0.1 * r2).b + 0.5 * fine;
    float foam = smoothstep(1.1 - 0.5 * caps, 1.5 - 0.4 * caps, vCrest + 1.2 * (gusts - 0.5) + 1.2 * r1.x) *
      smoothstep(0.4, 0.6, lace);
    float thread = 0.65 * texture2D(noise, (q + 1.2 * r1) * vec2(0.0065, 0.11)).r + 0.35 * gusts;
    float threads = smoothstep(0.49, 0.6, thread) * smoothstep(0.28, 0.64, fine);
    foam = max(foam, 0.75 * threads * smoothstep(12.0, 20.0, windSpeed));
    foam = mix(foam, 0.16 * caps, clamp(distance * 0.0012 - 0.2, 0.0, 0.9));
    c = mix(c, vec3(0.8) * (0.12 + light), 0.75 * foam * caps);
  }
  if (lampStrength > 0.0) {
    vec3 to = lamp - vPlace;
    // near by her own rail keeps them off
    float near = lampStrength / (1.0 + 0.0025 * dot(to, to)) * smoothstep(1.4, 2.2, length(to.xy) / max(to.z, 0.1));
    c += vec3(1.0, 0.9, 0.72) * near * (0.025 + 0.5 * exp2(58.0 * (dot(mirrored, normalize(to)) - 1.0)));
  }
  float alpha = 0.82 + 0.18 * min(1.0, 3.0 * fresnel);
  if (below) {
    // through the surface one sees the sky within a circle, beyond it the water mirrors itself
    float window = smoothstep(0.62, 0.72, dot(v, vec3(0.0, 0.0, -1.0)));
    c = mix(vec3(0.01, 0.09, 0.1), vec3(0.16, 0.42, 0.42), window) * (0.15 + 1.6 * light);
    alpha = 0.92;
  }
  float thick = fogDensity * distance;
  float fog = 1.0 - exp2(-1.4427 * thick * thick);
  c = mix(c, hazeColour(-v), fog);
  gl_FragColor = vec4(toScreen(c), mix(cover, 1.0, clamp(distance * 0.002 - 0.2, 0.0, 1.0)) * mix(alpha, 1.0, fog));
}
`;
