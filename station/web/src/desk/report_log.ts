// Reports of the forecastle as the exercise's log has them, each at its own time, with what was so then. The log alone
// says when one was made: a Report has no time, and a desk that opens late hears those of before all at once. What was
// so before it was here, it has from a recording that was being made, else from the lesson's judge, of the reports that
// he holds against the truth.

import { limits } from "../../../../words/words.json";
import { begins } from "../kit/branch";
import { inChosenUnits } from "../kit/figures_in_text";
import { cableSpeeds, celsius, clockHour, figure, loads, shacklesFigure } from "../kit/units";
import { besideSide, eventLine, reportText, saidOf, spoken } from "../kit/words";
import type { Connection } from "../wire/connection";
import {
  type AnchorState,
  type ChainState,
  type JudgedReport,
  type Report,
  ReportCode,
  type TopicName,
  type TopicTypes,
  type WindlassLoad,
} from "../wire/generated";
import type { EventStore, Logged } from "./events";
import type { Drawer } from "./recorded_past";
import { t } from "../kit/language";

/** What was so of a side when a report was made; nothing: it is not known any more. */
interface Then {
  load?: WindlassLoad;
  anchor?: AnchorState;
  chain?: ChainState; // of the past none is kept
}

/** Samples of each side, by time. */
class Course<T extends { side: number; time: number }> {
  private readonly sides = new Map<number, { sample: T }[]>();

  /** What lies after it, of a branch that was left, has not happened. */
  add(sample: T): void {
    const its = this.sides.get(sample.side) ?? [];
    this.sides.set(sample.side, its);
    while (its.length > 0 && its.at(-1)!.sample.time > sample.time) its.pop();
    its.push({ sample });
  }
  at(side: number, time: number): T | undefined {
    return nearest(this.sides.get(side) ?? [], time);
  }
}

/** A line of the log that tells of a report. */
export interface ReportLine {
  readonly event: Logged;
  readonly words: string;
  /** "was 3.2 in the pipe", or what the judge says; empty where it can be neither right nor wrong, or is not known. */
  was: string;
}

const kKept = 200;
const kOfThen = 1.5; // s between event and sample, at most: of the past there is a sample a second

export const isReport = ({ code }: { code: string }): boolean => code === "report.made" || code === "report.not_heard";

export class ReportLog implements Drawer {
  /** Of the branch that runs, as they came. */
  lines: ReportLine[] = [];
  private readonly truths = new Map<ReportLine, Then>();
  private readonly reports = new Map<string, Report>(); // what was said, by its words
  private judged: readonly JudgedReport[] = []; // so far, of this branch
  private loads = new Course<WindlassLoad>(); // of a past that is being told
  private anchors = new Course<AnchorState>();

  /** replay: of which all branches are shown. changed: is called after each change of the lines. */
  constructor(
    private readonly link: Pick<Connection, "on" | "track">,
    private readonly events: Pick<EventStore, "all" | "onChange">,
    private readonly replay: () => boolean,
    private readonly changed: () => void,
  ) {
    for (const side of [0, 1]) this.soThen(side, NaN); // wanted from the first on, so that it comes with its past
    link.on("Report", (report) => this.takeReport(report));
    link.on("Assessment", ({ reports }) => this.judge(reports));
    events.onChange((event) => {
      if (event && !begins(event)) return isReport(event) && this.take(event);
      this.sift();
    });
  }

  forget(): void {
    this.loads = new Course();
    this.anchors = new Course();
  }

  hear<T extends TopicName>(topic: T, sample: TopicTypes[T]): void {
    if (topic === "WindlassLoad") this.loads.add(sample as WindlassLoad);
    else if (topic === "AnchorState") this.anchors.add(sample as AnchorState);
  }

  /** Beside reports of which this desk has not heard what was so. */
  caughtUp(): void {
    for (const line of this.lines) {
      const { side, time } = line.event;
      if (this.truths.get(line)?.load) continue;
      this.truths.set(line, { load: this.loads.at(side, time), anchor: this.anchors.at(side, time) });
      line.was = this.wasOf(line);
    }
    this.forget();
    this.changed();
  }

  /** What its words mean: the log has no more than the words. */
  private takeReport(report: Report): void {
    const words = reportText(report);
    this.reports.set(words, report);
    const meant = this.lines.filter(({ event }) => spoken(event.text) === words);
    for (const line of meant) line.was = this.wasOf(line);
    if (meant.length > 0) this.changed();
  }

  private judge(reports: readonly JudgedReport[]): void {
    this.judged = reports;
    let news = false;
    for (const line of this.lines) {
      const was = this.wasOf(line);
      news ||= was !== line.was;
      line.was = was;
    }
    if (news) this.changed();
  }

  private take(event: Logged): void {
    const said = event.code === "report.made" ? besideSide(event.side, spoken(event.text)) : eventLine(event);
    const line: ReportLine = { event, words: said, was: "" };
    this.truths.set(line, this.soThen(event.side, event.time));
    line.was = this.wasOf(line);
    this.keep([...this.lines, line].slice(-kKept));
  }

