// The sky as a dome behind everything: gradient, sun or moon, clouds, stars.

import { BackSide, Color, Mesh, ShaderMaterial, SphereGeometry, type Texture, Vector2, Vector3 } from "three";
import type { Daylight } from "./daylight";
import { kToScreen } from "./materials";

/** GLSL that gives the sky's colour in a direction; shared with the sea that mirrors it. */
export const kSkyColour = `
uniform vec3 zenith;
uniform vec3 glow;
uniform vec3 away;
uniform vec2 sunwards;
uniform vec3 fogGlow;
uniform vec3 sunColour;
uniform vec3 sunTowards;
uniform float sunStrength;
vec3 horizonColour(vec3 dir) {
  float side = 0.5 + 0.5 * dot(dir.xy, sunwards);
  return mix(away, glow, side * side);
}
vec3 hazeColour(vec3 dir) { return horizonColour(dir) + fogGlow; }
vec3 skyColour(vec3 dir) {
  float low = 1.0 - max(dir.z, 0.0);
  low *= low * low;
  float side = 0.5 + 0.5 * dot(dir.xy, sunwards);
  return mix(mix(zenith, away, low), glow, low * low * side * side); // the glow lies lower than the haze
}
`;

export interface SkyUniforms {
  [name: string]: { value: unknown };
}

/** Uniforms that sky and sea share: one object, set once a frame. */
export function skyUniforms(): SkyUniforms {
  return {
    zenith: { value: new Vector3() },
    glow: { value: new Vector3() },
    away: { value: new Vector3() },
    sunwards: { value: new Vector2(0, 1) },
    sunColour: { value: new Vector3() },
    sunTowards: { value: new Vector3(0, 0, 1) },
    sunStrength: { value: 1 },
    fogDensity: { value: 0 },
    fogGlow: { value: new Vector3() },
    deepWater: { value: new Vector3() },
    dark: { value: 0 },
  };
}

/** fogDensity: as of FogExp2; lit: what lamps add to the haze; water: that all is seen through, else air. */
export function setSky(uniforms: SkyUniforms, light: Daylight, fogDensity: number, lit: Color, water?: Color): void {
  const set = (name: string, c: Color): Vector3 => (uniforms[name]!.value as Vector3).set(c.r, c.g, c.b);
  set("zenith", light.zenith);
  set("glow", water ?? light.glow);
  set("away", water ?? light.away);
  set("fogGlow", water ? kNone : lit);
  set("deepWater", light.deep);
  (uniforms.sunwards!.value as Vector2).copy(light.sunwards);
  (uniforms.sunColour!.value as Vector3).set(light.sun.r, light.sun.g, light.sun.b);
  (uniforms.sunTowards!.value as Vector3).copy(light.towards);
  uniforms.sunStrength!.value = light.sunStrength;
  uniforms.fogDensity!.value = fogDensity;
  uniforms.dark!.value = light.dark;
}

const kNone = new Color(0, 0, 0);

export class Sky {
  readonly mesh: Mesh<SphereGeometry, ShaderMaterial>;

  constructor(uniforms: SkyUniforms, noise: Texture) {
    this.mesh = new Mesh(
      // its pole up; to a little below the horizon
      new SphereGeometry(10, 32, 12, 0, 2 * Math.PI, 0, 0.506 * Math.PI).rotateX(Math.PI / 2),
      new ShaderMaterial({
        uniforms: { ...uniforms, noise: { value: noise }, clouds: { value: 0 }, overcast: { value: 0 } },
        vertexShader: `
varying vec3 vDir;
void main() {
  vDir = position;
  gl_Position = projectionMatrix * vec4(mat3(viewMatrix) * position, 1.0);
  gl_Position.z = gl_Position.w; // behind everything
}`,
        fragmentShader: `
varying vec3 vDir;
uniform sampler2D noise;
uniform float dark;
uniform float fogDensity;
uniform float clouds;
uniform float overcast;
${kSkyColour}
${kToScreen}
void main() {
  vec3 dir = normalize(vDir);
  vec3 c = skyColour(dir);
  float near = dot(dir, sunTowards);
  float clear = exp2(-1300.0 * fogDensity);
  if (near > 0.6) {
    c += sunColour * sunStrength * (0.05 * exp2(8.0 * (near - 1.0)) + 0.12 * exp2(85.0 * (near - 1.0)));
    c += sunColour * clear * mix(9.0, 1.6, dark) * smoothstep(0.99988, 0.99994, near + 0.00003 * (1.0 - dark));
  }
  if (dir.z > 0.01) {
    vec2 p = dir.xy / (dir.z + 0.12);
    vec4 heap = texture2D(noise, p * 0.13 + clouds);
    float n = heap.r * 0.66 + heap.b * 0.34;
    float cover = smoothstep(0.5 - 0.4 * overcast, 0.72 - 0.3 * overcast, n) * smoothstep(0.01, 0.16, dir.z) * clear;
    float through = 0.75 - overcast * (0.6 * n - 0.1); // of the light, by how thick they are
    vec3 lit = horizonColour(dir) * through + sunColour * sunStrength * (0.1 + 0.06 * max(near, 0.0));
    c = mix(c, lit, mix(0.62, 0.95, overcast) * cover);
    if (dark > 0.2) {
      vec2 star = texture2D(noise, dir.xy * 2.5 / (1.0 + dir.z)).ga; // few are bright, many are faint
      float bright = star.y * star.y * star.y * smoothstep(0.55, 0.9, star.x);
      c += vec3(0.8, 0.85, 1.0) * dark * dark * clear * (1.0 - cover) * bright * star.y * star.y * star.y;
    }
  }
  // haze lies low
  if (fogDensity > 2e-4) {
    float through = fogDensity * 60.0 / (max(dir.z, 0.0) + 0.03);
    c = mix(hazeColour(dir), c, exp2(-1.4427 * through * through));
  }
  gl_FragColor = vec4(toScreen(c), 1.0);
}`,
        side: BackSide,
        depthWrite: false,
      }),
    );
    this.mesh.renderOrder = 1; // behind what is opaque: only what is left is painted
    this.mesh.frustumCulled = false;
  }

  /** time: s, that drive the clouds; overcast: 0..1, of the sky. */
  show(time: number, overcast: number): void {
    this.mesh.material.uniforms.overcast!.value = overcast;
    this.mesh.material.uniforms.clouds!.value = (time * 0.0006) % 1;
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }
}
