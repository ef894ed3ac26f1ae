// What stands round the anchorage: how lights burn and what a chart writes of them, how buoys look.

import assert from "node:assert/strict";
import { test } from "node:test";

import { buoyOf } from "../../src/surroundings/buoyage";
import { character, colourSeen, flashes, points } from "../../src/surroundings/surroundings";
import { type Landmark, LandmarkKind, LightColour } from "../../src/wire/generated";

const { LANDMARK_LIGHTHOUSE, LANDMARK_BUOY_PORT, LANDMARK_BUOY_STARBOARD } = LandmarkKind;
const lighthouse: Landmark = {
  name: "North Point",
  kind: LANDMARK_LIGHTHOUSE,
  x: 2622,
  y: 4277,
  height: 52,
  light: LightColour.LIGHT_WHITE,
  period: 10,
  flashes: [
    { begin: 0, duration: 0.5 },
    { begin: 2.5, duration: 0.5 },
  ],
  sectors: [],
};

/** A buoy's light: so many flashes, s from one to the next. */
const buoy = (period: number, count: number, apart: number, duration: number, light = LightColour.LIGHT_WHITE) => ({
  ...lighthouse,
  kind: LandmarkKind.LANDMARK_BUOY_SPECIAL,
  light,
  period,
  flashes: Array.from({ length: count }, (_, k) => ({ begin: k * apart, duration })),
});

test("a light burns when its character says, however long the exercise runs", () => {
  assert.equal(character(lighthouse), "Fl(2) 10s 52m");
  const seen = (from: number): boolean[] => [0, 0.4, 0.6, 2.6, 3.1, 9.9].map((t) => flashes(lighthouse, from + t));
  assert.deepEqual(seen(0), [true, true, false, true, false, false]);
  assert.deepEqual(seen(36000), seen(0));
  assert.deepEqual(seen(-10), seen(0)); // what comes before the start of an exercise
});

test("a fixed light burns always, and what is unlit never and has no character", () => {
  const fixed = { ...lighthouse, period: 0, flashes: [] };
  assert.equal(flashes(fixed, 3), true);
  assert.equal(character(fixed), "F 52m");
  assert.equal(character({ ...fixed, light: LightColour.LIGHT_RED }), "F R 52m");
  const unlit = { ...lighthouse, light: LightColour.LIGHT_NONE };
  assert.equal(flashes(unlit, 0), false);
  assert.equal(character(unlit), "");
});

test("a sector has its colour between its bearings from seaward, over north, too, and none where hidden", () => {
  const degrees = Math.PI / 180;
  const { LIGHT_WHITE, LIGHT_RED, LIGHT_NONE } = LightColour;
  const sectors = [
    { light: LIGHT_RED, from: 345 * degrees, to: 11 * degrees },
    { light: LIGHT_NONE, from: 95 * degrees, to: 250 * degrees },
  ];
  const light = { ...lighthouse, sectors };
  /** From 1000 m off, where the light bears so. */
  const seen = (bearing: number): LightColour =>
    colourSeen(light, [light.x - 1000 * Math.sin(bearing * degrees), light.y - 1000 * Math.cos(bearing * degrees)]);
  assert.deepEqual([344, 346, 0, 10, 12].map(seen), [LIGHT_WHITE, LIGHT_RED, LIGHT_RED, LIGHT_RED, LIGHT_WHITE]);
  assert.deepEqual([94, 96, 249, 251].map(seen), [LIGHT_WHITE, LIGHT_NONE, LIGHT_NONE, LIGHT_WHITE]);
  assert.equal(character(light), "Fl(2) WR 10s 52m");
});

test("a buoy's character has a colour unless it is white, and no height", () => {
  assert.equal(character(buoy(3, 1, 0, 0.5, LightColour.LIGHT_RED)), "Fl R 3s");
  assert.equal(character(buoy(6, 2, 1.5, 0.5, LightColour.LIGHT_GREEN)), "Fl(2) G 6s");
  assert.equal(character(buoy(2.5, 1, 0, Math.fround(0.3), LightColour.LIGHT_YELLOW)), "Fl Y 2.5s");
});

