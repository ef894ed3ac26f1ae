// The hand on a windlass's levers, by a link and a clock of the test.

import assert from "node:assert/strict";
import { type TestContext, test } from "node:test";

import { LeverHand, kWheelTurns } from "../../src/forecastle/levers";
import type { Connection, LinkState, WindlassLevers } from "../../src/wire/connection";
import { ClutchState, RunState } from "../../src/wire/generated";

const kTravel = 4; // s, of the hand-wheel from open to hard on
const kFound: WindlassLevers = {
  brake: 0.5,
  speed_lever: 0.3,
  clutch_in: true,
  stopper_closed: false,
  emergency_stop: false,
};

class Link {
  state: LinkState = "open";
  run = RunState.RUN_RUNNING;
  now = 1000; // ms
  sent: WindlassLevers[] = [];
  let = 0; // how often they were let go
  held = false;
  /** Levers of an instructor who has taken over. */
  instructor: WindlassLevers | undefined;
  view: object | undefined;
  readonly hello = { name: "forecastle-1", hand_silent: 0.4 };
  private readonly states: ((state: LinkState) => void)[] = [];

  onState(listener: (state: LinkState) => void): void {
    this.states.push(listener);
  }
  becomes(state: LinkState): void {
    this.state = state;
    for (const listener of this.states) listener(state);
  }
  latest(topic: string): unknown {
    if (topic === "ExerciseStatus") return { state: this.run, time_scale_achieved: 1, time: 0 };
    return topic === "ForecastleView" ? this.view : undefined;
  }
  track(topic: string): unknown[] {
    if (topic !== "InstructorWindlassCommand" || !this.instructor) return [];
    const said = { sample: { ...this.instructor, origin: { source: "desk-1" } }, at: this.now };
    return [said, said]; // one alone may be an old one
  }
  heardAt(): number {
    return this.now;
  }
  holds(): boolean {
    return this.held;
  }
  holdLevers(_: number, levers: WindlassLevers): void {
    this.held = true;
    this.sent.push(levers);
  }
  letGo(): void {
    this.held = false;
    ++this.let;
  }
}

/** A hand and its link; run(s) goes on in frames of so many ms. */
function hand(t: TestContext, frame = 20): { link: Link; hand: LeverHand; run: (seconds: number) => void } {
  const link = new Link();
  const { brake, speed_lever, stopper_closed, emergency_stop } = kFound;
  link.view = { brake_position: brake, speed_lever, clutch: ClutchState.CLUTCH_IN, stopper_closed, emergency_stop };
  t.mock.method(performance, "now", () => link.now);
  const made = new LeverHand(link as unknown as Connection, 0, () => kTravel);
  return {
    link,
    hand: made,
    run: (seconds) => {
      for (const end = link.now + 1000 * seconds - 1e-6; link.now < end;) made.tick((link.now += frame));
    },
  };
}
const kFrame = 0.02 / kTravel + 1e-9; // by which the wheel turns in a frame
const kTap = 10 / 360 / kWheelTurns;
const near = (value: number, wanted: number, tolerance = 1e-9): void =>
  assert.ok(Math.abs(value - wanted) <= tolerance, `${value} is not ${wanted}`);

test("levers are shown as found, and nothing is sent before a hand is on them", (t) => {
  const { link, hand: one, run } = hand(t);
  assert.deepEqual(one.levers(), kFound);
  run(1);
  assert.deepEqual(link.sent, []);
});

test("a hand takes them as found, but for the speed lever, which has sprung back", (t) => {
  const { link, hand: one } = hand(t);
  one.put({ clutch_in: false });
  assert.deepEqual(link.sent[0], { ...kFound, speed_lever: 0 });
  assert.deepEqual(link.sent.at(-1), { ...kFound, speed_lever: 0, clutch_in: false });
});

test("the hand-wheel turns no faster than a hand: from half on to hard on in half its travel time", (t) => {
  const { hand: one, run } = hand(t);
  one.spinWheel(1);
  run(kTravel / 4);
  near(one.levers()!.brake, 0.75);
  run(kTravel);
  assert.equal(one.levers()!.brake, 1);
});

