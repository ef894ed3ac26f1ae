// Exercise time as one types it: seconds, M:SS or H:MM:SS.

import { typedFigure } from "../kit/language";

/** s; NaN for what is no time. */
export function seconds(text: string): number {
  const parts = typedFigure(text).split(":");
  if (parts.length > 3 || parts.some((part) => !/^\d+(\.\d+)?$/.test(part))) return NaN;
  return parts.reduce((sum, part) => 60 * sum + Number(part), 0);
}
