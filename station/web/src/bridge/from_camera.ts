// What the bridge's camera on the forecastle shows: the windlasses as ForecastleCamera has them, on the ship as the
// bridge's instruments have her.

import { type SeenBefore, nothingSeen, tackleSeen } from "../scene/from_seat";
import type { SceneFrame } from "../scene/frame";
import type { Connection } from "../wire/connection";
import type { LookingOut } from "./from_bridge";

export class CameraPicture {
  private time = NaN; // s, exercise time of the last frame
  private readonly seen: SeenBefore = nothingSeen();

  constructor(private readonly out: LookingOut) {}

  /** now: ms of performance.now(). Undefined before anything is heard. */
  frame(link: Connection, now: number): SceneFrame | undefined {
    const around = this.out.frame(link, now);
    if (!around) return undefined;
    const since = around.time - this.time;
    const seconds = since >= 0 && since < 1 ? since : undefined;
    this.time = around.time;
    const tackle = [0, 1].map((side) => tackleSeen(link, "ForecastleCamera", side, around.time, this.seen, seconds));
    return { ...around, tackle };
  }
}
