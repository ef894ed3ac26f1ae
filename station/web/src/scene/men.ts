// Where the men on deck stand, by what the page knows of the work at the windlasses. Nobody stands at a cable that
// moves: they touch none that is not held, step back when it runs, and run when it runs away.

import { DeckHindrance, DeckWork, type ForecastleView, LiningSeen } from "../wire/generated";
import type { TackleFrame } from "./frame";
import { type Rig, size } from "./rig";
import { clamp } from "./vec";

export type Spot = readonly [number, number];

/** What a man does with himself; point: with an arm, to where the cable leads. */
export type Bearing = "stands" | "watches" | "crouches" | "hammers" | "calls";

/** m, body frame, on deck. */
export interface Place {
  at: Spot;
  /** What he looks at. */
  looks: Spot;
  /** Ways from the middle line, first on it, on which nobody steps over a cable. */
  by: readonly Spot[];
  bearing: Bearing;
}

/** Three of them in a party: bosun, fitter, cadet. */
export const kMen = 3;

const kRunsAway = 6; // m/s: a cable that nobody stays beside, said to run away (forecastle/captions.ts)
const kRuns = 0.3; // m/s: one that nobody stands at
const kStaysBack = 30; // s, after a danger or a cry

/** Whether it is no place for men: what is seen and heard of one windlass. */
export const isDanger = (t: TackleFrame): boolean =>
  Math.abs(t.cable_speed) >= kRunsAway || t.jumping || t.stopper_sprung || t.lining >= LiningSeen.LINING_BURNS;

/** What men are at, as it is seen on deck. */
export function menSeen(view: ForecastleView): { work: DeckWork; goes: boolean } {
  const waits = view.deck_work_waits !== DeckHindrance.DECK_HINDRANCE_NONE;
  const isDone = !waits && !(view.deck_work_left > 0);
  return { work: isDone ? DeckWork.DECK_WORK_NONE : view.deck_work, goes: !waits };
}

/** Places by the gear; rail: m, half the breadth over the bulwark at x. */
class Gear {
  private readonly k: number;

  constructor(
    private readonly rig: Rig,
    private readonly rail: (x: number) => number,
  ) {
    this.k = size(rig.tackle);
  }

  /** In sizes of the gear: aft along the cable and outboard of the gypsy. */
  private from(aft: number, outboard: number): Spot {
    const { gypsy, lead, out } = this.rig;
    const [a, o] = [aft * this.k, outboard * this.k];
    return [gypsy[0] + a * lead[0] + o * out[0], gypsy[1] + a * lead[1] + o * out[1]];
  }

  private place(at: Spot, looks: Spot, bearing: Bearing): Place {
    return { at, looks, by: [[at[0], 0]], bearing };
  }
  /** On the inboard side of the cable, so far off it, looking at it. */
  private beside(aft: number, off: number, bearing: Bearing): Place {
    return this.place(this.from(aft, -off), this.from(aft, 0), bearing);
  }
  /** At the rail, m ahead of the hawse pipe's lip. */
  atRail(ahead: number): Place {
    const { lip } = this.rig.tackle;
    const x = lip.x + ahead;
    const y = this.rig.sign * (this.rail(x) - 0.62);
    return this.place([x, y], [x - 0.35, 2 * y], "watches");
  }
  /** By the stopper, of a cable that lies still. */
  byStopper(): Place {
    return this.beside(-2.1, 1.5, "stands");
  }
  /** Abaft the windlass, m to this side of the middle line. */
  abaft(behind: number, y: number, bearing: Bearing): Place {
    const x = this.rig.gypsy[0] - behind * this.k;
    return this.place([x, this.rig.sign * y], this.from(0, 0), bearing);
  }
  /** Of who works the windlass. */
  atBrake(): Place {
    return this.place(this.from(1.5, -0.85), this.from(-1, -0.3), "stands");
  }
  /** For those who are at it, the first first; what is not there is not asked of anybody. */
  work(work: DeckWork, goes: boolean): Place[] {
    const [near, does]: [number, Bearing] = goes ? [0.75, "crouches"] : [1.7, "stands"];
    switch (work) {
      case DeckWork.DECK_WORK_CLEAR_ANCHOR:
        return goes ? [this.atRail(0.7), this.atRail(1.7)] : [this.byStopper(), this.beside(-3, 1.7, "stands")];
      case DeckWork.DECK_WORK_BREAK_CABLE:
        return [this.beside(-1.3, near, does), this.beside(-2.9, near, does)];
      case DeckWork.DECK_WORK_SLIP:
        return [this.beside(-1.3, goes ? 0.95 : 1.7, goes ? "hammers" : "stands")];
      case DeckWork.DECK_WORK_CROSS_CONNECT:
        return [this.place(this.from(2.3, 2.6), this.from(1.1, 2.4), does)];
      default:
        return [];
    }
  }
}

