// Feeds the plan with what the bridge knows: GPS and gyro, the chart, her own plotted anchors and circles.

import { layChart } from "../plan/chart";
import type { PlanCircle, PlanMark } from "../plan/picture";
import type { PlanView } from "../plan/plan_view";
import { waterline } from "../plan/hull_outline";
import { clock, sideWord } from "../kit/units";
import type { Connection } from "../wire/connection";
import type { BridgeView } from "../wire/generated";
import { type AnchorPlot, shipOf } from "./anchor_plot";
import { windOf } from "./instruments";
import { Kept } from "./kept";
import type { WatchPanel } from "./watch_panel";
import { t } from "../kit/language";

const kTrack = 1800; // s
const kApart = 4; // s between two points of the track
const kStore = 20; // points, after which the track is kept

/** The track as it was at that time, s. */
function trackUpTo(track: number[], time: number): number[] {
  let length = track.length;
  while (length > 0 && track[length - 3]! > time) length -= 3;
  return length === track.length ? track : track.slice(0, length);
}

export class PlanFeed {
  private outline: Float32Array | undefined;
  private readonly kept: Kept<number[]>; // time, x, y one behind the other
  private track: number[] = [];
  private unstored = 0;
  private shown = ""; // what was given to the plan last

  constructor(
    link: Connection,
    private readonly plan: PlanView,
    private readonly anchors: AnchorPlot,
    private readonly watch: WatchPanel,
  ) {
    this.kept = new Kept<number[]>(link, "track", () => [], trackUpTo);
    this.kept.onChange((track) => (this.track = track));
    link.on("SceneDescription", (scene) => (this.outline = waterline(scene.hull_corners, scene.hull_triangles)));
    layChart(link, plan);
    link.on("BridgeView", (view) => this.follow(view));
    plan.onCircle((id, radius) => id === "watch" && watch.setRadius(radius));
  }

  private follow(view: BridgeView): void {
    this.addToTrack(view);
    const ship = view.gps_works && view.gyro_works;
    const marks = this.marks();
    const circles = this.circles();
    const wind = this.wind(view);
    const { position, heading, course_over_ground, speed_over_ground } = view;
    const now = JSON.stringify([
      ship && [position, heading, course_over_ground, speed_over_ground, this.outline?.length],
      [marks, circles, wind, this.track.at(-3), this.track.length],
    ]);
    if (now === this.shown) return; // a ship at rest is not drawn again
    this.shown = now;
    this.plan.update({
      // Without gyro or GPS her last place would be a lie.
      ship: ship
        ? {
            ...shipOf(view),
            outline: this.outline,
            course: course_over_ground,
            speed: speed_over_ground,
          }
        : undefined,
      lines: [{ kind: "track", points: this.track.filter((_, k) => k % 3 !== 0) }],
      marks,
      circles,
      wind,
    });
  }

  private wind(view: BridgeView): { direction: number; speed: number } | undefined {
    const wind = windOf(view);
    const degree = Math.PI / 180;
    return wind && { direction: Math.round(wind.from / degree) * degree, speed: Math.round(wind.speed * 10) / 10 };
  }

  private addToTrack(view: BridgeView): void {
    this.track = trackUpTo(this.track, view.time); // a restore: what lies after it has not happened
    const last = this.track.at(-3);
    if (!view.gps_works || (last !== undefined && view.time < last + kApart)) return;
    this.track.push(view.time, view.position.x, view.position.y);
    while (this.track[0]! < view.time - kTrack) this.track.splice(0, 3);
    if (++this.unstored < kStore) return;
    this.unstored = 0;
    this.kept.value = this.track;
  }

  private marks(): PlanMark[] {
    return ([0, 1] as const).flatMap((side): PlanMark[] => {
      const { place, time } = this.anchors.of(side);
      return place
        ? [
            {
              kind: "anchor",
              ...place,
              label: t("{side} let go {time}", { side: sideWord(side), time: clock(time ?? 0) }),
            },
          ]
        : [];
    });
  }

  private circles(): PlanCircle[] {
    const watch = this.watch.circle();
    const swinging = ([0, 1] as const).flatMap((side): PlanCircle[] => {
      const { place } = this.anchors.of(side);
      const swing = this.anchors.swing(side);
      const drag = this.anchors.drag(side);
      if (!place || !swing || !drag) return [];
      return [
        { id: `swing${side}`, kind: "swing", ...place, radius: swing, label: t("swinging") },
        { id: `drag${side}`, kind: "drag", ...place, radius: drag, label: t("drag|circle") },
      ];
    });
    return watch ? [...swinging, watch] : swinging;
  }
}
