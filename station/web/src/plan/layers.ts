// Layers of the plan, each drawn from plain data.

import { bearing, figure, kNauticalMile, knots } from "../kit/units";
import type { PlanColours } from "./colours";
import { contours as contoursOf } from "./contours";
import { type Lettering, around, letter, nameBeside, rank } from "./lettering";
import { type Context, grip, label, line, ring, stroke } from "./pen";
import type { PlanCircle, PlanFlow, PlanLine, PlanMark, PlanPicture, PlanShip, PlanSounding } from "./picture";
import { type Pixel, type Projection, ofShip, pointAt } from "./projection";
import { thin } from "./thin";
import { t } from "../kit/language";

const kSymbolBelow = 14; // px of length, under which a ship is a symbol
const kSoundingsApart = 52; // px, at least: fewer figures than the chart has, where it is shown small
const kSign = 8; // px, half of a mark's sign
const kFiguresApart = 300; // px along a contour, from one of its figures to the next
const kHullBoxes = 7; // along her hull, in which nothing is written: she is some seven beams long
const kVectorMinutes = 6; // her place after so many minutes, as ECDIS draws it at anchor speeds

export interface Sheet {
  c: Context;
  at: Projection;
  colours: PlanColours;
  /** Names and figures, which are written over all that is drawn. */
  lettering: Lettering;
}

/** The largest round length (1, 2, 5 times a power of ten; m, from a mile on miles) not above that one, m. */
export function roundLength(length: number): number {
  const unit = length < kNauticalMile ? 1 : kNauticalMile;
  const power = 10 ** Math.floor(Math.log10(length / unit));
  const first = length / unit / power;
  return (first >= 5 ? 5 : first >= 2 ? 2 : 1) * power * unit;
}

/** m below a mile, else miles. */
export function distanceText(metres: number): string {
  return metres < kNauticalMile
    ? `${figure(metres)} m`
    : `${figure(metres / kNauticalMile, 2).replace(/[.,]?0+$/, "")} ${t("NM")}`;
}

/** Lines of equal depth, each with its figure on it here and there. */
export function contours(sheet: Sheet, chart: PlanSounding[]): void {
  const { c, at, colours } = sheet;
  for (const { depth, points } of contoursOf(chart)) {
    const pixels = points.map(({ x, y }) => at.toScreen(x, y));
    c.beginPath();
    pixels.forEach((p, k) => (k === 0 ? c.moveTo(p.x, p.y) : c.lineTo(p.x, p.y)));
    c.lineJoin = "round";
    stroke(c, { colour: colours.contour });
    let before = kFiguresApart / 2; // px of the line since the last figure
    pixels.forEach((p, k) => {
      const last = pixels[k - 1];
      if (last) before += Math.hypot(p.x - last.x, p.y - last.y);
      if (before < kFiguresApart) return;
      before = 0;
      letter(sheet, rank.contour, `${depth}`, p, colours.contour, "center");
    });
  }
}

export function soundings({ c, at, colours, lettering }: Sheet, all: PlanSounding[]): void {
  const apart = 2 ** Math.ceil(Math.log2(kSoundingsApart / at.scale)); // by octaves, so that zooming does not stir them
  for (const s of thin(all, apart)) {
    const p = at.toScreen(s.x, s.y);
    if (p.x < -20 || p.y < -20 || p.x > at.width + 20 || p.y > at.height + 20) continue;
    const whole = Math.floor(s.depth + 1e-6);
    const box = { left: p.x - c.measureText(`${whole}`).width, top: p.y - 7, right: p.x + 17, bottom: p.y + 9 };
    lettering.add(rank.sounding, { box, draw: () => sounding(c, s, whole, p, colours.quiet) });
  }
}

