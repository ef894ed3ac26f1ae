// Where the processor draws, pictures leave it time for other work, and one that never ends does not stop the rest.

import assert from "node:assert/strict";
import { test } from "node:test";

import { Pace } from "../../src/scene/pace";

const kLooks = 1000 / 60; // ms

/** Pictures in ten seconds, each of which takes so many ms to draw, and the longest time without one. */
function drawn(takes: number, lost = false): { pictures: number; longest: number } {
  let now = 0;
  let begun = 0;
  let last = 0;
  const gl = {
    SIGNALED: 1,
    fenceSync: () => ({}),
    flush: () => {},
    deleteSync: () => {},
    getSyncParameter: () => (!lost && now - begun >= takes ? 1 : 0),
  };
  const pace = new Pace(gl as unknown as WebGL2RenderingContext);
  let pictures = 0;
  let longest = 0;
  for (; now < 10000; now += kLooks) {
    if (!pace.due(now)) continue;
    longest = Math.max(longest, now - last);
    last = begun = now;
    ++pictures;
    pace.given(now);
  }
  return { pictures, longest };
}

for (const takes of [2, 40, 100, 300])
  test(`pictures of ${takes} ms take no more than six tenths of the time, and no less than three`, () => {
    const share = (drawn(takes).pictures * takes) / 10000;
    assert.ok(share <= 0.6, `${share}`);
    assert.ok(share >= 0.3 || takes < kLooks, `${share}`); // one that is shorter than a look is drawn at every second
  });

test("however long one takes, the next is not waited for longer than a second", () =>
  assert.ok(drawn(3000).longest < 3000 + 1000 + 3 * kLooks));

test("one that is never told to be finished is given up", () => assert.ok(drawn(0, true).pictures >= 2));
