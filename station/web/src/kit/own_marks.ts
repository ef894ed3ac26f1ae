// What came of the lesson, for those who worked it: what they did, when, what was so, why it matters, and what to work
// on next time. It opens by itself when the marks are told, and is behind its button from then on.

import type { Connection, Seat } from "../wire/connection";
import { limits } from "../../../../words/words.json";
import {
  type Assessment,
  type BridgeOrder,
  BridgeOrderState,
  type Criterion,
  CriterionKind,
  CriterionState,
  LessonEnding,
  type JudgedReport,
  type ObjectiveMark,
  type SeatEvent,
} from "../wire/generated";
import { begins, leave } from "./branch";
import { h, setText } from "./dom";
import { inChosenUnits } from "./figures_in_text";
import type { OwnSeat } from "./instructions";
import { dropMarks, keepMarks } from "./kept_marks";
import { noticedAt } from "./noticed";
import { written } from "./orders";
import { pointsFigure, shareSaid } from "./points_said";
import { clock, measures } from "./units";
import { capital, endingSaid, outcomeSaid, reportRows, saidOf, spoken, stateSaid } from "./words";
import { t } from "./language";

const kToWorkOn = 3; // criteria that are named first: nobody mends ten things at once
const kNotInPlay = CriterionState.CRITERION_NOT_IN_PLAY;
const kFull = 1000; // that a mark can be
const kReports = 200; // that the log tells of
const kStill = 0.001; // of a limit: nothing ran

/** Points that a criterion has lost, of its weight. */
const lost = (criterion: Criterion): number => (criterion.weight * (1000 - criterion.counted)) / 1000;

const neverCame = ({ state }: Criterion): boolean => state === kNotInPlay;

/**
 * Criteria that went wrong, in the order in which to work on them: what must be first, then what cost most. A must that
 * it never came to is not met either, and comes behind those that it came to.
 */
export function toWorkOn(criteria: Criterion[]): Criterion[] {
  return criteria
    .filter((criterion) => criterion.counts && !criterion.met)
    .sort(
      (a, b) => Number(b.must) - Number(a.must) || Number(neverCame(a)) - Number(neverCame(b)) || lost(b) - lost(a),
    );
}

/** Whether nothing ran of which a limit bounds the speed: there was nothing to keep. */
const neverRan = ({ kind, unit, limit, worst }: Criterion): boolean =>
  kind === CriterionKind.CRITERION_LIMIT && unit === "m/s" && Math.abs(worst) < kStill * limit;

/**
 * What went well: what was done, and what only was not broken, which is no deed to praise. The limit of a cable that
 * never ran is none of both.
 */
export function wentWell(criteria: Criterion[]): { did: Criterion[]; kept: Criterion[] } {
  const well = criteria.filter((one) => one.counts && one.met && one.milli > 0 && !neverRan(one));
  return { did: well.filter(({ deed }) => deed), kept: well.filter(({ deed }) => !deed) };
}

/** "Achieved: 87.0 of 100 points, 70 are needed". */
export function headline({ outcome, score, pass }: Pick<Assessment, "outcome" | "score" | "pass">): string {
  return t("{outcome}: {score} of 100 points, {pass} are needed", {
    outcome: capital(outcomeSaid(outcome)),
    score: pointsFigure(score),
    pass,
  });
}

/** Whether an objective fails the lesson; from half of its points on it does not, though it may not be achieved yet. */
export const failsLesson = ({ outcome, score, pass }: Pick<ObjectiveMark, "outcome" | "score" | "pass">): boolean =>
  outcome !== "achieved" && score < Math.min(pass, limits.objective_fails.value);

/** By what rule an objective is achieved, under those of a lesson; empty: it has none. */
export const objectivesRule = (objectives: readonly unknown[]): string =>
  objectives.length > 0
    ? t(
        "An objective is achieved when its criteria marked (must) are met, each with half of its points at least, " +
          "and it has the points that are needed itself; only one with less than half of its points fails the lesson.",
      )
    : "";

/** What halved the points, by the rule of server/assess/result.cpp; nothing: they were not. */
export function whyHalved({
  criteria,
  objectives,
  ending,
  abort,
}: Pick<Assessment, "criteria" | "objectives" | "ending" | "abort">): string[] {
  const musts = criteria.filter(({ must }) => must);
  // All that the server says where the bridge gave up begins so.
  const gaveUp = ending === LessonEnding.LESSON_TIME_UP && abort.startsWith("the bridge ");
  return [
    musts.some((one) => one.counts && !one.met && !neverCame(one)) && t("a criterion marked (must) was missed"),
    musts.some(neverCame) && t("a criterion marked (must) was not come to"),
    objectives.some((one) => one.outcome === "not_yet" && failsLesson(one)) &&
      t("an objective has less than half of its points"),
    gaveUp && endingSaid(abort),
  ].filter((reason) => reason !== false);
}

