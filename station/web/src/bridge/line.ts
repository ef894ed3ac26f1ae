// The line between bridge and forecastle: what was said on it, in both directions. Which report is heard, and when it
// was, the exercise's log says: a Report has no time, and a page that opens late hears those of before all at once.

import { Before, begins, leave } from "../kit/branch";
import { orderState, wasSaidAgain, written } from "../kit/orders";
import { besideSide, eventText, reportText, spoken } from "../kit/words";
import type { Connection } from "../wire/connection";
import { type BridgeOrder, BridgeOrderState, EventSeverity, type Report, type SeatEvent } from "../wire/generated";

/** A line of the log. */
export interface Said {
  kind: "order" | "report" | "notice";
  time: number; // s, exercise time
  text: string;
  /** A restore has left it. */
  left: boolean;
  order?: BridgeOrder;
}

/** A report as it was heard. */
export interface HeardReport {
  report: Report;
  time: number; // s, exercise time
  /** Of that run's log. */
  number: number;
  /** Of now: not told again to a page that came late. */
  fresh: boolean;
}

/** A line of the log that tells of one. */
interface ReportLine extends SeatEvent {
  left: boolean;
  /** What it means is known, and was told. */
  told: boolean;
}
type Notice = SeatEvent & { left: boolean };

const kReports = 200;
const kFresh = 5; // s of exercise time

/** What the line is told beside orders and reports: that nothing came back, the bell, and what the bridge notices. */
const kOfTheLine = new Set(["order.not_heard", "report.bell", "hint.bridge"]);
const isNotice = (event: SeatEvent): boolean =>
  kOfTheLine.has(event.code) ||
  (event.severity !== EventSeverity.EVENT_INFO && !/^(order|report|levers)\./.test(event.code));

export class Line {
  private reports: ReportLine[] = [];
  private readonly meant = new Map<string, Report>(); // by side and words
  private notices: Notice[] = [];
  private readonly before = new Before();
  private worked: boolean | undefined; // as it was told last
  private run: number | undefined;
  private readonly reportListeners = new Set<(heard: HeardReport) => void>();
  private readonly listeners = new Set<() => void>();

  constructor(private readonly link: Connection) {
    link.onState((state) => {
      if (state !== "open") return;
      this.reports = []; // all of it comes again
      this.notices = [];
      this.before.clear();
      this.tell();
    });
    link.on("ExerciseStatus", ({ run }) => {
      if (run === this.run) return;
      this.run = run;
      this.tell();
    });
    link.on("Report", (report) => this.hear(report));
    link.on("BridgeOrder", () => this.tell());
    link.on("BridgeEvent", (event) => this.notice(event));
    link.on("BridgeInstruction", (event) => event.code === "hint.bridge" && this.notice(event));
    link.on("BridgeView", () => {
      if (this.works() === this.worked) return;
      this.worked = this.works();
      this.tell();
    });
  }

  /** Whether words pass: the VHF works, as far as this seat knows. */
  works(): boolean {
    return this.link.latest("BridgeView")?.vhf_works ?? true;
  }

  /** Whether it is known what this seat may say, and whether its VHF works. */
  known(): boolean {
    return this.link.hello !== undefined && this.link.latest("BridgeView") !== undefined;
  }

  /** Calls back for each report once it is heard, and what it means; after the link opened, for those before it. */
  onReport(listener: (heard: HeardReport) => void): void {
    this.reportListeners.add(listener);
  }
  onChange(listener: () => void): void {
    this.listeners.add(listener);
  }

  /** Orders of this run, by their numbers. */
  orders(): BridgeOrder[] {
    return this.link
      .all("BridgeOrder")
      .filter((order) => order.run === this.run)
      .sort((a, b) => a.number - b.number);
  }

  /** What is said of a question that was asked before the exercise was gone on with here; empty: it was not. */
  saidOfBefore(question: BridgeOrder): string {
    return this.before.said(question);
  }

  /** Lines of the log by which reports were heard, of this branch. */
  heard(): readonly SeatEvent[] {
    return this.reports.filter(({ left }) => !left);
  }

  /** All that was said and noticed, the newest first; last what a restore has left. */
  log(): Said[] {
    const said: Said[] = [
      ...this.orders().map((order): Said => ({
        kind: "order",
        time: order.time,
        text: written(order),
        left: false,
        order,
      })),
      ...this.reports.map(({ side, time, text, left }): Said => ({
        kind: "report",
        time,
        text: besideSide(side, spoken(text)),
        left,
      })),
      ...this.notices.map((event): Said => ({
        kind: "notice",
        time: event.time,
        text: eventText(event),
        left: event.left,
      })),
    ];
    return said.reverse().sort((a, b) => Number(a.left) - Number(b.left) || b.time - a.time);
  }

  /** What words mean: the log has no more than the words. */
  private hear(report: Report): void {
    this.meant.set(`${report.side} ${reportText(report)}`, report);
    for (const line of this.reports) this.pair(line);
  }

  private pair(line: ReportLine): void {
    const report = this.meant.get(`${line.side} ${spoken(line.text)}`);
    if (line.told || !report) return;
    line.told = true;
    const { time, number } = line;
    const fresh = time > (this.link.latest("ExerciseStatus")?.time ?? 0) - kFresh;
    for (const listener of this.reportListeners) listener({ report, time, number, fresh });
  }

  private notice(event: SeatEvent): void {
    const known = (log: readonly SeatEvent[]): boolean =>
      log.some((n) => n.number === event.number && n.time === event.time && n.code === event.code);
    this.before.hear(event);
    if (begins(event)) {
      leave(this.reports, event);
      leave(this.notices, event);
      this.reports = this.reports.filter(({ left, told }) => told || !left); // nobody here has heard those
    } else if (event.code === "report.made" && !known(this.reports)) {
      const line = { ...event, left: false, told: false };
      this.reports = [...this.reports, line].slice(-kReports);
      this.pair(line);
    } else if (isNotice(event) && !known(this.notices))
      this.notices = [...this.notices, { ...event, left: false }].slice(-kReports);
    else return;
    this.tell();
  }

  private tell(): void {
    for (const listener of this.listeners) listener();
  }
}

/** State of an order, with a sign of its own: never by colour alone. all: orders that it was given among. */
export function stateWords(order: BridgeOrder, all: readonly BridgeOrder[]): string {
  const signs: Record<BridgeOrderState, string> = {
    [BridgeOrderState.ORDER_GIVEN]: "\u2026",
    [BridgeOrderState.ORDER_REPEATED]: "\u2713",
    [BridgeOrderState.ORDER_MISREPEATED]: "\u2260",
    [BridgeOrderState.ORDER_NOT_REPEATED]: "!",
    [BridgeOrderState.ORDER_CANCELLED]: "\u2715",
  };
  const sign = wasSaidAgain(order, all) ? signs[BridgeOrderState.ORDER_NOT_REPEATED] : signs[order.state];
  return `${sign} ${orderState(order, all)}`;
}
