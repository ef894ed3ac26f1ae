// What is drawn for those who have the truth: ShipState, ChainState, AnchorState, WindlassLoad, EnvironmentState.

import { limits } from "../../../../words/words.json";
import type { WindlassLoad } from "../wire/generated";
import type { Connection } from "../wire/connection";
import type { AnchorFrame, SceneFrame, TackleFrame } from "./frame";
import { pitchRadius } from "./rig";
import { menSeen } from "./men";
import { atTime, between, mix, mixAngle, mixNodes, mixTurn } from "./follow";

/** What a frame is made of: a Connection, or something that has samples like one. */
export type Samples = Pick<Connection, "latest" | "track">;

/** K, skin of the lining, from which it is warm, smells, smokes, burns: as the seats are given it. */
const kLining = [limits.lining_warm, limits.lining_smells, limits.lining_smokes, limits.lining_burns].map(
  ({ value }) => value,
);
/** W into the lining, from which it rubs, squeals, screams. */
const kNoise = [limits.brake_rubs, limits.brake_squeals, limits.brake_screams].map(({ value }) => value);
/** Of the anchor's weight: all over with it. */
const kMudMost = limits.mud_most.value;

const passed = (steps: readonly number[], value: number): number => steps.filter((s) => value > s).length;

/** What is remembered of one link. */
interface Memory {
  /** rad/s, that each side's motor has reached at most: what is full speed is not on the wire. */
  fastest: number[];
  nodes: Float32Array[];
}
const memories = new WeakMap<object, Memory>();

function memoryOf(link: object): Memory {
  let memory = memories.get(link);
  if (!memory) memories.set(link, (memory = { fastest: [1, 1], nodes: [new Float32Array(0), new Float32Array(0)] }));
  return memory;
}

/** now: ms of performance.now(). Undefined before the ship is heard of. */
export function frameOfTruth(link: Samples, now: number): SceneFrame | undefined {
  const ship = between(link.track("ShipState"), now);
  if (!ship) return undefined;
  const { from, to, share } = ship;
  const weather = link.latest("EnvironmentState")?.now;
  return {
    time: ship.time,
    ship: {
      x: mix(from.position.x, to.position.x, share),
      y: mix(from.position.y, to.position.y, share),
      z: mix(from.position.z, to.position.z, share),
      heading: mixAngle(from.heading, to.heading, share),
      roll: mix(from.roll, to.roll, share),
      pitch: mix(from.pitch, to.pitch, share),
    },
    tackle: [0, 1].map((side) => tackleOf(link, side, ship.time)),
    wind_speed: weather?.wind_speed ?? 0,
    wind_from: weather?.wind_from ?? 0,
    visibility: weather?.visibility || 20000,
    time_of_day: weather?.time_of_day ?? 43200,
    shows: link.latest("LightsAndShapes"),
    ...(weather ? { current: { speed: weather.current_speed, towards: weather.current_towards } } : {}),
  };
}

function tackleOf(link: Samples, side: number, time: number): TackleFrame | undefined {
  const chain = atTime(link.track("ChainState", side), time);
  const load = atTime(link.track("WindlassLoad", side), time);
  if (!chain || !load) return undefined;
  const { from, to, share } = chain;
  const w = load.share < 0.5 ? load.from : load.to;
  const memory = memoryOf(link);
  const nodes = mixNodes(from.nodes, to.nodes, share, memory.nodes[side]!);
  if (from.nodes.length === to.nodes.length) memory.nodes[side] = nodes;
  const cableOut = from.nodes.length === to.nodes.length ? mix(from.cable_out, to.cable_out, share) : to.cable_out;
  return {
    side,
    nodes,
    tension: to.tension,
    utilisation: mix(load.from.utilisation, load.to.utilisation, load.share),
    marks: to.marks.map((m) => ({ ...m, x: m.position.x, y: m.position.y, z: m.position.z })),
    ...anchorOf(link, side, time),
    gypsy_turn: turnWith(link, side, w, cableOut),
    cable_out: cableOut,
    cable_speed: mix(load.from.cable_speed, load.to.cable_speed, load.share),
    brake: mix(load.from.brake_position, load.to.brake_position, load.share),
    speed_lever: w.speed_lever,
    clutch: w.clutch,
    clutch_offset: w.clutch_offset,
    stopper_closed: w.stopper_closed,
    stopper_sprung: w.stopper_sprung,
    lining: passed(kLining, w.lining_temperature),
    brake_noise: passed(kNoise, Math.abs(w.brake_power)),
    jumping: w.gypsy_jumping,
    ...(to.cable_out > 0 ? { lead: (to.lead_clock * Math.PI) / 6 } : {}),
    ...menAt(link, side),
    motor_speed: w.motor_speed / (memory.fastest[side] = Math.max(memory.fastest[side]!, Math.abs(w.motor_speed))),
  };
}

/** What men do is told by the eyes on deck alone. */
function menAt(link: Samples, side: number): Pick<TackleFrame, "men"> {
  const view = link.latest("ForecastleView", side);
  return view ? { men: menSeen(view) } : {};
}

/** rad: the gypsy goes with the cable that is drawn, whose samples are of other ticks than its own. */
function turnWith(link: Samples, side: number, w: WindlassLoad, cableOut: number): number {
  const d = link.latest("SceneDescription")?.tackle.find((t) => t.side === side)?.chain_diameter;
  if (d === undefined || w.gypsy_jumping) return w.gypsy_turn;
  return w.gypsy_turn + (cableOut - w.cable_out) / pitchRadius(d);
}

function anchorOf(link: Samples, side: number, time: number): { anchor?: AnchorFrame } {
  const found = atTime(link.track("AnchorState", side), time);
  if (!found) return {};
  const { from, to, share } = found;
  const q = mixTurn(from.attitude, to.attitude, share);
  return {
    anchor: {
      x: mix(from.position.x, to.position.x, share),
      y: mix(from.position.y, to.position.y, share),
      z: mix(from.position.z, to.position.z, share),
      qw: q.w,
      qx: q.x,
      qy: q.y,
      qz: q.z,
      fluke_angle: mix(from.fluke_angle, to.fluke_angle, share),
      mud: to.weight > 0 && to.fouled === 0 ? Math.min(1, Math.max(0, to.carried / (kMudMost * to.weight))) : 0,
    },
  };
}
