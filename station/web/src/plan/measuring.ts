// What is measured on the plan by hand: two bearing lines with their range rings from own ship, and a ruler.

import { bearing, degrees, figure } from "../kit/units";
import { type Sheet, distanceText } from "./layers";
import { grip, label, line, ring } from "./pen";
import type { Place, PlanShip } from "./picture";
import { type Pixel, type Projection, directionTo, distance, ofShip, pointAt } from "./projection";
import { t } from "../kit/language";

/** An electronic bearing line with its variable range marker. */
export interface BearingLine {
  on: boolean;
  /** m forward of midships, from where it is laid: the place of GPS, or of the eye that took the bearing. */
  forward: number;
  bearing: number; // rad clockwise from north
  range: number; // m
}

export interface Ruler {
  on: boolean;
  from: Place;
  to: Place;
}

/** Something that a finger takes hold of. */
export interface Grip {
  at: Pixel;
  /** Distance, px, within which it is taken, of the finger to the grip. */
  hit: (finger: Pixel) => number;
  move: (to: Place) => void;
}

export class Measuring {
  readonly lines: [BearingLine, BearingLine] = [
    { on: false, forward: 0, bearing: 0, range: 500 },
    { on: false, forward: 0, bearing: Math.PI / 2, range: 1000 },
  ];
  readonly ruler: Ruler = { on: false, from: { x: 0, y: 0 }, to: { x: 0, y: 0 } };

  /** What the lines read, e.g. "045.0° T, 010.0° R, 250 m"; empty where it is off. */
  text(which: 0 | 1, heading: number | undefined): string {
    const l = this.lines[which];
    if (!l.on) return "";
    const north = t("{bearing} T", { bearing: `${figure(((degrees(l.bearing) % 360) + 360) % 360, 1)}\u00b0` });
    const ahead = heading === undefined ? "" : t("R {bearing}", { bearing: `${bearing(l.bearing - heading)}\u00b0` });
    return [north, ahead, distanceText(l.range)].filter(Boolean).join(", ");
  }

  rulerText(): string {
    const { on, from, to } = this.ruler;
    const north = t("{bearing} T", { bearing: `${bearing(directionTo(from, to))}\u00b0` });
    return on ? `${north}, ${distanceText(distance(from, to))}` : "";
  }

  grips(at: Projection, ship: PlanShip | undefined): Grip[] {
    const found: Grip[] = [];
    const near =
      (p: Pixel) =>
      (finger: Pixel): number =>
        Math.hypot(finger.x - p.x, finger.y - p.y);
    if (ship)
      for (const l of this.lines.filter((l) => l.on)) {
        const from = ofShip(ship, l.forward, 0);
        const cross = pointAt(from, l.bearing, l.range);
        const pixel = at.toScreen(cross.x, cross.y);
        found.push({
          at: pixel,
          hit: near(pixel),
          move: (to) => {
            l.bearing = directionTo(from, to);
            l.range = Math.max(1, distance(from, to));
          },
        });
        const centre = at.toScreen(from.x, from.y);
        found.push({
          at: pixel,
          hit: (finger) => Math.abs(Math.hypot(finger.x - centre.x, finger.y - centre.y) - l.range * at.scale) + 6,
          move: (to) => (l.range = Math.max(1, distance(from, to))),
        });
      }
    if (this.ruler.on)
      for (const end of ["from", "to"] as const) {
        const pixel = at.toScreen(this.ruler[end].x, this.ruler[end].y);
        found.push({ at: pixel, hit: near(pixel), move: (to) => (this.ruler[end] = to) });
      }
    return found;
  }

  draw(sheet: Sheet, ship: PlanShip | undefined): void {
    const { c, at, colours } = sheet;
    const colour = colours.measure;
    this.lines.forEach((l, k) => {
      if (!l.on || !ship) return;
      const dash = k === 0 ? [10, 4] : [3, 4];
      const from = ofShip(ship, l.forward, 0);
      const centre = at.toScreen(from.x, from.y);
      const far = pointAt(from, l.bearing, (2 * Math.hypot(at.width, at.height)) / at.scale);
      line(c, centre, at.toScreen(far.x, far.y), { colour, width: 1.5, dash });
      ring(c, centre, l.range * at.scale, { colour, width: 1.5, dash });
      const cross = pointAt(from, l.bearing, l.range);
      const pixel = at.toScreen(cross.x, cross.y);
      grip(c, pixel, colour, colours.sea);
      label(c, `${k + 1}`, { x: pixel.x + 10, y: pixel.y - 10 }, colour, colours.sea);
    });
    if (!this.ruler.on) return;
    const from = at.toScreen(this.ruler.from.x, this.ruler.from.y);
    const to = at.toScreen(this.ruler.to.x, this.ruler.to.y);
    line(c, from, to, { colour, width: 2 });
    grip(c, from, colour, colours.sea);
    grip(c, to, colour, colours.sea);
    label(c, this.rulerText(), { x: (from.x + to.x) / 2 + 8, y: (from.y + to.y) / 2 - 10 }, colour, colours.sea);
  }
}
