// The sky as a dome behind everything: gradient, sun or moon, clouds, stars.

import { BackSide, type Color, Mesh, ShaderMaterial, SphereGeometry, Vector3, type Texture } from "three";
import type { Daylight } from "./daylight";
import { kToScreen } from "./materials";

/** GLSL that gives the sky's colour in a direction; shared with the sea that mirrors it. */
export const kSkyColour = `
uniform vec3 zenith;
uniform vec3 horizon;
uniform vec3 sunColour;
uniform vec3 sunTowards;
uniform float sunStrength;
vec3 skyColour(vec3 dir) {
  float low = 1.0 - max(dir.z, 0.0);
  return mix(zenith, horizon, low * low * low);
}
`;

export interface SkyUniforms {
  [name: string]: { value: unknown };
}

/** Uniforms that sky and sea share: one object, set once a frame. */
export function skyUniforms(): SkyUniforms {
  return {
    zenith: { value: new Vector3() },
    horizon: { value: new Vector3() },
    sunColour: { value: new Vector3() },
    sunTowards: { value: new Vector3(0, 0, 1) },
    sunStrength: { value: 1 },
    fogDensity: { value: 0 },
    fogTint: { value: new Vector3() },
    deepWater: { value: new Vector3() },
    dark: { value: 0 },
  };
}

/** fogDensity: as of FogExp2; fog: its colour, of haze or water; deep: of the water straight down. */
export function setSky(uniforms: SkyUniforms, light: Daylight, fogDensity: number, fog: Color, deep: Color): void {
  (uniforms.fogTint!.value as Vector3).set(fog.r, fog.g, fog.b);
  (uniforms.deepWater!.value as Vector3).set(deep.r, deep.g, deep.b);
  (uniforms.zenith!.value as Vector3).set(light.zenith.r, light.zenith.g, light.zenith.b);
  (uniforms.horizon!.value as Vector3).set(light.horizon.r, light.horizon.g, light.horizon.b);
  (uniforms.sunColour!.value as Vector3).set(light.sun.r, light.sun.g, light.sun.b);
  (uniforms.sunTowards!.value as Vector3).copy(light.towards);
  uniforms.sunStrength!.value = light.sunStrength;
  uniforms.fogDensity!.value = fogDensity;
  uniforms.dark!.value = light.dark;
}

export class Sky {
  readonly mesh: Mesh<SphereGeometry, ShaderMaterial>;

  constructor(uniforms: SkyUniforms, noise: Texture) {
    this.mesh = new Mesh(
      // its pole up; to a little below the horizon
      new SphereGeometry(10, 32, 12, 0, 2 * Math.PI, 0, 0.506 * Math.PI).rotateX(Math.PI / 2),
      new ShaderMaterial({
        uniforms: { ...uniforms, noise: { value: noise }, clouds: { value: 0 } },
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
uniform vec3 fogTint;
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
    float cover = smoothstep(0.5, 0.72, n) * smoothstep(0.01, 0.16, dir.z) * clear;
    vec3 lit = horizon * 0.75 + sunColour * sunStrength * (0.1 + 0.06 * max(near, 0.0));
    c = mix(c, lit, 0.62 * cover);
    if (dark > 0.2) {
      float star = texture2D(noise, dir.xy * 5.0 / (1.0 + dir.z)).g;
      c += vec3(0.8, 0.85, 1.0) * dark * dark * clear * (1.0 - cover) * smoothstep(0.965, 1.0, star) * 0.7;
    }
  }
  // haze lies low
  if (fogDensity > 2e-4) {
    float through = fogDensity * 60.0 / (max(dir.z, 0.0) + 0.03);
    c = mix(fogTint, c, exp2(-1.4427 * through * through));
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

  /** time: s, that drive the clouds. */
  show(time: number): void {
    this.mesh.material.uniforms.clouds!.value = (time * 0.0006) % 1;
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }
}
