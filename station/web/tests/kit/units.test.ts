// Figures as the trade reads them.

import assert from "node:assert/strict";
import { readFile, readdir } from "node:fs/promises";
import { join } from "node:path";
import { test } from "node:test";

import * as units from "../../src/kit/units";
import { root } from "../../tools/web.mjs";

const near = (value: number, wanted: number): void =>
  assert.ok(Math.abs(value - wanted) <= 1e-9 * Math.abs(wanted), `${value} is not ${wanted}`);

test("SI becomes knots, degrees, shackles and degrees Celsius", () => {
  near(units.knots(1852), 3600);
  near(units.degrees(Math.PI), 180);
  near(units.radians(90), Math.PI / 2);
  near(units.shackles(55), 2);
  near(units.celsius(373.15), 100);
});

test("shackles have two decimals at most and no minus before a zero, a lead is told in half hours", () => {
  const metres = [191.8, 110, -0.04, 82.5];
  assert.deepEqual(metres.map(units.shacklesFigure), ["6.97", "4", "0", "3"]);
  assert.deepEqual([11.7, 11.8, 0.1, 0.6, 6].map(units.clockHour), ["11.5", "12", "12", "12.5", "6"]);
  assert.equal(units.clockHour(NaN), "-");
});

test("a half is written as one", () => {
  assert.deepEqual([0, 0.5, 1, 1.5, 12].map(units.inHalves), ["0", "\u00bd", "1", "1\u00bd", "12"]);
});

test("a bearing has three figures, and 360 is 000", () => {
  const of = (angle: number): string => units.bearing(units.radians(angle));
  assert.deepEqual([7, 359.6, 360, -10, 725].map(of), ["007", "000", "000", "350", "005"]);
});

test("a bearing to a tenth has three figures before it, and 359.96 is 000.0", () => {
  const of = (angle: number): string => units.bearingToTenth(units.radians(angle));
  assert.deepEqual([7.24, 12.3, 359.96, 360, -10, 725.5].map(of), [
    "007.2",
    "012.3",
    "000.0",
    "000.0",
    "350.0",
    "005.5",
  ]);
});

test("a clock has hours where there are some, and nothing before 0", () => {
  assert.deepEqual([0, 59.9, 452, 4052, -3].map(units.clock), ["0:00", "0:59", "7:32", "1:07:32", "0:00"]);
});

test("a time of day goes round at midnight", () => {
  assert.deepEqual([0, 23400, 86399, 90000].map(units.timeOfDay), ["00:00", "06:30", "23:59", "01:00"]);
});

test("a figure has a true minus, none before a nought, and a dash for what is no number", () => {
  assert.equal(units.figure(-1.25, 1), "\u22121.3");
  assert.equal(units.figure(-0.04, 1), "0.0");
  assert.equal(units.figure(NaN), "-");
  assert.equal(units.figure(Infinity, 2), "-");
  assert.equal(units.figure(12.5, 2), "12.50");
});

test("a load is read in tonnes, with a tenth below 10 t, or in kilonewtons", () => {
  const { loads } = units;
  const [tonne, kilonewton] = loads.options;
  assert.deepEqual(
    [0, 4.64, 9.94, 9.96, 120].map((t) => loads.text(t * units.kTonne)),
    ["0.0 t", "4.6 t", "9.9 t", "10 t", "120 t"],
  );
  loads.choose(kilonewton!);
  assert.deepEqual(
    [45501, 1e6].map((n) => loads.text(n)),
    ["46 kN", "1000 kN"],
  );
  loads.next();
  assert.equal(loads.unit, tonne, "the one after the last is the first");
});

test("the cable's speed is read in metres a minute, knots or metres a second, and all that show it are told", () => {
  const { cableSpeeds } = units;
  const seen = cableSpeeds.options.map((unit) => (cableSpeeds.choose(unit), cableSpeeds.text(5.5)));
  assert.deepEqual(seen, ["330 m/min", "10.7 kn", "5.50 m/s"]);
  let told = 0;
  cableSpeeds.onChoice(() => ++told);
  cableSpeeds.choose(cableSpeeds.unit);
  assert.equal(told, 0, "nothing was changed");
  cableSpeeds.next();
  assert.deepEqual([told, cableSpeeds.text(5.5)], [1, "330 m/min"]);
  assert.equal(cableSpeeds.text(NaN), "- m/min");
});

test("a scale is divided into three to five steps that can be read between", () => {
  const steps = (end: number): number => end / units.scaleStep(end);
  for (const value of [0.7, 1, 1.4, 2, 2.2, 3, 4, 5, 6, 7, 9, 10, 30, 100, 150, 300, 980, 4000]) {
    const end = units.scaleEnd(value);
    assert.ok(end >= value && end <= 2 * value, `${value}: ${end}`);
    const whole = Math.round(steps(end));
    assert.ok(Math.abs(steps(end) - whole) < 1e-9 && whole >= 3 && whole <= 5, `${end}: ${steps(end)}`);
  }
  assert.deepEqual([10, 30, 100, 300].map(units.scaleStep), [2, 10, 20, 100]);
});

test("what is chosen is kept, and a page that is opened later has it", () => {
  const store = new Map<string, string>();
  const before = Object.getOwnPropertyDescriptor(globalThis, "localStorage");
  Object.defineProperty(globalThis, "localStorage", {
    configurable: true,
    value: {
      getItem: (key: string) => store.get(key) ?? null,
      setItem: (key: string, to: string) => store.set(key, to),
    },
  });
  try {
    const measure = (): units.Measure => new units.Measure("load", units.loads.options, () => 0);
    const [tonne, kilonewton] = units.loads.options;
    assert.equal(measure().unit, tonne);
    measure().choose(kilonewton!);
    assert.equal(measure().unit, kilonewton);
    for (const key of store.keys()) store.set(key, "furlong");
    assert.equal(measure().unit, tonne, "the usual one for what was never an option");
  } finally {
    if (before) Object.defineProperty(globalThis, "localStorage", before);
    else Reflect.deleteProperty(globalThis, "localStorage");
  }
});

test("no page has a unit or a limit of its own beside words.json's", async () => {
  const folder = join(root, "station/web/src");
  const own = /(?<![\d.])(27\.5|9\.80665|9806\.65|1852|0\.5144\d*|333\.15|423\.15|523\.15|673\.15)(?!\d)/;
  const found: string[] = [];
  for (const file of await readdir(folder, { recursive: true })) {
    if (!file.endsWith(".ts")) continue;
    const code = (await readFile(join(folder, file), "utf8")).replace(/\/\/.*|\/\*[^]*?\*\//g, "");
    if (own.test(code)) found.push(`${file}: ${own.exec(code)![1]}`);
  }
  assert.deepEqual(found, []);
});

test("sides have names", () => {
  assert.deepEqual([0, 1, 2].map(units.sideName), ["port", "starboard", "both"]);
});
