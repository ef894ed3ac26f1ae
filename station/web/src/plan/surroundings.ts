// What is charted round the anchorage: land, marks, transits, ships at anchor.

import { bearingToTenth, kNauticalMile } from "../kit/units";
import { buoyOf } from "../surroundings/buoyage";
import { character, points } from "../surroundings/surroundings";
import {
  type AnchoredShip,
  type Coast,
  type Landmark,
  LandmarkKind,
  type Landmarks,
  type Transit,
} from "../wire/generated";
import type { Sheet } from "./layers";
import { around, letter, rank } from "./lettering";
import { line, stroke } from "./pen";
import { type Pixel, directionTo, distance, ofShip, pointAt } from "./projection";
import { buoyMark, flare, lightSectors, shoreMark } from "./seamarks";
import { t } from "../kit/language";

const kInland = 1500; // m, of what the chart takes as land behind a ridge
const kSign = 8; // px, half of a mark's sign, which stands on its place
const kShortest = 9; // px, of a ship that is drawn
const kNamesApart = 140; // px, between marks that have their names beside them
const kWordsOut = 110; // px, to seaward of a transit's front mark, where its name stands
const kSeaward = 3 * kNauticalMile; // m, to which a transit is drawn from its front mark

export function land({ c, at, colours }: Sheet, coasts: readonly Coast[]): void {
  for (const coast of coasts) {
    const shore = points(coast.shore);
    const edge = shore.map(([x, y]) => at.toScreen(x, y));
    const inland = points(coast.ridge).map(([x, y], k) => {
      const up = { x: x - shore[k]![0], y: y - shore[k]![1] };
      const farther = kInland / (Math.hypot(up.x, up.y) || 1);
      return at.toScreen(x + farther * up.x, y + farther * up.y);
    });
    c.beginPath();
    [...edge, ...inland.reverse()].forEach((p, k) => (k === 0 ? c.moveTo(p.x, p.y) : c.lineTo(p.x, p.y)));
    c.closePath();
    c.fillStyle = colours.land;
    c.fill();
    c.beginPath();
    edge.forEach((p, k) => (k === 0 ? c.moveTo(p.x, p.y) : c.lineTo(p.x, p.y)));
    stroke(c, { colour: colours.quiet, width: 1.5 });
  }
}

/** All but the land. */
export function surroundings(sheet: Sheet, all: Landmarks): void {
  for (const of of all.transits) transit(sheet, of, all.marks);
  for (const ship of all.ships) anchored(sheet, ship);
  for (const landmark of all.marks) {
    const p = sheet.at.toScreen(landmark.x, landmark.y);
    const buoy = buoyOf(landmark.kind, all.region_b);
    flare(sheet, landmark, p);
    lightSectors(sheet, landmark, p);
    if (buoy) buoyMark(sheet, buoy, p);
    else shoreMark(sheet, landmark, p);
    sheet.lettering.keep(around({ x: p.x, y: p.y - kSign }, kSign));
  }
  const { at, colours } = sheet;
  for (const landmark of named(all.marks, kNamesApart / at.scale)) {
    const { x, y } = at.toScreen(landmark.x, landmark.y);
    const text = [landmark.name, character(landmark)].filter(Boolean).join(", ");
    letter(sheet, rank.charted, text, { x: x + kSign + 3, y: y - 10 }, colours.text);
  }
}

/** Those that stand so far apart, m, that their names do not lie on one another: lighthouses first, then as told. */
export function named(landmarks: readonly Landmark[], apart: number): Landmark[] {
  const isLighthouse = ({ kind }: Landmark): boolean => kind === LandmarkKind.LANDMARK_LIGHTHOUSE;
  const left: Landmark[] = [];
  for (const each of [...landmarks.filter(isLighthouse), ...landmarks.filter((l) => !isLighthouse(l))])
    if (left.every((other) => distance(each, other) >= apart)) left.push(each);
  return left;
}

/** Through both marks, and to seaward as far as it leads; its bearing is the one from seaward. */
function transit(sheet: Sheet, { name, front, rear }: Transit, landmarks: readonly Landmark[]): void {
  const { c, at, colours } = sheet;
  const near = landmarks[front];
  const far = landmarks[rear];
  if (!near || !far) return;
  const bearing = directionTo(near, far);
  const out = pointAt(near, bearing + Math.PI, kSeaward);
  const [p, q, sea] = [near, far, out].map(({ x, y }) => at.toScreen(x, y)) as [Pixel, Pixel, Pixel];
  line(c, p, q, { colour: colours.text, width: 1.2 });
  line(c, p, sea, { colour: colours.text, width: 1.2, dash: [8, 5] });
  const words = pointAt(near, bearing + Math.PI, kWordsOut / at.scale);
  const { x, y } = at.toScreen(words.x, words.y);
  letter(sheet, rank.charted, `${name} ${bearingToTenth(bearing)}\u00b0`, { x: x + 8, y }, colours.text);
}

function anchored(sheet: Sheet, ship: AnchoredShip): void {
  const { c, at, colours } = sheet;
  const stretch = Math.max(1, kShortest / (ship.length * at.scale));
  const half = (stretch * ship.length) / 2;
  const side = (stretch * ship.beam) / 2;
  const aft = [-half, -side] as const;
  const outline = [[half, 0], [0.7 * half, side], [-half, side], aft, [0.7 * half, -side]] as const;
  c.beginPath();
  outline.forEach(([forward, port], k) => {
    const place = ofShip(ship, forward, port);
    const p = at.toScreen(place.x, place.y);
    if (k === 0) c.moveTo(p.x, p.y);
    else c.lineTo(p.x, p.y);
  });
  c.closePath();
  c.fillStyle = colours.shipFill;
  c.fill();
  stroke(c, { colour: colours.quiet, width: 1.5 });
  const p = at.toScreen(ship.x, ship.y);
  sheet.lettering.keep(around(p, kSign));
  letter(sheet, rank.charted, t("at anchor"), { x: p.x + 12, y: p.y }, colours.quiet);
}
