// The line between bridge and forecastle: what was said on it, in both directions. Without VHF no report is heard; the
// server lets through what hand signals and the bell tell.

import { orderStates, reportWords, spoken } from "../kit/orders";
import { sideName } from "../kit/units";
import type { Connection } from "../wire/connection";
import {
  type BridgeOrder,
  BridgeOrderState,
  EventSeverity,
  type Report,
  ReportCode,
  type SeatEvent,
} from "../wire/generated";
import { Kept } from "./kept";

/** A line of the log. */
export interface Said {
  kind: "order" | "report" | "notice";
  time: number; // s, exercise time
  text: string;
  order?: BridgeOrder;
}

/** A report as it was heard. */
interface HeardReport {
  time: number; // s, exercise time
  text: string;
  /** Of its sender, serial and sending time: a station that was started again counts its serials anew. */
  origin: string;
}

const kReports = 200;
const kOld = 1000; // ms after the link opened, in which a sample may be one that the station kept

/** What the line is told beside orders and reports: that nothing came back, the bell, and what the bridge notices. */
const kOfTheLine = ["order.not_heard", "report.bell"];
const isNotice = (event: SeatEvent): boolean =>
  event.bridge &&
  (kOfTheLine.includes(event.code) ||
    (event.severity !== EventSeverity.EVENT_INFO && !/^(order|report|levers)\./.test(event.code)));

export class Line {
  private readonly heard: Kept<HeardReport[]>;
  private notices: SeatEvent[] = [];
  private early: Report[] = []; // heard before it was known of which run
  private worked: boolean | undefined; // as it was told last
  private opened = Infinity; // ms of performance.now()
  private run: number | undefined;
  private readonly reportListeners = new Set<(report: Report, time: number) => void>();
  private readonly listeners = new Set<() => void>();

  constructor(private readonly link: Connection) {
    this.heard = new Kept<HeardReport[]>(link, "reports", () => []);
    this.heard.onChange(() => this.tell());
    link.onState((state) => (this.opened = state === "open" ? performance.now() : Infinity));
    link.on("ExerciseStatus", ({ run }) => {
      if (run === this.run) return;
      if (this.run !== undefined) this.notices = [];
      this.run = run;
      for (const report of this.early.splice(0)) this.hear(report);
      this.tell();
    });
    link.on("Report", (report) => this.hear(report));
    link.on("BridgeOrder", () => this.tell());
    link.on("SeatEvent", (event) => {
      if (!isNotice(event) || this.notices.some((n) => n.number === event.number)) return;
      this.notices = [...this.notices, event].slice(-kReports);
      this.tell();
    });
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

  /** Calls back for each report at the moment it is heard, with the exercise time. */
  onReport(listener: (report: Report, time: number) => void): void {
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

  /** All that was said and noticed, the newest first. */
  log(): Said[] {
    const said: Said[] = [
      ...this.orders().map((order): Said => ({ kind: "order", time: order.time, text: spoken(order), order })),
      ...this.heard.value.map(({ time, text }): Said => ({ kind: "report", time, text })),
      ...this.notices.map(({ time, text }): Said => ({ kind: "notice", time, text })),
    ];
    return said.reverse().sort((a, b) => b.time - a.time);
  }

  private hear(report: Report): void {
    if (this.run === undefined) {
      this.early.push(report);
      return;
    }
    if (!this.works()) return;
    const { source, serial, sent_unix_ns } = report.origin;
    const origin = `${source}/${serial}/${sent_unix_ns}`;
    if (this.heard.value.some((r) => r.origin === origin)) return; // kept by the station, and heard before
    const time = this.link.latest("BridgeView")?.time ?? this.link.latest("ExerciseStatus")?.time ?? 0;
    const named = report.side >= 0 && report.code !== ReportCode.REPORT_ORDER_REPEATED; // which names it itself
    const text = (named ? `${sideName(report.side)}: ` : "") + reportWords(report);
    this.heard.value = [...this.heard.value, { time, text, origin }].slice(-kReports);
    if (performance.now() - this.opened < kOld) return;
    for (const listener of this.reportListeners) listener(report, time);
  }

  private tell(): void {
    for (const listener of this.listeners) listener();
  }
}

/** State of an order, with a sign of its own: never by colour alone. */
export function stateWords(state: BridgeOrderState): string {
  const signs: Record<BridgeOrderState, string> = {
    [BridgeOrderState.ORDER_GIVEN]: "\u2026",
    [BridgeOrderState.ORDER_REPEATED]: "\u2713",
    [BridgeOrderState.ORDER_MISREPEATED]: "\u2260",
    [BridgeOrderState.ORDER_NOT_REPEATED]: "!",
    [BridgeOrderState.ORDER_CANCELLED]: "\u2715",
  };
  return `${signs[state]} ${orderStates[state]}`;
}
