// The helm's orders as they stood last in a run. Of levers that nobody holds no server tells a seat anything:
// HelmCommand counts only while somebody speaks, and BridgeView has what engine, rudder and thrusters do, not what was
// ordered. So the page remembers, over a reload too, until another takes the helm whom it did not hear.

import { begins } from "../kit/branch";
import type { Connection, HelmLevers } from "../wire/connection";
import type { SeatEvent } from "../wire/generated";
import { Kept } from "./kept";

interface Book {
  levers?: HelmLevers;
  /** Number of the newest line of the log that was known then in which another takes the helm. */
  taken: number;
  /** Thruster levers spring back to zero when let go, or stay. */
  springs: boolean;
}

const kHelm = -1; // the side by which the log names it

const isSame = (one: HelmLevers, other: HelmLevers | undefined): boolean =>
  other !== undefined && (Object.keys(one) as (keyof HelmLevers)[]).every((lever) => one[lever] === other[lever]);

export class LastHelm {
  private readonly book: Kept<Book>;
  private taken = 0; // number of the log's newest line in which another takes it

  constructor(private readonly link: Connection) {
    this.book = new Kept<Book>(
      link,
      "helm",
      () => ({ taken: 0, springs: true }),
      ({ springs }) => ({ taken: 0, springs }), // a restore has the levers where they were then, and tells nobody
    );
    link.on("BridgeEvent", (event) => this.hear(event));
    link.onState((state) => state === "open" && (this.taken = 0)); // all of it comes again
  }

  /** The orders; undefined: not known. */
  levers(): HelmLevers | undefined {
    const { levers, taken } = this.book.value;
    return taken >= this.taken ? levers : undefined;
  }

  /** These count now. */
  ordered(levers: HelmLevers): void {
    const { value } = this.book;
    if (isSame(levers, value.levers) && value.taken === this.taken) return;
    this.book.value = { ...value, levers: { ...levers }, taken: this.taken };
  }

  get springs(): boolean {
    return this.book.value.springs;
  }
  set springs(springs: boolean) {
    this.book.value = { ...this.book.value, springs };
  }

  private hear(event: SeatEvent): void {
    if (begins(event)) this.taken = 0; // its log counts anew
    const { code, side, number, text } = event;
    if (code !== "levers.taken" || side !== kHelm || text.startsWith(`${this.link.hello?.name} has `)) return;
    this.taken = Math.max(this.taken, number);
  }
}
