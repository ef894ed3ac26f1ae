// The seabed round the cable, coloured by soil.

import { BufferAttribute, BufferGeometry, Color, Mesh, type Texture } from "three";
import { Soil, type SeabedDescription } from "../wire/generated";
import { bedHeight, soilAt } from "./ground";
import { type Materials } from "./materials";

const kCells = 72;
const kCell = 2.5; // m

const kSoilColour: Record<Soil, number> = {
  [Soil.SOIL_MUD]: 0x4d4636,
  [Soil.SOIL_SAND]: 0xa08f68,
  [Soil.SOIL_CLAY]: 0x6a6358,
  [Soil.SOIL_GRAVEL]: 0x78746a,
  [Soil.SOIL_ROCK]: 0x54544f,
  [Soil.SOIL_CORAL]: 0x9a7f74,
  [Soil.SOIL_MIXED]: 0x6f664c,
};

const kGrains = `
uniform sampler2D grain;
uniform sampler2D ripples;
uniform float drift;
vec3 paint(vec3 colour, vec3 place) {
  vec2 p = place.xy * 0.12;
  colour *= 0.55 + 0.9 * texture2D(grain, p * 1.1).r;
  // light that the waves gather
  float a = texture2D(ripples, p * 0.31 + vec2(drift * 0.021, drift * 0.013)).b;
  float b = texture2D(ripples, p * 0.27 - vec2(drift * 0.017, -drift * 0.019)).b;
  return colour * (0.85 + 0.75 * smoothstep(0.12, 0.0, abs(a - b)));
}
`;

export class Seabed {
  readonly mesh: Mesh;
  private readonly position = new Float32Array(3 * (kCells + 1) ** 2);
  private readonly colour = new Float32Array(3 * (kCells + 1) ** 2);
  private bed: SeabedDescription | undefined;
  private laidAt = "";
  /** m, of the water's surface, which is z = 0, over the datum from which the bed is counted. */
  tide = 0;
  private readonly drift = { value: 0 };

  constructor(materials: Materials, noise: Texture, ripples: Texture) {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(this.position, 3));
    geometry.setAttribute("normal", new BufferAttribute(new Float32Array(this.position.length), 3));
    geometry.setAttribute("color", new BufferAttribute(this.colour, 3));
    const index: number[] = [];
    for (let i = 0; i < kCells; ++i)
      for (let j = 0; j < kCells; ++j) {
        const a = i * (kCells + 1) + j;
        const b = a + kCells + 1;
        index.push(a, b, b + 1, a, b + 1, a + 1);
      }
    geometry.setIndex(index);
    const material = materials.make(
      { vertexColors: true, roughness: 1, metalness: 0 },
      {
        name: "seabed",
        uniforms: { grain: { value: noise }, ripples: { value: ripples }, drift: this.drift },
        glsl: kGrains,
      },
    );
    this.mesh = new Mesh(geometry, material);
    this.mesh.frustumCulled = false;
    this.mesh.visible = false;
  }

  set(bed: SeabedDescription | undefined): void {
    this.bed = bed;
    this.laidAt = "";
  }

  /** Whether the ground is known. */
  get known(): boolean {
    return this.bed !== undefined;
  }
  /** m, world. */
  height(x: number, y: number): number {
    return this.bed ? bedHeight(this.bed, x, y) - this.tide : -Infinity;
  }
  soil(x: number, y: number): Soil {
    return this.bed ? soilAt(this.bed, x, y) : Soil.SOIL_SAND;
  }
  soilColour(x: number, y: number): number {
    return kSoilColour[this.soil(x, y)];
  }

  /** Lays the patch round a place (m, world); visible only from under water. drift: s, that drive the light on it. */
  show(x: number, y: number, origin: readonly number[], visible: boolean, drift: number): void {
    this.drift.value = drift % 1000;
    this.mesh.visible = visible && this.bed !== undefined;
    if (!this.mesh.visible || !this.bed) return;
    const step = 8 * kCell;
    const cx = step * Math.round(x / step);
    const cy = step * Math.round(y / step);
    this.mesh.position.set(cx - origin[0]!, cy - origin[1]!, -this.tide - origin[2]!);
    const key = `${cx},${cy}`;
    if (key === this.laidAt) return;
    this.laidAt = key;
    const paint = new Color();
    for (let i = 0; i <= kCells; ++i)
      for (let j = 0; j <= kCells; ++j) {
        const dx = (i - kCells / 2) * kCell;
        const dy = (j - kCells / 2) * kCell;
        const n = i * (kCells + 1) + j;
        this.position.set([dx, dy, bedHeight(this.bed, cx + dx, cy + dy)], 3 * n);
        paint.set(kSoilColour[soilAt(this.bed, cx + dx, cy + dy) as Soil]);
        this.colour.set([paint.r, paint.g, paint.b], 3 * n);
      }
    const geometry = this.mesh.geometry;
    geometry.getAttribute("position").needsUpdate = true;
    geometry.getAttribute("color").needsUpdate = true;
    geometry.computeVertexNormals();
  }

  dispose(): void {
    this.mesh.geometry.dispose();
  }
}
