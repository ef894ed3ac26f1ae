// Few strokes that all layers of the plan share.

import type { Pixel } from "./projection";

export type Context = CanvasRenderingContext2D;

export interface Stroke {
  colour: string;
  width?: number;
  dash?: number[];
}

export function stroke(c: Context, { colour, width = 1, dash = [] }: Stroke): void {
  c.strokeStyle = colour;
  c.lineWidth = width;
  c.setLineDash(dash);
  c.stroke();
  c.setLineDash([]);
}

export function line(c: Context, from: Pixel, to: Pixel, how: Stroke): void {
  c.beginPath();
  c.moveTo(from.x, from.y);
  c.lineTo(to.x, to.y);
  stroke(c, how);
}

export function ring(c: Context, at: Pixel, radius: number, how: Stroke): void {
  c.beginPath();
  c.arc(at.x, at.y, radius, 0, 2 * Math.PI);
  stroke(c, how);
}

/** A line of text with a border in the ground's colour, so that it is read over anything. */
export function label(
  c: Context,
  text: string,
  at: Pixel,
  colour: string,
  ground: string,
  align: CanvasTextAlign = "left",
): void {
  c.textAlign = align;
  c.textBaseline = "middle";
  c.lineJoin = "round";
  c.lineWidth = 3;
  c.strokeStyle = ground;
  c.strokeText(text, at.x, at.y);
  c.fillStyle = colour;
  c.fillText(text, at.x, at.y);
}

/** A small square that can be dragged. */
export function grip(c: Context, at: Pixel, colour: string, ground: string): void {
  c.beginPath();
  c.rect(at.x - 5, at.y - 5, 10, 10);
  c.fillStyle = ground;
  c.fill();
  stroke(c, { colour, width: 2 });
}
