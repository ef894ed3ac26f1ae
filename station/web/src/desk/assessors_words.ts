// The assessor's words as the marks tell them: who set what, why, and when.

import { type Assessment, type Criterion, CriterionKind, CriterionState } from "../wire/generated";

export interface Word {
  by: string;
  note: string;
  /** s of exercise time, at which it was set. */
  time: number;
  /** It was set at some time before that: nobody was here to hear it come. */
  earlier: boolean;
}

/** A word as it was given. */
export interface Said extends Pick<Word, "by" | "note"> {
  criterion: string;
}

/** A criterion's reason, parted: what was computed, and the word beside it. */
export interface Parted extends Pick<Word, "by" | "note"> {
  computed: string;
}

type Judged = Pick<Criterion, "code" | "kind" | "state" | "reason" | "counts" | "counted">;

const kBrief = 2; // s between two marks of a replay, in which nothing was jumped over
const kCut = / \.\.\.$/; // at the end of what the server has cut

/**
 * The server puts a word at the reason's end, as "who: why", and a long one is cut there, with dots: what was given has
 * the whole.
 * undefined: there is none.
 */
export function parted(criterion: Judged, given: readonly Said[] = []): Parted | undefined {
  const { code, kind, state, reason } = criterion;
  if (state !== CriterionState.CRITERION_OVERRIDDEN) return undefined;
  for (const { by, note } of given.filter((said) => said.criterion === code).reverse()) {
    const at = reason.lastIndexOf(`${by}: `);
    const told = at < 0 ? "" : reason.slice(at + by.length + 2).replace(kCut, "");
    if (told && note.startsWith(told)) return { computed: reason.slice(0, at).replace(/; $/, ""), by, note };
  }
  const alone = kind === CriterionKind.CRITERION_RUBRIC; // of which nothing is computed
  const found = (alone ? /^(?:([^:]*); )?([^:;]+): (.*)$/s : /^(?:(.*); )?([^:;]{1,32}): (.*)$/s).exec(reason);
  return found ? { computed: found[1] ?? "", by: found[2]!, note: found[3]! } : undefined;
}

/** The words that stand, and when they came to stand, as far as it was heard here. */
export class AssessorsWords {
  private readonly given: Said[] = [];
  private readonly times = new Map<string, Pick<Word, "time" | "earlier">>(); // by all that is told of a word
  private before: { judged: number; now: number } | undefined; // s, of the marks heard last

  /** A word that was given here, or heard on its way: as it was typed. */
  give(said: Said): void {
    this.given.push(said);
  }

  /** What came meanwhile was not heard: the link was lost, or another server speaks. */
  miss(): void {
    this.before = undefined;
  }

  /** Takes what the marks tell. status: s of exercise time, in which the lesson may be over. */
  take(assessment: Pick<Assessment, "time" | "criteria">, status: number, replay: boolean): void {
    const { before } = this;
    const wentBack = before !== undefined && assessment.time < before.judged;
    const now = wentBack ? assessment.time : status; // which may tell of it later
    const wentOn = before !== undefined && !wentBack && now >= before.now;
    const heard = wentOn && (!replay || now - before.now <= kBrief);
    for (const criterion of assessment.criteria) {
      if (criterion.state !== CriterionState.CRITERION_OVERRIDDEN) continue;
      const known = this.times.get(this.keyOf(criterion));
      if (!known || known.time > now) this.times.set(this.keyOf(criterion), { time: now, earlier: !heard });
    }
    this.before = { judged: assessment.time, now };
  }

  /** The word that stands beside a criterion's mark. */
  of(criterion: Judged): (Word & Parted) | undefined {
    const word = parted(criterion, this.given);
    const time = word && this.times.get(this.keyOf(criterion));
    return time && { ...word, ...time };
  }

  /** What was computed may still change beside it. */
  private keyOf(criterion: Judged): string {
    const { by, note } = parted(criterion) ?? { by: "", note: criterion.reason };
    return JSON.stringify([criterion.code, criterion.counts, criterion.counted, by, note]);
  }
}