/** Whole metres, tenths small behind them where they count, and the soil. */
function sounding(c: Context, { depth, letter: soil }: PlanSounding, whole: number, p: Pixel, colour: string): void {
  const tenth = Math.floor((depth - whole) * 10 + 1e-6);
  c.fillStyle = colour;
  c.textBaseline = "middle";
  c.textAlign = "right";
  c.fillText(`${whole}`, p.x, p.y);
  c.textAlign = "left";
  if (whole < 31 && tenth > 0) {
    c.save();
    c.font = c.font.replace(/\d+px/, "9px");
    c.fillText(`${tenth}`, p.x + 1, p.y + 4);
    c.restore();
  }
  if (soil) {
    c.save();
    c.font = `italic ${c.font}`;
    c.fillText(soil, p.x + 8, p.y - 1);
    c.restore();
  }
}

export function rings(sheet: Sheet, ship: PlanShip, interval: number): void {
  const { c, at, colours } = sheet;
  const centre = at.toScreen(ship.x, ship.y);
  const reach = Math.hypot(at.width, at.height);
  for (let k = 1; k <= 8; ++k) {
    const radius = k * interval * at.scale;
    if (radius > reach) break;
    c.globalAlpha = 0.6;
    ring(c, centre, radius, { colour: colours.grid });
    c.globalAlpha = 1;
    const foot = { x: centre.x, y: centre.y + radius };
    letter(sheet, rank.ring, distanceText(k * interval), foot, colours.quiet, "center");
  }
}

export function lines({ c, at, colours }: Sheet, all: PlanLine[]): void {
  for (const { kind, points } of all) {
    c.beginPath();
    for (let k = 0; k + 1 < points.length; k += 2) {
      const p = at.toScreen(points[k]!, points[k + 1]!);
      if (k === 0) c.moveTo(p.x, p.y);
      else c.lineTo(p.x, p.y);
    }
    c.lineJoin = "round";
    if (kind === "cable") stroke(c, { colour: colours.cable, width: 2.5 });
    else if (kind === "trail") stroke(c, { colour: colours.anchor, width: 1.5, dash: [2, 3] });
    else stroke(c, { colour: colours.track, width: 1.5 });
  }
}

/** Where she will be: over her hull and her vector, from midships to a ring at its end. */
export function ahead({ c, at, colours }: Sheet, points: ArrayLike<number>): void {
  let end: Pixel | undefined;
  c.beginPath();
  for (let k = 0; k + 1 < points.length; k += 2) {
    end = at.toScreen(points[k]!, points[k + 1]!);
    if (k === 0) c.moveTo(end.x, end.y);
    else c.lineTo(end.x, end.y);
  }
  if (!end) return;
  c.lineCap = c.lineJoin = "round";
  stroke(c, { colour: colours.sea, width: 5 });
  stroke(c, { colour: colours.left, width: 3, dash: [0.1, 5] });
  c.lineCap = "butt";
  ring(c, end, 5, { colour: colours.left, width: 2 });
}

const circleDash: Record<PlanCircle["kind"], number[]> = { swing: [8, 5], drag: [2, 4], watch: [] };

/** Where round the circle its label is tried first, rad clockwise from up: so that labels lie apart. */
const kLabelTurn: Record<PlanCircle["kind"], number> = { swing: 0.35, drag: 0.8, watch: -0.6 };

/** A point of a circle that is well on the screen; undefined: there is none. */
function inSight(at: Projection, centre: Pixel, radius: number, first: number): Pixel | undefined {
  for (let k = 0; k < 16; ++k) {
    const turn = first + (Math.sign(first) * k * Math.PI) / 8;
    const p = { x: centre.x + radius * Math.sin(turn), y: centre.y - radius * Math.cos(turn) };
    if (p.x > 70 && p.x < at.width - 70 && p.y > 140 && p.y < at.height - 40) return p;
  }
  return undefined;
}

