// In which phase the work at a windlass is, as far as those at it know: by what the bridge has ordered and what was
// reported from here, and at first by what is seen of the anchor. Never by the truth: a pad that turned by itself when
// the anchor is on the bottom would tell what is to be noticed.

import { begins, leave } from "../kit/branch";
import { type PadLeaf, bareReport, orderText, padLeaves, placeOf, reportText } from "../kit/words";
import type { Connection } from "../wire/connection";
import type { BridgeOrderCode, ReportCode, SeatEvent } from "../wire/generated";

const kFigure = "\0"; // stands for one that is not known

/**
 * Whether a line of the log says that sentence, whatever its figure. What was reported is on the forecastle in its log
 * alone: Report goes to the bridge.
 */
const says = (line: string, sentence: string): boolean => sentence.split(kFigure).every((part) => line.includes(part));

/** With a figure, and without. */
const orderSentences = (code: BridgeOrderCode, side: number): string[] =>
  [1, 0].map((value) => orderText(code, side, value, () => kFigure));
const reportSentence = (code: ReportCode, side: number): string =>
  reportText({ ...bareReport(code, side), value: 1 }, () => kFigure);

/** The leaf of the pad to which a line of the log turns it; undefined: to none. */
export function leafAfter({ code, side, text }: Pick<SeatEvent, "code" | "side" | "text">): PadLeaf | undefined {
  if (code === "order.given")
    return padLeaves.find(({ after }) =>
      after?.orders?.some((name) =>
        orderSentences(placeOf("BridgeOrderCode", name), side).some((sentence) => says(text, sentence)),
      ),
    );
  if (code === "report.made" || code === "report.not_heard")
    return padLeaves.find(({ after }) =>
      after?.reports?.some((name) => says(text, reportSentence(placeOf("ReportCode", name), side))),
    );
  return undefined;
}

interface Turn {
  time: number; // s, exercise time
  side: number;
  leaf: PadLeaf;
  left: boolean;
}

export class Work {
  private turns: Turn[] = []; // the newest first
  private readonly listeners = new Set<() => void>();

  constructor(private readonly link: Connection) {
    link.on("SeatEvent", (event) => this.hear(event));
    link.onState((state) => state === "open" && (this.turns = [])); // all of it comes again
  }

  /** Calls back when the work may have gone on. */
  onTurn(listener: () => void): void {
    this.listeners.add(listener);
  }

  /** The leaf that the work at a windlass asks for. side: 0 port, 1 starboard. */
  leaf(side: number): PadLeaf {
    const last = this.turns.find((turn) => !turn.left && (turn.side === side || turn.side === -1));
    if (last) return last.leaf;
    const seen = this.link.latest("ForecastleView", side)?.anchor;
    const fits = ({ after }: PadLeaf): boolean | undefined =>
      after?.anchor?.some((name) => placeOf("AnchorSeen", name) === seen);
    return padLeaves.find(fits) ?? padLeaves[0]!;
  }

  private hear(event: SeatEvent): void {
    if (begins(event)) leave(this.turns, event);
    const leaf = leafAfter(event);
    if (leaf) this.turns.unshift({ time: event.time, side: event.side, leaf, left: false });
    if (leaf || begins(event)) for (const listener of this.listeners) listener();
  }
}
