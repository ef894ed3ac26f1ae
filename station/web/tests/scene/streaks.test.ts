// A cable that runs fast: streaks in the place of plain links, and painted ones as they are, to count by.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { test } from "node:test";
import { type InstancedMesh, PerspectiveCamera } from "three";

import { ChainMesh } from "../../src/scene/chain";
import { frameOfSeat } from "../../src/scene/from_seat";
import { LinkKind, Links } from "../../src/scene/links";
import { Materials } from "../../src/scene/materials";
import { deckHeight, rig } from "../../src/scene/rig";
import { root } from "../../tools/web.mjs";
import { OneInstant, type Recorded } from "./samples";

const recorded = JSON.parse(await readFile(join(root, "station/web/tests/scene/instants.json"), "utf8")) as Recorded;
const samples = new OneInstant(recorded, "running");
const scene = samples.latest("SceneDescription")!;
const frame = frameOfSeat(samples, 0)!;
const gear = rig(scene.tackle[0]!, deckHeight(scene));

/** What is drawn of a cable that runs so fast, m/s, seen from 30 m; painted: so many links of it are. */
function drawn(cable_speed: number, painted = 0): { links: number; streaks: number; over: number } {
  const links = new Links();
  const tackle = { ...frame.tackle[0]!, cable_speed };
  links.place(gear, tackle, frame.ship, [0, 0, 0]);
  for (let i = 0; i < painted; ++i) links.kind[i] = LinkKind.white;
  const chain = new ChainMesh(new Materials(false), 40);
  const eye = new PerspectiveCamera(120, 1, 0.1, 1000);
  const [x, y, z] = [links.middle[0]!, links.middle[1]!, links.middle[2]!];
  eye.up.set(0, 0, 1);
  eye.position.set(x + 25, y + 12, z + 8);
  eye.lookAt(x, y, z);
  eye.updateMatrixWorld();
  eye.updateProjectionMatrix();
  chain.show(links, tackle, gear.d, eye, 900, undefined, 0, -Infinity);
  const counts = (chain.group.children as InstancedMesh[]).map((mesh) => mesh.count);
  const under = Array.from({ length: links.count }, (_, i) => links.middle[3 * i + 2]!).filter((h) => h <= 0).length;
  return { links: counts.slice(0, 4).reduce((a, b) => a + b), streaks: counts.at(-1)!, over: links.count - under };
}

test("a cable that is veered is drawn link by link", () => {
  const { links, streaks } = drawn(-2);
  assert.ok(links > 40);
  assert.equal(streaks, 0);
});

test("one that runs has streaks between its links, and no plain link over the water when it runs away", () => {
  const slow = drawn(1);
  const quick = drawn(4);
  assert.equal(quick.links, slow.links);
  assert.ok(quick.streaks > 30 && quick.streaks <= quick.over);
  const away = drawn(8);
  assert.equal(away.links, slow.links - away.streaks);
});

test("painted links are drawn at any speed", () => {
  assert.equal(drawn(8, 5).links, drawn(8).links + 5);
  assert.equal(drawn(8, 5).streaks, drawn(8).streaks - 5);
});
