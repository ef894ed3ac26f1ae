// What lies round the place where an exercise begins, for window and chart alike: coast, lights, ships at anchor.
// World frame: x east, y north, m; z up from the water.

import roadstead from "./roadstead.json";

export interface Coast {
  /** "#rrggbb", of its hills by day. */
  colour: string;
  /** x y along the water's edge; as many points as the ridge. */
  shore: number[][];
  /** x y z along the hills behind it, in the same order. */
  ridge: number[][];
}

/** A lighthouse. */
export interface Light {
  name: string;
  x: number;
  y: number;
  height: number; // m, of the lantern above the water
  period: number; // s
  flashes: number[][]; // s from the period's beginning, and how long
}

export interface AnchoredShip {
  x: number;
  y: number;
  heading_deg: number;
  length: number;
  beam: number;
}

export interface Surroundings {
  coasts: Coast[];
  /** x y z of what is lit on shore by night. */
  lamps: number[][];
  lights: Light[];
  ships: AnchoredShip[];
}

/** The roadstead that all exercises lie in. */
export const kRoadstead: Surroundings = roadstead;

const kGrid = 20000; // m: an exercise that begins far from the world's origin has the same roadstead round it

/** By how much the surroundings are moved for a ship at that place, m. */
export const shiftFor = (x: number, y: number): { x: number; y: number } => ({
  x: kGrid * Math.round(x / kGrid),
  y: kGrid * Math.round(y / kGrid),
});

/** Whether a light is seen at that time, s. */
export function flashes(light: Light, time: number): boolean {
  const since = time - light.period * Math.floor(time / light.period);
  return light.flashes.some(([begin, lasts]) => since >= begin! && since < begin! + lasts!);
}

/** As the chart writes it: "Fl(2) 10s 52m". */
export function character({ flashes, period, height }: Light): string {
  return `Fl${flashes.length > 1 ? `(${flashes.length})` : ""} ${period}s ${height}m`;
}
