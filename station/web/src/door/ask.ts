// What pages of the door ask it, and do there. docs/class.md has the list.

import type { RunState } from "../wire/generated";
import type { Asking } from "../kit/asks_in_vain";
import { t } from "../kit/language";
import { clock } from "../kit/units";
import { doorSaid } from "./door_sentences";

/** Why the door did not. */
export class Denied extends Error {
  constructor(
    readonly status: number,
    text: string,
  ) {
    super(text);
  }
}

/** Whose browser this is. */
export interface Me {
  who: "nobody" | "staff" | "trainee" | "kiosk";
  /** The first owner is not set up yet. */
  setup: boolean;
  own_authority: boolean;
  fingerprint: string;
  authority_fingerprint: string;
  name?: string;
  rank?: "owner" | "instructor" | "assessor" | "observer";
  class?: string;
  exercise?: string;
  place?: PlaceName;
  /** Of a kiosk: which exercise of a class. */
  number?: number;
  /** Of a browser that a learning system has sent. */
  launch?: Launch;
}

export interface Launch {
  state: "under_way" | "marking" | "done";
  lesson: string;
  name: string;
  /** False: to look around. */
  counts: boolean;
  verdict: "passed" | "failed" | "";
  points: number | null;
  /** The learning system has not heard all of it yet. */
  waits: boolean;
  /** Address to go back to; empty: none. */
  back: string;
  /** That the learner prefers, "de-DE,en"; told once, at the launch. */
  languages?: string;
}

/** What somebody is to practise next, by the history. */
export interface Next {
  name: string;
  /** A class is opened with it. */
  file: string;
  title: string;
  why: string;
  practice: boolean;
  /** The attempt of which that is; null: of none. */
  after: After | null;
  /** From when his last attempt, which went wrong, is done again; null: nothing to go on from. */
  from: From | null;
  /** Why there is nothing, where it is for practice; else empty. */
  no_from: string;
}

/** Of a lesson that somebody is to do. */
export type ToDo = Pick<Next, "name" | "file" | "practice">;

/** An attempt at a lesson. */
export interface After {
  /** "L02". */
  lesson: string;
  recording: string;
  /** UTC: "2026-11-30T09:12:20Z". */
  began_at: string;
}

/** A moment of a recording. */
export interface From {
  recording: string;
  /** s from its beginning. */
  position: number;
  /** s of exercise. */
  time: number;
  /** What comes next: a hand that took the levers, an order, the time that it had, the loss. */
  before: "levers" | "order" | "due" | "loss";
  /** After so many: ten, or fewer where the attempt began sooner. */
  seconds: number;
  /** What was lost by that. */
  lost: string;
  /** s of exercise. */
  lost_at: number;
  /** What else had gone wrong by then: it goes on as it stood. */
  standing: string[];
}

/** A class that goes on from there, each where he sat. */
export interface Again extends From {
  /** Of the class before, whose recording that is. */
  exercise: string;
  crew: number;
  places: Record<string, PlaceName>;
}

/** An assessor's word on an attempt of a class that is over. */
export interface Word {
  recording: string;
  /** 0..100; null: nothing was assessed. */
  points: number | null;
  outcome: string;
  by: string;
  note: string;
}

export interface Words {
  words: Word[];
}

/** Of who sat in a class that is over; waits: attempts are not in the history yet. */
export interface NextOfClass extends Words {
  waits: boolean;
  next: Next[];
}

export type PlaceName = "ship" | "forecastle" | "bridge" | "watch";
export const placeWords: Readonly<Record<PlaceName, string>> = {
  ship: t("both|seat"),
  forecastle: t("forecastle"),
  bridge: t("bridge"),
  watch: t("watch|seat"),
};

export interface Seat {
  place: PlaceName;
  name: string | null;
  /** Its pages are open. */
  here: boolean;
  /** s for which its hand has done nothing; null: nobody is here. */
  silent: number | null;
  /** Something was done since the page was opened. */
  acted: boolean;
}

/** Whose work an exercise was, of one seat of it. */
export interface Part {
  name: string;
  place: PlaceName;
  /** s of exercise; null: from its beginning. */
  since: number | null;
  /** s of exercise; null: to its end. */
  until: number | null;
  /** The marks are of what is done there; else of another seat. */
  judged: boolean;
}

/** "to 4:00"; empty: all of it. */
export function partWords({ since, until }: Part): string {
  if (since !== null && until !== null)
    return t("from {since} to {until}", { since: clock(since), until: clock(until) });
  if (since !== null) return t("from {time}", { time: clock(since) });
  return until === null ? "" : t("to {time}", { time: clock(until) });
}

export interface ClassExercise {
  exercise: string;
  /** RunState, as it was told last; null: no server has it yet. */
  state: RunState | null;
  time: number;
  /** A server tells of it now: else it was lost with its server, or is being made. */
  heard: boolean;
  seats: Seat[];
  /** Who worked in it: who sits there, and who did and was relieved. */
  parts: Part[];
  /** Its recording's name; empty: none was made. */
  recording: string;
  /** Why the lesson ended before it was done; empty: it did not, or somebody ended it. */
  abort: string;
  /** 0..100; null: it is not marked. */
  points: number | null;
  /** The same, while points are of what is decided so far; null: it is marked to the end, or not at all. */
  lost: number | null;
  /** 0..100, that its lesson needs; null: it is not marked. */
  pass: number | null;
  /** achieved, not_yet, not_shown; empty: not marked to the end. */
  outcome: string;
  /** What the lesson's bridge waits for in vain; null: it waits for no answer. */
  asking: Asking | null;
  /** It holds for a question to one of its seats. */
  asked: boolean;
  /** Why it is not there yet, does not stand at its moment, or is not recorded; empty: nothing is wrong. */
  trouble: string;
}

export interface TrainingClass {
  id: string;
  lesson: string;
  /** Played with its hints, and no test. */
  practice: boolean;
  /** Empty: it is good no longer. */
  code: string;
  crew: number;
  /** A trainee on the bridge leads, and the forecastle does as it is ordered. */
  bridge_judged: boolean;
  until: number;
  /** Its seats and its code are nobody's any more. */
  over: boolean;
  /** How many words assessors have given on its attempts since the door was started. */
  words: number;
  exercises: ClassExercise[];
}

export interface Classes {
  classes: TrainingClass[];
  servers: number;
  /** Under which people reach this machine. */
  names: string[];
  /** Where they do, by TLS. */
  port: number;
}

export interface ExerciseFile {
  name: string;
  title: string;
  /** Its id; null: there is none in it. */
  lesson: string | null;
  /** An accident's lesson that is made of it. */
  taught_as: string | null;
  /** It is played by two at least. */
  bridge_judged: boolean;
}

/** Exercise files. */
export interface Lessons {
  files: ExerciseFile[];
}

async function answered<T>(answer: Response): Promise<T> {
  if (!answer.ok) throw new Denied(answer.status, doorSaid((await answer.text()).trim()));
  return (await answer.json()) as T;
}

/** Throws Denied, or what fetch throws where nobody answers. */
export const ask = async <T>(question: string): Promise<T> =>
  answered(await fetch(`/door/${question}`, { cache: "no-store" }));
export const act = async <T>(what: string, body: Record<string, unknown>): Promise<T> =>
  answered(
    await fetch(`/door/${what}`, {
      method: "POST",
      headers: { "Content-Type": "application/json" },
      body: JSON.stringify(body),
    }),
  );
