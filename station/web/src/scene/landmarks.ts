// The surroundings as one sees them: hills, what bearings are taken of, ships at anchor, and their lights by night.

import { Group, Mesh } from "three";
import { buoyOf } from "../surroundings/buoyage";
import { colourSeen, flashes, isBuoy, points } from "../surroundings/surroundings";
import {
  type AnchoredShip,
  type Coast,
  type Landmark,
  LandmarkKind,
  type Landmarks,
  LightColour,
  type SeaState,
} from "../wire/generated";
import { Buoys } from "./buoys";
import { type Lamp, LampHalos } from "./lamp_halos";
import { type Materials, type Painted, kPaint } from "./materials";
import { Solid } from "./solid";
import type { V3 } from "./vec";

const kWhite: V3 = [1.8, 1.7, 1.45];
const kYellow: V3 = [1.7, 1.2, 0.6];
const kColours: Record<LightColour, V3> = {
  [LightColour.LIGHT_NONE]: [0, 0, 0],
  [LightColour.LIGHT_WHITE]: kWhite,
  [LightColour.LIGHT_RED]: [1.8, 0.16, 0.1],
  [LightColour.LIGHT_GREEN]: [0.15, 1.6, 0.6],
  [LightColour.LIGHT_YELLOW]: kYellow,
};
const kBoard = [3, 12] as const; // m, of a beacon's board, least and most: as large as leading lines of big ports have

/** What is drawn of one sample. */
interface Drawn {
  mesh: Mesh;
  buoys: Buoys;
  shore: LampHalos; // what burns all night
  lights: LampHalos; // of the marks, one for each
  marks: readonly Landmark[];
}

/** In the world's axes. */
export class LandmarksScene {
  readonly group = new Group();
  private readonly paint: Painted;
  private drawn: Drawn | undefined;

  constructor(materials: Materials) {
    this.paint = materials.make({ vertexColors: true, roughness: 1, metalness: 0, dry: true });
  }

  /** undefined: open sea. */
  set(landmarks: Landmarks | undefined): void {
    this.dispose();
    if (!landmarks) return;
    const mesh = new Mesh(built(landmarks).build(), this.paint);
    mesh.name = "landmarks";
    mesh.frustumCulled = false;
    const shore = new LampHalos([
      ...points(landmarks.lamps).map((at): Lamp => ({ at, size: 85, colour: kYellow })),
      ...landmarks.ships.flatMap(anchorLights),
    ]);
    const lights = new LampHalos(landmarks.marks.map(lampOf));
    const afloat = landmarks.marks.flatMap((mark) => {
      const looks = buoyOf(mark.kind, landmarks.region_b);
      return looks ? [{ mark, looks }] : [];
    });
    const buoys = new Buoys(afloat, this.paint);
    this.group.add(mesh, buoys.mesh, shore.mesh, lights.mesh);
    this.drawn = { mesh, buoys, shore, lights, marks: landmarks.marks };
  }

  /** eye: m, world; time: s, of the exercise; sea: that buoys ride on; the rest as LampHalos.show() has it. */
  show(
    [x, y]: readonly [number, number],
    time: number,
    sea: SeaState | undefined,
    dark: number,
    pixels: number,
    fogDensity: number,
  ): void {
    if (!this.drawn) return;
    const { buoys, shore, lights, marks } = this.drawn;
    buoys.ride(sea, x, y, time, (mark, at) => lights.move(marks.indexOf(mark), at));
    shore.show(dark, pixels, fogDensity);
    marks.forEach((mark, k) => {
      const colour = colourSeen(mark, [x, y]);
      if (mark.sectors.length > 0) lights.paint(k, kColours[colour]);
      lights.light(k, colour !== LightColour.LIGHT_NONE && flashes(mark, time));
    });
    lights.show(dark, pixels, fogDensity);
  }

  dispose(): void {
    this.group.clear();
    this.drawn?.mesh.geometry.dispose();
    this.drawn?.buoys.dispose();
    this.drawn?.shore.dispose();
    this.drawn?.lights.dispose();
    this.drawn = undefined;
  }
}

function built(all: Landmarks): Solid {
  const solid = new Solid();
  for (const coast of all.coasts) hills(solid, coast);
  for (const ship of all.ships) anchored(solid, ship);
  all.marks.forEach((mark, k) => {
    if (isBuoy(mark.kind)) return; // they ride on the sea
    if (mark.kind === LandmarkKind.LANDMARK_LIGHTHOUSE) lighthouse(solid, mark);
    else if (mark.kind === LandmarkKind.LANDMARK_TOWER) tower(solid, mark);
    else beacon(solid, mark, transitOf(all, k));
  });
  return solid;
}

/** A lighthouse is seen farthest, a buoy nearest. */
function lampOf({ kind, x, y, height, light }: Landmark): Lamp {
  const size = kind === LandmarkKind.LANDMARK_LIGHTHOUSE ? 320 : isBuoy(kind) ? 30 : 110;
  return { at: [x, y, height + (isBuoy(kind) ? 0.3 : 0)], size, colour: kColours[light] };
}

