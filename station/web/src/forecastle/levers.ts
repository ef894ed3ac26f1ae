// The levers of one windlass in this page's hand: as found at first, then as the hand moves them, and no faster than
// a hand can.

import type { Connection, WindlassLevers } from "../wire/connection";
import { type Authority, windlassAuthority } from "../kit/authority";
import { ClutchState, RunState, type WindlassCommand } from "../wire/generated";

/** Turns of the hand-wheel from open to hard on. */
export const kWheelTurns = 5;

const kBehind = 0.3 / kWheelTurns; // by which a hand-wheel may lag behind a finger that is too fast
const kSpringTime = 150; // ms, from wherever the speed lever is back to zero
const kPushRate = 3; // 1/s, of a lever pushed by a key
const kBetweenSends = 40; // ms: with the repeats of two sides well below what the station takes
const kTap = 10 / 360; // turns by a key that is only tapped: some taps from one speed of the fall to the next
const kHeld = 300; // ms that a key is down before it is more than a tap
const kRunUp = 700; // ms after that, until the hand-wheel turns as fast as a hand can
const kFirst = 0.15; // of that rate, with which it begins
const kStep = 20; // ms, in which what moves goes on, however seldom a frame is drawn
const kLongest = 2000; // ms that are made up for at once: a page that stood for longer was asleep

/** Of a hand that goes finely, by Shift: share of what it does else. */
export const kFine = 0.2;

const clamp = (value: number, low: number, high: number): number => Math.min(high, Math.max(low, value));
const towards = (from: number, to: number, most: number): number => from + clamp(to - from, -most, most);

export class LeverHand {
  private mine: WindlassLevers | undefined;
  private wheelAim: number | undefined; // where the hand-wheel is being turned to
  private spun = false; // to one of its ends, by itself
  private wheelRun = 0; // -1..1 of the wheel's rate, by a stick or a trigger
  private key = { way: 0, share: 1, since: 0 }; // that turns the wheel: which way, how finely, since when (ms)
  private speedAim = 0;
  private speedHeld = false;
  private speedLatched = false;
  private sprungFrom = 0;
  private moved = performance.now(); // ms, up to when what moves has moved
  private lastSent = -Infinity;
  private changed = false;

  /** travelTime: s of the hand-wheel from open to hard on, as the scene's description has it. */
  constructor(
    private readonly link: Connection,
    readonly side: number,
    private readonly travelTime: () => number,
  ) {
    link.onState((state) => state !== "open" && this.drop());
  }

  /** Who has the levers now. */
  authority(): Authority<WindlassCommand> {
    return windlassAuthority(this.link, this.side, performance.now());
  }

  /** The set points: those of this hand, or as found; undefined while nothing has been heard of them. */
  levers(): WindlassLevers | undefined {
    return this.mine ?? this.found();
  }

  /** Whether a hand of this page may move them now. */
  movable(): boolean {
    const replay = this.link.latest("ExerciseStatus")?.state === RunState.RUN_REPLAY; // nobody to take an order
    const open = this.link.state === "open" && !replay;
    return open && this.levers() !== undefined && this.authority().owner !== "instructor";
  }

  /** Turns the hand-wheel on by so many turns (negative: off); what is faster than a hand can is lost. */
  turnWheel(turns: number): void {
    this.moveOn();
    const levers = this.take();
    if (!levers) return;
    const aim = (this.wheelAim ?? levers.brake) + turns / kWheelTurns;
    this.spun = false;
    this.wheelAim = clamp(clamp(aim, levers.brake - kBehind, levers.brake + kBehind), 0, 1);
  }

  /** Spins the hand-wheel to 0, open, or 1, hard on. */
  spinWheel(to: number): void {
    this.moveOn();
    if (!this.take()) return;
    this.wheelAim = clamp(to, 0, 1);
    this.spun = true;
  }

  /** Turns the hand-wheel at a share -1..1 of its rate until told 0. */
  runWheel(share: number): void {
    if (share === this.wheelRun) return;
    this.moveOn();
    const levers = share !== 0 ? this.take() : this.mine;
    if (levers && share !== 0) this.wheelAim = undefined;
    this.wheelRun = levers ? share : 0;
  }

