// The past that the plots draw, without a browser.

import assert from "node:assert/strict";
import { join } from "node:path";
import { before, test } from "node:test";

import { found, need, web } from "./browser.mjs";

let History;

before(async () => {
  const { outputFiles } = await need("esbuild").build({
    ...found,
    entryPoints: [join(web, "src/plots/history.ts")],
    bundle: true,
    write: false,
    format: "esm",
  });
  ({ History } = await import(`data:text/javascript,${encodeURIComponent(outputFiles[0].text)}`));
});

const kInterval = 0.05; // s
/** A history of one figure, of(time), from begin to end. */
function filled(of, begin, end, span = 7200) {
  const history = new History(1, kInterval, span);
  for (let i = 0; begin + i * kInterval <= end + 1e-9; ++i)
    history.add(begin + i * kInterval, () => of(begin + i * kInterval));
  return history;
}
const known = (values) => values.filter((v) => v !== null);

test("samples that come faster than the interval are left out", () => {
  const history = new History(1, kInterval, 10);
  for (let i = 0; i <= 100; ++i) history.add(i / 100, () => i); // 1 s at 100 Hz
  assert.equal(history.length, 21);
  assert.equal(history.at(0, 0.5), 50);
});

test("a short window has every sample as it was, and one on either side so that lines reach its edges", () => {
  const { times, series } = filled((t) => t * t, 0, 10).window(2, 3, 400, [0]);
  assert.ok(times[0] <= 2 && times.at(-1) >= 3);
  times.forEach((t, i) => assert.equal(series[0][i], Math.fround(t * t)));
});

test("a thinned window loses no peak: its extremes are those of all samples", () => {
  const spike = (t) =>
    Math.abs(t - 1234.5) < kInterval / 2 ? 900 : Math.abs(t - 2345.6) < kInterval / 2 ? -50 : Math.sin(t / 40);
  const { times, series } = filled(spike, 0, 3600).window(0, 3600, 400, [0]);
  assert.ok(times.length <= 2 * 402, `${times.length} points`);
  assert.equal(Math.max(...known(series[0])), 900);
  assert.equal(Math.min(...known(series[0])), -50);
});

test("a thinned window shows least and largest in the order in which they came", () => {
  const { series } = filled((t) => -t, 0, 100).window(0, 100, 10, [0]);
  for (let i = 1; i < series[0].length; ++i) assert.ok(series[0][i] <= series[0][i - 1]);
});

test("stretches lie where they lay when the window moves on", () => {
  const history = filled((t) => Math.sin(t), 0, 700);
  const inside = (w) => w.times.map((t, i) => [t, w.series[0][i]]).filter(([t]) => t > 150 && t < 550);
  assert.deepEqual(inside(history.window(100, 600, 100, [0])), inside(history.window(103, 603, 100, [0])));
});

test("only the series that are asked for come, in that order", () => {
  const history = new History(3, kInterval, 10);
  history.add(0, (s) => 10 * s);
  assert.deepEqual(history.window(0, 1, 10, [2, 0]).series, [[20], [0]]);
});

test("when time goes back, what came after has not happened", () => {
  const history = filled((t) => t, 0, 100);
  history.add(40, () => -1);
  assert.equal(history.end, 40);
  assert.equal(history.at(0, 40), -1);
  assert.equal(history.at(0, 90), -1, "nothing is left of 90 s");
  assert.equal(history.window(0, 100, 400, [0]).times.at(-1), 40);
});

test("a pause without samples is a gap, a rate below the interval is none", () => {
  const history = filled((t) => t, 0, 5);
  for (let t = 20; t < 25; t += 1 / 3) history.add(t, () => t); // 20 exercise seconds a second at 60 Hz
  const { times, series } = history.window(0, 30, 30, [0]);
  const gaps = series[0].flatMap((v, i) => (v === null ? [times[i]] : []));
  assert.equal(gaps.length, 1);
  assert.ok(gaps[0] > 5 && gaps[0] < 20);
});

test("what is not known is no figure and spoils no extreme", () => {
  const history = filled((t) => (t < 5 ? NaN : t), 0, 10);
  const { times, series } = history.window(0, 10, 10, [0]);
  times.forEach((t, i) => assert.equal(series[0][i] === null, t < 5, `${t}: ${series[0][i]}`));
});

test("the span is kept and no more", () => {
  const history = filled((t) => t, 0, 100, 30);
  assert.ok(Math.abs(history.end - 100) < 1e-6);
  assert.ok(Math.abs(history.begin - 70) < 2 * kInterval);
  assert.ok(Number.isNaN(history.at(0, 60)));
});
