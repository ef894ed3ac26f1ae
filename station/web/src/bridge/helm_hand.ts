// Telegraph, wheel and thruster levers in this page's hand: as the server has them at first, whoever ordered them, then
// as the hand moves them.

import { type Authority, helmAuthority, helmOrdered } from "../kit/authority";
import type { Connection, HelmLevers } from "../wire/connection";
import type { HelmCommand } from "../wire/generated";
import { t } from "../kit/language";
import { Kept } from "./kept";

/** Telegraph orders, share of full thrust; tuned to what the model's engine makes of them. */
export const kTelegraph = [-1, -0.7, -0.4, -0.2, 0, 0.2, 0.4, 0.7, 1] as const;
export const kTelegraphWords: readonly string[] = [
  t("full astern"),
  t("half astern"),
  t("slow astern"),
  t("dead slow astern"),
  t("stop"),
  t("dead slow ahead"),
  t("slow ahead"),
  t("half ahead"),
  t("full ahead"),
];

const kTakeOver = 600; // ms, in which a hand that has just moved a lever may not be heard yet
const kBetweenSends = 40; // ms: well below what the station takes

const clamp = (value: number, most: number): number => Math.min(most, Math.max(-most, value));

/** The telegraph's detent nearest to an order, 0..8. */
export function detentOf(engine: number): number {
  let nearest = 0;
  kTelegraph.forEach((order, k) => {
    if (Math.abs(order - engine) < Math.abs(kTelegraph[nearest]! - engine)) nearest = k;
  });
  return nearest;
}

export class HelmHand {
  private readonly springs: Kept<boolean>;
  private mine: HelmLevers | undefined;
  private changed = false;
  private lastSent = -Infinity;
  private lastPut = -Infinity;

  /** rudderMax: rad, the ship's. */
  constructor(
    private readonly link: Connection,
    readonly rudderMax: () => number,
  ) {
    link.onState((state) => state !== "open" && (this.mine = undefined));
    link.onMessage("levers", (message) => {
      // of silence the link makes good by itself
      if (message.helm !== true || (message.by !== "another" && !message.taken_by)) return;
      this.mine = undefined;
      link.letGo("helm");
    });
    this.springs = new Kept<boolean>(
      link,
      "thrusters",
      () => true,
      (springs) => springs,
    );
    for (const topic of ["HelmCommand", "InstructorHelmCommand"] as const) link.on(topic, () => this.hearOthers());
  }

  /** Thruster levers spring back to zero when let go, or stay. */
  get thrustersSpring(): boolean {
    return this.springs.value;
  }
  set thrustersSpring(springs: boolean) {
    this.springs.value = springs;
  }

  authority(): Authority<HelmCommand> {
    return helmAuthority(this.link, performance.now());
  }

  /** Whether it is known whose helm this is: the seat's grant and the ship have been heard of. */
  known(): boolean {
    return this.link.hello !== undefined && this.link.latest("BridgeView") !== undefined;
  }

  /** Whether this seat steers at all. */
  granted(): boolean {
    const commands = this.link.hello?.commands ?? [];
    return commands.includes("HelmCommand") || commands.includes("InstructorHelmCommand");
  }

  /**
   * Set points: those of this hand, or as the server has them; never those that a page remembers, for others may have
   * moved them since. Undefined while nothing has been heard.
   */
  levers(): HelmLevers | undefined {
    return this.mine ?? helmOrdered(this.link);
  }

  /** Whether a hand of this page may move them now. */
  movable(): boolean {
    return (
      this.granted() &&
      this.link.state === "open" &&
      this.levers() !== undefined &&
      this.authority().owner !== "instructor"
    );
  }

  /** Moves some of them; the first touch takes the helm as it is found. */
  put(change: Partial<HelmLevers>): void {
    if (!this.movable()) return;
    this.mine ??= { ...this.levers()! };
    Object.assign(this.mine, change);
    this.mine.engine = clamp(this.mine.engine, 1);
    this.mine.rudder = clamp(this.mine.rudder, this.rudderMax());
    this.mine.bow_thruster = clamp(this.mine.bow_thruster, 1);
    this.mine.stern_thruster = clamp(this.mine.stern_thruster, 1);
    this.changed = true;
    this.lastPut = performance.now();
    if (document.hidden) this.send(this.mine, performance.now()); // no frame is drawn that would send it
  }

  /** One telegraph order up (1) or down (-1). */
  stepTelegraph(by: number): void {
    const levers = this.levers();
    if (!levers) return;
    const next = Math.min(kTelegraph.length - 1, Math.max(0, detentOf(levers.engine) + by));
    this.put({ engine: kTelegraph[next]! });
  }

  /** Takes the helm without moving anything. */
  take(): void {
    this.put({});
  }

  /** Gives the helm out of this hand: everything stays where it is. */
  letGo(): void {
    this.mine = undefined;
    this.link.letGo("helm");
  }

  /** Sends what has changed; several times a second. now: ms of performance.now(). */
  tick(now: number): void {
    if (this.mine && this.changed && now - this.lastSent >= kBetweenSends) this.send(this.mine, now);
  }

  private follow(mine: HelmLevers, theirs: HelmLevers): void {
    for (const lever of ["engine", "rudder", "bow_thruster", "stern_thruster"] as const) {
      if (mine[lever] !== theirs[lever]) this.changed = true;
      mine[lever] = theirs[lever];
    }
  }

  private send(levers: HelmLevers, now: number): void {
    this.lastSent = now;
    this.changed = false;
    this.link.holdHelm({ ...levers });
  }

  /**
   * While others have the helm this hand's levers follow theirs, so that nothing lurches when their hand leaves it. As
   * they are heard, not as frames are drawn: a page that is hidden draws none, and its hand still lies there.
   */
  private hearOthers(): void {
    if (!this.mine) return;
    const now = performance.now();
    const { owner, command } = this.authority();
    const theirs = owner === "instructor" || (owner === "other" && now - this.lastPut > kTakeOver);
    if (!theirs || !command) return;
    this.follow(this.mine, command);
    if (this.changed && document.hidden) this.send(this.mine, now);
  }
}
