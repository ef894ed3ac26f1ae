// A flag on the jackstaff: it tells the wind.

import { DoubleSide, Mesh, PlaneGeometry, ShaderMaterial } from "three";

const kLength = 1.5; // m
const kHoist = 1.0;

export class Flag {
  readonly mesh: Mesh<PlaneGeometry, ShaderMaterial>;

  constructor() {
    const geometry = new PlaneGeometry(kLength, kHoist, 16, 6);
    geometry.translate(kLength / 2, -kHoist / 2, 0);
    this.mesh = new Mesh(
      geometry,
      new ShaderMaterial({
        uniforms: { time: { value: 0 }, blows: { value: 0 }, light: { value: 1 } },
        vertexShader: `
uniform float time;
uniform float blows;
varying vec2 vAt;
varying float vShade;
void main() {
  vAt = uv;
  float far = position.x;
  float wave = sin(far * 5.5 - time * (3.0 + 6.0 * blows)) * 0.11 * far * (0.3 + blows);
  // a slack flag hangs
  float angle = mix(-1.35, -0.06, blows);
  vec3 p = vec3(far * cos(angle), wave, position.y + far * sin(angle));
  vShade = 0.82 + 0.25 * cos(far * 5.5 - time * (3.0 + 6.0 * blows)) * blows;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(p, 1.0);
}`,
        fragmentShader: `
varying vec2 vAt;
varying float vShade;
uniform float light;
void main() {
  // a white lozenge on green
  float edge = abs(vAt.x - 0.5) * 1.2 + abs(vAt.y - 0.5);
  vec3 c = edge < 0.34 ? vec3(0.82) : vec3(0.01, 0.16, 0.09);
  gl_FragColor = vec4(c * light * vShade, 1.0);
  #include <tonemapping_fragment>
  #include <colorspace_fragment>
}`,
        side: DoubleSide,
      }),
    );
    this.mesh.name = "flag";
  }

  /** wind: m/s over the deck; towards: rad, direction in the parent's plane; drift: s. */
  show(wind: number, towards: number, drift: number, light: number): void {
    this.mesh.rotation.z = towards;
    const u = this.mesh.material.uniforms;
    u.time!.value = drift;
    u.blows!.value = Math.min(1, Math.max(0, (wind - 1) / 9));
    u.light!.value = light;
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }
}
