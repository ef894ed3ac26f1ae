// What is drawn for a seat: ForecastleView, in which ship and cable are as coarse as the eye, but for the cable's
// nodes, which are exact. So the ship is laid to where her cable leaves her, and her heading is evened out.

import type { ForecastleView } from "../wire/generated";
import type { AnchorFrame, SceneFrame, TackleFrame } from "./frame";
import { atTime, between, mix, mixAngle, mixNodes, mixTurn, mixTurning } from "./follow";
import type { Samples } from "./from_truth";
import { menSeen } from "./men";
import { pitchRadius } from "./rig";
import { wrap } from "./vec";
import { shipAxes, turned, vec } from "./vec";

/** m/s of each number of Beaufort, its middle. */
const kBeaufort = [0, 0.9, 2.4, 4.4, 6.7, 9.3, 12.3, 15.5, 18.9, 22.6, 26.4, 30.5, 34];

const kHeadingTime = 1.2; // s, over which the heading's steps of 0.1 degree are evened out
const kPlaceTime = 0.5; // s, the same for the place where no cable tells it

/** m, that a ship laid to her cable may be off the place told: its steps, and those of her heading at the bow. */
const kTold = 0.4;

/** What is remembered from frame to frame of the windlasses, by side. */
export interface SeenBefore {
  /** m, as of TackleFrame. */
  jumped: number[];
  nodes: Float32Array[];
}
export const nothingSeen = (): SeenBefore => ({ jumped: [0, 0], nodes: [new Float32Array(0), new Float32Array(0)] });

/** The same of all of one link. */
interface Memory extends SeenBefore {
  time: number;
  heading: number;
  /** m, of the ship's place, where no cable tells it. */
  x: number;
  y: number;
  z: number;
}
const memories = new WeakMap<object, Memory>();

/** now: ms of performance.now(). Undefined before a side is heard of. */
export function frameOfSeat(link: Samples, now: number): SceneFrame | undefined {
  const lead = between(link.track("ForecastleView", 0), now) ?? between(link.track("ForecastleView", 1), now);
  if (!lead) return undefined;
  const { from, to, share, time } = lead;
  const memory = memories.get(link) ?? {
    time: NaN,
    heading: 0,
    x: 0,
    y: 0,
    z: 0,
    ...nothingSeen(),
  };
  memories.set(link, memory);
  const since = time - memory.time;
  const fresh = !(since >= 0 && since < 1);
  const seconds = fresh ? 0 : since;
  memory.time = time;

  const heading = mixAngle(from.ship_heading, to.ship_heading, share);
  memory.heading = fresh ? heading : mixAngle(memory.heading, heading, 1 - Math.exp(-seconds / kHeadingTime));
  const roll = mix(from.ship_roll, to.ship_roll, share);
  const pitch = mix(from.ship_pitch, to.ship_pitch, share);

  const tackle = [0, 1].map((side) =>
    tackleSeen(link, "ForecastleView", side, time, memory, fresh ? undefined : seconds),
  );
  const place = placeByCable(link, tackle, { x: 0, y: 0, z: 0, heading: memory.heading, roll, pitch });
  const even = fresh ? 1 : 1 - Math.exp(-seconds / kPlaceTime);
  memory.x =
    place?.x ?? mix(fresh ? to.ship_position.x : memory.x, mix(from.ship_position.x, to.ship_position.x, share), even);
  memory.y =
    place?.y ?? mix(fresh ? to.ship_position.y : memory.y, mix(from.ship_position.y, to.ship_position.y, share), even);
  memory.z =
    place?.z ?? mix(fresh ? to.ship_position.z : memory.z, mix(from.ship_position.z, to.ship_position.z, share), even);

  const light = link.latest("Daylight");
  return {
    time,
    ship: { x: memory.x, y: memory.y, z: memory.z, heading: memory.heading, roll, pitch },
    tackle,
    wind_speed: kBeaufort[to.wind_felt] ?? 34,
    wind_from: wrap(memory.heading + to.wind_from_bow, 2 * Math.PI),
    visibility: light?.visibility || 20000,
    time_of_day: light?.time_of_day ?? 43200,
    shows: link.latest("LightsAndShapes"),
  };
}

