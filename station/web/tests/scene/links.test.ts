// Where links, gypsy and cable are, against the recorded samples and against sums done by hand.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { test } from "node:test";
import { frameOfSeat } from "../../src/scene/from_seat";
import { frameOfTruth } from "../../src/scene/from_truth";
import type { SceneFrame, TackleFrame } from "../../src/scene/frame";
import { bedHeight, soilAt } from "../../src/scene/ground";
import { LinkKind, Links, linkPhase } from "../../src/scene/links";
import { type Rig, chainAt, deckHeight, kPitch, pocketAngle, rig } from "../../src/scene/rig";
import { shipAxes, turned, vec } from "../../src/scene/vec";
import { shaderWaves, surface } from "../../src/scene/waves";
import type { SceneDescription, SeaState, SeabedDescription } from "../../src/wire/generated";
import { root } from "../../tools/web.mjs";
import { OneInstant, type Recorded } from "./samples";

const recorded = JSON.parse(await readFile(join(root, "station/web/tests/scene/instants.json"), "utf8")) as Recorded;
const kMillimetre = 1e-3;
/** float32 of nodes some 100 m from the world's origin. */
const kSingle = 2e-5;

interface Scene {
  frame: SceneFrame;
  tackle: TackleFrame;
  rig: Rig;
  links: Links;
}

function at(instant: string, seat = false): Scene {
  const samples = new OneInstant(recorded, instant);
  const description = samples.latest("SceneDescription") as SceneDescription;
  const frame = (seat ? frameOfSeat(samples, 0) : frameOfTruth(samples, 0))!;
  const tackle = frame.tackle[0]!;
  const made = rig(description.tackle[0]!, deckHeight(description));
  const links = new Links();
  links.place(made, tackle, frame.ship, [0, 0, 0]);
  return { frame, tackle, rig: made, links };
}

const middle = (links: Links, i: number): number[] => Array.from(links.middle.subarray(3 * i, 3 * i + 3));
const apart = (a: readonly number[], b: readonly number[]): number =>
  Math.hypot(a[0]! - b[0]!, a[1]! - b[1]!, a[2]! - b[2]!);

/** m, of a point from the polyline of nodes, and m along it. */
function toNodes(p: readonly number[], nodes: Float32Array): { off: number; along: number } {
  let best = { off: Infinity, along: 0 };
  let sum = 0;
  for (let i = 0; i + 5 < nodes.length; i += 3) {
    const a = [nodes[i]!, nodes[i + 1]!, nodes[i + 2]!];
    const d = [nodes[i + 3]! - a[0]!, nodes[i + 4]! - a[1]!, nodes[i + 5]! - a[2]!];
    const l = Math.hypot(d[0]!, d[1]!, d[2]!);
    const t = Math.min(1, Math.max(0, d.reduce((s, v, k) => s + v * (p[k]! - a[k]!), 0) / (l * l || 1)));
    const off = apart(
      p,
      a.map((v, k) => v + t * d[k]!),
    );
    if (off < best.off) best = { off, along: sum + t * l };
    sum += l;
  }
  return best;
}

const kInstants = recorded.instants.map((i) => i.name);

for (const instant of kInstants) {
  test(`${instant}: the cable passes through every recorded node`, () => {
    const { tackle, links } = at(instant);
    const place = new Float64Array(3);
    const { path } = links;
    for (let i = 0; i + 2 < tackle.nodes.length; i += 3) {
      const node = Array.from(tackle.nodes.subarray(i, i + 3));
      let nearest = Infinity;
      for (let k = 0; k < path.count; ++k)
        nearest = Math.min(nearest, apart(node, Array.from(path.points.subarray(3 * k, 3 * k + 3))));
      assert.ok(nearest < kSingle, `node ${i / 3} is ${nearest} m off`);
    }
    path.place(path.end, place, 0);
    assert.ok(apart(Array.from(place), Array.from(tackle.nodes.slice(-3))) < kSingle);
  });

  test(`${instant}: links follow each other without gap or jump, across the lip too`, () => {
    const { links, rig: r } = at(instant);
    const pitch = kPitch * r.d;
    for (let i = 1; i < links.count; ++i) {
      const gap = apart(middle(links, i), middle(links, i - 1));
      // Stretch adds a thousandth; on the gypsy and at a sharp bend on the ground chords are shorter than arcs.
      // With the anchor home, what is left of the cable is short: a few mm of play in the pipe are spread over it.
      assert.ok(gap < (instant === "housed" ? 1.01 : 1.004) * pitch, `link ${i}: ${gap} m after the last`);
      assert.ok(links.s[i]! - links.s[i - 1]! - pitch < kMillimetre);
    }
  });
}

