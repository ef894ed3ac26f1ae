// What is drawn at one instant, interpolated already. Units and frames as in windlass.idl.

import type { DeckWork } from "../wire/generated";

export interface MarkFrame {
  /** Lengths of 27.5 m between the joining shackle and the anchor. */
  shackle: number;
  /** m of cable from the hawse pipe lip to it; negative: inboard. */
  outboard: number;
  white_links: number;
  last: boolean;
  x: number;
  y: number;
  z: number;
}

/** m, world, of its centre of mass; attitude as AnchorState has it; fluke_angle rad; mud 0..1. */
export interface AnchorFrame {
  x: number;
  y: number;
  z: number;
  qw: number;
  qx: number;
  qy: number;
  qz: number;
  fluke_angle: number;
  mud: number;
}

export interface TackleFrame {
  side: number;
  /** m, world, x y z of each node, lip first; as far down as the cable is seen. */
  nodes: Float32Array;
  /** N, of the link between node i and i + 1; truth only. */
  tension?: Float32Array;
  /** Of the breaking load, at the lip; truth only. */
  utilisation?: number;
  marks: MarkFrame[];
  /** While in sight. */
  anchor?: AnchorFrame;
  /** rad, paying out positive. */
  gypsy_turn: number;
  /** m of cable outboard, where known; else worked out of the gypsy's turn and the marks in sight. */
  cable_out?: number;
  /** m, cable that went out while the gypsy stood still and links jumped over it; where cable_out is not known. */
  jumped?: number;
  /** m/s, paying out positive. */
  cable_speed: number;
  /** 0 open .. 1 hard on. */
  brake: number;
  /** -1 full lower .. 1 full heave. */
  speed_lever: number;
  /** ClutchState. */
  clutch: number;
  /** 0..1 of the claws' pitch. */
  clutch_offset: number;
  stopper_closed: boolean;
  stopper_sprung: boolean;
  /** LiningSeen. */
  lining: number;
  /** 0 none, 1 rubs, 2 squeals, 3 screams. */
  brake_noise: number;
  jumping: boolean;
  /** Of full speed, heaving positive. */
  motor_speed: number;
  /** rad clockwise from ahead, to where the cable leads, as far as it is seen to. */
  lead?: number;
  /** What men are at, if it is known: their work, none where it is done; whether it goes on, else they wait. */
  men?: { work: DeckWork; goes: boolean };
}

export interface SceneFrame {
  /** s, exercise time. */
  time: number;
  /** m, world, midships on the waterline; rad: heading clockwise from north, roll starboard down, pitch bow up. */
  ship: { x: number; y: number; z: number; heading: number; roll: number; pitch: number };
  /** By side; undefined: none, or not heard of. */
  tackle: (TackleFrame | undefined)[];
  /** m/s. */
  wind_speed: number;
  /** rad clockwise from north. */
  wind_from: number;
  /** m. */
  visibility: number;
  /** s since local midnight. */
  time_of_day: number;
  /** s, exercise time: when "stand clear" was last ordered or reported. */
  cried?: number;
  /** What she shows to those around her. */
  shows?: { anchor_ball: boolean; anchor_lights: boolean } | undefined;
  /** m/s; rad clockwise from north. */
  current?: { speed: number; towards: number };
}
