// In which phase the work at a windlass is, as far as those at it know: by what the bridge has ordered and what was
// reported from here; where neither is known, by what was seen of anchor and cable when this page began, or the branch
// of time. Never by the truth: a pad that turned by itself when the anchor is on the bottom would tell what is to be
// noticed.

import { begins, leave } from "../kit/branch";
import { type PadLeaf, bareReport, padLeaves, placeOf, reportText } from "../kit/words";
import type { Connection } from "../wire/connection";
import {
  AnchorSeen,
  type BridgeOrder,
  type BridgeOrderCode,
  BridgeOrderState,
  ClutchState,
  type ExerciseStatus,
  type ForecastleView,
  type ReportCode,
  type SeatEvent,
} from "../wire/generated";

const kFigure = "\0"; // stands for one that is not known

/**
 * Whether a line of the log says that sentence, whatever its figure. What was reported is on the forecastle in its log
 * alone: Report goes to the bridge.
 */
const says = (line: string, sentence: string): boolean => sentence.split(kFigure).every((part) => line.includes(part));

const reportSentence = (code: ReportCode, side: number): string =>
  reportText({ ...bareReport(code, side), value: 1 }, () => kFigure);

/** The leaf of the pad to which an order turns it; undefined: to none. */
export const leafAfterOrder = (code: BridgeOrderCode): PadLeaf | undefined =>
  padLeaves.find(({ after }) => after?.orders?.some((name) => placeOf("BridgeOrderCode", name) === code));

/** The same of a line of the log, which may tell of a report. */
export function leafAfter({ code, side, text }: Pick<SeatEvent, "code" | "side" | "text">): PadLeaf | undefined {
  if (code !== "report.made" && code !== "report.not_heard") return undefined;
  return padLeaves.find(({ after }) =>
    after?.reports?.some((name) => says(text, reportSentence(placeOf("ReportCode", name), side))),
  );
}

const kHeld = 0.9; // of the brake's way, from which it holds a cable that stands
const leafCalled = (name: string): PadLeaf => padLeaves.find((leaf) => leaf.const === name)!;

/** The leaf that the look of anchor, cable and levers asks for. */
export function leafSeen(view: ForecastleView): PadLeaf {
  const { anchor, cable_speed_seen: speed, brake_position: brake, stopper_closed: stopper, clutch } = view;
  const fits = padLeaves.find(({ after }) => after?.anchor?.some((name) => placeOf("AnchorSeen", name) === anchor));
  if (!fits) return padLeaves[0]!;
  if (speed < 0) return leafCalled("weighing");
  const free = brake < kHeld && !stopper && clutch === ClutchState.CLUTCH_OUT;
  return speed > 0 || free ? leafCalled("letting_go") : fits; // in the water she rides by a cable that is held
}

interface Turn {
  time: number; // s, exercise time
  side: number;
  leaf: PadLeaf;
  left: boolean;
}

const kNear = 5; // s of exercise time, by which what is seen may be older or newer than the branch's first status

export class Work {
  private reports: Turn[] = []; // the newest first
  private readonly seen = new Map<number, PadLeaf>(); // by side, as the page began or the branch
  private readonly ordered = new Set<string>(); // orders that were told, by run and number
  private run: number | undefined;
  private branch: number | undefined; // s, exercise time at which another run was heard than the first one
  private readonly listeners = new Set<() => void>();

  constructor(private readonly link: Connection) {
    link.on("ForecastleEvent", (event) => this.hear(event));
    link.on("BridgeOrder", (order) => this.hearOrder(order));
    link.on("ForecastleView", (view) => this.see(view));
    link.on("ExerciseStatus", (status) => this.follow(status));
    link.onState((state) => state === "open" && (this.reports = [])); // all of it comes again
    link.onAnotherServer(() => (this.reports = []));
  }

  /** Calls back when the work may have gone on. */
  onTurn(listener: () => void): void {
    this.listeners.add(listener);
  }

  /** The leaf that the work at a windlass asks for. side: 0 port, 1 starboard. */
  leaf(side: number): PadLeaf {
    const report = this.reports.find((turn) => !turn.left && (turn.side === side || turn.side === -1));
    const order = this.newestOrder(side);
    if (order && !(report && report.time >= order.time)) return leafAfterOrder(order.code)!;
    if (report) return report.leaf;
    const view = this.link.latest("ForecastleView", side);
    return this.seen.get(side) ?? (view ? leafSeen(view) : padLeaves[0]!);
  }

  /** Of those that turn the pad. A run has all of its orders, those from before a restore too; its log may not. */
  private newestOrder(side: number): BridgeOrder | undefined {
    return this.link
      .all("BridgeOrder")
      .filter(
        (order) =>
          order.run === this.run &&
          order.state !== BridgeOrderState.ORDER_CANCELLED &&
          (order.side === side || order.side === -1) &&
          leafAfterOrder(order.code),
      )
      .sort((a, b) => b.number - a.number)[0];
  }

  private hear(event: SeatEvent): void {
    if (begins(event)) leave(this.reports, event);
    const leaf = leafAfter(event);
    if (leaf) this.reports.unshift({ time: event.time, side: event.side, leaf, left: false });
    if (leaf || begins(event)) this.tell();
  }

  private hearOrder({ run, number, code }: BridgeOrder): void {
    const name = `${run}/${number}`;
    if (this.ordered.has(name)) return; // only its state has changed
    this.ordered.add(name);
    if (leafAfterOrder(code)) this.tell();
  }

  private follow({ run, time }: ExerciseStatus): void {
    if (run === this.run) return;
    if (this.run !== undefined) {
      this.branch = time;
      this.seen.clear();
    }
    this.run = run;
    this.tell();
  }

  /**
   * What is seen first counts, and an anchor at the hawse: one that is then let go without a word is not one at which
   * she rides.
   */
  private see(view: ForecastleView): void {
    const ofBefore = this.branch !== undefined && Math.abs(view.time - this.branch) > kNear;
    const atHawse = view.anchor === AnchorSeen.ANCHOR_SEEN_HOME || view.anchor === AnchorSeen.ANCHOR_SEEN_ACOCKBILL;
    if (atHawse || (!this.seen.has(view.side) && !ofBefore)) this.seen.set(view.side, leafSeen(view));
  }

  private tell(): void {
    for (const listener of this.listeners) listener();
  }
}
