// Where an anchor was let go, of an event and samples that come in any order: a recorder that had no time hears the one
// seconds before the other, and of the past there is a sample a second.

/** A place at an exercise time, s. */
export interface Passed {
  time: number;
  x: number;
  y: number;
}

const kRecent = 10; // samples: of the past, as many seconds
const kOfThen = 8; // s between event and sample, at most: at 1 kn she has gone four metres

export class LetGoPlace {
  private readonly recent: Passed[] = []; // oldest first
  private letGo = NaN; // s
  private nearest: Passed | undefined;

  /** The anchor was there. */
  passed(place: Passed): void {
    while (this.recent.length > 0 && this.recent.at(-1)!.time > place.time) this.recent.pop(); // time went back
    this.recent.push(place);
    if (this.recent.length > kRecent) this.recent.shift();
    this.consider(place);
  }

  /** It was let go at that moment, s. Heard once more (a replay tells its past, and plays it), it changes nothing. */
  at(time: number): void {
    if (time === this.letGo) return;
    this.letGo = time;
    this.nearest = undefined;
    for (const place of this.recent) this.consider(place);
  }

  forget(): void {
    this.recent.length = 0;
    this.letGo = NaN;
    this.nearest = undefined;
  }

  /** Where, as far as it is known at that moment, s, and had happened by then. */
  asOf(time: number): Passed | undefined {
    return this.letGo <= time ? this.nearest : undefined;
  }

  private consider(place: Passed): void {
    const apart = (of: Passed) => Math.abs(of.time - this.letGo);
    if (apart(place) < kOfThen && (!this.nearest || apart(place) < apart(this.nearest))) this.nearest = place;
  }
}
