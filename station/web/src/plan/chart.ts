// What is charted of the anchorage, laid on a plan: the same for a bridge and for the instructor's desk.

import { soilLetter } from "../kit/words";
import type { Connection } from "../wire/connection";
import type { PlanView } from "./plan_view";

/** Soundings with their soil, of which the plan draws contours, and what stands round the anchorage. */
export function layChart(link: Connection, plan: PlanView): void {
  link.on("Chart", ({ soundings }) =>
    plan.update({
      soundings: soundings.map((s) => ({ x: s.x, y: s.y, depth: s.depth, letter: soilLetter(s.soil) })),
    }),
  );
  link.on("Landmarks", (landmarks) => plan.update({ landmarks }));
}