/** What is known of the moment. */
export interface Known {
  /** By side. */
  tackle: readonly (TackleFrame | undefined)[];
  /** The windlass that is worked. */
  side: number;
  /** They were sent back, or a danger is not long over. */
  back: boolean;
}

export class Stations {
  private readonly gear = new Map<number, Gear>();

  /** rail: m, half the breadth over the bulwark at x. */
  constructor(rigs: readonly Rig[], rail: (x: number) => number) {
    for (const r of rigs) this.gear.set(r.tackle.side, new Gear(r, rail));
  }

  /** Where bosun, fitter and cadet stand; none: nothing is known of them. */
  places({ tackle, side, back }: Known): Place[] {
    const gear = this.gear.get(side);
    if (!gear || !tackle[side]?.men) return [];
    const danger = tackle.some((t) => t && isDanger(t));
    const runs = tackle.some((t) => t && Math.abs(t.cable_speed) > kRuns);
    const lookout = gear.atRail(0.7);
    const behind = gear.abaft(3.2, 0.8, "stands");
    const safe = [0.9, -0.9, 0].map((y, i) => gear.abaft(i === 2 ? 4.6 : 5.2, y, "calls"));
    const places =
      danger || back
        ? safe
        : [lookout, runs ? behind : gear.byStopper(), gear.abaft(2.7, -2.7, runs ? "calls" : "stands")];
    // Work is done where the server has men at it: by the fitter first, then by the bosun.
    const wanted = [...this.gear].flatMap(([at, g]) => {
      const { work, goes } = tackle[at]?.men ?? { work: DeckWork.DECK_WORK_NONE, goes: false };
      return goes || !(danger || back) ? g.work(work, goes) : [];
    });
    for (const [i, place] of wanted.slice(0, kMen).entries()) places[[1, 0, 2][i]!] = place;
    return places;
  }

  /** Of who works a windlass. */
  atBrake(side: number): Place | undefined {
    return this.gear.get(side)?.atBrake();
  }
}

/** When they were last sent back, and whether they may come forward again. */
export class Warned {
  private until = -Infinity; // s, exercise time

  /** cried: s, when somebody last cried "stand clear". */
  back(time: number, tackle: readonly (TackleFrame | undefined)[], cried = -Infinity): boolean {
    if (this.until > time + kStaysBack) this.until = -Infinity; // another branch of time
    if (tackle.some((t) => t && isDanger(t))) this.until = time + kStaysBack;
    if (cried <= time) this.until = Math.max(this.until, cried + kStaysBack);
    return time < this.until;
  }
}

const kWalk = 1.3; // m/s
const kRun = 3.8;
const kNear = 0.01; // m

/** A man on his way: back to the middle line as he came, along it, and out to his place. */
export class Walker {
  at: [number, number] = [0, 0];
  /** rad from ahead towards port. */
  faces = 0;
  /** m that he has gone: his legs swing by it. */
  gone = 0;
  walks = false;
  private place: Place | undefined;
  private back: Spot[] = []; // to the middle line, its own last first
  private ahead: Spot[] = [];
  private returns = false;

  /** Sends him there. seconds: since the last time; undefined: he is there at once. */
  go(to: Place, seconds: number | undefined, runs: boolean): void {
    if (!this.place || seconds === undefined) {
      this.at = [...to.at];
      this.back = [...to.by];
      this.ahead = [];
      this.returns = false;
    } else if (to.at[0] !== this.place.at[0] || to.at[1] !== this.place.at[1]) {
      this.returns = true;
      this.ahead = [...to.by, to.at];
    }
    this.place = to;
    let left = (seconds ?? 0) * (runs ? kRun : kWalk);
    this.walks = false;
    for (let legs = 0; left > 0 && legs < 8; ++legs) {
      if (this.returns && this.back.length === 0) this.returns = false;
      const next = this.returns ? this.back.at(-1)! : this.ahead[0];
      if (!next) break;
      left -= this.step(next, left);
      if (Math.hypot(next[0] - this.at[0], next[1] - this.at[1]) > kNear) break;
      if (this.returns) this.back.pop();
      else {
        this.ahead.shift();
        if (this.ahead.length > 0) this.back.push(next);
      }
    }
    if (!this.walks) this.turn(Math.atan2(to.looks[1] - this.at[1], to.looks[0] - this.at[0]), seconds);
  }

  /** m that he went. */
  private step(to: Spot, most: number): number {
    const [dx, dy] = [to[0] - this.at[0], to[1] - this.at[1]];
    const far = Math.hypot(dx, dy);
    const goes = Math.min(far, most);
    if (far < kNear) return 0;
    this.walks = true;
    this.gone += goes;
    this.at = [this.at[0] + (dx * goes) / far, this.at[1] + (dy * goes) / far];
    this.faces = Math.atan2(dy, dx);
    return goes;
  }

  private turn(to: number, seconds: number | undefined): void {
    const by = Math.atan2(Math.sin(to - this.faces), Math.cos(to - this.faces));
    this.faces += seconds === undefined ? by : clamp(by, -4 * seconds, 4 * seconds);
  }
}
