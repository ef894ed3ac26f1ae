// The line between bridge and forecastle: what was said on it, in both directions. Without VHF no report is heard; the
// server lets through what hand signals and the bell tell.

import { begins, leave } from "../kit/branch";
import { orderState, wasSaidAgain, written } from "../kit/orders";
import { besideSide, eventText, reportText } from "../kit/words";
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
  text: string;
  /** A restore has left it. */
  left: boolean;
  /** Of now: not told again to a page that came late. */
  fresh: boolean;
}
type Notice = SeatEvent & { left: boolean };

const kReports = 200;
const kFresh = 5; // s of exercise time

/** What the line is told beside orders and reports: that nothing came back, the bell, and what the bridge notices. */
const kOfTheLine = new Set(["order.not_heard", "report.bell", "hint.bridge"]);
const isNotice = (event: SeatEvent): boolean =>
  event.bridge &&
  (kOfTheLine.has(event.code) ||
    (event.severity !== EventSeverity.EVENT_INFO && !/^(order|report|levers)\./.test(event.code)));

export class Line {
  private reports: HeardReport[] = [];
  private notices: Notice[] = [];
  private worked: boolean | undefined; // as it was told last
  private run: number | undefined;
  private readonly reportListeners = new Set<(heard: HeardReport) => void>();
  private readonly listeners = new Set<() => void>();

  constructor(private readonly link: Connection) {
    link.onState((state) => {
      if (state !== "open") return;
      this.reports = []; // all of it comes again
      this.notices = [];
      this.tell();
    });
    link.on("ExerciseStatus", ({ run }) => {
      if (run === this.run) return;
      this.run = run;
      this.tell();
    });
    link.on("Report", (report) => this.hear(report));
    link.on("BridgeOrder", () => this.tell());
    link.on("SeatEvent", (event) => this.notice(event));
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

  /** Calls back for each report as it is heard; after the link opened, for those before it. */
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
      ...this.reports.map(({ time, text, left }): Said => ({ kind: "report", time, text, left })),
      ...this.notices.map((event): Said => ({
        kind: "notice",
        time: event.time,
        text: eventText(event),
        left: event.left,
      })),
    ];
    return said.reverse().sort((a, b) => Number(a.left) - Number(b.left) || b.time - a.time);
  }

  private hear(report: Report): void {
    if (!this.works()) return;
    const now = this.link.latest("ExerciseStatus")?.time ?? 0;
    const time = this.link.latest("BridgeView")?.time ?? now;
    const heard = {
      report,
      time,
      text: besideSide(report.side, reportText(report)),
      left: false,
      fresh: time > now - kFresh,
    };
    this.reports = [...this.reports, heard].slice(-kReports);
    this.tell();
    for (const listener of this.reportListeners) listener(heard);
  }

  private notice(event: SeatEvent): void {
    if (begins(event)) {
      leave(this.reports, event);
      leave(this.notices, event);
    } else if (
      isNotice(event) &&
      !this.notices.some((n) => n.number === event.number && n.time === event.time && n.code === event.code)
    )
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
