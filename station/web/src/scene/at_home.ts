// The side that an exercise does not speak of: its windlass stands there all the same, its anchor is home.

import type { SceneTackle } from "../wire/generated";
import { crownPlace } from "./anchor";
import type { TackleFrame } from "./frame";
import { type Rig, chainAt } from "./rig";
import { type ShipPose, type V3, along, cross, scale, shipAxes, turned, unit, vec } from "./vec";

/** The other side's twin of a tackle. */
export function otherSide(tackle: SceneTackle): SceneTackle {
  const across = (p: { x: number; y: number; z: number }): typeof p => ({ x: p.x, y: -p.y, z: p.z });
  return {
    ...tackle,
    side: 1 - tackle.side,
    lip: across(tackle.lip),
    mouth: across(tackle.mouth),
    bore: across(tackle.bore),
  };
}

/** Its frame: everything secured. */
export function secured(rig: Rig, pose: ShipPose): TackleFrame {
  const { tackle } = rig;
  const axes = shipAxes(pose);
  const world = (p: V3): V3 => {
    const at = turned(axes, p);
    return [at[0] + pose.x, at[1] + pose.y, at[2] + pose.z];
  };
  const bore = vec(tackle.bore);
  const shackle = along(vec(tackle.mouth), tackle.seat, bore);
  const turn = Math.acos(bore[2]);
  const home = -tackle.seat - tackle.bend * (turn - Math.sin(turn)); // m of cable out, below 0
  const crown = crownPlace(tackle);
  const x = turned(axes, bore);
  const y = unit(cross([0, 0, 1], x));
  const z = cross(x, y);
  const middle = along(shackle, -(crown.x + tackle.shank_length), bore);
  const at = world(middle);
  const q = rotation(x, y, z);
  return {
    side: tackle.side,
    nodes: Float32Array.from([...world(chainAt(tackle, -home + 0.5)), ...world(shackle)]),
    marks: [],
    anchor: { x: at[0], y: at[1], z: at[2], ...q, fluke_angle: -tackle.fluke_limit, mud: 0 },
    gypsy_turn: home / rig.radius,
    cable_out: home,
    cable_speed: 0,
    brake: 1,
    speed_lever: 0,
    clutch: 0,
    clutch_offset: 0,
    stopper_closed: true,
    stopper_sprung: false,
    lining: 0,
    brake_noise: 0,
    jumping: false,
    motor_speed: 0,
  };
}

/** The quaternion that has these axes as columns. */
function rotation(x: V3, y: V3, z: V3): { qw: number; qx: number; qy: number; qz: number } {
  const w = Math.sqrt(Math.max(0, 1 + x[0] + y[1] + z[2])) / 2;
  if (w > 0.1) {
    const k = 1 / (4 * w);
    return { qw: w, qx: k * (y[2] - z[1]), qy: k * (z[0] - x[2]), qz: k * (x[1] - y[0]) };
  }
  // near a half turn: about the axis that is turned least
  const axes = [x, y, z];
  const i = [0, 1, 2].reduce((a, b) => (axes[b]![b]! > axes[a]![a]! ? b : a));
  const half = unit([0, 1, 2].map((k) => (k === i ? 1 + axes[i]![i]! : axes[i]![k]!)) as unknown as V3);
  const [qx, qy, qz] = scale(1, half);
  return { qw: 0, qx, qy, qz };
}
