// Forces as arrows over the instructor's scene: what pulls at each cable, and what holds it, from what the desk hears.
// Wind and stream have their speed: what they press on the ship is on no topic. An arrow is as long on the screen as
// its force is large, against the largest of the moment, wherever one looks from; it is drawn over what stands before
// it.

import { units } from "../../../../words/words.json";
import { h } from "../kit/dom";
import { t } from "../kit/language";
import { figure, knots, loads, scaleEnd, sideWord, unitWritten } from "../kit/units";
import { type Stroke, label, line } from "../plan/pen";
import type { SceneFrame, TackleFrame } from "../scene/frame";
import type { ShipScene } from "../scene/ship_scene";
import { type V3, along, level, scale, sub, unit, vec } from "../scene/vec";
import type { Connection } from "../wire/connection";
import { AnchorPhase, type WindlassLoad } from "../wire/generated";

const kLeast = 500; // N, below which there is nothing to show
const kReach = 0.2; // of the distance from the eye, that the longest is long
const kShortest = 0.2; // of the longest, so that it is seen which way it points
const kFlow = 0.55; // of the longest: of wind and stream, which are no loads
const kHead = 11; // px
const kLine = 19; // px from one label to the next
const kGround = "#10161c"; // round arrows and words: they are read over sky, sea and steel

/** What pulls, what holds, what flows: told apart in grey, and by eyes that do not tell red from green (Okabe, Ito). */
const kInks: Record<"pulls" | "holds" | "flows", Stroke> = {
  pulls: { colour: "#e69f00" },
  holds: { colour: "#56b4e9" },
  flows: { colour: "#f2f2f2", dash: [9, 5] },
};

/** One arrow. */
export interface Force {
  ink: keyof typeof kInks;
  words: string;
  /** N; undefined: it is no load. */
  load?: number;
  /** Where it acts, m, and its direction, unit vector; in the frame of the world or of the ship's body. */
  at: V3;
  towards: V3;
  frame: "world" | "ship";
}

/** What acts on one side's cable, where so much of it is heard that it can be drawn. */
function ofTackle(scene: ShipScene, load: WindlassLoad, { side, nodes }: TackleFrame): Force[] {
  const gear = scene.gear(side);
  if (!gear) return [];
  const found: Force[] = [];
  const add = (ink: Force["ink"], name: string, value: number, at: V3, towards: V3, frame: Force["frame"]): void => {
    if (Math.abs(value) < kLeast) return;
    const words = `${sideWord(side)}: ${name} ${loads.text(Math.abs(value))}`;
    found.push({ ink, words, load: Math.abs(value), at, towards: value < 0 ? scale(-1, towards) : towards, frame });
  };
  const node = (i: number): V3 => [nodes[3 * i]!, nodes[3 * i + 1]!, nodes[3 * i + 2]!];
  if (nodes.length >= 6)
    add("pulls", t("cable at the hawse"), load.hawse_tension, node(0), unit(sub(node(1), node(0))), "world");
  add("holds", t("stopper holds"), load.stopper_load, gear.stopper, gear.stopperLead, "ship");
  const top = along(gear.gypsy, gear.radius, [0, 0, 1]);
  add("holds", t("brake holds"), load.brake_load, top, gear.lead, "ship");
  add("holds", t("motor holds"), load.motor_load, along(top, 0.5, gear.out), gear.lead, "ship");
  return found;
}

