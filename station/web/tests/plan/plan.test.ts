// What the plan and the bridge compute.

import assert from "node:assert/strict";
import { test } from "node:test";

import { type Landmark, LandmarkKind, LightColour } from "../../src/wire/generated";
import { trueWind } from "../../src/bridge/wind";
import { kNauticalMile } from "../../src/kit/units";
import { waterline } from "../../src/plan/hull_outline";
import { Measuring } from "../../src/plan/measuring";
import { distanceText, roundLength } from "../../src/plan/layers";
import { Lettering, around, rank } from "../../src/plan/lettering";
import { ParallelIndex, courseThrough, relativeTo } from "../../src/plan/parallel_index";
import { Projection, directionTo, ofShip, pointAt } from "../../src/plan/projection";
import { named } from "../../src/plan/surroundings";
import { thin } from "../../src/plan/thin";
import { bridgeEye } from "../../src/surroundings/bridge_eye";

const kDegree = Math.PI / 180;
const near = (a: number, b: number, tolerance = 1e-9): void =>
  assert.ok(Math.abs(a - b) <= tolerance, `${a} is not ${b}`);

test("north is up, or the heading is, and what is on the screen is found again in the world", () => {
  const at = Object.assign(new Projection(), {
    width: 800,
    height: 600,
    scale: 2,
    centre: { x: 100, y: -50 },
  });
  assert.deepEqual(at.toScreen(100, -40), { x: 400, y: 280 }); // 10 m north of the middle
  assert.deepEqual(at.toScreen(110, -50), { x: 420, y: 300 }); // 10 m east
  at.up = 90 * kDegree; // east is up
  const ahead = at.toScreen(110, -50);
  near(ahead.x, 400);
  near(ahead.y, 280);
  at.up = 0.7;
  const back = at.toWorld(at.toScreen(123, 45));
  near(back.x, 123);
  near(back.y, 45);
});

test("a zoom leaves the world where it is under the finger, a pan moves it by the finger's way", () => {
  const at = Object.assign(new Projection(), { width: 800, height: 600, scale: 2, up: 0.3 });
  const finger = { x: 650, y: 120 };
  const under = at.toWorld(finger);
  at.zoom(3, finger);
  near(at.toWorld(finger).x, under.x);
  near(at.toWorld(finger).y, under.y);
  at.pan(-40, 25);
  near(at.toWorld({ x: 610, y: 145 }).x, under.x);
  near(at.toWorld({ x: 610, y: 145 }).y, under.y);
});

test("directions go clockwise from north, and port is to port", () => {
  near(directionTo({ x: 0, y: 0 }, { x: -1, y: 0 }), 270 * kDegree);
  const point = pointAt({ x: 5, y: 5 }, 120 * kDegree, 10);
  near(directionTo({ x: 5, y: 5 }, point), 120 * kDegree);
  const port = ofShip({ x: 0, y: 0, heading: 90 * kDegree }, 104, 7); // heading east: port is north
  near(port.x, 104);
  near(port.y, 7);
  const west = ofShip({ x: 0, y: 0, heading: 0 }, 104, 7); // heading north: port is west
  near(west.x, -7);
  near(west.y, 104);
});

test("the waterline of a wedge is as wide as the wedge is at z = 0", () => {
  // A prism, 20 m long, 8 m wide at z = 2 and coming to a keel at z = -2: 4 m wide at the waterline.
  const corners: number[][] = [];
  for (const x of [-10, 10]) corners.push([x, 4, 2], [x, -4, 2], [x, 0, -2]);
  const triangles = [0, 3, 2, 3, 5, 2, 1, 2, 4, 4, 2, 5, 0, 1, 3, 1, 4, 3, 0, 2, 1, 3, 4, 5];
  const line = waterline(new Float32Array(corners.flat()), new Uint32Array(triangles));
  const xs = [...line].filter((_, k) => k % 2 === 0);
  const ys = [...line].filter((_, k) => k % 2 === 1);
  assert.equal(Math.min(...xs), -10);
  assert.equal(Math.max(...xs), 10);
  assert.equal(Math.min(...ys), -2);
  assert.equal(Math.max(...ys), 2);
  let twice = 0; // of the area, positive counterclockwise
  for (let k = 0; k < xs.length; ++k) {
    const next = (k + 1) % xs.length;
    twice += xs[k]! * ys[next]! - xs[next]! * ys[k]!;
  }
  assert.equal(twice / 2, 80);
  assert.equal(waterline(new Float32Array(9), new Uint32Array([0, 1, 2])).length, 0, "no hull, no waterline");
});

