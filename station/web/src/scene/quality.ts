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
  /** Clouds of spray a second, at most, that come over the bow. */
  spray: number;
}

export type QualityName = "software" | "low" | "high";

export const kQuality: Record<QualityName, Quality> = {
  software: {
    antialias: false,
    pixelRatioMax: 1,
    linksFull: 40,
    sea: "plain",
    shadows: false,
    particles: true,
    spray: 12,
  },
  low: { antialias: false, pixelRatioMax: 1, linksFull: 80, sea: "plain", shadows: false, particles: true, spray: 30 },
  high: { antialias: true, pixelRatioMax: 2, linksFull: 160, sea: "full", shadows: true, particles: true, spray: 120 },
};

/** By the name that the graphics driver gives itself. */
export function qualityOf(gl: WebGL2RenderingContext | WebGLRenderingContext): QualityName {
  const info = gl.getExtension("WEBGL_debug_renderer_info");
  const name = `${gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER)}`;
  return /llvmpipe|swiftshader|softpipe|software|basic render/i.test(name) ? "software" : "high";
}

const kSlow = 1000 / 21; // ms of a frame, slower than which less is drawn
const kFrames = 60; // frames that it has to be so
const kEasy = 1000 / 28; // ms of a frame, quicker than which more may be tried
const kCalm = 20000; // ms that it has to be so
const kHiccup = 2000; // ms of it that one slower frame costs
const kProof = 60000; // ms in which a rise shows whether the machine bears it
const kCalmMax = 600000; // ms, at most, after rises that it did not bear
const kHidden = 500; // ms of a frame: the page was hidden

interface Level {
  name: QualityName;
  /** Of the preset's pixels, each way. */
  scale: number;
}

/**
 * Falls from high to low, then to fewer pixels, where frames take too long, and rises again step by step after a calm
 * time. A rise that the machine does not bear doubles the time to the next: the picture is steady.
 */
export class QualityWatch {
  private readonly levels: readonly Level[];
  private level = 0;
  private slow = 0; // frames
  private calm = 0; // ms
  private wait = kCalm; // ms of calm before the next rise
  private sinceRise = Infinity; // ms

  /** start: the best that the machine is given. */
  constructor(start: QualityName) {
    const less = start === "high" ? "low" : start;
    this.levels = [
      { name: start, scale: 1 },
      ...(start === less ? [0.8, 0.64] : [1, 0.8, 0.64]).map((scale) => ({ name: less, scale })),
    ];
  }

  /** Of the preset's pixels, each way. */
  get scale(): number {
    return this.levels[this.level]!.scale;
  }

  /** After a frame of so many ms since the last: the preset to go on with. */
  after(ms: number): QualityName {
    if (ms <= kHidden) {
      this.slow = ms > kSlow ? this.slow + 1 : Math.max(0, this.slow - 2);
      this.calm = ms < kEasy ? this.calm + ms : Math.max(0, this.calm - kHiccup);
      this.sinceRise += ms;
      if (this.slow > kFrames) this.fall();
      else if (this.level > 0 && this.calm >= this.wait) this.rise();
    }
    return this.levels[this.level]!.name;
  }

  private fall(): void {
    this.slow = this.calm = 0;
    this.wait = this.sinceRise < kProof ? Math.min(2 * this.wait, kCalmMax) : kCalm;
    this.sinceRise = Infinity;
    this.level = Math.min(this.level + 1, this.levels.length - 1);
  }

  private rise(): void {
    this.calm = this.sinceRise = 0;
    --this.level;
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
