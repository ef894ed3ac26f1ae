// Dust, splash, mud, smoke, flames, sparks: sprites in two draws, one that covers and one that shines.

import {
  CustomBlending,
  DynamicDrawUsage,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  BufferAttribute,
  Mesh,
  OneFactor,
  OneMinusSrcAlphaFactor,
  ShaderMaterial,
  type Vector3,
} from "three";

const kMost = 400;
const kHides = 0.7; // of what is behind a flame: without, it would be white over bright steel

/** How a kind of particle is born and dies: s, m, m/s. */
export interface Puff {
  life: number;
  size: number;
  grows: number;
  /** m/s2 upwards, and share of its speed that is lost each second. */
  lift: number;
  drag: number;
  r: number;
  g: number;
  b: number;
  alpha: number;
  /** s of its way that are seen behind it; left out: none. */
  trail?: number;
}

export class Particles {
  readonly mesh: Mesh<InstancedBufferGeometry, ShaderMaterial>;
  private readonly place = new Float32Array(4 * kMost); // x y z size
  private readonly paint = new Float32Array(4 * kMost); // r g b alpha
  private readonly seed = Float32Array.from({ length: kMost }, (_, i) => (i * 0.618) % 1); // of its shape
  private readonly speed = new Float32Array(3 * kMost);
  private readonly age = new Float32Array(kMost).fill(1e9);
  private readonly born: (Puff | undefined)[] = Array.from({ length: kMost });
  private readonly shownPlace = new InstancedBufferAttribute(new Float32Array(4 * kMost), 4);
  private readonly shownPaint = new InstancedBufferAttribute(new Float32Array(4 * kMost), 4);
  private readonly shownTrail = new InstancedBufferAttribute(new Float32Array(3 * kMost), 3);
  private readonly shownSeed = new InstancedBufferAttribute(new Float32Array(kMost), 1);
  private next = 0;

  constructor(private readonly shines: boolean) {
    const geometry = new InstancedBufferGeometry();
    geometry.setAttribute(
      "position",
      new BufferAttribute(new Float32Array([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0]), 3),
    );
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    this.shownPlace.setUsage(DynamicDrawUsage);
    this.shownPaint.setUsage(DynamicDrawUsage);
    this.shownTrail.setUsage(DynamicDrawUsage);
    this.shownSeed.setUsage(DynamicDrawUsage);
    geometry.setAttribute("place", this.shownPlace);
    geometry.setAttribute("paint", this.shownPaint);
    geometry.setAttribute("trail", this.shownTrail);
    geometry.setAttribute("seed", this.shownSeed);
    geometry.instanceCount = 0;
    this.mesh = new Mesh(
      geometry,
      new ShaderMaterial({
        uniforms: { light: { value: 1 }, fogDensity: { value: 0 } },
        vertexShader: `
attribute vec4 place;
attribute vec4 paint;
attribute vec3 trail; // m that it came
attribute float seed;
varying vec2 vAt;
varying vec2 vShape;
varying vec4 vPaint;
varying float vDeep;
void main() {
  vAt = position.xy;
  float turn = 6.28 * seed;
  vShape = mat2(cos(turn), sin(turn), -sin(turn), cos(turn)) * position.xy * 1.7 + 37.0 * seed;
  vPaint = paint;
  vec4 p = viewMatrix * vec4(place.xyz, 1.0);
  vec2 came = (mat3(viewMatrix) * trail).xy;
  float far = length(came);
  vec2 on = far > 0.0 ? came / far : vec2(1.0, 0.0);
  p.xy += (position.x * place.w - (position.x < 0.0 ? far : 0.0)) * on + position.y * place.w * vec2(-on.y, on.x);
  vDeep = -p.z;
  gl_Position = projectionMatrix * p;
}`,
        fragmentShader: `
varying vec2 vAt;
varying vec2 vShape;
varying vec4 vPaint;
varying float vDeep;
uniform float light;
uniform float fogDensity;
float dot1(vec2 at) { return fract(sin(dot(at, vec2(12.9898, 78.233))) * 43758.5453); }
float lumps(vec2 at) {
  vec2 i = floor(at), f = fract(at);
  f *= f * (3.0 - 2.0 * f);
  return mix(mix(dot1(i), dot1(i + vec2(1.0, 0.0)), f.x), mix(dot1(i + vec2(0.0, 1.0)), dot1(i + 1.0), f.x), f.y);
}
void main() {
  float r = length(vAt) + 0.45 * (lumps(vShape) + 0.5 * lumps(2.3 * vShape) - 0.75); // torn at its edge
  if (r > 1.0) discard;
  r = max(r, 0.0);
  float soft = (1.0 - r) * (1.0 - r) * (1.0 + 2.0 * r);
  float clear = exp(-pow(fogDensity * vDeep, 2.0));
  float close = smoothstep(0.2, 1.2, vDeep);
  gl_FragColor = vec4(vPaint.rgb * light, vPaint.a * soft * clear * close);
  ${shines ? "" : "#include <tonemapping_fragment>"}
  #include <colorspace_fragment>
  ${shines ? `gl_FragColor *= vec4(vec3(gl_FragColor.a), ${kHides.toFixed(2)});` : ""}
}`,
        transparent: true,
        depthWrite: false,
        ...(shines ? { blending: CustomBlending, blendSrc: OneFactor, blendDst: OneMinusSrcAlphaFactor } : {}),
      }),
    );
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = shines ? 5 : 4;
    this.mesh.visible = false;
  }

