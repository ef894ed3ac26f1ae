// Set points that stand when the hand that gave them has left.

import assert from "node:assert/strict";
import { test } from "node:test";

import { helmOrdered, windlassOrdered } from "../../src/kit/authority";
import type { Connection } from "../../src/wire/connection";

/** A link that has heard one sample of each of these channels, at that time, ms. */
const heard = (samples: Record<string, [at: number, sample: object]>): Connection =>
  ({
    track: (channel: string, key: string | number = "") => {
      const found = samples[key === "" ? channel : `${channel}/${key}`];
      return found ? [{ at: found[0], sample: found[1] }] : [];
    },
  }) as unknown as Connection;

void test("the helm's set points are those that were given last, whoever gave them", () => {
  const [bridge, desk] = [{ engine: 0.5 }, { engine: 0.2 }];
  assert.equal(helmOrdered(heard({})), undefined);
  assert.equal(helmOrdered(heard({ HelmCommand: [1, bridge] })), bridge);
  assert.equal(helmOrdered(heard({ InstructorHelmCommand: [1, desk] })), desk);
  assert.equal(helmOrdered(heard({ HelmCommand: [1, bridge], InstructorHelmCommand: [2, desk] })), desk);
  assert.equal(helmOrdered(heard({ HelmCommand: [3, bridge], InstructorHelmCommand: [2, desk] })), bridge);
});

void test("a windlass's are those of its side", () => {
  const [port, starboard] = [{ brake: 1 }, { brake: 0 }];
  const link = heard({ "WindlassCommand/0": [1, port], "InstructorWindlassCommand/1": [2, starboard] });
  assert.equal(windlassOrdered(link, 0), port);
  assert.equal(windlassOrdered(link, 1), starboard);
});
