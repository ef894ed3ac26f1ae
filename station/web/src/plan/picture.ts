// What a plan shows: plain data. World frame: x east, y north, m; directions in rad clockwise from north; speeds in
// m/s.

import type { Landmarks } from "../wire/generated";

export interface Place {
  x: number;
  y: number;
}

export interface PlanShip extends Place {
  heading: number;
  /** Her waterline, body frame (x forward, y to port), x, y, x, y ...; without it she is a symbol. */
  outline?: Float32Array;
  /** Over ground: her vector; none without. */
  course?: number;
  speed?: number;
}

/** A point with a name: where an anchor was let go, a landmark. */
export interface PlanMark extends Place {
  kind: "anchor" | "landmark";
  label: string;
}

export type CircleKind = "swing" | "drag" | "watch";

export interface PlanCircle extends Place {
  /** By which onCircle() tells which was dragged. */
  id: string;
  kind: CircleKind;
  radius: number; // m
  label: string;
  /** Drawn as left: the ship is outside. */
  left?: boolean;
  /** Its rim can be dragged. */
  editable?: boolean;
}

/** A line of world points x, y, x, y ...: a track, a cable, an anchor's trail. */
export interface PlanLine {
  kind: "track" | "cable" | "trail";
  points: ArrayLike<number>;
}

export interface PlanSounding extends Place {
  depth: number; // m, below the chart's datum
  /** Of the soil: "S", "M" ...; empty: none. */
  letter: string;
}

/** Wind comes from, stream sets towards its direction. */
export interface PlanFlow {
  direction: number;
  speed: number;
}

export interface PlanPicture {
  ship?: PlanShip;
  lines: PlanLine[];
  /** Her track to come, x, y, x, y ... */
  ahead?: ArrayLike<number>;
  marks: PlanMark[];
  circles: PlanCircle[];
  soundings: PlanSounding[];
  /** What stands round the anchorage; without: open sea. */
  landmarks?: Landmarks;
  wind?: PlanFlow;
  stream?: PlanFlow;
}

export const emptyPicture = (): PlanPicture => ({ lines: [], marks: [], circles: [], soundings: [] });
