// Lines parallel to an intended course, at a distance from own ship, as on a radar: what is fixed and charted must run
// along its line as long as she makes good the course. They go with her place, and do not turn with her heading.

import { bearingToTenth, degrees, figure, kNauticalMile, radians } from "../kit/units";
import { t } from "../kit/language";
import type { Sheet } from "./layers";
import type { Grip } from "./measuring";
import { grip, label, line } from "./pen";
import type { Place, PlanShip } from "./picture";
import { type Pixel, type Projection, directionTo, distance, pointAt } from "./projection";

export interface IndexLine {
  on: boolean;
  /** rad clockwise from north. */
  course: number;
  /** m from own ship, positive to starboard of the course. */
  off: number;
}

/** Of distances: m in one. */
export const kIndexUnits = { nm: kNauticalMile, cable: kNauticalMile / 10 } as const;
export type IndexUnit = keyof typeof kIndexUnits;

interface Kept {
  exercise: string;
  unit: IndexUnit;
  lines: [IndexLine, IndexLine];
}

/** m, farther than which no line is laid. */
export const kIndexMost = 20 * kNauticalMile;
const kEntry = "windlass.bridge.parallel_index";
const kDashes = [
  [18, 4, 3, 4],
  [18, 4, 3, 4, 3, 4],
] as const;
const kCourseStep = radians(0.1); // that a hand sets
const kOffStep = kNauticalMile / 100;
const kTurnAhead = 0.3; // of the screen's lesser side, from the foot of a line to where a hand turns it
const kBeside = 6; // px that a finger is farther from a line than from a grip on it

const none = (): [IndexLine, IndexLine] => [
  { on: false, course: 0, off: 0 },
  { on: false, course: 0, off: 0 },
];
const rounded = (value: number, step: number): number => Math.round(value / step) * step;
const around = (angle: number): number => ((angle % (2 * Math.PI)) + 2 * Math.PI) % (2 * Math.PI);

/** m to starboard of a course through own ship, and ahead along it. */
export function relativeTo(ship: Place, course: number, place: Place): { off: number; ahead: number } {
  const [dx, dy] = [place.x - ship.x, place.y - ship.y];
  const [sin, cos] = [Math.sin(course), Math.cos(course)];
  return { off: dx * cos - dy * sin, ahead: dx * sin + dy * cos };
}

/** The course, rad, of the line through a place that passes own ship at that distance, m; ahead of her on it. */
export function courseThrough(ship: Place, off: number, place: Place): number {
  const range = distance(ship, place);
  const aside = range > 0 ? Math.asin(Math.max(-1, Math.min(1, off / range))) : 0;
  return around(directionTo(ship, place) - aside);
}

export class ParallelIndex {
  lines = none();
  unit: IndexUnit = "nm";
  private exercise = "";
  private readonly listeners = new Set<() => void>();

  /** Of which exercise this page is: the lines that this computer keeps of it come back, those of another do not. */
  belongsTo(exercise: string): void {
    if (exercise === this.exercise) return;
    this.exercise = exercise;
    const kept = this.read();
    this.lines = kept?.exercise === exercise ? kept.lines : none();
    this.unit = kept?.unit ?? this.unit;
    for (const listener of this.listeners) listener();
  }

  /** Sets some of a line, rounded to a tenth of a degree and a hundredth of a mile where a hand has drawn it. */
  set(which: 0 | 1, change: Partial<IndexLine>, byHand = false): void {
    const next = { ...this.lines[which], ...change };
    const off = Math.max(-kIndexMost, Math.min(kIndexMost, byHand ? rounded(next.off, kOffStep) : next.off));
    const course = around(byHand ? rounded(next.course, kCourseStep) : next.course);
    this.lines[which] = { ...next, course, off };
    this.changed();
  }

  setUnit(unit: IndexUnit): void {
    this.unit = unit;
    this.changed();
  }

  onChange(listener: () => void): void {
    this.listeners.add(listener);
  }

