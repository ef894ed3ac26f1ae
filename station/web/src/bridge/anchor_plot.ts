// Anchors as the bridge plots them: where the hawse was when it was let go, and how much cable was reported.

import { ofShip } from "../plan/projection";
import type { Place } from "../plan/picture";
import type { Connection } from "../wire/connection";
import { type BridgeView, ReportCode, type SceneDescription } from "../wire/generated";
import { Kept } from "./kept";
import type { Line } from "./line";

const kShackle = 27.5; // m

/** One anchor, by the bridge's own book. */
export interface Plotted {
  place?: Place; // m, world
  time?: number; // s, exercise time, of its being let go
  /** m, as last reported or set by hand. */
  cable?: number;
  /** "let go" was heard: where the hawse was then; not plotted yet. */
  reported?: Place & { time: number };
}

export class AnchorPlot {
  private readonly kept: Kept<[Plotted, Plotted]>;

  constructor(
    private readonly link: Connection,
    line: Line,
  ) {
    this.kept = new Kept<[Plotted, Plotted]>(link, "anchors", () => [{}, {}]);
    line.onReport((report, time) => {
      if (report.side !== 0 && report.side !== 1) return;
      const hawse = this.hawse(report.side);
      if (report.code === ReportCode.REPORT_LET_GO && hawse) this.set(report.side, { reported: { ...hawse, time } });
      const counts =
        report.code === ReportCode.REPORT_SHACKLES_IN_PIPE ||
        report.code === ReportCode.REPORT_SHACKLES_IN_WATER ||
        report.code === ReportCode.REPORT_SHACKLES_ON_DECK;
      if (counts) this.set(report.side, { cable: report.value * kShackle });
      if (report.code === ReportCode.REPORT_ANCHOR_AWEIGH || report.code === ReportCode.REPORT_ANCHOR_HOME)
        this.set(report.side, { cable: undefined });
    });
  }

  of(side: 0 | 1): Plotted {
    return this.kept.value[side];
  }

  onChange(listener: () => void): void {
    this.kept.onChange(listener);
  }

  /** Plots an anchor where the hawse was when "let go" was heard, or else where it is now. */
  mark(side: 0 | 1): void {
    const { reported } = this.of(side);
    const now = this.hawse(side);
    const time = this.link.latest("BridgeView")?.time ?? 0;
    if (reported) this.set(side, { place: { x: reported.x, y: reported.y }, time: reported.time, reported: undefined });
    else if (now) this.set(side, { place: now, time });
  }

  /** Takes an anchor off the plan. */
  clear(side: 0 | 1): void {
    this.set(side, { place: undefined, time: undefined, reported: undefined, cable: undefined });
  }

  /** m, as the bridge takes it to be; undefined: not known. */
  setCable(side: 0 | 1, cable: number | undefined): void {
    this.set(side, { cable });
  }

  /** Where a hawse pipe is now, by GPS and gyro; undefined while one of them fails. */
  hawse(side: number): Place | undefined {
    const view = this.link.latest("BridgeView");
    const lip = this.tackle(side)?.lip;
    if (!view?.gps_works || !view.gyro_works || !lip) return undefined;
    return ofShip(shipOf(view), lip.x, lip.y);
  }

  /** Radius that her stern swings through: cable and hawse to stern, in one line. m */
  swing(side: 0 | 1): number | undefined {
    const scene = this.link.latest("SceneDescription");
    return this.reach(side, scene ? scene.length_overall / 2 : 0);
  }

  /** Radius of her conning point, taken to be midships, where the GPS is. m */
  drag(side: 0 | 1): number | undefined {
    return this.reach(side, 0);
  }

  private reach(side: 0 | 1, aft: number): number | undefined {
    const { cable } = this.of(side);
    const lip = this.tackle(side)?.lip;
    return cable && lip ? cable + lip.x + aft : undefined;
  }

  private tackle(side: number): SceneDescription["tackle"][number] | undefined {
    return this.link.latest("SceneDescription")?.tackle.find((t) => t.side === side);
  }

  private set(side: 0 | 1, change: Partial<Plotted>): void {
    const next: [Plotted, Plotted] = [{ ...this.kept.value[0] }, { ...this.kept.value[1] }];
    Object.assign(next[side], change);
    this.kept.value = next;
  }
}

/** Where the instruments have the ship. */
export const shipOf = (view: BridgeView): Place & { heading: number } => ({
  x: view.position.x,
  y: view.position.y,
  heading: view.heading,
});