  /**
   * A key that turns the hand-wheel goes down (way 1: on, -1: off) or up (0). A tap turns it by a fixed small angle,
   * and takes one that spins where it is; held, it runs, faster and faster up to a hand's rate. fine: all that by a
   * fifth. at: when, ms: a page that is slow hears of its keys late.
   */
  pressWheel(way: number, fine = false, at = performance.now()): void {
    this.moveOn(at);
    const share = fine ? kFine : 1;
    if (way === this.key.way) {
      this.key.share = share; // Shift came or went
      return;
    }
    const levers = way !== 0 ? this.take() : undefined;
    if (levers) {
      const from = this.spun ? levers.brake : (this.wheelAim ?? levers.brake);
      this.wheelAim = clamp(from + (way * share * kTap) / kWheelTurns, 0, 1);
      this.spun = false;
    }
    this.key = { way: levers ? way : 0, share, since: at };
  }

  /** Stops a hand-wheel that spins. */
  stopWheel(): void {
    this.moveOn();
    this.wheelAim = undefined;
    this.wheelRun = this.key.way = 0;
  }

  /** Puts the speed lever there at once, as a finger does: -1 full lower .. 1 full heave. */
  moveSpeed(to: number): void {
    this.moveOn();
    const levers = this.take();
    if (!levers) return;
    this.speedHeld = true;
    this.speedLatched = false;
    this.speedAim = clamp(to, -1, 1);
    this.put({ speed_lever: this.speedAim });
  }

  /** Pushes the speed lever there, as a key does. at: as of pressWheel(). */
  pushSpeed(to: number, at = performance.now()): void {
    this.moveOn(at);
    if (!this.take()) return;
    this.speedHeld = true;
    this.speedLatched = false;
    this.speedAim = clamp(to, -1, 1);
  }

  /** Whether the speed lever stays where it is although no hand is on it. */
  get latched(): boolean {
    return this.speedLatched;
  }

  /** Leaves the speed lever where the finger has it, until it is touched again or let go as any lever is. */
  latchSpeed(): void {
    this.speedLatched = this.speedHeld && this.speedAim !== 0;
    if (!this.speedLatched) this.releaseSpeed();
  }

  /** The hand leaves the speed lever: it springs back. at: as of pressWheel(). */
  releaseSpeed(at = performance.now()): void {
    if (!this.speedHeld) return;
    this.moveOn(at);
    this.speedHeld = this.speedLatched = false;
    this.speedAim = 0;
    this.sprungFrom = Math.abs(this.mine?.speed_lever ?? 0);
  }

  /** The hand is off what it holds: lost focus, another side in hand. A wheel that was spun goes on to its end. */
  release(): void {
    this.moveOn();
    this.wheelRun = this.key.way = 0;
    this.releaseSpeed();
  }

  /** Puts clutch, stopper or emergency stop. */
  put(change: Partial<WindlassLevers>): void {
    const levers = this.take();
    if (!levers) return;
    Object.assign(levers, change);
    this.changed = true;
    if (!("speed_lever" in change)) this.send(performance.now()); // of what has two places nothing waits
  }

  /**
   * A lever of two places does not go where this hand wants it: the hand leaves it as it stands, else it would go there
   * by itself as soon as it can, with nobody at it. Returns how it stands; undefined: it was no try of this hand, or a
   * clutch that seeks: that waits for its claws.
   */
  leave(lever: "clutch_in" | "stopper_closed"): boolean | undefined {
    const view = this.link.latest("ForecastleView", this.side);
    if (!view || !this.mine || !this.movable()) return undefined;
    if (lever === "clutch_in" && view.clutch === ClutchState.CLUTCH_ENGAGING) return undefined;
    const stands = lever === "clutch_in" ? view.clutch === ClutchState.CLUTCH_IN : view.stopper_closed;
    if (this.mine[lever] === stands) return undefined;
    this.put({ [lever]: stands });
    return stands;
  }

  /** Gives the levers out of this hand; the speed lever goes to zero first. */
  letGo(): void {
    if (this.mine) {
      this.mine.speed_lever = 0;
      this.send(performance.now());
    }
    this.drop();
    this.link.letGo(this.side);
  }