/** All forces of the moment that is drawn. */
export function forces(link: Connection, scene: ShipScene, frame: SceneFrame): Force[] {
  const found: Force[] = [];
  for (const tackle of frame.tackle) {
    if (!tackle) continue;
    const load = link.latest("WindlassLoad", tackle.side);
    if (load) found.push(...ofTackle(scene, load, tackle));
    const anchor = link.latest("AnchorState", tackle.side);
    if (!anchor || anchor.holding_used < kLeast || anchor.phase >= AnchorPhase.ANCHOR_AWEIGH) continue;
    const away = level(sub(vec(anchor.shackle), [tackle.nodes[0] ?? 0, tackle.nodes[1] ?? 0, 0]));
    const words = t("{side}: ground holds {load} of {most}", {
      side: sideWord(tackle.side),
      load: loads.text(anchor.holding_used),
      most: loads.text(anchor.holding_capacity),
    });
    found.push({
      ink: "holds",
      words,
      load: anchor.holding_used,
      at: vec(anchor.position),
      towards: away,
      frame: "world",
    });
  }
  const flow = (name: string, speed: number, towards: number, at: V3): void => {
    const words = `${name} ${figure(knots(speed), 1)} ${unitWritten(units.knot)}`;
    if (speed > 0.05)
      found.push({ ink: "flows", words, at, towards: [Math.sin(towards), Math.cos(towards), 0], frame: "world" });
  };
  const { x, y, heading } = frame.ship;
  const ahead = (distance: number, up: number): V3 => [
    x + distance * Math.sin(heading),
    y + distance * Math.cos(heading),
    up,
  ];
  const half = 0.5 * (link.latest("SceneDescription")?.length_overall ?? 0);
  flow(t("wind"), frame.wind_speed, frame.wind_from + Math.PI, ahead(half + 12, 18));
  if (frame.current) flow(t("stream"), frame.current.speed, frame.current.towards, ahead(half + 12, 0));
  return found;
}

/** A canvas over the scene's. */
export class ForceArrows {
  readonly element = h("canvas", { class: "forces", "aria-hidden": "true" });

  /** What the scene has drawn last, with these over it. */
  draw(scene: ShipScene, all: readonly Force[]): void {
    const { clientWidth: width, clientHeight: height } = this.element;
    const ratio = devicePixelRatio || 1;
    this.element.width = Math.max(1, Math.round(width * ratio));
    this.element.height = Math.max(1, Math.round(height * ratio));
    const c = this.element.getContext("2d");
    if (!c) return;
    c.scale(ratio, ratio);
    c.font = getComputedStyle(this.element).font;
    const end = scaleEnd(Math.max(...all.map(({ load }) => load ?? 0)));
    const named: { words: string; x: number; y: number; wide: number; colour: string }[] = [];
    for (const { ink, words, load, at, towards, frame } of all) {
      const from = scene.onCanvas(at, frame);
      if (!from) continue;
      const share = load === undefined ? kFlow : Math.max(kShortest, load / end);
      const to = scene.onCanvas(along(at, kReach * from.far * share, towards), frame);
      if (!to || Math.max(from.x, to.x) < 0 || Math.min(from.x, to.x) > width) continue;
      if (Math.max(from.y, to.y) < 0 || Math.min(from.y, to.y) > height) continue;
      const how: Stroke = { width: 4, ...kInks[ink] };
      line(c, from, to, { width: 7, colour: kGround });
      line(c, from, to, how);
      head(c, from, to, how.colour);
      const wide = c.measureText(words).width;
      const beside = to.x < from.x ? -wide - 2 * kHead : 2 * kHead;
      named.push({
        words,
        x: Math.min(Math.max(to.x + beside, 4), width - wide - 4),
        y: Math.min(Math.max(to.y, kLine), height - kLine),
        wide,
        colour: how.colour,
      });
    }
    // Over all arrows, and each below those above it that it would lie on.
    named.sort((a, b) => a.y - b.y);
    named.forEach((name, k) => {
      for (const above of named.slice(0, k))
        if (name.y - above.y < kLine && above.x < name.x + name.wide && name.x < above.x + above.wide)
          name.y = above.y + kLine;
      label(c, name.words, name, name.colour, kGround);
    });
  }
}

function head(c: CanvasRenderingContext2D, from: { x: number; y: number }, to: typeof from, colour: string): void {
  const long = Math.hypot(to.x - from.x, to.y - from.y) || 1;
  const [ax, ay] = [(to.x - from.x) / long, (to.y - from.y) / long];
  c.beginPath();
  c.moveTo(to.x + kHead * ax, to.y + kHead * ay);
  for (const side of [1, -1])
    c.lineTo(to.x - 0.3 * kHead * ax - side * 0.7 * kHead * ay, to.y - 0.3 * kHead * ay + side * 0.7 * kHead * ax);
  c.closePath();
  c.lineWidth = 3;
  c.strokeStyle = kGround;
  c.stroke();
  c.fillStyle = colour;
  c.fill();
}
