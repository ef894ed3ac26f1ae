// Levers of two places that did not go where a hand wanted them: for a while it is said why.

const kTold = 10_000; // ms

export class Refusals {
  private readonly tries = new Map<number, { at: number; stands: boolean }>(); // by side; ms, and how it stood

  /** That of this side did not move when it was tried, and stands so. */
  add(side: number, stands: boolean): void {
    this.tries.set(side, { at: performance.now(), stands });
  }

  /** Whether it was tried lately, and has not moved since. */
  lately(side: number, stands: boolean): boolean {
    const tried = this.tries.get(side);
    return tried?.stands === stands && performance.now() - tried.at < kTold;
  }
}