  /** "PI 1 045.0°, 0.50 NM"; on which side it lies the plan shows. */
  text(which: 0 | 1): string {
    const { course, off } = this.lines[which];
    const far = Math.abs(off) / kIndexUnits[this.unit];
    const written = this.unit === "nm" ? `${figure(far, 2)} ${t("NM")}` : `${figure(far, 1)} ${t("cables")}`;
    return `PI ${which + 1} ${bearingToTenth(course)}\u00b0, ${written}`;
  }

  grips(at: Projection, ship: PlanShip | undefined): Grip[] {
    if (!ship) return [];
    return ([0, 1] as const)
      .filter((which) => this.lines[which].on)
      .flatMap((which): Grip[] => {
        const { course } = this.lines[which];
        const turn = screen(at, this.turn(which, at, ship));
        return [
          {
            at: turn,
            hit: (finger) => Math.hypot(finger.x - turn.x, finger.y - turn.y),
            move: (to) => this.set(which, { course: courseThrough(ship, this.lines[which].off, to) }, true),
          },
          {
            at: screen(at, this.foot(which, ship)),
            hit: (finger) => {
              const { off } = relativeTo(ship, course, at.toWorld(finger));
              return Math.abs(off - this.lines[which].off) * at.scale + kBeside;
            },
            move: (to) => this.set(which, { off: relativeTo(ship, course, to).off }, true),
          },
        ];
      });
  }

  draw({ c, at, colours }: Sheet, ship: PlanShip | undefined): void {
    if (!ship) return;
    for (const which of [0, 1] as const) {
      const { on, course } = this.lines[which];
      if (!on) continue;
      const foot = this.foot(which, ship);
      const far =
        distance(ship, at.toWorld({ x: 0, y: 0 })) + distance(at.toWorld({ x: at.width, y: at.height }), foot);
      const ends = [course, course + Math.PI].map((way) => screen(at, pointAt(foot, way, far))) as [Pixel, Pixel];
      line(c, ...ends, { colour: colours.measure, width: 1.5, dash: [...kDashes[which]] });
      const turn = screen(at, this.turn(which, at, ship));
      grip(c, turn, colours.measure, colours.sea);
      const left = turn.x > at.width / 2;
      label(
        c,
        this.text(which),
        { x: turn.x + (left ? -12 : 12), y: turn.y },
        colours.measure,
        colours.sea,
        left ? "right" : "left",
      );
    }
  }

  /** Where a line is nearest to own ship. */
  private foot(which: 0 | 1, ship: PlanShip): Place {
    const { course, off } = this.lines[which];
    return pointAt(ship, course + Math.PI / 2, off);
  }

  /** Where a hand turns it. */
  private turn(which: 0 | 1, at: Projection, ship: PlanShip): Place {
    const ahead = (kTurnAhead * Math.min(at.width, at.height)) / at.scale;
    return pointAt(this.foot(which, ship), this.lines[which].course, ahead);
  }

  private changed(): void {
    try {
      const { exercise, unit, lines } = this;
      localStorage.setItem(kEntry, JSON.stringify({ exercise, unit, lines } satisfies Kept));
    } catch {
      // a browser that keeps nothing shows them all the same
    }
    for (const listener of this.listeners) listener();
  }

  private read(): Kept | undefined {
    try {
      const kept = JSON.parse(localStorage.getItem(kEntry) ?? "null") as Kept | null;
      const whole = (l: IndexLine): boolean => Number.isFinite(l.course) && Number.isFinite(l.off);
      return kept?.lines.length === 2 && kept.lines.every(whole) && kept.unit in kIndexUnits ? kept : undefined;
    } catch {
      return undefined; // what somebody else has written there
    }
  }
}

const screen = (at: Projection, { x, y }: Place): Pixel => at.toScreen(x, y);

/** deg and the unit that is chosen, as a form has them. */
export const indexFigures = ({ course, off }: IndexLine, unit: IndexUnit): { course: string; far: string } => ({
  course: String(Math.round(10 * degrees(course)) / 10),
  far: String(Math.round((1000 * Math.abs(off)) / kIndexUnits[unit]) / 1000),
});
