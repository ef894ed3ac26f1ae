// How much is drawn: presets, and which of them a machine is given.

export interface Quality {
  antialias: boolean;
  /** Of the canvas against CSS pixels, at most. */
  pixelRatioMax: number;
  /** Links of a cable drawn in full, nearest first. */
  linksFull: number;
  sea: "flat" | "plain" | "full";
  shadows: boolean;
  particles: boolean;
}

export type QualityName = "software" | "low" | "high";

export const kQuality: Record<QualityName, Quality> = {
  software: { antialias: false, pixelRatioMax: 1, linksFull: 40, sea: "plain", shadows: false, particles: true },
  low: { antialias: false, pixelRatioMax: 1, linksFull: 80, sea: "plain", shadows: false, particles: true },
  high: { antialias: true, pixelRatioMax: 2, linksFull: 160, sea: "full", shadows: true, particles: true },
};

/** By the name that the graphics driver gives itself. */
export function qualityOf(gl: WebGL2RenderingContext | WebGLRenderingContext): QualityName {
  const info = gl.getExtension("WEBGL_debug_renderer_info");
  const name = `${gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER)}`;
  return /llvmpipe|swiftshader|softpipe|software|basic render/i.test(name) ? "software" : "high";
}

const kSlow = 1000 / 21; // ms of a frame, slower than which less is drawn
const kFrames = 60; // frames that it has to be so
const kScales = [1, 0.8, 0.64];

/**
 * Falls from high to low, then to fewer pixels, where frames take too long. It does not rise again, so that the
 * picture is steady.
 */
export class QualityWatch {
  private slow = 0;
  private step = 0;

  constructor(private name: QualityName) {}

  /** Of the preset's pixels, each way. */
  get scale(): number {
    return kScales[this.step]!;
  }

  /** After a frame of so many ms since the last: the preset to go on with. */
  after(ms: number): QualityName {
    if (ms > 500) return this.name; // the page was hidden
    this.slow = ms > kSlow ? this.slow + 1 : Math.max(0, this.slow - 2);
    if (this.slow <= kFrames) return this.name;
    this.slow = 0;
    if (this.name === "high") this.name = "low";
    else this.step = Math.min(this.step + 1, kScales.length - 1);
    return this.name;
  }
}

/** ms a frame, smoothed, and frames a second. */
export class FrameClock {
  frameMs = 0;
  interval = 0;
  private last = 0;

  /** Between two draws; now: ms. */
  tick(now: number): number {
    const since = this.last > 0 ? now - this.last : 0;
    this.last = now;
    if (since > 0 && since < 500) this.interval = this.interval > 0 ? 0.9 * this.interval + 0.1 * since : since;
    return since;
  }
  took(ms: number): void {
    this.frameMs = this.frameMs > 0 ? 0.9 * this.frameMs + 0.1 * ms : ms;
  }
  get fps(): number {
    return this.interval > 0 ? 1000 / this.interval : 0;
  }
}
