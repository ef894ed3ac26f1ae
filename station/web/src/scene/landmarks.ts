// The surroundings as one sees them: hills, a lighthouse, ships at anchor, and their lights by night.

import { Group, Mesh } from "three";
import { radians } from "../kit/units";
import { type AnchoredShip, type Light, type Surroundings, flashes } from "../surroundings/surroundings";
import { type Lamp, LampHalos } from "./lamp_halos";
import { type Materials } from "./materials";
import { Solid } from "./solid";
import type { V3 } from "./vec";

const kWhite: V3 = [1.8, 1.7, 1.45];
const kYellow: V3 = [1.7, 1.2, 0.6];

/** In the world's axes. */
export class Landmarks {
  readonly group = new Group();
  private readonly mesh: Mesh;
  private readonly shore: LampHalos; // what burns all night
  private readonly lights: readonly { light: Light; halo: LampHalos }[];

  constructor({ coasts, lamps, lights, ships }: Surroundings, materials: Materials) {
    const solid = new Solid();
    for (const { colour, shore, ridge } of coasts) hills(solid, shore, ridge, parseInt(colour.slice(1), 16));
    for (const light of lights) lighthouse(solid, light);
    for (const ship of ships) anchored(solid, ship);
    this.mesh = new Mesh(solid.build(), materials.make({ vertexColors: true, roughness: 1, metalness: 0 }));
    this.mesh.name = "landmarks";
    this.mesh.frustumCulled = false;
    this.shore = new LampHalos([
      ...lamps.map(([x, y, z]): Lamp => ({ at: [x!, y!, z!], size: 85, colour: kYellow })),
      ...ships.flatMap(anchorLights),
    ]);
    this.lights = lights.map((light) => ({
      light,
      halo: new LampHalos([{ at: [light.x, light.y, light.height], size: 320, colour: kWhite }]),
    }));
    this.group.add(this.mesh, this.shore.mesh, ...this.lights.map(({ halo }) => halo.mesh));
  }

  /** time: s, of the exercise; the rest as LampHalos.show() has it. */
  show(time: number, dark: number, pixels: number, fogDensity: number): void {
    this.shore.show(dark, pixels, fogDensity);
    for (const { light, halo } of this.lights) halo.show(flashes(light, time) ? dark : 0, pixels, fogDensity);
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.shore.dispose();
    for (const { halo } of this.lights) halo.dispose();
  }
}

/** A slope from the water's edge, of points x y, up to the ridge, of points x y z. */
function hills(solid: Solid, shore: number[][], ridge: number[][], colour: number): void {
  const foot = (k: number): V3 => [shore[k]![0]!, shore[k]![1]!, -2];
  const top = (k: number): V3 => [ridge[k]![0]!, ridge[k]![1]!, ridge[k]![2]!];
  for (let k = 0; k + 1 < ridge.length; ++k) solid.quad(top(k), foot(k), foot(k + 1), top(k + 1), colour);
}

function lighthouse(solid: Solid, { x, y, height }: Light): void {
  const gallery = height - 12;
  const lantern = height - 6; // its light stands clear of what it stands on
  solid.bar([x, y, -2], [x, y, gallery], 6, 0xe8e6de, 12, 4);
  solid.bar([x, y, 0.52 * gallery], [x, y, 0.7 * gallery], 5.3, 0xa8281e, 12, 5);
  solid.bar([x, y, gallery], [x, y, lantern], 3.2, 0x30363a, 10, 2.4);
}

function anchored(solid: Solid, { x, y, heading_deg, length, beam }: AnchoredShip): void {
  const heading = radians(heading_deg);
  solid.box([x, y, 3.5], [beam, length, 11], 0x20262c, -heading);
  const s = Math.sin(heading);
  const c = Math.cos(heading);
  const along = (share: number): [number, number] => [x + share * length * s, y + share * length * c];
  solid.box([...along(-0.39), 17], [0.85 * beam, 18, 16], 0xdcdcd4, -heading);
  solid.box([...along(-0.41), 27], [7, 8, 6], 0xc0562a, -heading);
  for (const share of [-0.17, 0.07, 0.3]) solid.bar([...along(share), 9], [...along(share), 24], 1, 0xb8a040, 6);
}

/** The higher forward, the lower aft, and deck lights (COLREG, rule 30). */
function anchorLights({ x, y, heading_deg, length }: AnchoredShip): Lamp[] {
  const s = length * Math.sin(radians(heading_deg));
  const c = length * Math.cos(radians(heading_deg));
  const lamp = (share: number, z: number, size: number, colour: V3): Lamp => ({
    at: [x + share * s, y + share * c, z],
    size,
    colour,
  });
  return [
    lamp(0.45, 26, 60, kWhite),
    lamp(-0.47, 16, 60, kWhite),
    ...[-0.35, -0.1, 0.15, 0.35].map((share) => lamp(share, 12, 40, kYellow)),
  ];
}
