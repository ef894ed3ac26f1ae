// The colours of tension are told apart by everybody.

import assert from "node:assert/strict";
import { test } from "node:test";

import { rampAt, rampCss } from "../../src/scene/colour_ramp";

type Triple = readonly [number, number, number];
type Matrix = readonly [Triple, Triple, Triple];

const times = (matrix: Matrix, [x, y, z]: Triple): Triple => {
  const row = ([a, b, c]: Triple): number => a * x + b * y + c * z;
  return [row(matrix[0]), row(matrix[1]), row(matrix[2])];
};
// What an eye without one kind of cones makes of linear RGB (Vienot, Brettel, Mollon, Color Research & Application 24,
// 1999, for the primaries of sRGB), and what a grey print does.
const eyes: Record<string, Matrix> = {
  all: [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ],
  "no red": [
    [0.11238, 0.88762, 0],
    [0.11238, 0.88762, 0],
    [0.00401, -0.00401, 1],
  ],
  "no green": [
    [0.29275, 0.70725, 0],
    [0.29275, 0.70725, 0],
    [-0.02234, 0.02234, 1],
  ],
  "no colour": [
    [0.2126, 0.7152, 0.0722],
    [0.2126, 0.7152, 0.0722],
    [0.2126, 0.7152, 0.0722],
  ],
};
/** OKLab of linear RGB. */
const seen = (rgb: Triple): Triple => {
  const cone = times(
    [
      [0.4122214708, 0.5363325363, 0.0514459929],
      [0.2119034982, 0.6806995451, 0.1073969566],
      [0.0883024619, 0.2817188376, 0.6299787005],
    ],
    rgb,
  ).map((x) => Math.cbrt(Math.max(0, x))) as unknown as Triple;
  return times(
    [
      [0.2104542553, 0.793617785, -0.0040720468],
      [1.9779984951, -2.428592205, 0.4505937099],
      [0.0259040371, 0.7827717662, -0.808675766],
    ],
    cone,
  );
};
const shares = Array.from({ length: 21 }, (_, i) => i / 20);

test("every colour of the scale is one that a screen can show", () => {
  for (const share of shares) for (const x of rampAt(share)) assert.ok(x >= 0 && x <= 1, `${share}: ${rampCss(share)}`);
  assert.match(rampCss(0), /^rgb\(\d+ \d+ \d+\)$/);
  assert.deepEqual([rampAt(-1), rampAt(7)], [rampAt(0), rampAt(1)], "beyond its ends the scale goes on as they are");
});

for (const [name, eye] of Object.entries(eyes))
  test(`more tension is lighter, step by step, to an eye with ${name}`, () => {
    const lightness = shares.map((share) => seen(times(eye, rampAt(share)))[0]);
    for (let i = 1; i < lightness.length; ++i) {
      const step = lightness[i]! - lightness[i - 1]!;
      assert.ok(step > 0.02 && step < 0.045, `from ${shares[i - 1]} to ${shares[i]}: ${step}`);
    }
  });

test("two marks of the legend differ by more than five times what can just be told apart, to every eye", () => {
  const kJust = 0.02; // in OKLab
  for (const [name, eye] of Object.entries(eyes))
    for (let i = 0; i < 5; ++i) {
      const [a, b] = [i / 5, (i + 1) / 5].map((share) => seen(times(eye, rampAt(share)))) as [Triple, Triple];
      const apart = Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
      assert.ok(apart > 5 * kJust, `${name}, ${i}: ${apart}`);
    }
});