export function circles(sheet: Sheet, all: PlanCircle[]): void {
  const { c, at, colours } = sheet;
  for (const circle of all) {
    const centre = at.toScreen(circle.x, circle.y);
    const radius = circle.radius * at.scale;
    const colour = circle.left ? colours.left : circle.kind === "watch" ? colours.watch : colours.anchor;
    ring(c, centre, radius, {
      colour,
      width: circle.left ? 5 : circle.kind === "watch" ? 2.5 : 1.5,
      dash: circleDash[circle.kind],
    });
    if (circle.kind === "watch") {
      line(c, { x: centre.x - 5, y: centre.y }, { x: centre.x + 5, y: centre.y }, { colour, width: 2 });
      line(c, { x: centre.x, y: centre.y - 5 }, { x: centre.x, y: centre.y + 5 }, { colour, width: 2 });
    }
    const text = `${circle.label} ${distanceText(circle.radius)}${circle.left ? `, ${t("LEFT|circle")}` : ""}`;
    const place = inSight(at, centre, radius, kLabelTurn[circle.kind]);
    if (place) letter(sheet, circle.left ? rank.left : rank.own, text, place, colours.text, "center");
    if (circle.editable) grip(c, { x: centre.x + radius, y: centre.y }, colour, colours.sea);
  }
}

export function marks(sheet: Sheet, all: PlanMark[]): void {
  const { c, at, colours, lettering } = sheet;
  for (const mark of all) {
    const p = at.toScreen(mark.x, mark.y);
    const pen = { colour: colours.anchor, width: 2 };
    if (mark.kind === "anchor") anchorSign(c, p.x, p.y, colours);
    else {
      c.beginPath();
      c.moveTo(p.x, p.y - 7);
      c.lineTo(p.x + 6, p.y + 5);
      c.lineTo(p.x - 6, p.y + 5);
      c.closePath();
      stroke(c, pen);
    }
    lettering.keep(around(p, kSign));
    nameBeside(sheet, rank.own, mark.label, p, 11, colours.text);
  }
}

/** Ring, stock, shank and arms: the chart's sign of an anchor. */
function anchorSign(c: Context, x: number, y: number, colours: PlanColours): void {
  const path = (): void => {
    c.beginPath();
    c.arc(x, y - 8, 2, 0, 2 * Math.PI);
    c.moveTo(x, y - 6);
    c.lineTo(x, y + 8);
    c.moveTo(x - 4, y - 3);
    c.lineTo(x + 4, y - 3);
    c.moveTo(x - 7, y + 3);
    c.quadraticCurveTo(x - 5, y + 8, x, y + 8);
    c.quadraticCurveTo(x + 5, y + 8, x + 7, y + 3);
  };
  path();
  stroke(c, { colour: colours.sea, width: 5 });
  path();
  stroke(c, { colour: colours.anchor, width: 2 });
}

export function ownShip(sheet: Sheet, ship: PlanShip): void {
  const { c, at, colours, lettering } = sheet;
  const here = at.toScreen(ship.x, ship.y);
  lettering.keep(around(here, kSign));
  const outline = ship.outline ?? new Float32Array();
  const length = outline.length ? 2 * at.scale * Math.max(...outline.filter((_, k) => k % 2 === 0)) : 0;
  if (length >= kSymbolBelow) {
    c.beginPath();
    for (let k = 0; k + 1 < outline.length; k += 2) {
      const p = ofShip(ship, outline[k]!, outline[k + 1]!);
      const pixel = at.toScreen(p.x, p.y);
      if (k === 0) c.moveTo(pixel.x, pixel.y);
      else c.lineTo(pixel.x, pixel.y);
    }
    c.closePath();
    c.fillStyle = colours.shipFill;
    c.globalAlpha = 0.6;
    c.fill();
    c.globalAlpha = 1;
    stroke(c, { colour: colours.ship, width: 2 });
    const half = length / 2 / kHullBoxes;
    for (let k = 1 - kHullBoxes; k < kHullBoxes; k += 2) {
      const p = ofShip(ship, (k * half) / at.scale, 0);
      lettering.keep(around(at.toScreen(p.x, p.y), half));
    }
  } else {
    ring(c, here, 6, { colour: colours.ship, width: 2 });
    ring(c, here, 3, { colour: colours.ship, width: 1.5 });
  }
  const ahead = ofShip(ship, Math.max(length / 2 / at.scale, 0) + 60 / at.scale, 0);
  line(c, here, at.toScreen(ahead.x, ahead.y), { colour: colours.ship });
  ring(c, here, 2.5, { colour: colours.ship, width: 1.5 });
  vector(sheet, ship);
}

