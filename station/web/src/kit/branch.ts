// Branches of time: a set-up, a reset or a restore leaves what came after its moment. What is told of that has not
// happened, and is struck out wherever it stands.

import { t } from "./language";
import { clock } from "./units";

/** An event, as far as it tells of a branch. */
interface Told {
  code: string;
  time: number; // s, exercise time
}

/** Whether an event begins another branch, at its time. */
export const begins = ({ code }: Told): boolean => /^exercise\.(ready|loaded|reset|restored)$/.test(code);

/** What is said of one that was left. */
export const kLeft = t("in a branch that was left");

/** Marks those of a log that lie after the moment at which an event begins another branch. */
export function leave(log: Iterable<{ time: number; left: boolean }>, event: Told): void {
  for (const other of log) if (other.time > event.time) other.left = true;
}

/**
 * Orders that were given before the moment from which the exercise goes on, somewhere else, as in a recording: they are
 * told with it, and what was said to them is not. Of a question among them nobody here knows whether it was answered.
 */
export class Before {
  private from = -Infinity; // s, of that moment
  private readonly given = new Set<string>(); // that were heard here

  /** All of the log comes again. */
  clear(): void {
    this.from = -Infinity;
    this.given.clear();
  }

  hear(event: Told & { value: number }): void {
    if (event.code === "order.given") this.given.add(`${event.value} ${event.time}`);
    if (begins(event)) this.from = event.code === "exercise.restored" ? event.time : -Infinity;
  }

  has({ number, time }: { number: number; time: number }): boolean {
    return time <= this.from && !this.given.has(`${number} ${time}`);
  }

  /** What is said of a question among them; empty: it is none. */
  said(question: { number: number; time: number }): string {
    if (!this.has(question)) return "";
    return t("asked before {time}, from where this goes on; whether it was answered is not told here", {
      time: clock(this.from),
    });
  }
}
