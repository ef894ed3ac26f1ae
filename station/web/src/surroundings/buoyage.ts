// How buoys look by IALA's Maritime Buoyage System, for window and chart alike. Shapes are the same in both regions,
// lateral colours change places.

import { LandmarkKind } from "../wire/generated";

export type Paint = "red" | "green" | "yellow" | "black" | "white";
export type Topmark = "can" | "cone up" | "cone down" | "ball" | "cross";

export interface Buoy {
  body: "can" | "cone" | "pillar";
  /** Its bands from the top down; stripes: side by side instead. */
  paint: readonly Paint[];
  stripes?: boolean;
  /** From the top down. */
  topmarks: readonly Topmark[];
  topmarkPaint: Paint;
}

const cardinal = (paint: readonly Paint[], upper: Topmark, lower: Topmark): Buoy => ({
  body: "pillar",
  paint,
  topmarks: [upper, lower],
  topmarkPaint: "black",
});

/** regionB: red to starboard; undefined: no buoy. */
export function buoyOf(kind: LandmarkKind, regionB: boolean): Buoy | undefined {
  const port = regionB ? "green" : "red";
  const starboard = regionB ? "red" : "green";
  switch (kind) {
    case LandmarkKind.LANDMARK_BUOY_PORT:
      return { body: "can", paint: [port], topmarks: ["can"], topmarkPaint: port };
    case LandmarkKind.LANDMARK_BUOY_STARBOARD:
      return { body: "cone", paint: [starboard], topmarks: ["cone up"], topmarkPaint: starboard };
    case LandmarkKind.LANDMARK_BUOY_NORTH:
      return cardinal(["black", "yellow"], "cone up", "cone up");
    case LandmarkKind.LANDMARK_BUOY_EAST:
      return cardinal(["black", "yellow", "black"], "cone up", "cone down");
    case LandmarkKind.LANDMARK_BUOY_SOUTH:
      return cardinal(["yellow", "black"], "cone down", "cone down");
    case LandmarkKind.LANDMARK_BUOY_WEST:
      return cardinal(["yellow", "black", "yellow"], "cone down", "cone up");
    case LandmarkKind.LANDMARK_BUOY_ISOLATED_DANGER:
      return { body: "pillar", paint: ["black", "red", "black"], topmarks: ["ball", "ball"], topmarkPaint: "black" };
    case LandmarkKind.LANDMARK_BUOY_SAFE_WATER:
      return { body: "pillar", paint: ["red", "white"], stripes: true, topmarks: ["ball"], topmarkPaint: "red" };
    case LandmarkKind.LANDMARK_BUOY_SPECIAL:
      return { body: "pillar", paint: ["yellow"], topmarks: ["cross"], topmarkPaint: "yellow" };
    default:
      return undefined;
  }
}
