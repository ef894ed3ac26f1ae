// The helm in this page's hand: taken by its orders as they stood, over a reload and from others.

import assert from "node:assert/strict";
import { beforeEach, test } from "node:test";

import { HelmHand, kTelegraph } from "../../src/bridge/helm_hand";
import type { Connection, HelmLevers } from "../../src/wire/connection";

const kHalfAstern = kTelegraph[1];
const kDoes: HelmLevers = { engine: -0.34, rudder: 0.1, bow_thruster: 0.3, stern_thruster: 0 };
const kOrdered: HelmLevers = { engine: kHalfAstern, rudder: 0.2, bow_thruster: 0.95, stern_thruster: 0 };

/** A browser's session, which outlives a page. */
const session = new Map<string, string>();
Object.assign(globalThis, {
  sessionStorage: {
    getItem: (name: string) => session.get(name) ?? null,
    setItem: (name: string, text: string) => session.set(name, text),
  },
  document: { hidden: false },
});
beforeEach(() => session.clear());

/** A page of trainee-1's bridge, opened in a run, while the ship does kDoes. */
class Page {
  readonly state = "open";
  readonly hello = { name: "trainee-1", seat: "conning", exercise: "L01", commands: ["HelmCommand"], hand_silent: 5 };
  readonly helm: HelmHand;
  readonly sent: HelmLevers[] = [];
  private held = false;
  private readonly listeners = new Map<string, ((sample: object) => void)[]>();
  private readonly tracks = new Map<string, { sample: object; at: number }[]>();

  constructor(run = 1) {
    this.helm = new HelmHand(this as unknown as Connection, () => 0.6);
    this.run(run);
  }
  on(topic: string, listener: (sample: object) => void): void {
    this.listeners.set(topic, [...(this.listeners.get(topic) ?? []), listener]);
  }
  onState(listener: (state: string) => void): void {
    listener("open");
  }
  onMessage(): void {}
  latest(topic: string): unknown {
    return topic === "BridgeView" ? kDoes : undefined;
  }
  track(topic: string): unknown[] {
    return this.tracks.get(topic) ?? [];
  }
  holds(): boolean {
    return this.held;
  }
  holdHelm(levers: HelmLevers): void {
    this.held = true;
    this.sent.push(levers);
  }
  letGo(): void {
    this.held = false;
  }
  tell(topic: string, sample: object): void {
    for (const listener of this.listeners.get(topic) ?? []) listener(sample);
  }
  run(run: number): void {
    this.tell("ExerciseStatus", { run, exercise: "L01", time: 100 });
  }
  /** A line of the log: who takes the helm, or the other branch that begins. */
  log(number: number, code: string, name = ""): void {
    const text = name && `${name} has the helm, taken from somebody`;
    this.tell("BridgeEvent", { number, code, side: -1, text, time: 50 });
  }
  /** Another speaks at the helm, twice: one sample alone may be an old one; then it is silent. */
  others(source: string, levers: HelmLevers, topic = "HelmCommand"): void {
    const said = { sample: { ...levers, origin: { source } }, at: performance.now() };
    this.tracks.set(topic, [said, said]);
    this.tell(topic, said.sample);
    this.tracks.delete(topic);
  }
  order(levers: Partial<HelmLevers>): void {
    this.helm.put(levers);
    this.helm.tick(performance.now() + 1000);
  }
}

test("where nothing is known of its orders the helm is taken by what the ship does", () => {
  const page = new Page();
  assert.deepEqual(page.helm.levers(), kDoes);
  page.order({});
  assert.deepEqual(page.sent, [kDoes]);
});

test("after a reload the telegraph shows what was ordered, and the helm is taken by that", () => {
  const before = new Page();
  before.helm.thrustersSpring = false;
  before.order(kOrdered);
  const after = new Page();
  assert.deepEqual(after.helm.levers(), kOrdered);
  assert.equal(after.helm.thrustersSpring, false);
  after.log(4, "levers.taken", "trainee-1"); // all of the log comes again
  after.order({});
  assert.deepEqual(after.sent, [kOrdered]);
});

test("of another run, or after a restore, nothing of it is so any more, but how the thrusters' levers are set", () => {
  const before = new Page();
  before.helm.thrustersSpring = false;
  before.order(kOrdered);
  assert.deepEqual(new Page(2).helm.levers(), kDoes);
  const there = new Page();
  there.run(2);
  assert.deepEqual(there.helm.levers(), kDoes);
  assert.equal(there.helm.thrustersSpring, false);
});

test("what others ordered last stands when they have left the helm, an instructor's too", () => {
  const page = new Page();
  page.others("bridge-2", kOrdered);
  assert.deepEqual(page.helm.levers(), kOrdered);
  page.others("desk-1", { ...kOrdered, engine: 1 }, "InstructorHelmCommand");
  assert.deepEqual(new Page().helm.levers(), { ...kOrdered, engine: 1 });
});

test("an order is not known any more when another has taken the helm meanwhile", () => {
  const before = new Page();
  before.log(3, "levers.taken", "desk-1");
  before.order(kOrdered);
  const after = new Page();
  after.log(3, "levers.taken", "desk-1"); // was known
  assert.deepEqual(after.helm.levers(), kOrdered);
  after.log(8, "levers.taken", "desk-1");
  assert.deepEqual(after.helm.levers(), kDoes);
  after.order({ engine: 0 });
  assert.deepEqual(after.helm.levers(), { ...kDoes, engine: 0 });
  after.helm.letGo();
  assert.deepEqual(after.helm.levers(), { ...kDoes, engine: 0 });
});
