// Faces of the stand's gauges.

import assert from "node:assert/strict";
import { readFile, readdir } from "node:fs/promises";
import { join } from "node:path";
import { test } from "node:test";
import schema from "../../../../config/schema/windlass.schema.json";
import { countedFrom, lampsLit, motorFace } from "../../src/forecastle/gauges";
import { root } from "../../tools/web.mjs";

const plate = ["rated_pull", "stall_pull", "motor_current_rated"] as const;

test("an ammeter's face has the current at which the motor of each windlass stalls, and little more", async () => {
  const folder = join(root, "config/windlasses");
  const files = (await readdir(folder)).filter((file) => file.endsWith(".json"));
  for (const file of files) {
    const own = JSON.parse(await readFile(join(folder, file), "utf8")) as Record<string, unknown>;
    if (own.drive === "hydraulic") continue;
    const of = (name: (typeof plate)[number]): number => (own[name] ?? schema.properties[name].default) as number;
    const rated = of("motor_current_rated");
    const atStall = (of("stall_pull") / of("rated_pull")) * rated;
    const { unit, end, redLine } = motorFace({ drive: "electric_vfd", rated_current: rated });
    assert.equal(unit, "A");
    assert.equal(redLine, rated, file);
    assert.ok(end >= atStall && end < 1.5 * atStall, `${file}: ${end} A, at stall ${atStall} A`);
  }
});

test("a hydraulic drive has a pressure gauge, and no motor's red line", () => {
  assert.deepEqual(motorFace({ drive: "hydraulic", rated_current: 0 }), { unit: "bar", end: 200 });
});

test("an ammeter whose windlass is not known yet has no red line", () => {
  assert.equal(motorFace(undefined).redLine, undefined);
});

test("a counter that stands below zero says of what: an anchor that is home has its shackle up the pipe", () => {
  assert.equal(countedFrom(-2.84), "inboard of the lip");
  assert.equal(countedFrom(-0.04), "from the lip", "as it is shown: 0.0");
  assert.equal(countedFrom(0.6), "from the lip");
});

test("a panel without supply has no lamp lit, though its drive is cut off", () => {
  const lit = (power: boolean, tripped: boolean, emergency_stop = false): string[] =>
    Object.entries(lampsLit({ power, tripped, emergency_stop })).flatMap(([lamp, on]) => (on ? lamp : []));
  assert.deepEqual(lit(true, false), ["power", "ready"]);
  assert.deepEqual(lit(true, true), ["power", "trip"]);
  assert.deepEqual(lit(true, true, true), ["power", "trip", "e-stop"]);
  assert.deepEqual(lit(false, true, true), []);
});
