// Latitude and longitude of places in the world, which is a plane that touches the ellipsoid WGS 84 at x = y = 0.

import { radians } from "../kit/units";
import type { Landmarks } from "../wire/generated";
import { writtenFigure } from "../kit/language";

/** Degrees north and east. */
export interface Position {
  latitude: number;
  longitude: number;
}

const kEquator = 6378137; // m, WGS 84's radius there
const kFlattening = 1 / 298.257223563;
const kEccentricity2 = kFlattening * (2 - kFlattening); // its square

/** The ellipsoid's radii of curvature at a latitude in degrees, m: along the meridian, and across it. */
export function radiiOfCurvature(latitude: number): { meridian: number; across: number } {
  const w = Math.sqrt(1 - kEccentricity2 * Math.sin(radians(latitude)) ** 2);
  return { meridian: (kEquator * (1 - kEccentricity2)) / w ** 3, across: kEquator / w };
}

/** Of the world's x = y = 0; undefined: the exercise lies nowhere on earth. */
export const originOf = (landmarks: Landmarks | undefined): Position | undefined =>
  landmarks?.has_position ? { latitude: landmarks.latitude_deg, longitude: landmarks.longitude_deg } : undefined;

/** Of a place in the world, m east and north of its origin. */
export function positionAt(origin: Position, x: number, y: number): Position {
  const { meridian, across } = radiiOfCurvature(origin.latitude);
  const degree = radians(1);
  const longitude = origin.longitude + x / (across * Math.cos(radians(origin.latitude)) * degree);
  return {
    latitude: origin.latitude + y / (meridian * degree),
    longitude: longitude - 360 * Math.round(longitude / 360), // across the date line
  };
}

/** As mariners write it: "50°47.123'N" and "001°06.045'W", to a thousandth of a minute, 1.9 m. */
export function positionWords({ latitude, longitude }: Position): { latitude: string; longitude: string } {
  return {
    latitude: `${degreesAndMinutes(latitude, 2)}${latitude < 0 ? "S" : "N"}`,
    longitude: `${degreesAndMinutes(longitude, 3)}${longitude < 0 ? "W" : "E"}`,
  };
}

/**
 * Where in the world a position lies that was written as mariners write it, m east and north of the origin; signs and
 * spaces may be left out: "48 00.047 N 20 00.005 W". Undefined: it is none.
 */
export function placeAt(origin: Position, written: string): { x: number; y: number } | undefined {
  const angle = String.raw`(\d{1,3})(?:\s*\u00b0\s*|\s+)(\d{1,2}(?:[.,]\d*)?)\s*['\u2032]?\s*`;
  const parts = new RegExp(String.raw`^\s*${angle}([NS])[\s,;]*${angle}([EW])\s*$`, "i").exec(written);
  if (!parts) return undefined;
  const degrees = (first: number, negative: string): number => {
    const minutes = Number(parts[first + 1]!.replace(",", "."));
    const size = minutes < 60 ? Number(parts[first]) + minutes / 60 : NaN;
    return parts[first + 2]!.toUpperCase() === negative ? -size : size;
  };
  const latitude = degrees(1, "S");
  const longitude = degrees(4, "W");
  if (!(Math.abs(latitude) <= 90 && Math.abs(longitude) <= 180)) return undefined;
  const { meridian, across } = radiiOfCurvature(origin.latitude);
  const turned = longitude - origin.longitude;
  const east = turned - 360 * Math.round(turned / 360); // across the date line
  return {
    x: radians(east) * across * Math.cos(radians(origin.latitude)),
    y: radians(latitude - origin.latitude) * meridian,
  };
}

/** Rounded before it is taken apart, so that there are never 60 minutes. */
function degreesAndMinutes(angle: number, figures: number): string {
  const thousandths = Math.round(Math.abs(angle) * 60000);
  const whole = Math.floor(thousandths / 60000);
  const minutes = (thousandths - 60000 * whole) / 1000;
  return `${String(whole).padStart(figures, "0")}\u00b0${writtenFigure(minutes.toFixed(3).padStart(6, "0"))}'`;
}
