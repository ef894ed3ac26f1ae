// What the bridge sees of the forecastle, by its camera there and, far away, out of its windows: windlasses and men as
// ForecastleCamera has them, on the ship as the bridge's instruments have her. Nothing where the camera has failed.

import { type SeenBefore, nothingSeen, tackleSeen } from "../scene/from_seat";
import type { SceneFrame, TackleFrame } from "../scene/frame";
import type { Samples } from "../scene/from_truth";
import type { LookingOut } from "./from_bridge";

export class CameraPicture {
  /** At which men are seen. */
  readonly worked = new WorkedWindlass();
  private time = NaN; // s, exercise time of the last frame
  private readonly seen: SeenBefore = nothingSeen();

  constructor(private readonly out: LookingOut) {}

  /** now: ms of performance.now(). Undefined before anything is heard. */
  frame(link: Samples, now: number): SceneFrame | undefined {
    const around = this.out.frame(link, now);
    if (!around || link.latest("BridgeView")?.cctv_works === false) return around;
    const since = around.time - this.time;
    const seconds = since >= 0 && since < 1 ? since : undefined;
    this.time = around.time;
    const tackle = [0, 1].map((side) => tackleSeen(link, "ForecastleCamera", side, around.time, this.seen, seconds));
    this.worked.see(tackle);
    return { ...around, tackle };
  }
}

/** Which windlass is worked, by what is seen of both: where a lever was moved last, or the cable moves. */
export class WorkedWindlass {
  /** Undefined: nothing was moved yet. */
  side: number | undefined;
  private readonly levers = new Map<number, string>();

  see(tackle: readonly (TackleFrame | undefined)[]): void {
    for (const t of tackle) {
      if (!t) continue;
      const now = [t.brake, t.speed_lever, t.clutch, t.stopper_closed].join();
      const before = this.levers.get(t.side) ?? now;
      this.levers.set(t.side, now);
      if (now !== before || t.cable_speed !== 0) this.side = t.side;
    }
  }
}