test("a page at 4 frames a second sweeps as far in a second as one at 60, and one that draws less than one", (t) => {
  const swept = (frame: number, seconds: number, act: (one: LeverHand) => void): WindlassLevers => {
    const { hand: one, run } = hand(t, frame);
    act(one);
    run(seconds);
    t.mock.reset();
    return one.levers()!;
  };
  const spin = (one: LeverHand): void => one.spinWheel(1);
  const held = (one: LeverHand): void => one.pressWheel(-1);
  const push = (one: LeverHand): void => one.pushSpeed(-1);
  for (const frame of [250, 1000]) {
    near(swept(frame, 1, spin).brake, swept(1000 / 60, 1, spin).brake);
    near(swept(frame, 1, held).brake, swept(1000 / 60, 1, held).brake, kFrame);
    near(swept(frame, 1, push).speed_lever, swept(1000 / 60, 1, push).speed_lever);
  }
  near(swept(250, 1, spin).brake, 0.75);
});

test("a wheel turns from when it is spun, whenever the last frame was; a page that slept makes up for little", (t) => {
  const { link, hand: one } = hand(t);
  one.put({ clutch_in: false });
  link.now += 1500;
  one.spinWheel(0);
  one.tick((link.now += 100));
  near(one.levers()!.brake, 0.5 - 0.1 / kTravel);
  one.stopWheel();
  one.spinWheel(1);
  one.tick((link.now += 60_000));
  assert.ok(one.levers()!.brake < 1);
});

test("a key let go is heard of late on a slow page: the wheel turned while it was down, and no longer", (t) => {
  const { link, hand: one } = hand(t);
  one.pressWheel(1, false, link.now);
  const letGo = link.now + 100;
  link.now += 1400;
  one.pressWheel(0, false, letGo);
  one.tick(link.now);
  near(one.levers()!.brake, 0.5 + kTap);
});

test("a finger that is too fast is ahead of the wheel by three tenths of a turn at most", (t) => {
  const { hand: one, run } = hand(t);
  one.turnWheel(2);
  run(kTravel);
  near(one.levers()!.brake, 0.5 + 0.3 / kWheelTurns);
});

test("a stick turns the wheel at a share of its rate until it is let go", (t) => {
  const { hand: one, run } = hand(t);
  one.runWheel(-0.5);
  run(2);
  one.runWheel(0);
  run(1);
  near(one.levers()!.brake, 0.25, kFrame);
});

test("a tap of a key turns the wheel by ten degrees, with Shift by two, however long a tap takes a hand", (t) => {
  const { hand: one, run } = hand(t);
  for (const [way, fine, taps, by] of [
    [1, false, 3, 3 * kTap],
    [-1, false, 1, -kTap],
    [1, true, 5, kTap],
  ] as const) {
    const before = one.levers()!.brake;
    for (let tap = 0; tap < taps; ++tap) {
      one.pressWheel(way, fine);
      run(0.16);
      one.pressWheel(0);
      run(0.1);
    }
    near(one.levers()!.brake, before + by);
  }
});

test("a key takes a wheel that spins where it is, and the speed lever's zero lets it spin on", (t) => {
  const { hand: one, run } = hand(t);
  one.spinWheel(0);
  run(0.5);
  const spun = one.levers()!.brake;
  one.pressWheel(1);
  run(0.1);
  one.pressWheel(0);
  run(1);
  near(one.levers()!.brake, spun + kTap);
  one.moveSpeed(0.5);
  one.latchSpeed();
  one.spinWheel(1);
  one.releaseSpeed();
  run(kTravel);
  assert.equal(one.levers()!.brake, 1);
  assert.equal(one.levers()!.speed_lever, 0);
});

test("a key that is held runs the wheel, slowly at first and then as fast as a hand can, until it is let go", (t) => {
  const { hand: one, run } = hand(t);
  one.pressWheel(-1);
  run(0.5);
  const slow = 0.5 - kTap - one.levers()!.brake;
  assert.ok(slow > 0 && slow < 0.1 / kTravel, `${slow}`);
  run(0.5);
  const before = one.levers()!.brake;
  run(0.5);
  near(before - one.levers()!.brake, 0.5 / kTravel, kFrame);
  one.pressWheel(0);
  const then = one.levers()!.brake;
  run(1);
  near(one.levers()!.brake, then);
});

test("with Shift a key that is held runs a fifth as fast, from when Shift is down", (t) => {
  const { hand: one, run } = hand(t);
  one.pressWheel(1);
  run(1.1);
  one.pressWheel(1, true);
  const before = one.levers()!.brake;
  run(0.5);
  near(one.levers()!.brake - before, 0.1 / kTravel, kFrame);
});

