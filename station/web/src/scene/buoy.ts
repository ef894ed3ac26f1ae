// Buoys as one sees them, by IALA's colours, shapes and topmarks.

import { CylinderGeometry, Matrix4 } from "three";
import type { Buoy, Paint, Topmark } from "../surroundings/buoyage";
import { kPaint } from "./materials";
import type { Solid } from "./solid";

const kPaints: Record<Paint, number> = {
  red: kPaint.red,
  green: 0x1f7a45,
  yellow: kPaint.yellow,
  black: kPaint.black,
  white: kPaint.white,
};
const kAcross = 1.25; // m, half of a body's breadth
const kFreeboard = 0.7; // m, of the float that a pillar stands on
const kDraught = 0.6; // m that are drawn under water: enough for a trough
const kTopmark = 1; // m, of a topmark's part, where the buoy is high enough
const kApart = 1.15; // of a part's size, from one to the next
const kStripes = 8;

/** A round piece about an upright axis: m above the water of foot and top, radii there; as Buoy.paint. */
interface Round {
  foot: number;
  top: number;
  wide: number;
  narrow: number;
  paint: readonly Paint[];
}

/** height: m of the topmark's end above the water. */
export function buoy(solid: Solid, { x, y, height }: { x: number; y: number; height: number }, looks: Buoy): void {
  const size = Math.min(kTopmark, 0.2 * height);
  const top = height - kApart * size * looks.topmarks.length;
  const body = top - 0.3 * size;
  for (const piece of pieces(looks, body)) (looks.stripes ? striped : banded)(solid, x, y, piece);
  solid.bar([x, y, body], [x, y, height - 0.5 * size], 0.07, kPaint.black, 6);
  looks.topmarks.forEach((mark, k) => {
    const foot = height - kApart * size * k - size;
    topmark(solid, x, y, foot, size, mark, kPaints[looks.topmarkPaint]);
  });
}

/** Its body; a pillar stands on a float in the paint of its lowest band. */
function pieces({ body, paint, stripes }: Buoy, top: number): Round[] {
  if (body === "can") return [{ foot: -kDraught, top, wide: kAcross, narrow: kAcross, paint }];
  if (body === "cone") return [{ foot: -kDraught, top, wide: kAcross, narrow: 0.12, paint }];
  const deck = Math.min(kFreeboard, 0.3 * top);
  return [
    { foot: -kDraught, top: deck, wide: kAcross, narrow: 0.9 * kAcross, paint: stripes ? paint : paint.slice(-1) },
    { foot: deck, top, wide: 0.75, narrow: 0.5, paint },
  ];
}

/** In bands from the top down. */
function banded(solid: Solid, x: number, y: number, { foot, top, wide, narrow, paint }: Round): void {
  const height = (bands: number): number => top + ((foot - top) * bands) / paint.length;
  const radius = (bands: number): number => narrow + ((wide - narrow) * bands) / paint.length;
  paint.forEach((band, k) =>
    solid.bar([x, y, height(k + 1)], [x, y, height(k)], radius(k + 1), kPaints[band], 12, radius(k)),
  );
}

/** In upright stripes. */
function striped(solid: Solid, x: number, y: number, { foot, top, wide, narrow, paint }: Round): void {
  const upright = new Matrix4().makeRotationX(Math.PI / 2).setPosition(x, y, 0.5 * (foot + top));
  const turn = (2 * Math.PI) / kStripes;
  for (let k = 0; k < kStripes; ++k) {
    const stripe = new CylinderGeometry(narrow, wide, top - foot, 2, 1, false, k * turn, turn);
    solid.add(stripe, kPaints[paint[k % paint.length]!], upright);
  }
}

function topmark(solid: Solid, x: number, y: number, foot: number, size: number, mark: Topmark, colour: number): void {
  const half = 0.5 * size;
  const top = foot + size;
  if (mark === "ball") solid.ball([x, y, foot + half], half, colour);
  else if (mark === "can") solid.bar([x, y, foot], [x, y, top], half, colour, 12);
  else if (mark === "cone up") solid.bar([x, y, foot], [x, y, top], half, colour, 12, 0);
  else if (mark === "cone down") solid.bar([x, y, foot], [x, y, top], 0, colour, 12, half);
  else {
    // Two crosses: one is seen from whichever side.
    for (const way of [-half, half]) {
      solid.bar([x - way, y, foot], [x + way, y, top], 0.14 * size, colour, 6);
      solid.bar([x, y - way, foot], [x, y + way, top], 0.14 * size, colour, 6);
    }
  }
}
