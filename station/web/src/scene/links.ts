// Where the links of a cable are. The cable is counted unstretched from the anchor shackle: link j covers
// [4 d j, 4 d (j + 1)], even ones lie flat in the gypsy's pockets, odd ones stand on edge. So links neither slip on
// the gypsy nor jump between frames.

import { kShackle } from "../kit/units";
import type { TackleFrame } from "./frame";
import { CablePath } from "./path";
import { type Rig, kPitch } from "./rig";
import { type ShipPose, wrap } from "./vec";

export enum LinkKind {
  plain = 0,
  white = 1,
  joining = 2,
  warning = 3,
}

/**
 * m of cable outboard: as known, else the value nearest to what is in sight of marks and anchor that agrees with the
 * gypsy, which the cable passes 8 d at a time without a difference. NaN where nothing in sight tells: then only the
 * links' places are known, not their numbers.
 */
export function cableOut(tackle: TackleFrame, rig: Rig, drawn: number): number {
  if (tackle.cable_out !== undefined) return tackle.cable_out;
  const two = 2 * kPitch * rig.d;
  const phase = linkPhase(tackle, rig);
  const near = (about: number): number => about + wrap(phase - about + two / 2, two) - two / 2;
  const mark = tackle.marks[0];
  if (mark) return near(mark.shackle * kShackle + mark.outboard);
  if (tackle.anchor && tackle.nodes.length > 3) return near(drawn);
  return NaN;
}

/** m, 0 <= phase < 8 d: cable outboard, modulo two links. */
export function linkPhase(tackle: TackleFrame, rig: Rig): number {
  const out = tackle.cable_out ?? tackle.gypsy_turn * rig.radius + (tackle.jumped ?? 0);
  return wrap(out, 2 * kPitch * rig.d);
}

/** The links of one side, for one instant. */
export class Links {
  count = 0;
  /** m, from the origin: middle of each link. */
  middle = new Float32Array(3 * 1200);
  /** Unit vectors: along the link, and across it in its plane. */
  along = new Float32Array(3 * 1200);
  across = new Float32Array(3 * 1200);
  /** LinkKind. */
  kind = new Uint8Array(1200);
  /** m outboard of the lip, of its middle. */
  s = new Float32Array(1200);
  /** Number from the anchor; -1 where not known. */
  number = new Int32Array(1200);
  readonly path = new CablePath();
  /** m of cable outboard, NaN where not known. */
  out = NaN;

  /** rig and frame of one side; origin: m, world, taken off all places. */
  place(rig: Rig, tackle: TackleFrame, pose: ShipPose, origin: readonly number[]): void {
    const drawn = polylineLength(tackle.nodes);
    this.out = cableOut(tackle, rig, drawn);
    const whole = tackle.cable_out !== undefined || tackle.anchor !== undefined;
    this.path.lay(rig, pose, tackle.nodes, origin, whole ? this.out : NaN);
    const pitch = kPitch * rig.d;
    // From the anchor's end (or where the cable passes out of sight) inwards.
    const known = !Number.isNaN(this.out);
    const out = known ? this.out : linkPhase(tackle, rig);
    const first = Math.ceil((out - this.path.end) / pitch - 1e-6);
    const last = Math.floor((out - this.path.begin) / pitch);
    this.hold(Math.max(0, last - first));
    const ends = kEnds;
    let n = 0;
    this.path.place(out - pitch * last, ends, 0);
    for (let j = last - 1; j >= first && n < this.kind.length; --j) {
      const s = out - pitch * (j + 0.5);
      this.path.place(s, kMiddle, 0, kAcross);
      this.path.place(out - pitch * j, ends, 3);
      const ax = ends[3]! - ends[0]!;
      const ay = ends[4]! - ends[1]!;
      const az = ends[5]! - ends[2]!;
      const l = Math.hypot(ax, ay, az) || 1;
      const tx = ax / l;
      const ty = ay / l;
      const tz = az / l;
      // A link is stiff: it lies along the chord, and across is square to it.
      const off = kAcross[0]! * tx + kAcross[1]! * ty + kAcross[2]! * tz;
      let cx = kAcross[0]! - off * tx;
      let cy = kAcross[1]! - off * ty;
      let cz = kAcross[2]! - off * tz;
      const cl = Math.hypot(cx, cy, cz) || 1;
      cx /= cl;
      cy /= cl;
      cz /= cl;
      if (j & 1) {
        const ex = ty * cz - tz * cy;
        const ey = tz * cx - tx * cz;
        cz = tx * cy - ty * cx;
        cx = ex;
        cy = ey;
      }
      const a = 3 * n;
      this.middle[a] = 0.5 * (ends[0]! + ends[3]!);
      this.middle[a + 1] = 0.5 * (ends[1]! + ends[4]!);
      this.middle[a + 2] = 0.5 * (ends[2]! + ends[5]!);
      this.along[a] = tx;
      this.along[a + 1] = ty;
      this.along[a + 2] = tz;
      this.across[a] = cx;
      this.across[a + 1] = cy;
      this.across[a + 2] = cz;
      this.s[n] = s;
      this.number[n] = known ? j : -1;
      this.kind[n] = LinkKind.plain;
      ends.copyWithin(0, 3, 6);
      ++n;
    }
    this.count = n;
    this.firstNumber = n > 0 ? last - 1 : 0;
    if (known) this.paint(tackle, pitch);
  }

  private firstNumber = 0; // of the link at index 0; numbers fall from there

  /** Joining shackles and the links beside them, and the last lengths. */
  private paint(tackle: TackleFrame, pitch: number): void {
    for (const mark of tackle.marks) {
      const joint = Math.round((mark.shackle * kShackle) / pitch - 0.5);
      if (mark.last) this.paintRun(joint + 1, joint + Math.round(kShackle / pitch), LinkKind.warning);
    }
    for (const mark of tackle.marks) {
      const joint = Math.round((mark.shackle * kShackle) / pitch - 0.5);
      this.paintRun(joint, joint, LinkKind.joining);
      this.paintRun(joint + mark.white_links, joint + mark.white_links, LinkKind.white);
      this.paintRun(joint - mark.white_links, joint - mark.white_links, LinkKind.white);
    }
  }

  private paintRun(from: number, to: number, kind: LinkKind): void {
    const begin = Math.max(0, this.firstNumber - to);
    const end = Math.min(this.count - 1, this.firstNumber - from);
    for (let i = begin; i <= end; ++i) this.kind[i] = kind;
  }

  private hold(count: number): void {
    if (count <= this.kind.length) return;
    const room = 2 * count;
    this.middle = new Float32Array(3 * room);
    this.along = new Float32Array(3 * room);
    this.across = new Float32Array(3 * room);
    this.kind = new Uint8Array(room);
    this.s = new Float32Array(room);
    this.number = new Int32Array(room);
  }
}

const kEnds = new Float64Array(6);
const kMiddle = new Float64Array(3);
const kAcross = new Float64Array(3);

/** m, along nodes x y z. */
export function polylineLength(nodes: Float32Array): number {
  let sum = 0;
  for (let i = 3; i + 2 < nodes.length; i += 3)
    sum += Math.hypot(nodes[i]! - nodes[i - 3]!, nodes[i + 1]! - nodes[i - 2]!, nodes[i + 2]! - nodes[i - 1]!);
  return sum;
}
