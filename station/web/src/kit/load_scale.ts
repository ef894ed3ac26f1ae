// The scale on which loads are read, of a dial or in colours, follows the load step by step: at 5 t a dial to 300 t
// shows nothing. It widens at once, and narrows when the load has been small for a while, so that it does not jump with
// every wave.

const kCalm = 5000; // ms for which the load has been well within the next smaller scale
const kWell = 0.8; // of that scale's end

export class LoadScale {
  private end: number | undefined;
  private calmSince: number | undefined;

  /** The end of the scale for that load; ends: of all scales of this ship, rising. now: ms. */
  at(load: number, ends: readonly number[], now: number): number {
    const last = ends.length - 1;
    const first = (fits: (end: number) => boolean): number => {
      const found = ends.findIndex(fits);
      return found < 0 ? last : found;
    };
    if (this.end === undefined) return this.turn(ends[first((end) => load <= kWell * end)]!);
    const step = first((end) => end >= this.end!);
    const needed = first((end) => end >= load);
    if (needed > step) return this.turn(ends[needed]!);
    if (step === 0 || load > kWell * ends[step - 1]!) return this.turn(ends[step]!);
    this.calmSince ??= now;
    return now - this.calmSince < kCalm ? ends[step]! : this.turn(ends[step - 1]!);
  }

  private turn(end: number): number {
    this.calmSince = undefined;
    return (this.end = end);
  }
}

/** The ends of the scales up to the ship's own: each about three times the one before. */
export function loadScales(full: number, smallest: number): number[] {
  const ends: number[] = [];
  for (let end = smallest, step = 0; end < full; end = smallest * 10 ** Math.floor(++step / 2) * (step % 2 ? 3 : 1))
    ends.push(end);
  return [...ends, full];
}
