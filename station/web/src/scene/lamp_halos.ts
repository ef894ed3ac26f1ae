// Lamps as one sees them by night: points of light with a halo that fog widens.

import { AdditiveBlending, BufferAttribute, BufferGeometry, Points, ShaderMaterial } from "three";
import type { V3 } from "./vec";

/** A lamp, m in the parent's frame; size: m of its halo in clear air; colour: linear. */
export interface Lamp {
  at: V3;
  size: number;
  colour: V3;
}

export class LampHalos {
  readonly mesh: Points<BufferGeometry, ShaderMaterial>;
  private readonly lit: BufferAttribute; // 0 or 1, of each

  constructor(lamps: readonly Lamp[]) {
    this.lit = new BufferAttribute(new Float32Array(lamps.length).fill(1), 1);
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(new Float32Array(lamps.flatMap((l) => l.at)), 3));
    geometry.setAttribute("paint", new BufferAttribute(new Float32Array(lamps.flatMap((l) => l.colour)), 3));
    geometry.setAttribute("size", new BufferAttribute(new Float32Array(lamps.map((l) => l.size)), 1));
    geometry.setAttribute("lit", this.lit);
    this.mesh = new Points(
      geometry,
      new ShaderMaterial({
        uniforms: { dark: { value: 0 }, pixels: { value: 1 }, fogDensity: { value: 0 } },
        vertexShader: `
attribute vec3 paint;
attribute float size;
attribute float lit;
uniform float pixels;
uniform float fogDensity;
varying vec3 vPaint;
void main() {
  vec4 seen = modelViewMatrix * vec4(position, 1.0);
  float far = -seen.z;
  vPaint = paint * exp(-0.7 * fogDensity * far);
  float wide = size * (1.0 + min(2.5, 260.0 * fogDensity));
  gl_PointSize = clamp(wide * pixels / far, 3.0, 220.0);
  gl_Position = lit > 0.5 ? projectionMatrix * seen : vec4(0.0, 0.0, 2.0, 1.0); // out of the picture
}`,
        fragmentShader: `
uniform float dark;
varying vec3 vPaint;
void main() {
  float r = 2.0 * length(gl_PointCoord - 0.5);
  float light = max(0.0, 1.0 - r);
  gl_FragColor = vec4(vPaint * dark * (0.3 * light * light + 1.2 * pow(light, 9.0)), 1.0);
}`,
        transparent: true,
        depthWrite: false,
        blending: AdditiveBlending,
      }),
    );
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = 6;
  }

  /** Switches one of them, by its number; all burn until told. */
  light(which: number, on: boolean): void {
    if (this.lit.getX(which) === Number(on)) return;
    this.lit.setX(which, Number(on));
    this.lit.needsUpdate = true;
  }

  /** Gives one of them another colour, by its number. */
  paint(which: number, colour: V3): void {
    const paints = this.mesh.geometry.getAttribute("paint");
    if (paints.getX(which) === Math.fround(colour[0]) && paints.getY(which) === Math.fround(colour[1])) return;
    paints.setXYZ(which, ...colour);
    paints.needsUpdate = true;
  }

  /** Moves one of them, by its number; m in the parent's frame. */
  move(which: number, at: V3): void {
    const places = this.mesh.geometry.getAttribute("position");
    places.setXYZ(which, ...at);
    places.needsUpdate = true;
  }

  /** dark: 0 day .. 1 night; pixels: of one radian; fogDensity: as of FogExp2. */
  show(dark: number, pixels: number, fogDensity: number): void {
    const u = this.mesh.material.uniforms;
    this.mesh.visible = dark > 0.2;
    u.dark!.value = dark;
    u.pixels!.value = pixels;
    u.fogDensity!.value = fogDensity;
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }
}
