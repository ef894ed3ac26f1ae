// The helm in this page's hand: taken as the server has it, whoever ordered it last, and not as a page remembers it.

import assert from "node:assert/strict";
import { beforeEach, test } from "node:test";

import { HelmHand, kTelegraph } from "../../src/bridge/helm_hand";
import type { Connection, HelmLevers } from "../../src/wire/connection";

const [kSlowAhead, kHalfAhead] = [kTelegraph[6], kTelegraph[7]];
const kDoes: HelmLevers = { engine: 0.34, rudder: 0.1, bow_thruster: 0.3, stern_thruster: 0 };
const kOrdered: HelmLevers = { engine: kHalfAhead, rudder: 0.2, bow_thruster: 0.95, stern_thruster: 0 };
const kStopped: HelmLevers = { engine: 0, rudder: 0.2, bow_thruster: 0, stern_thruster: 0 };

/** A browser's session, which outlives a page. */
const session = new Map<string, string>();
const browser = { hidden: false };
Object.assign(globalThis, {
  sessionStorage: {
    getItem: (name: string) => session.get(name) ?? null,
    setItem: (name: string, text: string) => session.set(name, text),
  },
  document: browser,
});
beforeEach(() => {
  session.clear();
  browser.hidden = false;
});

/** What the server has, for all pages. */
let server = kOrdered;

/** A page of trainee-1's bridge, while the ship does kDoes. */
class Page {
  readonly state = "open";
  readonly hello = { name: "trainee-1", seat: "conning", exercise: "L01", commands: ["HelmCommand"], hand_silent: 5 };
  readonly helm: HelmHand;
  readonly sent: HelmLevers[] = [];
  private held = false;
  private readonly listeners = new Map<string, ((sample: object) => void)[]>();
  private readonly tracks = new Map<string, { sample: object; at: number }[]>();

  constructor() {
    this.helm = new HelmHand(this as unknown as Connection, () => 0.6);
    this.tell("ExerciseStatus", { run: 1, exercise: "L01", time: 100 });
  }
  on(topic: string, listener: (sample: object) => void): void {
    this.listeners.set(topic, [...(this.listeners.get(topic) ?? []), listener]);
  }
  onState(listener: (state: string) => void): void {
    listener("open");
  }
  onMessage(): void {}
  latest(topic: string): unknown {
    const { engine, rudder, bow_thruster, stern_thruster } = server;
    const ordered = {
      engine_ordered: engine,
      rudder_ordered: rudder,
      bow_thruster_ordered: bow_thruster,
      stern_thruster_ordered: stern_thruster,
    };
    return topic === "BridgeView" ? { ...kDoes, ...ordered } : undefined;
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
    server = levers;
  }
  letGo(): void {
    this.held = false;
  }
  private tell(topic: string, sample: object): void {
    for (const listener of this.listeners.get(topic) ?? []) listener(sample);
  }
  /** Another speaks at the helm, twice: one sample alone may be an old one. */
  others(source: string, levers: HelmLevers, topic = "HelmCommand"): void {
    const said = { sample: { ...levers, origin: { source } }, at: performance.now() };
    this.tracks.set(topic, [said, said]);
    this.tell(topic, said.sample);
  }
  order(levers: Partial<HelmLevers>): void {
    this.helm.put(levers);
    this.helm.tick(performance.now() + 1000);
  }
}

test("the helm is shown and taken as it was ordered, not by what the ship does yet", () => {
  server = kOrdered;
  const page = new Page();
  assert.deepEqual(page.helm.levers(), kOrdered);
  page.order({});
  assert.deepEqual(page.sent, [kOrdered]);
});

// Slow ahead here; half ahead, slow and stop in another tab of this station, which is closed; then here again.
test("an order of another page stands when this one comes back, and a touch of one lever moves no other", () => {
  const before = new Page();
  before.order({ engine: kSlowAhead });
  before.helm.letGo();
  server = kStopped;
  const after = new Page();
  assert.deepEqual(after.helm.levers(), kStopped);
  after.order({ rudder: 0 });
  assert.deepEqual(after.sent, [{ ...kStopped, rudder: 0 }]);
});

test("a page that has let the helm go shows what others order, and takes it so", () => {
  server = kStopped;
  const page = new Page();
  page.order({ engine: kSlowAhead });
  page.helm.letGo();
  server = kOrdered;
  assert.deepEqual(page.helm.levers(), kOrdered);
  page.helm.stepTelegraph(-1);
  assert.deepEqual(page.helm.levers(), { ...kOrdered, engine: kSlowAhead });
});

test("while an instructor has the helm this hand follows him, also on a hidden page, which draws no frame", () => {
  server = kStopped;
  const page = new Page();
  page.order({ engine: kSlowAhead });
  browser.hidden = true;
  page.others("desk-1", kOrdered, "InstructorHelmCommand");
  assert.deepEqual(page.helm.levers(), kOrdered);
  assert.deepEqual(page.sent.at(-1), kOrdered);
});

test("how the thrusters' levers are set is kept over a reload", () => {
  new Page().helm.thrustersSpring = false;
  assert.equal(new Page().helm.thrustersSpring, false);
});
