// The echo sounder's trace: depth below the keel over the last ten minutes, the bottom filled.

import { h, setAttribute } from "../kit/dom";
import { colour, onPalette } from "../kit/palette";
import { figure } from "../kit/units";
import { t } from "../kit/language";

const kSpan = 600; // s
const kApart = 1; // s between two soundings that are kept

export class DepthTrace {
  readonly element = h("canvas", { class: "depth-trace", role: "img" });
  /** time (s), depth (m; NaN: none) one behind the other. */
  private readonly trace: number[] = [];
  private due = false;

  constructor() {
    onPalette(() => this.draw());
    new ResizeObserver(() => this.draw()).observe(this.element);
  }

  /** time: s; depth: m below the keel, undefined where there is no echo. */
  add(time: number, depth: number | undefined): void {
    const last = this.trace.at(-2);
    while (this.trace.length > 0 && this.trace.at(-2)! > time) this.trace.length -= 2; // a restore: it has not happened
    if (last !== undefined && time >= last && time < last + kApart) return;
    this.trace.push(time, depth ?? NaN);
    while (this.trace[0]! < time - kSpan) this.trace.splice(0, 2);
    this.later();
  }

  /** At most once a frame: the past comes all at once. */
  private later(): void {
    if (this.due) return;
    this.due = true;
    requestAnimationFrame(() => {
      this.due = false;
      this.draw();
    });
  }

  private draw(): void {
    const { clientWidth: width, clientHeight: height } = this.element;
    const c = this.element.getContext("2d");
    if (!c || !width || !height) return;
    this.element.width = Math.round(width * devicePixelRatio);
    this.element.height = Math.round(height * devicePixelRatio);
    c.scale(devicePixelRatio, devicePixelRatio);
    const depths = this.trace.filter((_, k) => k % 2 === 1).filter(Number.isFinite);
    const deepest = Math.max(...depths, 1);
    const range = [5, 10, 20, 50, 100, 200, 500, 1000].find((r) => r > deepest * 1.1) ?? 2000;
    const now = this.trace.at(-2) ?? 0;
    const x = (time: number): number => width - 30 - ((now - time) / kSpan) * (width - 30);
    const y = (depth: number): number => 4 + (depth / range) * (height - 8);
    c.fillStyle = colour("instrument-regular-tertiary-color");
    c.strokeStyle = colour("instrument-enhanced-secondary-color");
    c.lineWidth = 2;
    // Pieces between losses of the echo.
    for (let k = 0; k < this.trace.length;) {
      let end = k;
      while (end < this.trace.length && Number.isFinite(this.trace[end + 1]!)) end += 2;
      if (end > k) {
        const line = new Path2D();
        for (let i = k; i < end; i += 2) line.lineTo(x(this.trace[i]!), y(this.trace[i + 1]!));
        const ground = new Path2D(line);
        ground.lineTo(x(this.trace[end - 2]!), height);
        ground.lineTo(x(this.trace[k]!), height);
        c.fill(ground);
        c.stroke(line);
      }
      k = end + 2;
    }
    c.fillStyle = colour("element-neutral-color");
    c.font = `11px "Noto Sans", sans-serif`;
    c.textAlign = "right";
    c.fillText("0", width - 2, 11);
    c.fillText(`${range} m`, width - 2, height - 4);
    c.textAlign = "left";
    c.fillText("10 min", 2, height - 4);
    setAttribute(
      this.element,
      "aria-label",
      depths.length
        ? t("depth below keel over ten minutes, {least} to {most} m", {
            least: figure(Math.min(...depths), 1),
            most: figure(deepest, 1),
          })
        : t("depth below keel: no trace"),
    );
  }
}
