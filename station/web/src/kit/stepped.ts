// A figure that is typed, and buttons that add to it.

import { typedFigure, writtenFigure } from "./language";

/** A typed figure with the step added, in as many decimals as they have: 5.5 and 0.5 make "6". */
export function stepped(typed: string, step: number): string {
  const from = Number(typedFigure(typed)) || 0;
  const decimals = Math.max(...[typed, `${step}`].map((text) => typedFigure(text).split(".")[1]?.length ?? 0));
  return writtenFigure(`${Number((from + step).toFixed(Math.min(decimals, 6)))}`);
}
