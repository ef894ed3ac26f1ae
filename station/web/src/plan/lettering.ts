// What is written on the plan, so that nothing of it lies on anything else: what is needed most is placed first, and
// what then has no room is left out.

import type { PlanColours } from "./colours";
import { type Context, label } from "./pen";
import type { Pixel } from "./projection";

/** px, y downwards. */
export interface Box {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

/** Where something may be written, and how it is written there. */
interface Place {
  box: Box;
  draw: () => void;
}

/** In which order what is written has its place. What is the ship's own, up to rank.own, gives way to no sign. */
export const rank = { left: 0, own: 1, charted: 2, ring: 3, contour: 4, sounding: 5 } as const;

const kHalfLine = 7; // px, of a line of text
const kBorder = 2; // px round it

/** Around a point. */
export const around = ({ x, y }: Pixel, half: number): Box => ({
  left: x - half,
  top: y - half,
  right: x + half,
  bottom: y + half,
});

const overlap = (a: Box, b: Box): boolean =>
  a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;

/** Of one picture. */
export class Lettering {
  private readonly signs: Box[] = [];
  private readonly words: Box[] = [];
  private readonly waiting: { rank: number; places: Place[] }[] = [];

  /** Keeps a place free: a sign stands there. */
  keep(...boxes: Box[]): void {
    this.signs.push(...boxes);
  }

  /** Lets nothing be written there, the ship's own neither: it could not be read. */
  cover(...boxes: Box[]): void {
    this.words.push(...boxes);
  }

  /** Something that is to be written, at the first of these places that has room. */
  add(its: number, ...places: Place[]): void {
    this.waiting.push({ rank: its, places });
  }

  /** Writes all that has room, in a rank what was added first. */
  write(): void {
    for (const { rank: its, places } of this.waiting.sort((a, b) => a.rank - b.rank)) {
      const taken = its > rank.own ? [...this.words, ...this.signs] : this.words;
      const free = places.find(({ box }) => !taken.some((other) => overlap(box, other)));
      if (!free) continue;
      this.words.push(free.box);
      free.draw();
    }
  }
}

function boxOf(c: Context, text: string, { x, y }: Pixel, align: CanvasTextAlign): Box {
  const { width } = c.measureText(text);
  const left = align === "right" ? x - width : align === "center" ? x - width / 2 : x;
  return {
    left: left - kBorder,
    top: y - kHalfLine - kBorder,
    right: left + width + kBorder,
    bottom: y + kHalfLine + kBorder,
  };
}

interface Sheet {
  c: Context;
  colours: PlanColours;
  lettering: Lettering;
}

function placed({ c, colours }: Sheet, text: string, at: Pixel, colour: string, align: CanvasTextAlign): Place {
  return { box: boxOf(c, text, at, align), draw: () => label(c, text, at, colour, colours.sea, align) };
}

/** A label, where it has room. */
export function letter(
  sheet: Sheet,
  its: number,
  text: string,
  at: Pixel,
  colour: string,
  align: CanvasTextAlign = "left",
): void {
  sheet.lettering.add(its, placed(sheet, text, at, colour, align));
}

/** The name of a sign, on whichever side of it there is room: right, left, below or above. gap: px from its middle. */
export function nameBeside(
  sheet: Sheet,
  its: number,
  text: string,
  { x, y }: Pixel,
  gap: number,
  colour: string,
): void {
  const down = gap + kHalfLine;
  sheet.lettering.add(
    its,
    placed(sheet, text, { x: x + gap, y }, colour, "left"),
    placed(sheet, text, { x: x - gap, y }, colour, "right"),
    placed(sheet, text, { x, y: y + down }, colour, "center"),
    placed(sheet, text, { x, y: y - down }, colour, "center"),
  );
}