test("a grid of soundings that is thinned is a grid, and none stand closer than told", () => {
  const all: { x: number; y: number; depth: number; letter: string }[] = [];
  for (let x = 0; x < 20; ++x) for (let y = 0; y < 20; ++y) all.push({ x: 50 * x, y: 50 * y, depth: 20, letter: "S" });
  const left = thin(all, 90);
  assert.equal(left.length, 100); // every other one, both ways
  assert.ok(left.every(({ x, y }) => x % 100 === 0 && y % 100 === 0));
  assert.equal(thin(all, 49).length, all.length);
});

test("names of marks do not lie on one another: a lighthouse has its own before what stands close to it", () => {
  const mark = (name: string, kind: LandmarkKind, x: number): Landmark => {
    return { name, kind, x, y: 0, height: 20, light: LightColour.LIGHT_NONE, period: 0, flashes: [], sectors: [] };
  };
  const marks = [
    mark("Church", LandmarkKind.LANDMARK_TOWER, 0),
    mark("North Point", LandmarkKind.LANDMARK_LIGHTHOUSE, 80),
    mark("No 1", LandmarkKind.LANDMARK_BUOY_PORT, 300),
  ];
  const names = (apart: number): string[] => named(marks, apart).map(({ name }) => name);
  assert.deepEqual(names(100), ["North Point", "No 1"]);
  assert.deepEqual(names(50), ["North Point", "Church", "No 1"]);
});

test("of what would be written one over another the first by rank stays; her own words give way to no sign", () => {
  const lettering = new Lettering();
  const written: string[] = [];
  const add = (text: string, its: number, x: number): void =>
    lettering.add(its, { box: around({ x, y: 0 }, 10), draw: () => written.push(text) });
  lettering.keep(around({ x: 100, y: 0 }, 10));
  add("sounding", rank.sounding, 0);
  add("contour", rank.contour, 15);
  add("sounding apart", rank.sounding, 40);
  add("sounding behind it", rank.sounding, 55);
  add("beside a sign", rank.charted, 95);
  add("anchor", rank.own, 85);
  add("another anchor", rank.own, 90);
  lettering.write();
  assert.deepEqual(written, ["anchor", "contour", "sounding apart"]);
});

test("under what covers the plan nothing is written, her own words neither", () => {
  const lettering = new Lettering();
  const written: string[] = [];
  const place = (text: string, x: number) => ({ box: around({ x, y: 0 }, 10), draw: () => written.push(text) });
  lettering.cover(around({ x: 0, y: 0 }, 10));
  lettering.add(rank.own, place("let go, under a button", 5), place("let go, beside it", 30));
  lettering.add(rank.own, place("P", 0));
  lettering.add(rank.sounding, place("25", -15));
  lettering.write();
  assert.deepEqual(written, ["let go, beside it"]);
});

test("what has no room on one side of its sign is written on another", () => {
  const lettering = new Lettering();
  const written: string[] = [];
  const place = (text: string, x: number) => ({ box: around({ x, y: 0 }, 10), draw: () => written.push(text) });
  lettering.add(rank.own, place("P", 0));
  lettering.add(rank.own, place("let go, right", 5), place("let go, left", -30));
  lettering.write();
  assert.deepEqual(written, ["P", "let go, left"]);
});

test("the true wind is the apparent one less her own way", () => {
  // Steaming north at 5 m/s in a calm: 5 m/s from ahead.
  near(trueWind(5, 0, 0, 0, 5).speed, 0);
  // At rest, heading east, wind from the port beam: from north.
  const north = trueWind(8, -90 * kDegree, 90 * kDegree, 0, 0);
  near(north.speed, 8);
  near(Math.cos(north.from), 1);
  // Falling astern to the south at 0.5 m/s, heading north, 7.5 m/s from ahead: 8 m/s from north.
  const astern = trueWind(7.5, 0, 0, 180 * kDegree, 0.5);
  near(astern.speed, 8);
  near(Math.cos(astern.from), 1);
});