/** A slope from the water's edge up to the ridge. */
function hills(solid: Solid, { colour, shore, ridge }: Coast): void {
  const foot = points(shore).map(([x, y]): V3 => [x, y, -2]);
  const top = points(ridge);
  for (let k = 0; k + 1 < top.length; ++k) solid.quad(top[k]!, foot[k]!, foot[k + 1]!, top[k + 1]!, colour);
}

function lighthouse(solid: Solid, { x, y, height }: Landmark): void {
  const gallery = height - 12;
  const lantern = height - 6; // its light stands clear of what it stands on
  solid.bar([x, y, -2], [x, y, gallery], 6, 0xe8e6de, 12, 4);
  solid.bar([x, y, 0.52 * gallery], [x, y, 0.7 * gallery], 5.3, 0xa8281e, 12, 5);
  solid.bar([x, y, gallery], [x, y, lantern], 3.2, 0x30363a, 10, 2.4);
}

function tower(solid: Solid, { x, y, height, light }: Landmark): void {
  const top = light === LightColour.LIGHT_NONE ? height : height - 2; // its light stands clear of it
  solid.bar([x, y, -2], [x, y, top], 3, 0xd4d6d2, 12, 2);
}

/** The transit that a landmark is a mark of: which one, and rad clockwise from north, from front to rear. */
type Leads = { mark: "front" | "rear"; bearing: number } | undefined;

function transitOf({ marks, transits }: Landmarks, which: number): Leads {
  const transit = transits.find(({ front, rear }) => front === which || rear === which);
  const front = transit && marks[transit.front];
  const rear = transit && marks[transit.rear];
  if (!front || !rear) return undefined;
  const bearing = Math.atan2(rear.x - front.x, rear.y - front.y);
  return { mark: transit.front === which ? "front" : "rear", bearing };
}

/**
 * A board on a frame. Those of a transit face along it to seaward, the front one's triangle point up, the rear one's
 * point down, so that the points meet on the line; any other is a diamond, and has two boards crosswise.
 */
function beacon(solid: Solid, { x, y, height, light }: Landmark, leads: Leads): void {
  const size = Math.min(kBoard[1], Math.max(kBoard[0], 0.5 * height));
  const top = light === LightColour.LIGHT_NONE ? height : height - 1; // its light stands clear of it
  const foot = top - size;
  for (const [east, north] of [
    [1, 1],
    [1, -1],
    [-1, 1],
    [-1, -1],
  ] as const)
    solid.bar([x + 0.3 * size * east, y + 0.3 * size * north, -2], [x, y, foot], 0.15, 0xb8bab4, 6);
  const shape = leads?.mark === "front" ? kPointUp : leads?.mark === "rear" ? kPointDown : kDiamond;
  for (const turn of leads ? [0] : [0, Math.PI / 2])
    board(solid, x, y, foot, size, (leads?.bearing ?? 0) + turn, shape);
}

/** A board's half breadth at foot, middle and top, of its height; the paint of its lower and its upper half. */
interface Board {
  breadth: readonly [number, number, number];
  paint: readonly [number, number];
}
const kPointUp: Board = { breadth: [0.5, 0.25, 0], paint: [kPaint.orange, kPaint.white] };
const kPointDown: Board = { breadth: [0, 0.25, 0.5], paint: [kPaint.white, kPaint.orange] };
const kDiamond: Board = { breadth: [0, 0.5, 0], paint: [kPaint.white, kPaint.orange] };

/** Upright, across a direction (rad clockwise from north), seen from both sides; foot: m above the water. */
function board(solid: Solid, x: number, y: number, foot: number, size: number, across: number, shape: Board): void {
  const corner = (side: number, level: 0 | 1 | 2): V3 => {
    const aside = side * size * shape.breadth[level];
    return [x + aside * Math.cos(across), y - aside * Math.sin(across), foot + 0.5 * size * level];
  };
  shape.paint.forEach((colour, half) => {
    const [lower, upper] = half === 0 ? ([0, 1] as const) : ([1, 2] as const);
    for (const face of [1, -1])
      solid.quad(corner(face, lower), corner(face, upper), corner(-face, upper), corner(-face, lower), colour);
  });
}

function anchored(solid: Solid, { x, y, heading, length, beam }: AnchoredShip): void {
  solid.box([x, y, 3.5], [beam, length, 11], 0x20262c, -heading);
  const s = Math.sin(heading);
  const c = Math.cos(heading);
  const along = (share: number): [number, number] => [x + share * length * s, y + share * length * c];
  solid.box([...along(-0.39), 17], [0.85 * beam, 18, 16], 0xdcdcd4, -heading);
  solid.box([...along(-0.41), 27], [7, 8, 6], 0xc0562a, -heading);
  for (const share of [-0.17, 0.07, 0.3]) solid.bar([...along(share), 9], [...along(share), 24], 1, 0xb8a040, 6);
}

/** The higher forward, the lower aft, and deck lights (COLREG, rule 30). */
function anchorLights({ x, y, heading, length }: AnchoredShip): Lamp[] {
  const s = length * Math.sin(heading);
  const c = length * Math.cos(heading);
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
