// Branches of time: a set-up, a reset or a restore leaves what came after its moment. What is told of that has not
// happened, and is struck out wherever it stands.

import { t } from "./language";

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
