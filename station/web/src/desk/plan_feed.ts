// The plan as the instructor sees it: ship and cables as they are, her track, anchors now and where they were let go.

import { everySecond } from "../kit/page";
import { layChart } from "../plan/chart";
import { waterline } from "../plan/hull_outline";
import type { PlanCircle, PlanLine, PlanMark } from "../plan/picture";
import { PlanView } from "../plan/plan_view";
import type { Connection } from "../wire/connection";
import {
  AnchorPhase,
  type AnchorState,
  type Event,
  type Prediction,
  type ShipState,
  type TopicName,
  type TopicTypes,
} from "../wire/generated";
import type { EventStore } from "./events";
import { LetGoPlace, type Passed } from "./let_go_place";
import { t } from "../kit/language";

const kTrack = 1800; // s that are kept
const kStep = 2; // s between two points of the track

/** Points of the recent past of one body; when time goes back, what was after it is dropped. */
class Trail {
  private readonly points: Passed[] = [];

  add(time: number, x: number, y: number, apart: number): void {
    while (this.points.length > 0 && this.points.at(-1)!.time > time) this.points.pop();
    const last = this.points.at(-1);
    if (last && (time < last.time + kStep || Math.hypot(x - last.x, y - last.y) < apart)) return;
    this.points.push({ time, x, y });
    while (this.points.length > 0 && this.points[0]!.time < time - kTrack) this.points.shift();
  }
  clear(): void {
    this.points.length = 0;
  }
  line(): Float64Array {
    return Float64Array.from(this.points.flatMap(({ x, y }) => [x, y]));
  }
}

const isDown = (phase: AnchorPhase): boolean =>
  phase >= AnchorPhase.ANCHOR_ON_BOTTOM && phase <= AnchorPhase.ANCHOR_DRAGGING;

export class PlanFeed {
  readonly view: PlanView;
  private readonly track = new Trail();
  private readonly trails = [new Trail(), new Trail()];
  private readonly letGo = [new LetGoPlace(), new LetGoPlace()];
  private outline: Float32Array | undefined;
  private length = 0; // m

  constructor(
    container: HTMLElement,
    private readonly link: Connection,
    events: EventStore,
    private readonly ahead: () => Prediction | undefined,
  ) {
    this.link.latest("ChainState", 0); // asked for from the beginning, not when a cable is first drawn
    this.view = new PlanView(container);
    link.on("SceneDescription", (scene) => {
      this.outline = waterline(scene.hull_corners, scene.hull_triangles);
      this.length = scene.length_overall;
    });
    layChart(link, this.view);
    events.onChange((event) => event && this.hear("Event", event));
    // By the samples' times: those of the past come all at once.
    link.on("ShipState", (ship) => this.hear("ShipState", ship));
    link.on("AnchorState", (anchor) => this.hear("AnchorState", anchor));
    everySecond(4, () => this.update());
  }

  /** Nothing of what is drawn over time has been. */
  forget(): void {
    for (const trail of [this.track, ...this.trails]) trail.clear();
    for (const place of this.letGo) place.forget();
  }

  /** A sample of now or of the past. */
  hear<T extends TopicName>(topic: T, sample: TopicTypes[T]): void {
    if (topic === "ShipState") {
      const { time, position } = sample as ShipState;
      this.track.add(time, position.x, position.y, 0.5);
    } else if (topic === "AnchorState") {
      const { side, time, phase, position } = sample as AnchorState;
      this.letGo[side]!.passed({ time, x: position.x, y: position.y });
      if (isDown(phase)) this.trails[side]!.add(time, position.x, position.y, 0.5);
      else this.trails[side]!.clear();
    } else if (topic === "Event") {
      const { code, side, time } = sample as Event;
      if (code === "anchor.let_go") this.letGo[side]!.at(time);
    }
  }

  private update(): void {
    const ship = this.link.latest("ShipState");
    if (!ship) return;
    const { x, y } = ship.position;
    const lines: PlanLine[] = [{ kind: "track", points: this.track.line() }];
    const marks: PlanMark[] = [];
    const circles: PlanCircle[] = [];
    const ahead = this.ahead()?.moments.flatMap((moment) => [moment.x, moment.y]) ?? [];
    for (const side of [0, 1]) this.addSide(side, ship.time, lines, marks, circles);
    const environment = this.link.latest("EnvironmentState")?.now;
    this.view.update({
      ship: {
        x,
        y,
        heading: ship.heading,
        outline: this.outline,
        course: ship.course_over_ground,
        speed: ship.speed_over_ground,
      },
      lines,
      ahead,
      marks,
      circles,
      ...(environment && {
        wind: { direction: environment.wind_from, speed: environment.wind_speed },
        stream: { direction: environment.current_towards, speed: environment.current_speed },
      }),
    });
  }

  private addSide(side: number, time: number, lines: PlanLine[], marks: PlanMark[], circles: PlanCircle[]): void {
    const name = side === 0 ? t("P|port") : t("S|starboard");
    const chain = this.link.latest("ChainState", side);
    const anchor = this.link.latest("AnchorState", side);
    if (!chain || !anchor || anchor.phase <= AnchorPhase.ANCHOR_ACOCKBILL) return;
    lines.push({ kind: "cable", points: flat(chain.nodes) });
    lines.push({ kind: "trail", points: this.trails[side]!.line() });
    marks.push({ kind: "anchor", x: anchor.position.x, y: anchor.position.y, label: name });
    const mark = this.letGo[side]!.asOf(time);
    if (mark) marks.push({ kind: "landmark", x: mark.x, y: mark.y, label: t("{side} let go", { side: name }) });
    // Where she may swing: all cable that is out, straight, and her length.
    if (isDown(anchor.phase))
      circles.push({
        id: `swing ${side}`,
        kind: "swing",
        x: anchor.position.x,
        y: anchor.position.y,
        radius: chain.cable_out + this.length,
        label: t("{side} swing", { side: name }),
      });
  }
}

/** x, y of points x, y, z. */
function flat(points: Float32Array): Float32Array {
  const plane = new Float32Array((points.length / 3) * 2);
  for (let i = 0; 3 * i < points.length; ++i) {
    plane[2 * i] = points[3 * i]!;
    plane[2 * i + 1] = points[3 * i + 1]!;
  }
  return plane;
}