/** When the report came against what it told of: "2 s early", "8 s after it", "at once". */
export function delayWords(delay: number): string {
  const s = Math.round(Math.abs(delay));
  if (s === 0) return t("at once");
  return delay < 0 ? t("{s} s early", { s }) : t("{s} s after it", { s });
}

/** What a report has earned: "right" is that to which nothing was wanting. */
export function rightWords(milli: number): string {
  if (milli >= kFull) return t("right|of a report");
  if (milli === 0) return t("not right|of a report");
  return t("nearly right: {share} % of its points", { share: Math.round(milli / 10) });
}

/** What was said, by the line of the log that tells of it: "port: 4 shackles in the pipe"; undefined: none does. */
export function saidIn(
  log: readonly Reported[],
  { tick, side }: Pick<JudgedReport, "tick" | "side">,
): string | undefined {
  const line = log.find((one) => one.tick === tick && !one.left && (one.side < 0 || one.side === side));
  return line && spoken(line.text);
}
type Reported = Pick<SeatEvent, "tick" | "time" | "side" | "text"> & { left: boolean };

/** "For practice, 2 hints". */
export function practiceSaid({ hints }: Pick<Assessment, "hints">): string {
  if (hints.length === 1) return t("For practice, 1 hint");
  return t("For practice, {count} hints", { count: hints.length });
}

/**
 * The seat that the lesson judges, by what the server says behind each briefing (server/run/briefing.cpp): nothing else
 * that a seat hears tells it. undefined: it is not heard.
 */
