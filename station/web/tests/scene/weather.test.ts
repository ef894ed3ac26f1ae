// Sky and spray: the sun has a side, and water comes over the bow when it blows and a sea meets it.

import assert from "node:assert/strict";
import { test } from "node:test";

import { daylight, empty } from "../../src/scene/daylight";
import type { SceneFrame } from "../../src/scene/frame";
import type { Particles } from "../../src/scene/particles";
import { Spray, sprayed } from "../../src/scene/spray";
import { significantHeight } from "../../src/scene/waves";
import type { SeaState } from "../../src/wire/generated";

const at = (hour: number, visibility = 20000, overcast = 0): ReturnType<typeof daylight> =>
  daylight(3600 * hour, visibility, overcast, empty());
const bright = ({ r, g, b }: { r: number; g: number; b: number }): number => r + g + b;

test("the sky is bright where the sun went down, blue across from it, and alike all round at noon", () => {
  const dusk = at(18.2);
  assert.ok(dusk.sunwards.x < -0.99, "she sets in the west");
  assert.ok(at(5.8).sunwards.x > 0.99, "and rises in the east");
  assert.ok(bright(dusk.glow) > 2 * bright(dusk.away));
  assert.ok(dusk.glow.r > dusk.glow.b && dusk.away.b > dusk.away.r);
  assert.deepEqual(at(12).glow, at(12).away);
});

test("fog and clouds take the colours, and the sun's strength, of dusk and day", () => {
  for (const dull of [at(18.2, 250), at(18.2, 20000, 1)])
    assert.ok(dull.glow.r - dull.glow.b < 0.7 * (at(18.2).glow.r - at(18.2).glow.b));
  assert.ok(at(12, 20000, 1).sunStrength < 0.3 * at(12).sunStrength);
});

const kWave = { k_x: 0, k_y: 0.1, omega: 1, phase: 0 };
const swell = (amplitude: number): SeaState =>
  ({
    ramp_begin: 0,
    ramp_end: 0,
    components: [{ ...kWave, amplitude_before: amplitude, amplitude_after: amplitude }],
  }) as unknown as SeaState;
const frame = (more: Partial<SceneFrame>): SceneFrame => ({
  time: 100,
  ship: { x: 0, y: 0, z: 0, heading: 0, roll: 0, pitch: 0 },
  tackle: [],
  wind_speed: 20,
  wind_from: 0,
  visibility: 4000,
  time_of_day: 43200,
  ...more,
});

test("one wave's significant height is 2.8 amplitudes", () =>
  assert.ok(Math.abs(significantHeight(swell(1), 0) - 2.828) < 1e-3));

test("spray comes in a gale on the bow with a sea, and not in a breeze, in a harbour or from astern", () => {
  assert.ok(sprayed(frame({}), swell(1)) > 0.9);
  assert.equal(sprayed(frame({ wind_speed: 9 }), swell(1)), 0);
  assert.equal(sprayed(frame({}), swell(0.1)), 0);
  assert.equal(sprayed(frame({}), undefined), 0);
  assert.equal(sprayed(frame({ wind_from: Math.PI }), swell(1)), 0);
});

test("it comes while the water rises against the bow, from the rail ahead, at most so many a second", () => {
  const born: number[][] = [];
  const into = { add: (_: unknown, ...rest: number[]) => born.push(rest) } as unknown as Particles;
  const spray = new Spray([100, 0, 12], (x) => 105 - x);
  const sea = swell(2);
  const thrown = (time: number): number => {
    born.length = 0;
    for (let i = 0; i < 10; ++i)
      spray.stir(
        into,
        frame({ time }),
        time,
        0.1,
        sea,
        [0, 0, 0],
        (p) => p,
        50,
        () => 0.5,
      );
    return born.length;
  };
  // at the stem, at y = 0, the surface rises while sin(t) < 0
  const [rises, falls] = [1.5 * Math.PI + 32 * Math.PI, 0.5 * Math.PI + 32 * Math.PI];
  assert.equal(thrown(falls), 0);
  const many = thrown(rises);
  assert.ok(many > 40 && many <= 50, `${many}`);
  for (const [x, y, z] of born) assert.ok(x! > 86 && x! <= 100 && Math.abs(y!) <= 105 - x! && z! >= 12);
});
