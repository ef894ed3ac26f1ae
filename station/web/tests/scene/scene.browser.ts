// The scene in a browser: what it may cost, that it leaves nothing behind, that still pictures come out again, and that
// links are where the samples say.
//
// usage: node station/web/tools/ts.mjs --test station/web/tests/scene/scene.browser.ts
//            (CHROMIUM: the browser, /usr/bin/chromium)

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { type Landmarks, LandmarkKind, LightColour } from "../../src/wire/generated";
import { type SceneBrowser, here, openScene } from "./browser";
import type { Show } from "./page";
import type { Recorded } from "./samples";

const recorded = JSON.parse(await readFile(join(here, "instants.json"), "utf8")) as Recorded;
const kCameras = ["stand", "bow", "brake", "aft", "outside", "water", "free"] as const;
const kCalls = 80; // of a frame: stations.md's budget
const kTriangles = { software: 120_000, high: 250_000 };

let browser: SceneBrowser;
before(async () => (browser = await openScene(640, 360)));
after(() => browser.close());

for (const quality of ["software", "high"] as const)
  test(`${quality}: every camera at every instant keeps to the budget of calls and triangles`, async () => {
    for (const { name } of recorded.instants)
      for (const camera of quality === "high" ? (["stand", "outside"] as const) : kCameras) {
        const stats = await browser.show({ instant: name, camera, quality, loads: camera === "outside" });
        assert.ok(stats.calls > 4 && stats.calls <= kCalls, `${name} ${camera}: ${stats.calls} calls`);
        assert.ok(stats.triangles <= kTriangles[quality], `${name} ${camera}: ${stats.triangles} triangles`);
      }
  });

test("geometries and textures do not grow as cable runs out and cameras change", async () => {
  const round = async () => {
    for (const instant of ["hanging", "running", "landed", "brought_up"])
      for (const camera of kCameras)
        await browser.show({ instant, camera, quality: "software", tackle: { lining: 4, cable_speed: 5 } });
    return browser.show({ instant: "hanging", camera: "stand", quality: "software" });
  };
  const first = await round();
  const second = await round();
  assert.equal(second.geometries, first.geometries);
  assert.equal(second.textures, first.textures);
});

test("a still picture is the same each time", async () => {
  const smoke: Show = { instant: "running", camera: "stand", quality: "software", tackle: { lining: 3 } };
  await browser.show(smoke);
  const first = await browser.page.screenshot();
  await browser.show({ instant: "landed", camera: "water", quality: "software" });
  await browser.show(smoke);
  assert.ok(first.equals(await browser.page.screenshot()));
});

test("links are drawn where the samples have the cable", async () => {
  await browser.show({ instant: "hanging", camera: "stand", quality: "software" });
  const places = await browser.places(0);
  const hanging = recorded.instants.find((i) => i.name === "hanging")!;
  const { nodes } = hanging["ChainState/0"] as { nodes: number[] };
  const node = (k: number): number => nodes[k]!;
  let outboard = 0;
  for (let i = 0; i < places.length; i += 3) {
    const z = places[i + 2]!;
    if (z > node(2) - 0.2 || z < nodes.at(-1)! + 0.2) continue;
    let k = 0;
    while (node(k + 5) > z) k += 3;
    const share = (z - node(k + 2)) / (node(k + 5) - node(k + 2));
    const on = (c: number): number => node(k + c) + share * (node(k + 3 + c) - node(k + c));
    assert.ok(Math.hypot(places[i]! - on(0), places[i + 1]! - on(1)) < 1e-3);
    ++outboard;
  }
  assert.ok(outboard > 10);
});

/** One of each kind, a transit, a coast, a ship. */
const landmarks: Landmarks = {
  definition_hash: 1n,
  has_position: false,
  latitude_deg: 0,
  longitude_deg: 0,
  region_b: false,
  coasts: [
    { colour: 0x4c5f4e, shore: Float32Array.of(-900, 900, 0, 900, 900, 0), ridge: new Float32Array(6).fill(99) },
  ],
  lamps: Float32Array.of(100, 910, 20),
  marks: Object.values(LandmarkKind)
    .filter((kind) => typeof kind === "number")
    .map((kind, k) => ({
      name: `${k}`,
      kind,
      x: 40 * k,
      y: 500,
      height: 20,
      light: LightColour.LIGHT_GREEN,
      period: 4,
      flashes: [{ begin: 0, duration: 1 }],
      sectors: [],
    })),
  transits: [{ name: "leading line", front: LandmarkKind.LANDMARK_BEACON, rear: LandmarkKind.LANDMARK_TOWER }],
  ships: [{ x: -300, y: 600, heading: 1, length: 150, beam: 26 }],
};

test("landmarks cost four calls however many there are, and leave nothing behind", async () => {
  const night: Show = { instant: "hanging", camera: "stand", quality: "software", frame: { time_of_day: 0, time: 0 } };
  await browser.show({ ...night, landmarks });
  const openSea = await browser.show(night);
  const shore = await browser.show({ ...night, landmarks });
  assert.equal(shore.calls - openSea.calls, 4);
  assert.ok(shore.triangles - openSea.triangles < 5000, `${shore.triangles - openSea.triangles} triangles`);
  assert.equal((await browser.show(night)).geometries, openSea.geometries);
});

test("nothing is said on the console", () => assert.deepEqual(browser.errors, []));
