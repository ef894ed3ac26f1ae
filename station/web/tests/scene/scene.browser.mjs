// The scene in a browser: what it may cost, that it leaves nothing behind, that still pictures come out again, and that
// links are where the samples say.
//
// usage: node tests/scene/scene.browser.mjs      (CHROMIUM: the browser, /usr/bin/chromium)

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, before, test } from "node:test";
import { openScene } from "./browser.mjs";

const recorded = JSON.parse(await readFile(new URL("instants.json", import.meta.url), "utf8"));
const kCameras = ["stand", "bow", "brake", "aft", "outside", "water", "free"];
const kCalls = 80; // of a frame: stations.md's budget
const kTriangles = { software: 120_000, low: 120_000, high: 250_000 };

let browser;
before(async () => (browser = await openScene(640, 360)));
after(() => browser.close());

for (const quality of ["software", "high"])
  test(`${quality}: every camera at every instant keeps to the budget of calls and triangles`, async () => {
    for (const { name } of recorded.instants)
      for (const camera of quality === "high" ? ["stand", "outside"] : kCameras) {
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
  const smoke = { instant: "running", camera: "stand", quality: "software", tackle: { lining: 3 } };
  await browser.show(smoke);
  const first = await browser.page.screenshot();
  await browser.show({ instant: "landed", camera: "water", quality: "software" });
  await browser.show(smoke);
  assert.ok(first.equals(await browser.page.screenshot()));
});

test("links are drawn where the samples have the cable", async () => {
  await browser.show({ instant: "hanging", camera: "stand", quality: "software" });
  const places = await browser.page.evaluate(() => window.places(0));
  const nodes = recorded.instants.find((i) => i.name === "hanging")["ChainState/0"].nodes;
  let outboard = 0;
  for (let i = 0; i < places.length; i += 3) {
    const z = places[i + 2];
    if (z > nodes[2] - 0.2 || z < nodes.at(-1) + 0.2) continue;
    let k = 0;
    while (nodes[k + 5] > z) k += 3;
    const share = (z - nodes[k + 2]) / (nodes[k + 5] - nodes[k + 2]);
    const on = (c) => nodes[k + c] + share * (nodes[k + 3 + c] - nodes[k + c]);
    assert.ok(Math.hypot(places[i] - on(0), places[i + 1] - on(1)) < 1e-3);
    ++outboard;
  }
  assert.ok(outboard > 10);
});

test("nothing is said on the console", () => assert.deepEqual(browser.errors, []));