  /** A new one at x y z (m from the origin) with a speed; the oldest gives way. */
  add(puff: Puff, x: number, y: number, z: number, vx: number, vy: number, vz: number): void {
    const i = this.next;
    this.next = (this.next + 1) % kMost;
    this.born[i] = puff;
    this.age[i] = 0;
    this.place.set([x, y, z, puff.size], 4 * i);
    this.paint.set([puff.r, puff.g, puff.b, puff.alpha], 4 * i);
    this.speed.set([vx, vy, vz], 3 * i);
  }

  /** Moves all by so many seconds, with the air's speed; light: on what does not shine. */
  step(seconds: number, windX: number, windY: number, light: number, fogDensity: number): void {
    const place = this.shownPlace.array as Float32Array;
    const paint = this.shownPaint.array as Float32Array;
    let n = 0;
    for (let i = 0; i < kMost; ++i) {
      const puff = this.born[i];
      if (!puff) continue;
      const age = (this.age[i]! += seconds);
      if (age >= puff.life) {
        this.born[i] = undefined;
        continue;
      }
      const lost = Math.min(1, puff.drag * seconds);
      const s = 3 * i;
      this.speed[s]! += (windX - this.speed[s]!) * lost;
      this.speed[s + 1]! += (windY - this.speed[s + 1]!) * lost;
      this.speed[s + 2]! += puff.lift * seconds - this.speed[s + 2]! * lost;
      const p = 4 * i;
      for (let k = 0; k < 3; ++k) this.place[p + k]! += this.speed[s + k]! * seconds;
      const t = age / puff.life;
      for (let k = 0; k < 3; ++k) {
        place[4 * n + k] = this.place[p + k]!;
        paint[4 * n + k] = this.paint[p + k]!;
        this.shownTrail.array[3 * n + k] = this.speed[s + k]! * (puff.trail ?? 0);
      }
      place[4 * n + 3] = puff.size + puff.grows * age;
      this.shownSeed.array[n] = this.seed[i]!;
      paint[4 * n + 3] = puff.alpha * Math.min(1, 8 * t) * (1 - t);
      ++n;
    }
    this.mesh.visible = n > 0;
    this.mesh.geometry.instanceCount = n;
    if (n === 0) return;
    for (const attribute of [this.shownPlace, this.shownPaint, this.shownTrail, this.shownSeed]) {
      attribute.clearUpdateRanges();
      attribute.addUpdateRange(0, attribute.itemSize * n);
      attribute.needsUpdate = true;
    }
    const u = this.mesh.material.uniforms;
    u.light!.value = this.shines ? 1 : light;
    u.fogDensity!.value = fogDensity;
  }

  /** Moves all by so much: the scene's origin was laid anew. */
  shift(by: Vector3): void {
    for (let i = 0; i < kMost; ++i) {
      this.place[4 * i]! += by.x;
      this.place[4 * i + 1]! += by.y;
      this.place[4 * i + 2]! += by.z;
    }
  }

  clear(): void {
    this.born.fill(undefined);
    this.next = 0;
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }
}
