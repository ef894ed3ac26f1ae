// Latitude and longitude of places in the world.

import assert from "node:assert/strict";
import { test } from "node:test";

import { placeAt, positionAt, positionWords, radiiOfCurvature } from "../../src/surroundings/position";

const near = (value: number, wanted: number, tolerance: number): void =>
  assert.ok(Math.abs(value - wanted) <= tolerance, `${value} is not ${wanted}`);
const words = (latitude: number, longitude: number): string[] => Object.values(positionWords({ latitude, longitude }));

test("radii of curvature are WGS 84's at equator, 45 degrees and pole", () => {
  const a = 6378137; // m
  const b = 6356752.314245; // m, of the pole
  near(radiiOfCurvature(0).meridian, (b * b) / a, 1e-3);
  near(radiiOfCurvature(0).across, a, 1e-3);
  const middle = Math.sqrt((a * a + b * b) / 2);
  near(radiiOfCurvature(45).meridian, (a * a * b * b) / middle ** 3, 1e-3);
  near(radiiOfCurvature(45).across, (a * a) / middle, 1e-3);
  near(radiiOfCurvature(90).meridian, (a * a) / b, 1e-3);
  near(radiiOfCurvature(90).across, (a * a) / b, 1e-3);
});

test("a minute of latitude is a nautical mile, within six in a thousand by latitude", () => {
  for (const latitude of [0, 20, 45, 60, 80]) {
    const minutes = 60 * (positionAt({ latitude, longitude: 0 }, 0, 1852).latitude - latitude);
    near(minutes, 1, 0.006);
  }
  near(60 * positionAt({ latitude: 0, longitude: 0 }, 0, 1842.905).latitude, 1, 1e-6);
});

test("a minute of longitude is one of latitude at the equator's radius, and half of it at 60 degrees", () => {
  near(60 * positionAt({ latitude: 0, longitude: 0 }, 1855.325, 0).longitude, 1, 1e-6);
  near(60 * positionAt({ latitude: 60, longitude: 0 }, 930.0, 0).longitude, 1, 1e-3);
});

test("north and east go up, and longitude goes on across the date line", () => {
  const there = positionAt({ latitude: -33, longitude: 179.999 }, 1000, -1000);
  assert.ok(there.latitude < -33);
  assert.ok(there.longitude < -179.98 && there.longitude > -180);
});

test("a position is written in degrees and minutes with its quarter", () => {
  assert.deepEqual(words(50 + 47.123 / 60, -(1 + 6.045 / 60)), ["50\u00b047.123'N", "001\u00b006.045'W"]);
  assert.deepEqual(words(-33.5, 151.25), ["33\u00b030.000'S", "151\u00b015.000'E"]);
  assert.deepEqual(words(0, 0), ["00\u00b000.000'N", "000\u00b000.000'E"]);
});

test("sixty minutes are the next degree", () => {
  assert.deepEqual(words(49.9999999, -0.9999999), ["50\u00b000.000'N", "001\u00b000.000'W"]);
  assert.deepEqual(words(50 + 59.9994 / 60, 9 + 59.9996 / 60), ["50\u00b059.999'N", "010\u00b000.000'E"]);
});

test("a place is found again from its position as it is written, to a thousandth of a minute", () => {
  for (const origin of [
    { latitude: 48, longitude: -20 },
    { latitude: -33, longitude: 179.999 },
  ]) {
    const { latitude, longitude } = positionWords(positionAt(origin, -1234, 567));
    const place = placeAt(origin, `${latitude} ${longitude}`)!;
    near(place.x, -1234, 1);
    near(place.y, 567, 1);
  }
});

test("a position may be written without signs, and what is none is refused", () => {
  const origin = { latitude: 48, longitude: -20 };
  const place = placeAt(origin, "48 00.047 n, 20 00,005 w")!;
  near(place.x, -6.2, 0.1);
  near(place.y, 87.1, 0.1);
  for (const none of ["", "48 N 20 W", "48 60.0 N 20 00.0 W", "95 00.0 N 20 00.0 W", "48 00.0 N", "6 shackles"])
    assert.equal(placeAt(origin, none), undefined, none);
});
