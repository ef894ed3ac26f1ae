// Colours of loads, for instructors, and the scale that explains them.

import { CanvasTexture, type Color, Mesh, MeshBasicMaterial, PlaneGeometry, SRGBColorSpace } from "three";
import { figure, loads } from "../kit/units";

/** Share of the breaking load at the scale's end: what a windlass's brake holds, and more. */
export const kScaleEnd = 0.5;

const kStops: readonly (readonly [number, number, number, number])[] = [
  [0, 0.35, 0.68, 0.95],
  [0.1, 0.2, 0.75, 0.6],
  [0.2, 0.35, 0.7, 0.2],
  [0.3, 0.92, 0.78, 0.12],
  [0.4, 0.9, 0.4, 0.08],
  [0.5, 0.8, 0.06, 0.06],
];

/** share: of the breaking load. */
export function loadColour(share: number, out: Color): Color {
  let i = 1;
  while (i < kStops.length - 1 && share > kStops[i]![0]) ++i;
  const [s0, r0, g0, b0] = kStops[i - 1]!;
  const [s1, r1, g1, b1] = kStops[i]!;
  const t = Math.min(1, Math.max(0, (share - s0) / (s1 - s0)));
  return out.setRGB(r0 + t * (r1 - r0), g0 + t * (g1 - g0), b0 + t * (b1 - b0), "srgb");
}

export const kLegendWidth = 300;
export const kLegendHeight = 64;

/** A legend for the picture's corner, one pixel a unit. breaking: N. */
export function legend(breaking: number): Mesh<PlaneGeometry, MeshBasicMaterial> {
  const canvas = document.createElement("canvas");
  canvas.width = 2 * kLegendWidth;
  canvas.height = 2 * kLegendHeight;
  const g = canvas.getContext("2d")!;
  g.scale(2, 2);
  g.fillStyle = "rgba(16, 22, 26, 0.72)";
  g.fillRect(0, 0, kLegendWidth, kLegendHeight);
  const gradient = g.createLinearGradient(16, 0, kLegendWidth - 16, 0);
  for (const [share, r, gr, b] of kStops)
    gradient.addColorStop(share / kScaleEnd, `rgb(${255 * r},${255 * gr},${255 * b})`);
  g.fillStyle = gradient;
  g.fillRect(16, 24, kLegendWidth - 32, 14);
  g.fillStyle = "#fff";
  g.font = "12px 'Noto Sans', sans-serif";
  g.textBaseline = "top";
  g.fillText("Tension of the cable", 16, 6);
  g.textAlign = "center";
  for (const share of [0, 0.1, 0.2, 0.3, 0.4, 0.5]) {
    const x = 16 + (share / kScaleEnd) * (kLegendWidth - 32);
    g.fillRect(x - 0.5, 38, 1, 4);
    const force = figure(loads.of(share * breaking));
    g.fillText(share === 0.5 ? `${force} ${loads.unit.written}` : force, Math.min(x, kLegendWidth - 22), 45);
  }
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  return new Mesh(
    new PlaneGeometry(kLegendWidth, kLegendHeight),
    new MeshBasicMaterial({ map: texture, transparent: true, depthTest: false, toneMapped: false, fog: false }),
  );
}
