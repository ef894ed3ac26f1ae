// What a vessel at anchor shows (COLREG 72, rule 30): a ball in her fore part by day; by night all-round white lights,
// forward and, lower, at the stern.

import { BufferGeometry, Group, Line, LineBasicMaterial, Mesh, Vector3 } from "three";
import type { SceneDescription } from "../wire/generated";
import { type Foremast, stayPlace } from "./foremast";
import { LampHalos } from "./lamp_halos";
import { type Materials, kPaint } from "./materials";
import { Solid } from "./solid";
import type { V3 } from "./vec";

const kBall = 0.3; // m, its radius: 0.6 m across at least (COLREG 72, annex I, 6)
const kHoisted = 0.25; // of the stay, from the mast
const kLower = 4.6; // m, of the after light below the forward one: 4.5 at least (annex I, 2 k)
const kByDay = 0.3; // how well a light is seen by day, of what it is by night; tuned
const kWhite: V3 = [1, 0.97, 0.9];

export class AnchorSignals {
  readonly group = new Group();
  private readonly ball: Mesh;
  private readonly lights: LampHalos;
  /** A line, which is a pixel wide however far it is: of a wire's breadth only dots would be left. */
  private readonly stay: Line<BufferGeometry, LineBasicMaterial>;

  constructor(scene: SceneDescription, mast: Foremast, materials: Materials) {
    const paint = materials.make({ vertexColors: true, roughness: 0.85 });
    const ball = new Solid();
    ball.ball(stayPlace(mast, kHoisted), kBall, kPaint.black);
    this.ball = new Mesh(ball.build(), paint);
    const aft: V3 = [-0.5 * scene.length_overall + 1.2, 0, mast.head[2] - kLower];
    this.lights = new LampHalos([mast.head, aft].map((at) => ({ at, size: 2.2, colour: kWhite })));
    const staff = new Solid();
    staff.bar([aft[0], 0, 0.5 * aft[2]], aft, 0.07, kPaint.white, 6, 0.04);
    const wire = new BufferGeometry().setFromPoints(mast.stay.map((p) => new Vector3(...p)));
    this.stay = new Line(wire, new LineBasicMaterial());
    this.group.add(new Mesh(staff.build(), paint), this.stay, this.ball, this.lights.mesh);
  }

  /** shown: as LightsAndShapes; the rest as of LampHalos. */
  show(
    shown: { anchor_ball: boolean; anchor_lights: boolean } | undefined,
    dark: number,
    pixels: number,
    fogDensity: number,
  ): void {
    this.ball.visible = shown?.anchor_ball ?? false;
    this.stay.material.color.setScalar(0.02 + 0.1 * (1 - dark));
    this.lights.show(shown?.anchor_lights ? Math.max(dark, kByDay) : 0, pixels, fogDensity);
  }

  dispose(): void {
    this.lights.dispose(); // the other meshes go with the ship's
    this.stay.material.dispose();
  }
}
