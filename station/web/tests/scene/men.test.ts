// Where the men on deck stand: by the state of the windlasses alone, and never at a cable that moves.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { test } from "node:test";

import type { TackleFrame } from "../../src/scene/frame";
import { frameOfSeat } from "../../src/scene/from_seat";
import { type Place, Stations, Walker, Warned } from "../../src/scene/men";
import { otherSide, secured } from "../../src/scene/at_home";
import { deckHeight, rig } from "../../src/scene/rig";
import { DeckWork } from "../../src/wire/generated";
import { root } from "../../tools/web.mjs";
import { OneInstant, type Recorded } from "./samples";

const recorded = JSON.parse(await readFile(join(root, "station/web/tests/scene/instants.json"), "utf8")) as Recorded;
const samples = new OneInstant(recorded, "hanging");
const scene = samples.latest("SceneDescription")!;
const { ship, tackle: seen } = frameOfSeat(samples, 0)!;
const told = rig(scene.tackle[0]!, deckHeight(scene));
const other = rig(otherSide(scene.tackle[0]!), deckHeight(scene));
const rigs = [told, other];
const rail = (x: number): number => (x < 100 ? 12 : 12 - (x - 100));
const stations = new Stations(rigs, rail);

/** Where they stand with such a port windlass. */
const men = (port: Partial<TackleFrame>, back = false): Place[] =>
  stations.places({ tackle: [{ ...seen[0]!, cable_speed: 0, ...port }, secured(other, ship)], side: 0, back });

/** m from the cable on deck of either side, from pipe to locker. */
const fromCable = ([x, y]: readonly [number, number]): number =>
  Math.min(
    ...rigs.map(({ deckPipe: a, spurling: b }) => {
      const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
      const t = Math.min(1, Math.max(0, ((x - a[0]) * dx + (y - a[1]) * dy) / (dx * dx + dy * dy)));
      return Math.hypot(x - a[0] - t * dx, y - a[1] - t * dy);
    }),
  );

test("where nothing is heard of the men, as when the bridge's camera has failed, nobody is drawn", () => {
  assert.deepEqual(stations.places({ tackle: [undefined, undefined], side: 0, back: false }), []);
  const { men: _, ...unseen } = seen[0]!;
  assert.deepEqual(stations.places({ tackle: [unseen, undefined], side: 0, back: false }), []);
});

test("a lookout at the rail ahead of the pipe looks out; the fitter is by the stopper of a cable that is held", () => {
  const [bosun, fitter] = men({});
  assert.ok(bosun!.at[0] > told.deckPipe[0] && rail(bosun!.at[0]) - bosun!.at[1] < 1);
  assert.ok(bosun!.looks[1] > bosun!.at[1]);
  assert.ok(fromCable(fitter!.at) > 1 && fitter!.at[0] > told.gypsy[0]);
});

test("when the cable runs only the lookout is ahead of the windlass, and nobody within 2 m of a cable", () => {
  const places = men({ cable_speed: 2 });
  assert.equal(places.filter(({ at }) => at[0] > told.gypsy[0]).length, 1);
  for (const { at } of places) assert.ok(fromCable(at) > 2, `${at}: ${fromCable(at)} m`);
});

for (const danger of [{ cable_speed: 8 }, { jumping: true }, { stopper_sprung: true }, { lining: 4 }])
  test(`all are abaft the windlass: ${JSON.stringify(danger)}`, () => {
    for (const { at } of men(danger)) assert.ok(at[0] < told.gypsy[0] - 4, `${at}`);
  });

test("who are set to work are at it where the server has them at it, and stand off where it has them wait", () => {
  const work = DeckWork.DECK_WORK_BREAK_CABLE;
  const near = (goes: boolean): number => men({ men: { work, goes } }).filter(({ at }) => fromCable(at) < 1).length;
  assert.equal(near(true), 2);
  assert.equal(near(false), 0);
  for (const { at } of men({ men: { work, goes: false }, cable_speed: 8 })) assert.ok(at[0] < told.gypsy[0]);
  const valves = men({ men: { work: DeckWork.DECK_WORK_CROSS_CONNECT, goes: true } })[1]!;
  assert.ok(valves.at[0] < told.gypsy[0] && valves.at[1] > told.gypsy[1]);
});

test("a cry sends them back for half a minute, a danger for as long after it", () => {
  const warned = new Warned();
  const quiet = [{ ...seen[0]!, cable_speed: 0 }];
  assert.equal(warned.back(10, quiet), false);
  assert.equal(warned.back(11, quiet, 11), true);
  assert.equal(warned.back(40, quiet, 11), true);
  assert.equal(warned.back(42, quiet, 11), false);
  assert.equal(warned.back(50, [{ ...seen[0]!, cable_speed: -9 }], 11), true);
  assert.equal(warned.back(79, quiet, 11), true);
  assert.equal(warned.back(81, quiet, 11), false);
  assert.equal(warned.back(5, [{ ...seen[0]!, cable_speed: 9 }]), true);
  assert.equal(new Warned().back(5, quiet, 11), false, "a cry of a branch that was left");
});

test("nobody steps over a cable on his way, whatever comes between", () => {
  const walker = new Walker();
  const states: Partial<TackleFrame>[] = [
    {},
    { cable_speed: 8 },
    { men: { work: DeckWork.DECK_WORK_CROSS_CONNECT, goes: true } },
    { men: { work: DeckWork.DECK_WORK_CLEAR_ANCHOR, goes: true } },
    { cable_speed: 1 },
  ];
  for (const i of [0, 1, 2])
    for (const pause of [0.7, 2.3, 9])
      for (const state of [...states, ...states.toReversed(), ...states]) {
        const to = men(state)[i]!;
        for (let time = 0; time < pause; time += 0.1) {
          walker.go(to, 0.1, false);
          assert.ok(fromCable(walker.at) > 0.7, `man ${i} at ${walker.at}, ${fromCable(walker.at)} m from a cable`);
        }
      }
});

test("he walks, runs, and comes where he is sent", () => {
  const [from, to] = [men({})[0]!, men({ cable_speed: 8 })[0]!];
  const time = (runs: boolean): number => {
    const walker = new Walker();
    walker.go(from, undefined, false);
    let s = 0;
    for (; walker.at[0] !== to.at[0] || walker.at[1] !== to.at[1]; s += 0.05) {
      assert.ok(s < 60);
      walker.go(to, 0.05, runs);
    }
    return s;
  };
  assert.ok(time(true) < 7 && time(true) > 4, `${time(true)} s`);
  assert.ok(time(false) > 2.5 * time(true));
});
