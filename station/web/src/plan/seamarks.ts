// Signs of landmarks and buoys on the plan, small and simple, and upright however the plan is turned.

import type { Buoy, Paint, Topmark } from "../surroundings/buoyage";
import { type Landmark, LandmarkKind, LightColour } from "../wire/generated";
import type { Sheet } from "./layers";
import { line, ring, stroke } from "./pen";
import type { Pixel } from "./projection";

const kPlace = 2; // px, of the small ring that marks the place
const kHigh = 13; // px, of a buoy's body
const kBroad = { can: [5, 5], cone: [6, 0], pillar: [5, 2] } as const; // px, half of it, below and above
const kArc = 34; // px, of a sector's arc
const kLimit = 60; // px, of a sector's limit
const kTopmark = 5; // px, of a topmark's part

/** A flare, as of all that is lit. */
export function flare({ c, colours }: Sheet, { light }: Landmark, p: Pixel): void {
  if (light === LightColour.LIGHT_NONE) return;
  c.beginPath();
  c.moveTo(p.x, p.y);
  c.quadraticCurveTo(p.x + 12, p.y + 4, p.x + 18, p.y + 15);
  c.quadraticCurveTo(p.x + 6, p.y + 16, p.x, p.y);
  c.fillStyle = paint(colours, light);
  c.fill();
}

function paint({ paints, light }: Sheet["colours"], of: LightColour): string {
  return of === LightColour.LIGHT_RED ? paints.red : of === LightColour.LIGHT_GREEN ? paints.green : light;
}

/** A light's sectors, as a chart has them: their limits, and between them an arc in their colour; none where hidden. */
export function lightSectors({ c, at, colours }: Sheet, { light, sectors }: Landmark, p: Pixel): void {
  const seaward = (bearing: number): number => bearing + Math.PI / 2 - at.up; // of canvas, from the light
  for (const { from, to } of sectors)
    for (const limit of [from, to]) {
      const angle = seaward(limit);
      const tip = { x: p.x + kLimit * Math.cos(angle), y: p.y + kLimit * Math.sin(angle) };
      line(c, p, tip, { colour: colours.quiet, width: 1, dash: [4, 4] });
    }
  const arc = (from: number, to: number, colour: LightColour): void => {
    if (colour === LightColour.LIGHT_NONE) return;
    c.beginPath();
    c.arc(p.x, p.y, kArc, seaward(from), seaward(to));
    stroke(c, { colour: paint(colours, colour), width: 3 });
  };
  const ordered = [...sectors].sort((a, b) => a.from - b.from);
  ordered.forEach(({ light: own, from, to }, k) => {
    arc(from, to, own);
    const next = ordered[(k + 1) % ordered.length]!.from;
    if (next !== to) arc(to, next, light);
  });
}

/** Of what stands on shore: a lighthouse is a point, a tower a ring with a point, a beacon a board on a staff. */
export function shoreMark({ c, colours }: Sheet, { kind }: Landmark, p: Pixel): void {
  const ink = { colour: colours.text, width: 1.5 };
  if (kind === LandmarkKind.LANDMARK_TOWER) ring(c, p, 5, ink);
  if (kind === LandmarkKind.LANDMARK_BEACON) {
    line(c, p, { x: p.x, y: p.y - 7 }, ink);
    polygon(c, [p.x - 5, p.y - 7], [p.x + 5, p.y - 7], [p.x, p.y - 16]);
    c.fillStyle = colours.sea;
    c.fill();
    stroke(c, ink);
  }
  c.beginPath();
  c.arc(p.x, p.y, kind === LandmarkKind.LANDMARK_LIGHTHOUSE ? 3 : 1.5, 0, 2 * Math.PI);
  c.fillStyle = colours.text;
  c.fill();
}

export function buoyMark(sheet: Sheet, { body, paint, stripes, topmarks, topmarkPaint }: Buoy, p: Pixel): void {
  const { c, colours } = sheet;
  const ink = { colour: colours.text, width: 1 };
  const [below, above] = kBroad[body];
  const foot = p.y - kPlace;
  const top = foot - kHigh;
  const outline = (): void =>
    polygon(c, [p.x - below, foot], [p.x + below, foot], [p.x + above, top], [p.x - above, top]);
  c.save();
  outline();
  c.clip();
  const stripe = stripes ? (2 * below) / 3 : 0; // red, white, red
  (stripes ? [...paint, paint[0]!] : paint).forEach((band, k, all) => {
    c.fillStyle = colours.paints[band];
    if (stripes) c.fillRect(p.x - below + k * stripe, top, stripe, kHigh);
    else c.fillRect(p.x - below, top + (k * kHigh) / all.length, 2 * below, kHigh / all.length);
  });
  c.restore();
  outline();
  stroke(c, ink);
  ring(c, p, kPlace, ink);
  [...topmarks].reverse().forEach((mark, k) => topmark(sheet, mark, topmarkPaint, p.x, top - 2 - k * (kTopmark + 1)));
}

function topmark({ c, colours }: Sheet, mark: Topmark, paint: Paint, x: number, foot: number): void {
  const half = kTopmark / 2;
  const top = foot - kTopmark;
  if (mark === "cross") {
    for (const way of [1, -1])
      line(
        c,
        { x: x - way * half, y: foot },
        { x: x + way * half, y: top },
        { colour: colours.paints[paint], width: 2 },
      );
    return;
  }
  if (mark === "can") polygon(c, [x - half, foot], [x + half, foot], [x + half, top], [x - half, top]);
  else if (mark === "cone up") polygon(c, [x - half, foot], [x + half, foot], [x, top]);
  else if (mark === "cone down") polygon(c, [x - half, top], [x + half, top], [x, foot]);
  else {
    c.beginPath();
    c.arc(x, foot - half, half, 0, 2 * Math.PI);
  }
  c.fillStyle = colours.paints[paint];
  c.fill();
  stroke(c, { colour: colours.text, width: 0.75 });
}

function polygon(c: Sheet["c"], ...corners: [x: number, y: number][]): void {
  c.beginPath();
  corners.forEach(([x, y], k) => (k === 0 ? c.moveTo(x, y) : c.lineTo(x, y)));
  c.closePath();
}