test("the speed lever follows a finger at once and springs back in 150 ms when it is left", (t) => {
  const { link, hand: one, run } = hand(t);
  one.moveSpeed(-0.8);
  assert.equal(one.levers()!.speed_lever, -0.8);
  run(0.1);
  assert.equal(link.sent.at(-1)!.speed_lever, -0.8);
  one.releaseSpeed();
  run(0.08);
  assert.ok(one.levers()!.speed_lever < -0.3 && one.levers()!.speed_lever > -0.5);
  run(0.08);
  near(one.levers()!.speed_lever, 0);
});

test("a key pushes the speed lever there in a third of a second", (t) => {
  const { hand: one, run } = hand(t);
  one.pushSpeed(1);
  run(0.2);
  near(one.levers()!.speed_lever, 0.6);
  run(0.2);
  assert.equal(one.levers()!.speed_lever, 1);
});

test("a latched speed lever stays; let go as any lever it goes to zero, which is sent first", (t) => {
  const { link, hand: one, run } = hand(t);
  one.moveSpeed(0.5);
  one.latchSpeed();
  assert.equal(one.latched, true);
  run(2);
  assert.equal(one.levers()!.speed_lever, 0.5);
  one.letGo();
  assert.equal(link.sent.at(-1)!.speed_lever, 0);
  assert.equal(link.let, 1);
});

test("what moves is sent every 40 ms at most, what has two places at once", (t) => {
  const { link, hand: one, run } = hand(t);
  one.spinWheel(0);
  const before = link.sent.length;
  run(0.4);
  assert.equal(link.sent.length - before, 10);
  one.put({ stopper_closed: true });
  assert.equal(link.sent.length - before, 11);
});

test("a bar that does not move is left as it stands, and no other lever is", (t) => {
  const { link, hand: one } = hand(t);
  assert.equal(one.leave("stopper_closed"), undefined, "an event of another's try, or told again, takes nothing");
  assert.deepEqual(link.sent, []);
  one.put({ stopper_closed: true });
  one.put({ clutch_in: false });
  assert.equal(one.leave("stopper_closed"), false);
  assert.deepEqual(link.sent.at(-1), { ...kFound, speed_lever: 0, clutch_in: false });
  assert.equal(one.leave("stopper_closed"), undefined);
});

test("a clutch that does not come out, or in, is left as it stands; one that seeks waits for its claws", (t) => {
  const { link, hand: one } = hand(t);
  one.put({ clutch_in: false });
  assert.equal(one.leave("clutch_in"), true, "under load");
  assert.deepEqual(link.sent.at(-1), { ...kFound, speed_lever: 0 });
  link.view = { ...link.view, clutch: ClutchState.CLUTCH_ENGAGING };
  assert.equal(one.leave("clutch_in"), undefined);
  link.view = { ...link.view, clutch: ClutchState.CLUTCH_OUT };
  assert.equal(one.leave("clutch_in"), false, "broken, or seized");
  assert.deepEqual(link.sent.at(-1), { ...kFound, speed_lever: 0, clutch_in: false });
});

test("an instructor who takes over is followed, and no hand moves against him", (t) => {
  const { link, hand: one, run } = hand(t);
  one.spinWheel(1);
  run(0.1);
  link.instructor = { ...kFound, brake: 0.2, speed_lever: 0.7, stopper_closed: true };
  run(0.1);
  assert.equal(one.movable(), false);
  assert.deepEqual(one.levers(), { ...kFound, brake: 0.2, speed_lever: 0, stopper_closed: true });
  link.instructor = undefined;
  run(1);
  assert.equal(one.levers()!.brake, 0.2, "the wheel that was spun has stopped");
});

test("nothing is moved in a replay, nor when nobody knows where the levers are", (t) => {
  const { link, hand: one } = hand(t);
  link.run = RunState.RUN_REPLAY;
  one.moveSpeed(1);
  assert.deepEqual(link.sent, []);
  link.run = RunState.RUN_RUNNING;
  link.view = undefined;
  one.moveSpeed(1);
  assert.deepEqual(link.sent, []);
});

test("a link that is lost takes the hand off the levers", (t) => {
  const { link, hand: one, run } = hand(t);
  one.spinWheel(1);
  run(0.2);
  link.becomes("lost");
  const { length } = link.sent;
  link.becomes("open");
  run(1);
  assert.equal(link.sent.length, length);
  assert.deepEqual(one.levers(), kFound);
});