export function judgedBy(briefing: string): OwnSeat | undefined {
  if (/The bridge's orders come from its own seat\./.test(briefing)) return "bridge";
  return /The bridge's orders come by themselves\./.test(briefing) ? "forecastle" : undefined;
}

/** Whose marks they are, told to a seat that is not the judged one; undefined: they are its own, or nobody knows. */
export function whose(judged: OwnSeat | undefined, seat: Seat | undefined): { marks: string; why: string } | undefined {
  const own: Seat = judged === "bridge" ? "conning" : "forecastle";
  if (!judged || !seat || seat === own || seat === "trainee") return undefined; // a trainee has both seats
  if (judged === "bridge")
    return {
      marks: t("The bridge's marks"),
      why: seat === "forecastle" ? t("This lesson judges the bridge; the forecastle has no marks of it.") : "",
    };
  return {
    marks: t("The forecastle's marks"),
    why: seat === "conning" ? t("This lesson judges the work on the forecastle; the bridge shares its marks.") : "",
  };
}

export class OwnMarks {
  /** Opens it; hidden until there are marks. */
  readonly button: HTMLButtonElement;
  readonly element: HTMLDialogElement;
  private readonly head = h("h2", {});
  private readonly body = h("div", { class: "scroll", tabIndex: 0, role: "group", "aria-label": t("marks") });
  /** Of a lesson that a learning system has started. */
  private readonly back = h(
    "a",
    { class: "plain", href: "/cmi5#finish", hidden: true },
    t("Finish, back to the course"),
  );
  /** Of a class that has ended meanwhile: there is nothing else here any more. */
  private readonly over = h(
    "p",
    { class: "row class-over", role: "status", hidden: true },
    t("The class is over."),
    h("a", { class: "plain", href: "/", onclick: dropMarks }, t("Leave the seat")),
  );
  private shown: Assessment | undefined;
  private judged: OwnSeat | undefined;
  private readonly listeners = new Set<(told: boolean) => void>();
  /** Lines of the log by which reports were heard. */
  private log: Reported[] = [];

  /** at: the seat of its page. */
  constructor(
    private readonly link: Connection,
    at: OwnSeat,
  ) {
    this.element = h(
      "dialog",
      { class: "briefing own-marks panel", "aria-label": t("what came of it") },
      h(
        "div",
        { class: "row" },
        this.head,
        h("button", { class: "plain", onclick: () => this.element.close() }, t("Close")),
        this.back,
      ),
      this.over,
      this.body,
    );
    this.button = h(
      "button",
      { class: "plain", type: "button", hidden: true, onclick: () => this.element.open || this.element.showModal() },
      t("Marks"),
    );
    link.on("SeatAssessment", (assessment) => this.tell(assessment));
    link.onClassOver(() => this.stay());
    link.onState((state) => state === "open" && (this.log = [])); // all of it comes again
    link.on(noticedAt[at], (event) => this.hear(event));
    link.on("BridgeOrder", () => this.shown && this.fill(this.shown));
    for (const measure of measures) measure.onChoice(() => this.shown && this.fill(this.shown));
  }

  /** Calls back when marks are told, and when they are taken back. */
  onTold(listener: (told: boolean) => void): void {
    this.listeners.add(listener);
  }

  /** judged: by the lesson; undefined: it is not known. */
  judge(judged: OwnSeat | undefined): void {
    this.judged = judged;
    if (this.shown) this.fill(this.shown);
  }

  private hear(event: SeatEvent): void {
    if (begins(event)) return leave(this.log, event);
    if (event.code !== "report.made") return;
    this.log = [...this.log, { ...event, left: false }].slice(-kReports);
    if (this.shown) this.fill(this.shown); // the page came late, and the marks sooner than the log
  }

  private tell(assessment: Assessment): void {
    const told = assessment.criteria.length > 0;
    const first = told && !this.shown;
    this.shown = told ? assessment : undefined;
    this.button.hidden = !told;
    if (told) this.fill(assessment);
    for (const listener of this.listeners) listener(told);
    if (first) void this.offerBack();
    if (!told) this.element.close();
    else if (first && !this.element.open) this.element.showModal();
  }

  /** Whether there are marks to read: then closing them leaves the page. */
  private stay(): boolean {
    if (!this.shown) return false;
    this.over.hidden = false;
    keepMarks(this.head, this.body);
    this.element.onclose = () => {
      dropMarks();
      location.assign("/");
    };
    if (!this.element.open) this.element.showModal();
    return true;
  }

  /** Who came by the door may have come from a course; no station's own page has. */
  private async offerBack(): Promise<void> {
    if (!this.link.byDoor) return;
    try {
      const me = (await (await fetch("/door/me", { cache: "no-store" })).json()) as { launch?: unknown };
      this.back.hidden = !me.launch;
    } catch {
      // it is offered where the page leads to without a seat, too
    }
  }

  private fill(assessment: Assessment): void {
    const at = (tick: number): string => clock((tick * assessment.time) / assessment.tick);
    const row = (criterion: Criterion): HTMLElement => criterionRow(criterion, assessment);
    const wrong = toWorkOn(assessment.criteria);
    const { did, kept } = wentWell(assessment.criteria);
    const never = assessment.criteria.filter((criterion) => neverCame(criterion) && !criterion.counts);
    const neverAs = [...new Set(never.map(stateSaid))];
    const others = whose(this.judged, this.link.hello?.seat);
    setText(this.head, others ? `${others.marks}. ${headline(assessment)}` : headline(assessment));
    const { hints } = assessment;
    const rule = objectivesRule(assessment.objectives);
    const parts = [
      others?.why && h("p", {}, others.why),
      assessment.practice &&
        h("p", { class: "practice" }, t("{practice}: no test.", { practice: practiceSaid(assessment) })),
      assessment.abort &&
        h(
          "p",
          {},
          assessment.ending === LessonEnding.LESSON_ENDED_EARLY
            ? t("It was ended before its lesson was done.")
            : t("It ended before it was done: {why}.", { why: endingSaid(assessment.abort) }),
        ),
      reckoning(assessment),
      section(t("To work on next time"), wrong.slice(0, kToWorkOn).map(row)),
      section(t("Also missed"), wrong.slice(kToWorkOn).map(row)),
      section(others ? t("What was done") : t("What you did"), did.map(row)),
      section(others ? t("What was kept") : t("What you kept"), kept.map(row)),
      ...neverAs.map((said) =>
        section(
          capital(said),
          never
            .filter((one) => stateSaid(one) === said)
            .map((one) => h("li", {}, capital(spaced(one.code)), whyItMatters(one))),
        ),
      ),
      section(
        t("What was to be learnt"),
        assessment.objectives.map((each) =>
          h(
            "li",
            { "data-outcome": each.outcome },
            each.text || spaced(each.id),
            h("span", { class: "quiet" }, headline(each)),
          ),
        ),
      ),
      rule && h("p", { class: "quiet" }, rule),
      section(
        t("Hints"),
        hints.map(({ tick, text, criterion }) =>
          h(
            "li",
            {},
            `${at(tick)} `,
            h("span", { lang: "en" }, text),
            criterion && h("span", { class: "quiet" }, spaced(criterion)),
          ),
        ),
      ),
      section(t("Orders"), this.orders(assessment)),
      section(
        reportsBy(this.link.hello?.seat),
        assessment.reports.map((report) => {
          const { tick, code, criterion, milli, timed, delay, text } = report;
          const asked = reportRows[code];
          const said = saidIn(this.log, report) ?? asked?.label ?? asked?.said ?? "";
          return h(
            "li",
            { "data-right": milli >= kFull ? "" : undefined },
            h("span", {}, `${at(tick)} `, h("span", { lang: "en" }, said), `: ${rightWords(milli)}`),
            h(
              "span",
              { class: "quiet" },
              [timed && delayWords(delay), !criterion && t("costs no points")].filter(Boolean).join(", "),
            ),
            text && h("span", { class: "quiet", lang: "en" }, inChosenUnits(text)), // the judge speaks English
          );
        }),
      ),
    ];
    this.body.replaceChildren(...parts.filter((part) => part instanceof HTMLElement));
  }

  private orders(assessment: Assessment): HTMLElement[] {
    const run = this.link.latest("ExerciseStatus")?.run;
    const given = this.link.all("BridgeOrder").filter((order) => order.run === run);
    return assessment.orders.flatMap(({ number, tick }) => {
      const order = given.find((each) => each.number === number);
      if (!order) return [];
      const done = tick > 0 ? (tick * assessment.time) / assessment.tick : undefined;
      const came = orderDone(order, done);
      return [h("li", {}, `${clock(order.time)} ${written(order)}`, h("span", { class: "quiet" }, came))];
    });
  }
}

const reportsBy = (seat: Seat | undefined): string =>
  seat === "forecastle" || seat === "trainee" ? t("Your reports") : t("Reports of the forecastle");

/** What came of an order. done: s of exercise, when it was carried out; undefined: it was not. */
export function orderDone({ state, time }: Pick<BridgeOrder, "state" | "time">, done: number | undefined): string {
  if (done === undefined)
    return state === BridgeOrderState.ORDER_CANCELLED ? saidOf("BridgeOrderState", state) : t("not carried out");
  return done < time
    ? t("so already at {time}", { time: clock(done) })
    : t("carried out {time}", { time: clock(done) });
}

const spaced = (code: string): string => code.replace(/[_-]/g, " ");

/** Why the points of the list do not add up to those of the whole; nothing where they do. */
function reckoning(assessment: Assessment): HTMLElement | false {
  const { kept } = wentWell(assessment.criteria);
  const why = whyHalved(assessment);
  const rules = [
    kept.length > 0 &&
      toWorkOn(assessment.criteria).length > 0 &&
      t("What was kept counts in the measure in which the rest was done, and the points in play make up 100."),
    why.length > 0 && t("Points are halved, since {why}.", { why: why.join("; ") }),
  ].filter((rule) => rule !== false);
  return rules.length > 0 && h("p", { class: "quiet" }, rules.join(" "));
}

/** Nothing without rows. */
function section(title: string, rows: HTMLElement[]): HTMLElement | false {
  return rows.length > 0 && h("section", {}, h("h3", {}, title), h("ul", {}, ...rows));
}

/**
 * A reason without what it cost, as the debriefing has it: the points beside it say that, and in the reader's figures,
 * where the judge's sentence has English ones.
 */
export const withoutCost = (reason: string): string =>
  reason.replace(/(?:^|: )(?:all of its|[\d.]+ % of its) points lost/, "");

/** Its reason begins with the moment at which it went wrong. Points are those of the debriefing. */
function criterionRow(criterion: Criterion, assessment: Assessment): HTMLElement {
  const points = shareSaid(criterion, criterion.counted, assessment);
  const reason = withoutCost(criterion.reason);
  return h(
    "li",
    { "data-met": criterion.met ? "" : undefined },
    `${capital(spaced(criterion.code))}${criterion.must ? ` ${t("(must)")}` : ""}: ${points}`,
    reason && h("span", { lang: "en" }, inChosenUnits(reason)),
    whyItMatters(criterion),
  );
}

const whyItMatters = ({ text }: Criterion): HTMLElement | string =>
  text && h("span", { class: "quiet", lang: "en" }, inChosenUnits(text));
