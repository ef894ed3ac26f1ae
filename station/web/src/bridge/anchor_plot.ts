// Anchors as the bridge plots them: where the hawse was when it was let go, and how much cable was reported.

import { kShackle } from "../kit/units";
import { ofShip } from "../plan/projection";
import type { Place } from "../plan/picture";
import type { Connection } from "../wire/connection";
import { type BridgeView, ReportCode, type SceneDescription } from "../wire/generated";
import { Kept } from "./kept";
import type { HeardReport, Line } from "./line";

/** One anchor, by the bridge's own book. */
export interface Plotted {
  place?: Place; // m, world
  time?: number; // s, exercise time, of its being let go
  /** m, as reported or set by hand, and when; the last one counts. */
  cables?: { time: number; cable: number | undefined }[];
  /** "let go" was heard: where the hawse was then; not plotted yet. */
  reported?: Place & { time: number };
  /** Reports that are in this book, by time and number of the log: they are told again when the link opens. */
  entered?: string[];
}

const kOfThen = 5; // s between a report and the sight of her by which it is plotted, at most
const kEntered = 200; // as many as the line has

/** What of an anchor's book had happened at that time, s. */
function upTo(plotted: Plotted, time: number): Plotted {
  const { place, time: letGo, cables, reported, entered } = plotted;
  return {
    ...(letGo !== undefined && letGo <= time && { place, time: letGo }),
    ...(reported && reported.time <= time && { reported }),
    cables: cables?.filter((each) => each.time <= time),
    entered,
  };
}

export class AnchorPlot {
  private readonly kept: Kept<[Plotted, Plotted]>;

  constructor(
    private readonly link: Connection,
    line: Line,
  ) {
    this.kept = new Kept<[Plotted, Plotted]>(
      link,
      "anchors",
      () => [{}, {}],
      ([port, starboard], time) => [upTo(port, time), upTo(starboard, time)],
    );
    line.onReport((heard) => this.enter(heard));
  }

  private enter({ report, time, number }: HeardReport): void {
    const { side, code } = report;
    if (side !== 0 && side !== 1) return;
    const name = `${time}/${number}`;
    const { entered = [] } = this.of(side);
    if (entered.includes(name)) return;
    const change: Partial<Plotted> = { entered: [...entered, name].slice(-kEntered) };
    // A station tells its past as it came; where it has none, she lies elsewhere by now.
    const isOfThen = Math.abs((this.link.latest("BridgeView")?.time ?? Infinity) - time) < kOfThen;
    const hawse = isOfThen ? this.hawse(side) : undefined;
    if (code === ReportCode.REPORT_LET_GO && hawse) change.reported = { ...hawse, time };
    const counts =
      code === ReportCode.REPORT_SHACKLES_IN_PIPE ||
      code === ReportCode.REPORT_SHACKLES_IN_WATER ||
      code === ReportCode.REPORT_SHACKLES_ON_DECK;
    const gone = code === ReportCode.REPORT_ANCHOR_AWEIGH || code === ReportCode.REPORT_ANCHOR_HOME;
    if (counts || gone) change.cables = this.withCable(side, time, counts ? report.value * kShackle : undefined);
    this.set(side, change);
  }

  of(side: 0 | 1): Plotted {
    return this.kept.value[side];
  }

  /** m of cable, as last reported or set by hand; undefined: not known. */
  cable(side: 0 | 1): number | undefined {
    return this.of(side).cables?.at(-1)?.cable;
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

  /** Plots an anchor at a place that the bridge was told, by who had the watch before. */
  lay(side: 0 | 1, place: Place): void {
    this.set(side, { place, time: this.link.latest("BridgeView")?.time ?? 0, reported: undefined });
  }

  /** Takes an anchor off the plan. */
  clear(side: 0 | 1): void {
    this.set(side, { place: undefined, time: undefined, reported: undefined, cables: undefined });
  }

  /** m, as the bridge takes it to be; undefined: not known. */
  setCable(side: 0 | 1, cable: number | undefined): void {
    this.set(side, { cables: this.withCable(side, this.link.latest("BridgeView")?.time ?? 0, cable) });
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
    const cable = this.cable(side);
    const lip = this.tackle(side)?.lip;
    return cable && lip ? cable + lip.x + aft : undefined;
  }

  private withCable(side: 0 | 1, time: number, cable: number | undefined): Plotted["cables"] {
    return [...(this.of(side).cables ?? []), { time, cable }].slice(-kEntered);
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