test("links on straight cable lie on the recorded line to a millimetre, where their number puts them", () => {
  const { tackle, links, rig: r } = at("hanging"); // plumb: line and chord are one
  const pitch = kPitch * r.d;
  let seen = 0;
  for (let i = 0; i < links.count; ++i) {
    if (links.s[i]! < pitch || links.s[i]! > links.out - pitch) continue;
    const { off, along } = toNodes(middle(links, i), tackle.nodes);
    const drawn = links.out - pitch * (links.number[i]! + 0.5);
    assert.ok(off < kMillimetre, `${off}`);
    // nodes are stretched by 20 t over EA at most: 0.3 mm in a metre
    assert.ok(Math.abs(along - drawn) < 2 * kMillimetre, `${along} for ${drawn}`);
    ++seen;
  }
  assert.ok(seen > 10);
});

test("on a curved cable, middles of links stand off the recorded line by no more than the curve between nodes", () => {
  const { tackle, links } = at("brought_up");
  for (let i = 0; i < links.count; ++i) {
    if (links.s[i]! < 0.2) continue;
    assert.ok(toNodes(middle(links, i), tackle.nodes).off < 0.02);
  }
});

test("the last link ends at the anchor's shackle", () => {
  const { tackle, links, rig: r } = at("brought_up");
  const last = links.count - 1;
  assert.equal(links.number[last], 0);
  const end = Array.from(
    { length: 3 },
    (_, k) => links.middle[3 * last + k]! + (kPitch / 2) * r.d * links.along[3 * last + k]!,
  );
  assert.ok(apart(end, Array.from(tackle.nodes.slice(-3))) < kMillimetre);
});

test("flat links lie in the gypsy's pockets, to a degree, however far the cable has run", () => {
  for (const instant of kInstants) {
    const { frame, tackle, rig: r, links } = at(instant);
    const axes = shipAxes(frame.ship);
    const gypsy = turned(axes, r.gypsy).map((v, k) => v + [frame.ship.x, frame.ship.y, frame.ship.z][k]!);
    const lead = turned(axes, r.lead);
    const up = turned(axes, [0, 0, 1]);
    const pocket = (2 * Math.PI) / 5;
    let seated = 0;
    for (let i = 0; i < links.count; ++i) {
      const d = middle(links, i).map((v, k) => v - gypsy[k]!);
      const x = d.reduce((s, v, k) => s + v * lead[k]!, 0);
      const z = d.reduce((s, v, k) => s + v * up[k]!, 0);
      const angle = Math.atan2(x, z);
      // both ends on the pitch circle
      if (Math.hypot(x, z) > 1.001 * r.radius || angle < r.meets + 0.32 || angle > 1.25) continue;
      const off = (angle - pocketAngle(r, tackle.gypsy_turn)) / pocket;
      const expected = links.number[i]! % 2 === 0 ? 0 : 0.5;
      const wrong = off - expected - Math.round(off - expected);
      assert.ok(
        Math.abs(wrong) * 72 < 1,
        `${instant}: link ${links.number[i]} is ${wrong * 72} degrees off its pocket`,
      );
      ++seated;
    }
    assert.ok(seated >= 1, `${instant}: ${seated} links on the gypsy`);
  }
});

test("links move with the cable: 10 mm more of it move every inboard link by 10 mm", () => {
  const scene = at("two_shackles");
  const more = new Links();
  const tackle = { ...scene.tackle, cable_out: scene.tackle.cable_out! + 0.01 };
  more.place(scene.rig, tackle, scene.frame.ship, [0, 0, 0]);
  for (let i = 2; i < 20; ++i) {
    const j = scene.links.number[i]!;
    const k = Array.from(more.number.subarray(0, more.count)).indexOf(j);
    assert.ok(Math.abs(more.s[k]! - scene.links.s[i]! - 0.01) < 1e-5);
    assert.ok(Math.abs(apart(middle(more, k), middle(scene.links, i)) - 0.01) < kMillimetre);
  }
});

test("a seat, which is not told how much cable is out, sees the same links", () => {
  let numbered = 0;
  for (const instant of ["hanging", "running", "two_shackles", "long_stay", "brought_up", "weighing"]) {
    const truth = at(instant);
    const seat = at(instant, true);
    const pitch = kPitch * truth.rig.d;
    const off = linkPhase(seat.tackle, seat.rig) - linkPhase(truth.tackle, truth.rig);
    assert.ok(Math.abs(off - 2 * pitch * Math.round(off / (2 * pitch))) < kMillimetre);
    if (Number.isNaN(seat.links.out)) continue; // no mark in sight: links without numbers
    ++numbered;
    assert.ok(Math.abs(seat.links.out - truth.links.out) < kMillimetre, `${seat.links.out} for ${truth.links.out}`);
    const kinds = new Map<number, number>();
    for (let i = 0; i < truth.links.count; ++i) kinds.set(truth.links.number[i]!, truth.links.kind[i]!);
    for (let i = 0; i < seat.links.count; ++i) {
      // past the last mark in sight, the next shackle's marks may begin
      if (seat.links.kind[i] !== LinkKind.plain) assert.equal(seat.links.kind[i], kinds.get(seat.links.number[i]!));
      const k = Array.from(truth.links.number.subarray(0, truth.links.count)).indexOf(seat.links.number[i]!);
      if (seat.links.s[i]! < -pitch) {
        // The ship is laid to her cable; her heading has steps of 0.1 degree, 10 m from the lip 9 mm.
        const off = apart(middle(truth.links, k), middle(seat.links, i));
        assert.ok(off < 0.02, `${instant}: link ${seat.links.number[i]} is ${off} m off`);
      }
    }
  }
  assert.ok(numbered >= 3, `${numbered}`);
});

