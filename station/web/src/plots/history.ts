// The recent past of many figures, sampled evenly in exercise time, for plots: a ring of samples, and windows of it
// thinned so that no peak is lost. Pure: no page, no clock.

/** A piece of the past, ready to draw. */
export interface Window {
  /** s of exercise time, rising; all series share them. */
  times: number[];
  /** One for each series that was asked for, as long as times; null where nothing was known. */
  series: (number | null)[][];
}

export class History {
  private readonly times: Float64Array;
  private readonly values: Float32Array[];
  private first = 0; // place in the ring of the oldest sample
  private count = 0;

  /** series: how many figures; interval: s between samples at least; span: s that are kept at that interval. */
  constructor(
    readonly series: number,
    readonly interval: number,
    span: number,
  ) {
    const size = Math.max(2, Math.ceil(span / interval) + 1);
    this.times = new Float64Array(size);
    this.values = Array.from({ length: series }, () => new Float32Array(size).fill(NaN));
  }

  get length(): number {
    return this.count;
  }
  /** s, of the oldest sample; NaN when there is none. */
  get begin(): number {
    return this.count ? this.timeOf(0) : NaN;
  }
  /** s, of the newest. */
  get end(): number {
    return this.count ? this.timeOf(this.count - 1) : NaN;
  }

  clear(): void {
    this.count = this.first = 0;
  }

  /** Whether a sample at that time would be kept: it is an interval on, or time went back. */
  due(time: number): boolean {
    const tolerance = 1e-6; // s, of exercise time that is a whole number of steps
    return this.count === 0 || time < this.end - tolerance || time >= this.end + this.interval - tolerance;
  }

  /**
   * Takes a sample if it is due. When time went back (a restore, a seek), what lay at or after it is dropped: it has
   * not happened. read(i) gives the figure of series i.
   */
  add(time: number, read: (series: number) => number): boolean {
    if (!Number.isFinite(time) || !this.due(time)) return false;
    while (this.count > 0 && this.end >= time) --this.count;
    const size = this.times.length;
    const at = (this.first + this.count) % size;
    if (this.count === size) this.first = (this.first + 1) % size;
    else ++this.count;
    this.times[at] = time;
    for (let s = 0; s < this.series; ++s) this.values[s]![at] = read(s);
    return true;
  }

  /** The figure of a series at the newest sample up to a time; NaN before the first. */
  at(series: number, time: number): number {
    const i = this.after(time) - 1;
    return i < 0 ? NaN : this.valueOf(series, i);
  }

  /**
   * What lies from `from` to `to`, in at most about `buckets` stretches of equal length, each drawn by its least and
   * its largest value in the order in which they came; whole as it is where there are fewer samples. Stretches lie at
   * multiples of their length, so that a window that moves on does not shimmer. A pause without samples is a gap.
   * which: numbers of the series.
   */
  window(from: number, to: number, buckets: number, which: readonly number[]): Window {
    const begin = Math.max(0, this.after(from) - 1); // one before, so that the line comes in from the edge
    const end = Math.min(this.count, this.after(to) + 1);
    const width = (to - from) / Math.max(1, buckets);
    return width <= 2 * this.interval ? this.whole(begin, end, which) : this.thinned(begin, end, width, which);
  }

  private whole(begin: number, end: number, which: readonly number[]): Window {
    const times: number[] = [];
    const series: (number | null)[][] = which.map(() => []);
    for (let i = begin; i < end; ++i) {
      if (i > begin && this.isGap(this.timeOf(i - 1), this.timeOf(i), this.interval))
        this.breakAt((this.timeOf(i - 1) + this.timeOf(i)) / 2, times, series);
      times.push(this.timeOf(i));
      which.forEach((s, k) => series[k]!.push(known(this.valueOf(s, i))));
    }
    return { times, series };
  }

  private thinned(begin: number, end: number, width: number, which: readonly number[]): Window {
    const times: number[] = [];
    const series: (number | null)[][] = which.map(() => []);
    let i = begin;
    while (i < end) {
      const bucket = Math.floor(this.timeOf(i) / width);
      let next = i + 1;
      while (next < end && Math.floor(this.timeOf(next) / width) === bucket) ++next;
      if (i > begin && this.isGap(this.timeOf(i - 1), this.timeOf(i), width))
        this.breakAt((this.timeOf(i - 1) + this.timeOf(i)) / 2, times, series);
      times.push(this.timeOf(i));
      if (next - i > 1) times.push(this.timeOf(next - 1));
      for (const [k, s] of which.entries()) {
        const [early, late] = this.extremes(s, i, next);
        series[k]!.push(known(early));
        if (next - i > 1) series[k]!.push(known(late));
      }
      i = next;
    }
    return { times, series };
  }

  /** Least and largest of samples begin to end, the one that came first first; NaN where none is known. */
  private extremes(series: number, begin: number, end: number): [number, number] {
    let low = NaN,
      high = NaN,
      lowAt = 0,
      highAt = 0;
    for (let i = begin; i < end; ++i) {
      const v = this.valueOf(series, i);
      if (Number.isNaN(v)) continue;
      if (!(v >= low)) {
        low = v;
        lowAt = i;
      }
      if (!(v <= high)) {
        high = v;
        highAt = i;
      }
    }
    return lowAt <= highAt ? [low, high] : [high, low];
  }

  private isGap(before: number, after: number, width: number): boolean {
    return after - before > 3 * Math.max(width, this.interval) && after - before > kGap;
  }
  private breakAt(time: number, times: number[], series: (number | null)[][]): void {
    times.push(time);
    for (const one of series) one.push(null);
  }

  /** How many samples are at or before a time. */
  private after(time: number): number {
    let low = 0,
      high = this.count;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.timeOf(middle) <= time) low = middle + 1;
      else high = middle;
    }
    return low;
  }
  private timeOf(i: number): number {
    return this.times[(this.first + i) % this.times.length]!;
  }
  private valueOf(series: number, i: number): number {
    return this.values[series]![(this.first + i) % this.times.length]!;
  }
}

/** s without a sample that are drawn as a gap: above what a hurried exercise leaves between samples, 20 / 60 s. */
const kGap = 2;

const known = (value: number): number | null => (Number.isNaN(value) ? null : value);
