// Day, dusk, night: OpenBridge's palettes. The exercise's time of day proposes one, the user disposes.

import { t } from "./language";

export const palettes = ["bright", "day", "dusk", "night"] as const;
export type Palette = (typeof palettes)[number];

const kChosen = "windlass.palette";
const listeners = new Set<(palette: Palette) => void>();

export function palette(): Palette {
  return (document.documentElement.dataset.obcTheme as Palette | undefined) ?? "day";
}

function show(next: Palette): void {
  if (palette() === next && document.documentElement.dataset.obcTheme) return;
  document.documentElement.dataset.obcTheme = next;
  colours.clear();
  for (const listener of listeners) listener(next);
}

/** How the palette that is shown is called. */
export const paletteWord = (): string =>
  ({ bright: t("bright"), day: t("day"), dusk: t("dusk"), night: t("night") })[palette()];
export const paletteLabel = (): string => t("palette: {palette}", { palette: paletteWord() });

/** To the next of them, by the user. */
export const nextPalette = (): void => choosePalette(palettes[(palettes.indexOf(palette()) + 1) % palettes.length]!);

/** By the user, kept in this browser. */
export function choosePalette(next: Palette): void {
  try {
    localStorage.setItem(kChosen, next);
  } catch {
    // a browser that keeps nothing shows it all the same
  }
  show(next);
}

/** By the exercise's time of day, s since midnight, unless the user has chosen. */
export function proposePalette(time: number): void {
  const hour = time / 3600;
  const proposed: Palette = hour < 5 || hour >= 21 ? "night" : hour < 7 || hour >= 19 ? "dusk" : "day";
  show(chosen() ?? proposed);
}

function chosen(): Palette | undefined {
  try {
    const kept = localStorage.getItem(kChosen);
    return palettes.find((p) => p === kept);
  } catch {
    return undefined;
  }
}

/** Canvases and plots do not follow the style sheet: they draw anew when it changes. */
export function onPalette(listener: (palette: Palette) => void): void {
  listeners.add(listener);
}

const colours = new Map<string, string>(); // of the palette that is shown: asking the style sheet costs a layout's time

/** The value of a colour of the palette that is shown, e.g. colour("element-active-color"). */
export function colour(name: string): string {
  const known = colours.get(name);
  if (known) return known;
  const value = getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
  colours.set(name, value);
  return value;
}

show(chosen() ?? "day");