test("rings and scale are round in metres, and from a mile on in miles", () => {
  near(roundLength(260), 200);
  near(roundLength(1900), kNauticalMile);
  near(roundLength(4200), 2 * kNauticalMile);
  assert.equal(distanceText(500), "500 m");
  assert.equal(distanceText(roundLength(4200)), "2 NM");
  assert.equal(distanceText(2.25 * kNauticalMile), "2.25 NM");
});

test("a bearing that the eye on the bridge took goes through its mark on the plan", () => {
  const ship = { x: 30, y: -20, heading: 90 * kDegree };
  const mark = { x: 30, y: 980 };
  const eye = bridgeEye(225);
  const taken = directionTo(ofShip(ship, eye, 0), mark); // abeam, 5 degrees off what GPS's place would have
  const measuring = new Measuring();
  Object.assign(measuring.lines[0], { on: true, forward: eye, bearing: taken, range: 1000 });
  const at = Object.assign(new Projection(), { width: 800, height: 600, scale: 0.5, centre: { x: 30, y: 480 } });
  const grip = measuring.grips(at, ship)[0]!;
  const there = at.toWorld(grip.at);
  near(directionTo(ofShip(ship, eye, 0), there), taken, 1e-6);
  assert.ok(Math.hypot(there.x - mark.x, there.y - mark.y) < 6, "a kilometre along it from the eye is the mark");
  near(Math.abs(taken - directionTo(ship, mark)) / kDegree, 5.1, 0.1);
});

test("a parallel index goes with own ship, at its distance, and does not turn with her heading", () => {
  const at = Object.assign(new Projection(), { width: 800, height: 600, scale: 0.5 });
  const index = new ParallelIndex();
  const off = 0.2 * kNauticalMile;
  index.set(0, { on: true, course: 30 * kDegree, off });
  const held = (ship: { x: number; y: number; heading: number }): { x: number; y: number } => {
    const [turn, line] = index.grips(at, ship);
    const place = at.toWorld(turn!.at);
    near(relativeTo(ship, 30 * kDegree, place).off, off, 1e-6);
    for (const far of [-2000, 0, 3000]) {
      const p = pointAt(pointAt(ship, 120 * kDegree, off), 30 * kDegree, far);
      near(line!.hit(at.toScreen(p.x, p.y)), 6, 1e-6); // px, by which a grip goes before a line
    }
    return place;
  };
  const before = held({ x: 0, y: 0, heading: 0 });
  assert.deepEqual(held({ x: 0, y: 0, heading: 1.3 }), before);
  const after = held({ x: 250, y: -100, heading: 1.3 });
  near(after.x - before.x, 250, 1e-6);
  near(after.y - before.y, -100, 1e-6);
  assert.deepEqual(index.grips(at, undefined), [], "without GPS or gyro there is none");
});

test("a parallel index is dragged to its distance, over to the other side, and to its course", () => {
  const at = Object.assign(new Projection(), { width: 800, height: 600, scale: 0.5 });
  const ship = { x: 40, y: 60, heading: 2 };
  const index = new ParallelIndex();
  index.set(1, { on: true, course: 0, off: 300 });
  const drag = (which: 0 | 1, to: { x: number; y: number }): void => index.grips(at, ship)[which]!.move(to);
  drag(1, pointAt(ship, -90 * kDegree, 0.35 * kNauticalMile));
  near(index.lines[1].off, -0.35 * kNauticalMile, 1e-6);
  near(index.lines[1].course, 0);
  // On a course of 60 degrees the line leads 0.35 miles to port of her.
  drag(0, pointAt(pointAt(ship, -30 * kDegree, 0.35 * kNauticalMile), 60 * kDegree, 900));
  near(index.lines[1].course, 60 * kDegree, 1e-9);
  near(index.lines[1].off, -0.35 * kNauticalMile, 1e-6);
  assert.equal(index.text(1), "PI 2 060.0\u00b0, 0.35 NM");
  index.setUnit("cable");
  assert.equal(index.text(1), "PI 2 060.0\u00b0, 3.5 cables");
  near(courseThrough(ship, 200, pointAt(ship, 10 * kDegree, 100)), 280 * kDegree, 1e-9); // nearer than the line: abeam
});
