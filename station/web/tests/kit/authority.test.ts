// Set points that stand when the hand that gave them has left.

import assert from "node:assert/strict";
import { test } from "node:test";

import { helmOrdered, windlassOrdered } from "../../src/kit/authority";
import type { Connection } from "../../src/wire/connection";

/** A link that has heard one sample of each of these channels, at that time, ms. */
const heard = (samples: Record<string, [at: number, sample: object]>): Connection =>
  ({
    latest: (channel: string) => samples[channel]?.[1],
    track: (channel: string, key: string | number = "") => {
      const found = samples[key === "" ? channel : `${channel}/${key}`];
      return found ? [{ at: found[0], sample: found[1] }] : [];
    },
  }) as unknown as Connection;

void test("the helm's set points are those that the server has, whatever was said last and the engine does", () => {
  const command = { engine: 0.5, rudder: 0.3, bow_thruster: 0, stern_thruster: 0 };
  assert.equal(helmOrdered(heard({ HelmCommand: [2, command] })), undefined);
  const view = {
    engine: 0.1,
    rudder: 0,
    bow_thruster: 0,
    stern_thruster: 0,
    engine_ordered: 0.2,
    rudder_ordered: 0.1,
    bow_thruster_ordered: -0.5,
    stern_thruster_ordered: 1,
  };
  assert.deepEqual(helmOrdered(heard({ BridgeView: [1, view], HelmCommand: [2, command] })), {
    engine: 0.2,
    rudder: 0.1,
    bow_thruster: -0.5,
    stern_thruster: 1,
  });
});

void test("a windlass's are those of its side that were given last, whoever gave them", () => {
  const [port, starboard, desk] = [{ brake: 1 }, { brake: 0 }, { brake: 0.5 }];
  const link = heard({
    "WindlassCommand/0": [1, port],
    "WindlassCommand/1": [1, starboard],
    "InstructorWindlassCommand/1": [2, desk],
  });
  assert.equal(windlassOrdered(link, 0), port);
  assert.equal(windlassOrdered(link, 1), desk);
});