/** Course and speed over ground as the way she makes in some minutes, with two arrow heads. */
function vector({ c, at, colours }: Sheet, ship: PlanShip): void {
  if (ship.course === undefined || !ship.speed) return;
  const tip = pointAt(ship, ship.course, ship.speed * 60 * kVectorMinutes);
  const from = at.toScreen(ship.x, ship.y);
  const to = at.toScreen(tip.x, tip.y);
  if (Math.hypot(to.x - from.x, to.y - from.y) < 4) return;
  line(c, from, to, { colour: colours.measure, width: 2, dash: [6, 3] });
  const way = Math.atan2(to.y - from.y, to.x - from.x);
  for (const back of [0, 6]) head(c, to.x - back * Math.cos(way), to.y - back * Math.sin(way), way, colours.measure);
}

function head(c: Context, x: number, y: number, way: number, colour: string): void {
  c.beginPath();
  c.moveTo(x - 7 * Math.cos(way - 0.45), y - 7 * Math.sin(way - 0.45));
  c.lineTo(x, y);
  c.lineTo(x - 7 * Math.cos(way + 0.45), y - 7 * Math.sin(way + 0.45));
  stroke(c, { colour, width: 2 });
}

/** In the corner: north, wind and stream as arrows round one point, with their figures under it. */
export function compassRose({ c, at, colours, lettering }: Sheet, picture: PlanPicture): void {
  const centre = { x: at.width - 48, y: 56 };
  lettering.keep(around(centre, 44));
  ring(c, centre, 30, { colour: colours.grid });
  const end = (direction: number, length: number): { x: number; y: number } => ({
    x: centre.x + length * Math.sin(direction - at.up),
    y: centre.y - length * Math.cos(direction - at.up),
  });
  const tip = end(0, 30);
  line(c, end(0, 14), tip, { colour: colours.text, width: 2 });
  head(c, tip.x, tip.y, Math.atan2(tip.y - centre.y, tip.x - centre.x), colours.text);
  const n = end(0, 39);
  label(c, "N", n, colours.text, colours.sea, "center");
  let row = centre.y + 56;
  const arrow = (flow: PlanFlow | undefined, towards: number, colour: string, words: (way: string) => string): void => {
    if (!flow || flow.speed < 0.01) return;
    const from = end(towards + Math.PI, 25);
    const to = end(towards, 25);
    line(c, from, to, { colour, width: 2.5 });
    head(c, to.x, to.y, Math.atan2(to.y - from.y, to.x - from.x), colour);
    const text = `${words(bearing(flow.direction))} ${figure(knots(flow.speed), 1)} kn`;
    const right = at.width - 10;
    lettering.keep({ left: right - c.measureText(text).width, top: row - 9, right: at.width, bottom: row + 9 });
    label(c, text, { x: right, y: row }, colours.text, colours.sea, "right");
    row += 17;
  };
  const windTo = (picture.wind?.direction ?? 0) + Math.PI;
  arrow(picture.wind, windTo, colours.wind, (way) => t("wind from {way}°", { way }));
  arrow(picture.stream, picture.stream?.direction ?? 0, colours.stream, (way) => t("stream sets {way}°", { way }));
}

/** A round length along the lower edge, in m. */
export function scaleBar({ c, at, colours, lettering }: Sheet): void {
  const metres = roundLength(160 / at.scale);
  const width = metres * at.scale;
  const y = at.height - 14;
  const x = 14;
  c.beginPath();
  c.moveTo(x, y - 5);
  c.lineTo(x, y);
  c.lineTo(x + width, y);
  c.lineTo(x + width, y - 5);
  stroke(c, { colour: colours.text, width: 2 });
  const text = distanceText(metres);
  const words = { x: x + width + 8, y: y - 4 };
  lettering.keep({ left: x, top: y - 12, right: words.x + c.measureText(text).width + 4, bottom: y + 6 });
  label(c, text, words, colours.text, colours.sea);
}
