// Colours of the plan: sea and land by palette, as charts have them, the rest of OpenBridge's palette.

import { type Palette, colour, palette } from "../kit/palette";
import type { Paint } from "../surroundings/buoyage";

export interface PlanColours {
  sea: string;
  land: string;
  contour: string;
  /** Of buoys. */
  paints: Record<Paint, string>;
  light: string;
  grid: string;
  text: string;
  quiet: string;
  ship: string;
  shipFill: string;
  track: string;
  cable: string;
  anchor: string;
  measure: string;
  wind: string;
  stream: string;
  watch: string;
  left: string;
}

const seas: Record<Palette, string> = {
  bright: "#eef6fb",
  day: "#dfedf5",
  dusk: "#14222b",
  night: "#020507",
};

const lands: Record<Palette, string> = {
  bright: "#f0e3b4",
  day: "#e2d3a0",
  dusk: "#3a3524",
  night: "#14120a",
};

const contours: Record<Palette, string> = {
  bright: "#6f9bb5",
  day: "#6a93ac",
  dusk: "#44657a",
  night: "#35505f",
};

const byDay = { red: "#d3222f", green: "#178a43", yellow: "#f2c300", black: "#161616", white: "#ffffff" };

const paints: Record<Palette, Record<Paint, string>> = {
  bright: byDay,
  day: byDay,
  dusk: { red: "#c0333b", green: "#2f8f55", yellow: "#c9a41f", black: "#05080a", white: "#d5d5d5" },
  night: { red: "#7a2026", green: "#1d5a35", yellow: "#6f5c14", black: "#000000", white: "#6e6e6e" },
};

/** Those of the palette that is shown now. */
export function planColours(): PlanColours {
  return {
    sea: seas[palette()],
    land: lands[palette()],
    contour: contours[palette()],
    paints: paints[palette()],
    light: colour("data-categorical-qualitative-06"),
    grid: colour("instrument-tick-mark-tertiary-color"),
    text: colour("element-active-color"),
    quiet: colour("element-neutral-color"),
    ship: colour("element-active-color"),
    shipFill: colour("instrument-regular-tertiary-color"),
    track: colour("element-inactive-color"),
    cable: colour("instrument-regular-secondary-color"),
    anchor: colour("data-categorical-qualitative-08"),
    measure: colour("instrument-enhanced-secondary-color"),
    wind: colour("data-categorical-qualitative-01"),
    stream: colour("data-categorical-qualitative-03"),
    watch: colour("running-enabled-border-color"),
    left: colour("alert-warning-color"), // as the server's alert "watch.circle"
  };
}