  /** Those of a branch that was left go, and those that came otherwise than one by one are taken. */
  private sift(): void {
    const now = this.events.all.filter((event) => isReport(event) && (this.replay() || !event.left));
    const known = new Set(this.lines.map(({ event }) => event));
    this.keep(this.lines.filter(({ event }) => now.includes(event)));
    for (const event of now.slice(-kKept)) if (!known.has(event)) this.take(event);
  }

  private keep(lines: ReportLine[]): void {
    this.lines = lines;
    for (const line of this.truths.keys()) if (!lines.includes(line)) this.truths.delete(line);
    this.changed();
  }

  private soThen(side: number, time: number): Then {
    const { link } = this;
    return {
      load: nearest(link.track("WindlassLoad", side), time),
      anchor: nearest(link.track("AnchorState", side), time),
      chain: nearest(link.track("ChainState", side), time),
    };
  }

  private wasOf(line: ReportLine): string {
    const then = this.truths.get(line) ?? {};
    if (!then.load) return this.judgedOf(line.event);
    const report = this.reports.get(spoken(line.event.text));
    return report ? truthOf(report, then) : atLarge(then);
  }

  /** In the judge's words. */
  private judgedOf({ tick, side }: Logged): string {
    const its = this.judged.filter((one) => one.tick === tick && (side < 0 || one.side === side));
    return [...new Set(its.map(({ text }) => inChosenUnits(text)))].join("; ");
  }
}

/** The sample of that moment, s; undefined: none of those that were heard last is of then. */
function nearest<T extends { time: number }>(heard: readonly { sample: T }[], time: number): T | undefined {
  let found: T | undefined;
  let least = kOfThen;
  for (const { sample } of heard) {
    const apart = Math.abs(sample.time - time);
    if (apart > least) continue;
    least = apart;
    found = sample;
  }
  return found;
}

function truthOf(report: Report, { load, anchor, chain }: Then): string {
  if (!load || !anchor) return "";
  switch (report.code) {
    case ReportCode.REPORT_SHACKLES_ON_DECK:
      return t("was {shackles} on deck", { shackles: shacklesFigure(load.cable_out + limits.mark_on_deck.value) });
    case ReportCode.REPORT_SHACKLES_IN_PIPE:
      return t("was {shackles} in the pipe", { shackles: shacklesFigure(load.cable_out + limits.mark_in_pipe.value) });
    case ReportCode.REPORT_SHACKLES_IN_WATER: {
      const lip = chain?.nodes[2]; // m over the water: the nodes are x, y, z from the lip on
      if (lip === undefined) return t("was {shackles} from the lip", { shackles: shacklesFigure(load.cable_out) });
      return t("was {shackles} in the water", { shackles: shacklesFigure(load.cable_out - lip) });
    }
    case ReportCode.REPORT_LEAD:
    case ReportCode.REPORT_SHORT_STAY:
    case ReportCode.REPORT_UP_AND_DOWN:
      if (!chain) return "";
      return t("was {hour} o'clock, {stay}", { hour: clockHour(chain.lead_clock), stay: saidOf("Stay", chain.stay) });
    case ReportCode.REPORT_GROWING:
    case ReportCode.REPORT_WEIGHT:
      return t("was {what}", { what: loads.text(load.hawse_tension) });
    case ReportCode.REPORT_TURNS:
      return chain ? t("was {what}", { what: figure(chain.turns, 1) }) : "";
    case ReportCode.REPORT_NO_POWER:
      return load.power ? t("had power") : t("had none");
    case ReportCode.REPORT_BRAKE_DOES_NOT_HOLD:
      return t("bore {load} of {capacity}, lining {degrees} °C", {
        load: loads.figure(load.brake_load),
        capacity: loads.text(load.brake_capacity),
        degrees: figure(celsius(load.lining_temperature)),
      });
    case ReportCode.REPORT_DOES_NOT_RUN:
      return t("ran {speed}", { speed: cableSpeeds.text(load.cable_speed) });
    case ReportCode.REPORT_SECURED:
      return load.stopper_closed
        ? t("brake {percent} %, stopper closed", { percent: figure(100 * load.brake_position) })
        : t("brake {percent} %, stopper open", { percent: figure(100 * load.brake_position) });
    case ReportCode.REPORT_LET_GO:
    case ReportCode.REPORT_ON_THE_BOTTOM:
    case ReportCode.REPORT_BROUGHT_UP:
    case ReportCode.REPORT_ANCHOR_AWEIGH:
    case ReportCode.REPORT_CLEAR_ANCHOR:
    case ReportCode.REPORT_FOUL_ANCHOR:
    case ReportCode.REPORT_ANCHOR_HOME:
    case ReportCode.REPORT_DRAGGING:
      return t("was {what}", { what: saidOf("AnchorPhase", anchor.phase) });
    default:
      return "";
  }
}

/** What was so of that side at large: a replay has the words of a report, but not the Report. */
function atLarge({ load, anchor }: Then): string {
  if (!load || !anchor) return "";
  const out = shacklesFigure(load.cable_out);
  return t("was {shackles} from the lip, {phase}", { shackles: out, phase: saidOf("AnchorPhase", anchor.phase) });
}