  /** Moves what moves; once a frame. now: ms of performance.now(). */
  tick(now: number): void {
    const { owner, command } = this.authority();
    if (this.mine && owner === "instructor" && command) this.follow(command);
    this.moveOn(now);
    if (this.mine && this.changed && now - this.lastSent >= kBetweenSends) this.send(now);
  }

  /** Moves what moves up to a moment, ms: by the clock, and before what moves it changes. */
  private moveOn(to = performance.now()): void {
    let at = Math.max(this.moved, to - kLongest);
    this.moved = Math.max(this.moved, to);
    while (this.mine && at < to) {
      const step = Math.min(kStep, to - at);
      at += step;
      this.move(this.mine, step / 1000, at);
    }
  }

  /** By dt s, until now (ms). */
  private move(levers: WindlassLevers, dt: number, now: number): void {
    const before = { ...levers };
    const most = dt / Math.max(0.1, this.travelTime());
    if (this.wheelAim !== undefined) {
      levers.brake = towards(levers.brake, this.wheelAim, most);
      if (levers.brake === this.wheelAim) this.wheelAim = undefined;
    }
    const run = this.wheelRun + this.keyRun(now);
    if (run !== 0 && this.wheelAim === undefined) levers.brake = clamp(levers.brake + clamp(run, -1, 1) * most, 0, 1);
    const spring = (Math.max(this.sprungFrom, 0.1) * dt * 1000) / kSpringTime;
    levers.speed_lever = towards(levers.speed_lever, this.speedAim, this.speedHeld ? kPushRate * dt : spring);
    this.changed ||= levers.brake !== before.brake || levers.speed_lever !== before.speed_lever;
  }

  /** -1..1 of the wheel's rate, by a key that is held. */
  private keyRun(now: number): number {
    const { way, share, since } = this.key;
    const held = now - since - kHeld;
    return way === 0 || held < 0 ? 0 : way * share * Math.min(1, kFirst + ((1 - kFirst) * held) / kRunUp);
  }

  /** While the instructor has them, this hand's follow his, so that nothing lurches when he hands back. */
  private follow(command: WindlassLevers): void {
    this.stopWheel();
    this.releaseSpeed();
    const { brake, clutch_in, stopper_closed, emergency_stop } = command;
    const now = { brake, speed_lever: 0, clutch_in, stopper_closed, emergency_stop };
    const kept = this.mine!;
    this.changed ||= (Object.keys(now) as (keyof WindlassLevers)[]).some((name) => now[name] !== kept[name]);
    this.mine = now;
  }

  /** Takes the levers as found, unless this hand has them; undefined: it may not, or nobody knows where they are. */
  private take(): WindlassLevers | undefined {
    if (!this.movable()) return undefined;
    if (this.mine) return this.mine;
    this.mine = { ...this.found()!, speed_lever: 0 }; // it springs back when no hand is on it
    this.speedAim = this.sprungFrom = 0;
    this.send(performance.now());
    return this.mine;
  }

  private found(): WindlassLevers | undefined {
    const { command } = this.authority();
    if (command) {
      const { brake, speed_lever, clutch_in, stopper_closed, emergency_stop } = command;
      return { brake, speed_lever, clutch_in, stopper_closed, emergency_stop };
    }
    const view = this.link.latest("ForecastleView", this.side);
    if (!view) return undefined;
    return {
      brake: clamp(view.brake_position, 0, 1),
      speed_lever: clamp(view.speed_lever, -1, 1),
      clutch_in: view.clutch !== ClutchState.CLUTCH_OUT,
      stopper_closed: view.stopper_closed,
      emergency_stop: view.emergency_stop,
    };
  }

  private send(now: number): void {
    if (!this.mine) return;
    this.link.holdLevers(this.side, { ...this.mine });
    this.lastSent = now;
    this.changed = false;
  }

  /** The levers are in this hand no more; nothing is sent. */
  drop(): void {
    this.stopWheel();
    this.releaseSpeed();
    this.mine = undefined;
    this.changed = false;
  }
}
