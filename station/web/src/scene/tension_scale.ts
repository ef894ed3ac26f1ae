// Colours of the cable's tension, for instructors, and the scale that explains them. As that of the load's dial it
// follows the moment: on a scale of the brake's rating a cable that grows from 3 to 5 t would keep one colour.

import {
  CanvasTexture,
  type Color,
  LinearSRGBColorSpace,
  Mesh,
  MeshBasicMaterial,
  PlaneGeometry,
  SRGBColorSpace,
} from "three";
import { LoadScale, loadScales } from "../kit/load_scale";
import { figure, kTonne, loads, scaleEnd, scaleStep, unitWritten } from "../kit/units";
import { rampAt, rampCss } from "./colour_ramp";
import type { SceneFrame } from "./frame";
import { t } from "../kit/language";

/** Share of the breaking load at the end of the widest scale: what a windlass's brake holds, and more. */
const kWidest = 0.5;
const kSmallest = 10 * kTonne; // N: a chain that hangs in 25 m pulls some 3 t
const kStops = 16; // of the gradient that is drawn

export const kLegendWidth = 300;
export const kLegendHeight = 64;
const kMargin = 16;
const kBar = kLegendWidth - 2 * kMargin;

/** The largest tension of all cables, N; undefined: no tension is known. */
function largest(frame: SceneFrame): number | undefined {
  let most: number | undefined;
  for (const tackle of frame.tackle)
    for (const tension of tackle?.tension ?? []) most = Math.max(most ?? tension, tension);
  return most;
}

export class TensionScale {
  /** For the picture's corner, one pixel a unit. */
  readonly legend: Mesh<PlaneGeometry, MeshBasicMaterial>;
  private readonly canvas = document.createElement("canvas");
  private readonly texture: CanvasTexture;
  private scale = new LoadScale();
  private end = 0; // in the unit that is chosen, as the legend has it
  private unit = loads.unit;

  /** breaking: N, of a cable. */
  constructor(private readonly breaking: number) {
    this.canvas.width = 2 * kLegendWidth;
    this.canvas.height = 2 * kLegendHeight;
    this.texture = new CanvasTexture(this.canvas);
    this.texture.colorSpace = SRGBColorSpace;
    this.legend = new Mesh(
      new PlaneGeometry(kLegendWidth, kLegendHeight),
      new MeshBasicMaterial({ map: this.texture, transparent: true, depthTest: false, toneMapped: false, fog: false }),
    );
    this.show(this.ends()[0]!);
  }

  /** Takes the scale for what is drawn. now: ms. */
  follow(frame: SceneFrame, now: number): void {
    if (loads.unit !== this.unit) {
      this.unit = loads.unit;
      this.scale = new LoadScale();
    }
    const most = largest(frame);
    if (most !== undefined) this.show(this.scale.at(loads.of(most), this.ends(), now));
  }

  /** tension: N. */
  colour(tension: number, out: Color): Color {
    const [r, g, b] = rampAt(loads.of(tension) / this.end);
    return out.setRGB(r, g, b, LinearSRGBColorSpace);
  }

  dispose(): void {
    this.legend.geometry.dispose();
    this.legend.material.dispose();
    this.texture.dispose();
  }

  /** In the unit that is chosen. */
  private ends(): number[] {
    return loadScales(scaleEnd(loads.of(kWidest * this.breaking)), scaleEnd(loads.of(kSmallest)));
  }

  private show(end: number): void {
    const words = t("Tension of the cable, scale to {end} {unit}", { end, unit: unitWritten(this.unit) });
    if (this.legend.name === words) return;
    this.legend.name = words;
    this.end = end;
    const g = this.canvas.getContext("2d")!;
    g.setTransform(2, 0, 0, 2, 0, 0);
    g.clearRect(0, 0, kLegendWidth, kLegendHeight);
    g.fillStyle = "rgba(16, 22, 26, 0.72)";
    g.fillRect(0, 0, kLegendWidth, kLegendHeight);
    const gradient = g.createLinearGradient(kMargin, 0, kMargin + kBar, 0);
    for (let i = 0; i <= kStops; ++i) gradient.addColorStop(i / kStops, rampCss(i / kStops));
    g.fillStyle = gradient;
    g.fillRect(kMargin, 24, kBar, 14);
    g.fillStyle = "#fff";
    g.font = "12px 'Noto Sans', sans-serif";
    g.textBaseline = "top";
    g.textAlign = "left";
    g.fillText(words, kMargin, 6);
    g.textAlign = "center";
    const step = scaleStep(end);
    for (let value = 0; value <= end; value += step) {
      const x = kMargin + (value / end) * kBar;
      g.fillRect(x - 0.5, 38, 1, 4);
      g.fillText(figure(value), x, 45);
    }
    this.texture.needsUpdate = true;
  }
}