/** m, world: where the ship is, so that a cable that hangs from its pipe begins at the lip. */
function placeByCable(
  link: Samples,
  tackle: readonly (TackleFrame | undefined)[],
  pose: SceneFrame["ship"],
): { x: number; y: number; z: number } | undefined {
  const scene = link.latest("SceneDescription");
  for (const t of tackle) {
    const lip = scene?.tackle.find((s) => s.side === t?.side)?.lip;
    if (!t || !lip || t.nodes.length < 6) continue;
    const at = turned(shipAxes(pose), vec(lip));
    const place = { x: t.nodes[0]! - at[0], y: t.nodes[1]! - at[1], z: t.nodes[2]! - at[2] };
    // An anchor that is being drawn home has its cable begin up the pipe, and a cable that is lost has none.
    const told = link.latest("ForecastleView", t.side)!.ship_position;
    if (Math.hypot(place.x - told.x, place.y - told.y, place.z - told.z) < kTold) return place;
  }
  return undefined;
}

/**
 * One windlass with its cable, at s of exercise time, as a man on deck or the bridge's camera sees it. seconds: since
 * the frame before; undefined: there was none.
 */
export function tackleSeen(
  link: Samples,
  topic: "ForecastleView" | "ForecastleCamera",
  side: number,
  time: number,
  memory: SeenBefore,
  seconds: number | undefined,
): TackleFrame | undefined {
  const found = atTime(link.track(topic, side), time);
  if (!found) return undefined;
  const { from, to, share } = found;
  // Links that ride over the pockets: the gypsy no longer tells where they are.
  if (seconds === undefined) memory.jumped[side] = 0;
  else if (to.gypsy_jumping) memory.jumped[side]! += to.cable_speed_seen * seconds;
  else if (memory.jumped[side] !== 0) memory.jumped[side] = 0;
  const nodes = mixNodes(from.nodes, to.nodes, share, memory.nodes[side]!);
  if (from.nodes.length === to.nodes.length) memory.nodes[side] = nodes;
  return {
    side,
    nodes,
    marks: to.marks.map((m) => ({ ...m, x: m.position.x, y: m.position.y, z: m.position.z })),
    ...anchorOf(from, to, share),
    gypsy_turn: mixTurning(from.gypsy_turn, to.gypsy_turn, share, turnedAbout(link, from, to)),
    jumped: memory.jumped[side]!,
    cable_speed: to.cable_speed_seen,
    brake: mix(from.brake_position, to.brake_position, share),
    speed_lever: to.speed_lever,
    clutch: to.clutch,
    clutch_offset: to.clutch_offset,
    stopper_closed: to.stopper_closed,
    stopper_sprung: to.stopper_sprung,
    lining: to.lining,
    brake_noise: to.brake_noise,
    jumping: to.gypsy_jumping,
    motor_speed: to.motor_speed_heard,
    ...(to.leads ? { lead: (to.lead_clock * Math.PI) / 6 } : {}),
    men: topic === "ForecastleView" ? menSeen(to) : { work: to.deck_work, goes: true }, // the camera's: of men at it
  };
}

/** rad, by which the gypsy turned from one sample to the next, by the speed that is seen. */
function turnedAbout(link: Samples, from: ForecastleView, to: ForecastleView): number {
  const d = link.latest("SceneDescription")?.tackle.find((t) => t.side === to.side)?.chain_diameter;
  if (d === undefined || to.gypsy_jumping) return 0;
  return (0.5 * (from.cable_speed_seen + to.cable_speed_seen) * (to.time - from.time)) / pitchRadius(d);
}

/** An anchor that is out of sight has no attitude. */
const seen = (v: ForecastleView): boolean => {
  const q = v.anchor_attitude;
  return q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z > 0.5;
};

function anchorOf(from: ForecastleView, to: ForecastleView, share: number): { anchor?: AnchorFrame } {
  if (!seen(to)) return {};
  const a = seen(from) ? from : to;
  const q = mixTurn(a.anchor_attitude, to.anchor_attitude, share);
  return {
    anchor: {
      x: mix(a.anchor_position.x, to.anchor_position.x, share),
      y: mix(a.anchor_position.y, to.anchor_position.y, share),
      z: mix(a.anchor_position.z, to.anchor_position.z, share),
      qw: q.w,
      qx: q.x,
      qy: q.y,
      qz: q.z,
      fluke_angle: mix(a.fluke_angle, to.fluke_angle, share),
      mud: to.mud,
    },
  };
}