test("the joining shackle at n lengths is red, the n-th link on either side white", () => {
  const { links, tackle, rig: r } = at("brought_up");
  const pitch = kPitch * r.d;
  const kindOf = (number: number): number =>
    links.kind[Array.from(links.number.subarray(0, links.count)).indexOf(number)]!;
  for (const mark of tackle.marks) {
    if (mark.outboard < 1) continue;
    const joint = Math.round((mark.shackle * 27.5) / pitch - 0.5);
    assert.equal(kindOf(joint), LinkKind.joining, `shackle ${mark.shackle}`);
    for (const side of [-1, 1]) {
      assert.equal(kindOf(joint + side * mark.white_links), LinkKind.white);
      for (let k = 1; k < mark.white_links; ++k) assert.notEqual(kindOf(joint + side * k), LinkKind.white);
    }
  }
});

test("inboard of the lip the cable lies in the pipe as the physics has it", () => {
  const { rig: r, frame, links } = at("two_shackles");
  const axes = shipAxes(frame.ship);
  const place = new Float64Array(3);
  for (const up of [0.2, 0.7, 1.5, 3, 4.5]) {
    links.path.place(-up, place, 0);
    const body = turned(axes, chainAt(r.tackle, up));
    const world = [body[0] + frame.ship.x, body[1] + frame.ship.y, body[2] + frame.ship.z];
    // the bend is drawn in steps of 6 cm: chords of a circle of 0.94 m
    assert.ok(apart(Array.from(place), world) < kMillimetre, `${up} m up the pipe`);
  }
});

test("with the anchor home, no cable is drawn outside the ship", () => {
  const { links, rig: r, frame } = at("housed");
  assert.ok(links.out < 0);
  const lip = turned(shipAxes(frame.ship), vec(r.tackle.lip))[2] + frame.ship.z;
  for (let i = 0; i < links.count; ++i) assert.ok(links.middle[3 * i + 2]! > lip - 0.05);
});

test("the ship's axes: heading clockwise from north, bow up, starboard down", () => {
  const close = (a: readonly number[], b: readonly number[]): void => assert.ok(apart(a, b) < 1e-12, `${a} for ${b}`);
  const pose = { x: 0, y: 0, z: 0, heading: Math.PI / 2, roll: 0, pitch: 0 };
  close(turned(shipAxes(pose), [1, 0, 0]), [1, 0, 0]);
  close(turned(shipAxes(pose), [0, 1, 0]), [0, 1, 0]);
  assert.ok(turned(shipAxes({ ...pose, pitch: 0.1 }), [1, 0, 0])[2] > 0);
  assert.ok(turned(shipAxes({ ...pose, roll: 0.1 }), [0, -1, 0])[2] < 0);
});

test("the surface is the sum of the components, and the shader's phases give the same", () => {
  const component = { k_x: 0.31, k_y: -0.2, omega: 1.9, phase: 0.7, amplitude_before: 0, amplitude_after: 0.8 };
  const sea: SeaState = { time: 0, ramp_begin: 100, ramp_end: 200, tide_height: 0, components: [component] };
  assert.equal(surface(sea, 8000, 3, 100), 0);
  const t = 86400;
  const eta = surface(sea, 8012, -3003, t);
  assert.ok(Math.abs(eta - 0.8 * Math.cos(0.31 * 8012 + 0.2 * 3003 - 1.9 * t + 0.7)) < 1e-9);
  const waves = new Float32Array(8);
  assert.equal(shaderWaves(sea, 8000, -3000, t, waves), 1);
  const single = waves[3]! * Math.cos(waves[0]! * 12 + waves[1]! * -3 + waves[2]!);
  assert.ok(Math.abs(single - eta) < 1e-5, "a day on, 8 km off: single precision of a small phase");
});

test("the ground is a plane where there is no grid, and a B-spline over one", () => {
  const flat: SeabedDescription = {
    definition_hash: 0n, depth: 25, soil: 1, slope: 0.1, slope_towards: 0, origin_x: 0, origin_y: 0, spacing: 10,
    columns: 0, rows: 0, heights: new Float32Array(0), soils: new Uint8Array(0),
  }; // prettier-ignore
  assert.ok(Math.abs(bedHeight(flat, 5, 100) - (-25 + 100 * Math.tan(0.1))) < 1e-12);
  const heights = new Float32Array(25);
  heights[12] = 1;
  const hill = { ...flat, slope: 0, columns: 5, rows: 5, heights, soils: new Uint8Array(25).fill(4) };
  assert.ok(Math.abs(bedHeight(hill, 20, 20) - (-25 + 0.75 ** 2)) < 1e-12);
  assert.ok(Math.abs(bedHeight(hill, 25, 20) - (-25 + 0.5 * 0.75)) < 1e-12);
  assert.equal(soilAt(hill, 20, 20), 4);
});
