// From the world to the plan's screen and back.

import type { Place } from "./picture";

/** Pixels are CSS pixels, from the upper left corner. */
export interface Pixel {
  x: number;
  y: number;
}

export class Projection {
  /** World point in the middle of the screen. */
  centre: Place = { x: 0, y: 0 };
  /** Pixels for a metre. */
  scale = 1;
  /** Direction that is up on the screen, rad clockwise from north. */
  up = 0;
  width = 1;
  height = 1;

  toScreen(x: number, y: number): Pixel {
    const dx = x - this.centre.x;
    const dy = y - this.centre.y;
    const sin = Math.sin(this.up);
    const cos = Math.cos(this.up);
    return {
      x: this.width / 2 + (dx * cos - dy * sin) * this.scale,
      y: this.height / 2 - (dx * sin + dy * cos) * this.scale,
    };
  }

  toWorld({ x, y }: Pixel): Place {
    const right = (x - this.width / 2) / this.scale;
    const ahead = (this.height / 2 - y) / this.scale;
    const sin = Math.sin(this.up);
    const cos = Math.cos(this.up);
    return {
      x: this.centre.x + right * cos + ahead * sin,
      y: this.centre.y - right * sin + ahead * cos,
    };
  }

  /** Zooms by a factor so that the world stays where it is under a pixel. */
  zoom(factor: number, about: Pixel): void {
    const under = this.toWorld(about);
    this.scale = Math.min(kScaleMax, Math.max(kScaleMin, this.scale * factor));
    const now = this.toWorld(about);
    this.centre = { x: this.centre.x + under.x - now.x, y: this.centre.y + under.y - now.y };
  }

  /** Moves the world by pixels. */
  pan(dx: number, dy: number): void {
    this.centre = this.toWorld({ x: this.width / 2 - dx, y: this.height / 2 - dy });
  }
}

const kScaleMin = 0.01; // px/m: 100 km over 1000 px
const kScaleMax = 20; // a link is some 10 px

/** Direction from one point to another, rad clockwise from north, 0..2 pi. */
export function directionTo(from: Place, to: Place): number {
  const angle = Math.atan2(to.x - from.x, to.y - from.y);
  return angle < 0 ? angle + 2 * Math.PI : angle;
}

export const distance = (from: Place, to: Place): number => Math.hypot(to.x - from.x, to.y - from.y);

/** The point at a distance (m) in a direction (rad clockwise from north). */
export const pointAt = (from: Place, direction: number, range: number): Place => ({
  x: from.x + range * Math.sin(direction),
  y: from.y + range * Math.cos(direction),
});

/** A body point (x forward, y to port) of a ship, in the world. */
export const ofShip = (ship: Place & { heading: number }, forward: number, port: number): Place => ({
  x: ship.x + forward * Math.sin(ship.heading) - port * Math.cos(ship.heading),
  y: ship.y + forward * Math.cos(ship.heading) + port * Math.sin(ship.heading),
});
