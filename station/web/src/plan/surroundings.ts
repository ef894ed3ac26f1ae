// What is charted round the anchorage: land, lights, ships at anchor.

import { radians } from "../kit/units";
import { type AnchoredShip, type Coast, type Light, type Surroundings, character } from "../surroundings/surroundings";
import type { Sheet } from "./layers";
import { label, stroke } from "./pen";
import type { Place } from "./picture";
import { type Pixel, ofShip } from "./projection";

/** m, of what the chart takes as land behind a ridge. */
const kInland = 1500;
const kShortest = 9; // px, of a ship that is drawn

/** shift: m, by which they are moved. */
export function surroundings(sheet: Sheet, { coasts, lights, ships }: Surroundings, shift: Place): void {
  const toScreen = (x: number, y: number): Pixel => sheet.at.toScreen(x + shift.x, y + shift.y);
  for (const coast of coasts) land(sheet, coast, toScreen);
  for (const ship of ships) anchored(sheet, ship, toScreen);
  for (const light of lights) lighthouse(sheet, light, toScreen(light.x, light.y));
}

function land({ c, colours }: Sheet, { shore, ridge }: Coast, toScreen: (x: number, y: number) => Pixel): void {
  const edge = shore.map(([x, y]) => toScreen(x!, y!));
  const inland = ridge.map(([x, y]) => {
    const farther = 1 + kInland / Math.hypot(x!, y!);
    return toScreen(farther * x!, farther * y!);
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

/** A point with a flare, its character beside it. */
function lighthouse({ c, colours }: Sheet, light: Light, p: Pixel): void {
  c.beginPath();
  c.moveTo(p.x, p.y);
  c.quadraticCurveTo(p.x + 12, p.y + 4, p.x + 18, p.y + 15);
  c.quadraticCurveTo(p.x + 6, p.y + 16, p.x, p.y);
  c.fillStyle = colours.light;
  c.fill();
  c.beginPath();
  c.arc(p.x, p.y, 3, 0, 2 * Math.PI);
  c.fillStyle = colours.text;
  c.fill();
  label(c, `${light.name}, ${character(light)}`, { x: p.x + 10, y: p.y - 10 }, colours.text, colours.sea);
}

function anchored({ c, at, colours }: Sheet, ship: AnchoredShip, toScreen: (x: number, y: number) => Pixel): void {
  const heading = radians(ship.heading_deg);
  const stretch = Math.max(1, kShortest / (ship.length * at.scale));
  const half = (stretch * ship.length) / 2;
  const side = (stretch * ship.beam) / 2;
  const aft = [-half, -side] as const;
  const outline = [[half, 0], [0.7 * half, side], [-half, side], aft, [0.7 * half, -side]] as const;
  c.beginPath();
  outline.forEach(([forward, port], k) => {
    const place = ofShip({ ...ship, heading }, forward, port);
    const p = toScreen(place.x, place.y);
    if (k === 0) c.moveTo(p.x, p.y);
    else c.lineTo(p.x, p.y);
  });
  c.closePath();
  c.fillStyle = colours.shipFill;
  c.fill();
  stroke(c, { colour: colours.quiet, width: 1.5 });
  const p = toScreen(ship.x, ship.y);
  label(c, "at anchor", { x: p.x + 12, y: p.y }, colours.quiet, colours.sea);
}