test("a rhythm is named by how long and how often it burns", () => {
  assert.equal(character(buoy(1, 1, 0, 0.3)), "Q");
  assert.equal(character(buoy(0.5, 1, 0, 0.2)), "VQ");
  assert.equal(character(buoy(10, 3, 1, 0.3)), "Q(3) 10s");
  assert.equal(character(buoy(15, 9, 1, 0.4)), "Q(9) 15s");
  assert.equal(character(buoy(5, 3, 0.5, 0.25)), "VQ(3) 5s");
  assert.equal(character(buoy(10, 1, 0, 2)), "LFl 10s");
  assert.equal(character(buoy(10, 1, 0, 5)), "Iso 10s");
  assert.equal(character(buoy(6, 1, 0, 4.5)), "Oc 6s");
  assert.equal(character(buoy(10, 2, 4, 3)), "Oc(2) 10s");
  const south = buoy(15, 6, 1, 0.4);
  assert.equal(character({ ...south, flashes: [...south.flashes, { begin: 7, duration: 2 }] }), "Q(6)+LFl 15s");
});

test("groups of groups and Morse letters are named as the chart does", () => {
  const of = (period: number, ...burns: [begin: number, duration: number][]): string =>
    character({
      ...buoy(period, 0, 0, 0),
      flashes: burns.map(([begin, duration]) => ({ begin, duration: Math.fround(duration) })),
    });
  assert.equal(of(15, [0, 0.5], [2, 0.5], [6, 0.5]), "Fl(2+1) 15s"); // a preferred channel
  assert.equal(of(20, [0, 0.5], [2, 0.5], [4, 0.5], [8, 0.5]), "Fl(3+1) 20s");
  assert.equal(of(8, [0, 0.5], [1, 1.5]), "Mo(A) 8s"); // safe water
  assert.equal(of(15, [0, 0.4], [0.8, 0.4], [1.6, 1.2]), "Mo(U) 15s"); // what stands off the shore
  assert.equal(of(15, [0, 1], [3, 1], [6, 1]), "Fl(3) 15s");
});

test("lateral colours change places in region B, their shapes do not", () => {
  const looks = (kind: LandmarkKind, regionB: boolean): string[] => {
    const { body, paint, topmarks } = buoyOf(kind, regionB)!;
    return [body, ...paint, ...topmarks];
  };
  assert.deepEqual(looks(LANDMARK_BUOY_PORT, false), ["can", "red", "can"]);
  assert.deepEqual(looks(LANDMARK_BUOY_PORT, true), ["can", "green", "can"]);
  assert.deepEqual(looks(LANDMARK_BUOY_STARBOARD, false), ["cone", "green", "cone up"]);
  assert.deepEqual(looks(LANDMARK_BUOY_STARBOARD, true), ["cone", "red", "cone up"]);
});

test("a cardinal's topmark points to where its black band is", () => {
  const { LANDMARK_BUOY_NORTH, LANDMARK_BUOY_EAST, LANDMARK_BUOY_SOUTH, LANDMARK_BUOY_WEST } = LandmarkKind;
  for (const [kind, paint, topmarks] of [
    [LANDMARK_BUOY_NORTH, ["black", "yellow"], ["cone up", "cone up"]],
    [LANDMARK_BUOY_EAST, ["black", "yellow", "black"], ["cone up", "cone down"]],
    [LANDMARK_BUOY_SOUTH, ["yellow", "black"], ["cone down", "cone down"]],
    [LANDMARK_BUOY_WEST, ["yellow", "black", "yellow"], ["cone down", "cone up"]],
  ] as const) {
    const looks = buoyOf(kind, true)!; // the same in both regions
    assert.deepEqual([looks.paint, looks.topmarks], [paint, topmarks]);
  }
});

test("every kind of buoy has its looks, and what stands on shore has none", () => {
  for (const kind of Object.values(LandmarkKind).filter((k) => typeof k === "number"))
    assert.equal(buoyOf(kind, false) !== undefined, LandmarkKind[kind].includes("BUOY"), LandmarkKind[kind]);
});

test("points come one behind the other on the wire", () => {
  assert.deepEqual(points(Float32Array.of(1, 2, 3, 4, 5, 6)), [
    [1, 2, 3],
    [4, 5, 6],
  ]);
});
