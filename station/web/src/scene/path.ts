// The line of a cable from locker to anchor: points, cable along them, and a direction across that does not spin.

import { type Rig } from "./rig";
import { type ShipPose, clamp, shipAxes } from "./vec";

const kSmoothMax = 40 * (Math.PI / 180); // a sharper turn between links stays a corner
const kSmoothMin = 1.5 * (Math.PI / 180);
const kPieces = 4; // of a span that is smoothed

/**
 * Points in the order of the cable, from the locker out. s is m of cable outboard of the lip, negative inboard; what
 * is outboard is measured in unstretched cable where its length is known.
 */
export class CablePath {
  count = 0;
  points: Float64Array = new Float64Array(3 * 512);
  across: Float64Array = new Float64Array(3 * 512);
  s: Float64Array = new Float64Array(512);
  private readonly axes = new Float64Array(9);
  private bare = new Float64Array(3 * 256); // nodes from the lip, before smoothing
  private at = 0; // where the last question fell: links are asked for in order

  /**
   * Lays the path anew. nodes: m, world, lip first; pose: of the ship; origin: m, world, taken off all points;
   * cableOut: m of unstretched cable along the nodes, NaN where not known.
   */
  lay(rig: Rig, pose: ShipPose, nodes: Float32Array, origin: readonly number[], cableOut: number): void {
    this.count = 0;
    this.at = 0;
    const axes = shipAxes(pose, this.axes);
    const { points, toLip } = rig.inboard;
    const ox = pose.x - origin[0]!;
    const oy = pose.y - origin[1]!;
    const oz = pose.z - origin[2]!;
    const nodeCount = Math.floor(nodes.length / 3);
    const drawnIn = nodeCount > 1 ? this.drawnIn(rig, pose, nodes) : 0;
    for (let i = 0; i < toLip.length; ++i) {
      if (toLip[i]! < drawnIn - 1e-9) break;
      if (nodeCount > 1 && toLip[i]! < drawnIn + 1e-9) break; // that point is the first node
      const x = points[3 * i]!;
      const y = points[3 * i + 1]!;
      const z = points[3 * i + 2]!;
      this.push(
        ox + axes[0]! * x + axes[1]! * y + axes[2]! * z,
        oy + axes[3]! * x + axes[4]! * y + axes[5]! * z,
        oz + axes[6]! * x + axes[7]! * y + axes[8]! * z,
        -toLip[i]!,
      );
    }
    if (nodeCount > 1) this.layNodes(nodes, nodeCount, origin, -drawnIn, cableOut);
    this.layAcross(rig);
  }

  /** m of cable at the outer end. */
  get end(): number {
    return this.count > 0 ? this.s[this.count - 1]! : 0;
  }
  get begin(): number {
    return this.s[0]!;
  }

  /** The place at s into out[at..], and the direction across into across[at..] where given. */
  place(s: number, out: Float64Array, at: number, across?: Float64Array): void {
    const n = this.count;
    let i = this.at;
    while (i > 0 && this.s[i]! > s) --i;
    while (i < n - 2 && this.s[i + 1]! <= s) ++i;
    this.at = i;
    const from = this.s[i]!;
    const share = clamp((s - from) / (this.s[i + 1]! - from || 1), -1, 2);
    for (let k = 0; k < 3; ++k) {
      const a = this.points[3 * i + k]!;
      out[at + k] = a + share * (this.points[3 * i + 3 + k]! - a);
      if (across) across[at + k] = this.across[3 * i + k]!;
    }
  }

  /** m up the pipe at which the cable outboard begins: more than 0 only while the anchor is being drawn in. */
  private drawnIn(rig: Rig, pose: ShipPose, nodes: Float32Array): number {
    const axes = this.axes;
    const dx = nodes[0]! - pose.x;
    const dy = nodes[1]! - pose.y;
    const dz = nodes[2]! - pose.z;
    const x = axes[0]! * dx + axes[3]! * dy + axes[6]! * dz;
    const y = axes[1]! * dx + axes[4]! * dy + axes[7]! * dz;
    const z = axes[2]! * dx + axes[5]! * dy + axes[8]! * dz;
    const { lip } = rig.tackle;
    if (Math.hypot(x - lip.x, y - lip.y, z - lip.z) < 0.05) return 0;
    const { points, toLip } = rig.inboard;
    let best = 0.6; // m off the pipe's line, beyond which it is none of it
    let found = 0;
    for (let i = toLip.length - 1; i > 0 && toLip[i]! < rig.toGypsy - 0.5; --i) {
      const ax = points[3 * i]!;
      const ay = points[3 * i + 1]!;
      const az = points[3 * i + 2]!;
      const bx = points[3 * i - 3]! - ax;
      const by = points[3 * i - 2]! - ay;
      const bz = points[3 * i - 1]! - az;
      const share = clamp(((x - ax) * bx + (y - ay) * by + (z - az) * bz) / (bx * bx + by * by + bz * bz), 0, 1);
      const off = Math.hypot(ax + share * bx - x, ay + share * by - y, az + share * bz - z);
      if (off >= best) continue;
      best = off;
      found = toLip[i]! + share * (toLip[i - 1]! - toLip[i]!);
    }
    return found;
  }

  private layNodes(nodes: Float32Array, n: number, origin: readonly number[], begin: number, cableOut: number): void {
    if (this.bare.length < 3 * n) this.bare = new Float64Array(6 * n);
    const p = this.bare;
    for (let i = 0; i < 3 * n; ++i) p[i] = nodes[i]! - origin[i % 3]!;
    const first = this.count;
    let s = begin;
    this.push(p[0]!, p[1]!, p[2]!, s);
    for (let i = 0; i + 1 < n; ++i) {
      const bentHere = i > 0 ? this.turn(p, i) : 0;
      const bentThere = i + 2 < n ? this.turn(p, i + 1) : 0;
      const smooth = (a: number): boolean => a > kSmoothMin && a < kSmoothMax;
      const pieces = smooth(bentHere) || smooth(bentThere) ? kPieces : 1;
      for (let k = 1; k <= pieces; ++k) {
        const last = this.count - 1;
        const t = k / pieces;
        if (k === pieces) this.push(p[3 * i + 3]!, p[3 * i + 4]!, p[3 * i + 5]!, 0);
        else this.pushSmooth(p, i, n, t, smooth(bentHere), smooth(bentThere));
        s += Math.hypot(
          this.points[3 * last + 3]! - this.points[3 * last]!,
          this.points[3 * last + 4]! - this.points[3 * last + 1]!,
          this.points[3 * last + 5]! - this.points[3 * last + 2]!,
        );
        this.s[last + 1] = s;
      }
    }
    // Drawn is the stretched cable; links count unstretched.
    const share = (cableOut - begin) / (s - begin);
    if (share > 0.9 && share < 1.1)
      for (let i = first; i < this.count; ++i) this.s[i] = begin + share * (this.s[i]! - begin);
  }

  /** rad, by which the cable turns at node i. */
  private turn(p: Float64Array, i: number): number {
    const a = 3 * i;
    const ux = p[a]! - p[a - 3]!;
    const uy = p[a + 1]! - p[a - 2]!;
    const uz = p[a + 2]! - p[a - 1]!;
    const vx = p[a + 3]! - p[a]!;
    const vy = p[a + 4]! - p[a + 1]!;
    const vz = p[a + 5]! - p[a + 2]!;
    const both = Math.hypot(ux, uy, uz) * Math.hypot(vx, vy, vz);
    return both > 0 ? Math.acos(clamp((ux * vx + uy * vy + uz * vz) / both, -1, 1)) : 0;
  }

  /** A point of the span from node i, t 0..1: cubic through both nodes, with the directions of their neighbours. */
  private pushSmooth(p: Float64Array, i: number, n: number, t: number, here: boolean, there: boolean): void {
    const t2 = t * t;
    const t3 = t2 * t;
    const h1 = t3 - 2 * t2 + t;
    const h2 = 3 * t2 - 2 * t3;
    const h3 = t3 - t2;
    const out: number[] = [0, 0, 0];
    const a = 3 * i;
    const span = Math.hypot(p[a + 3]! - p[a]!, p[a + 4]! - p[a + 1]!, p[a + 5]! - p[a + 2]!);
    // Tangents as long as this span, so that spans of unlike length do not overshoot.
    const tangent = (from: number, to: number, k: number, reach: number): number =>
      ((p[3 * to + k]! - p[3 * from + k]!) * span) / (reach || 1);
    const across = (from: number, to: number): number =>
      Math.hypot(p[3 * to]! - p[3 * from]!, p[3 * to + 1]! - p[3 * from + 1]!, p[3 * to + 2]! - p[3 * from + 2]!);
    const hereFrom = here && i > 0 ? i - 1 : i;
    const thereTo = there && i + 2 < n ? i + 2 : i + 1;
    const reachHere = across(hereFrom, i + 1);
    const reachThere = across(i, thereTo);
    for (let k = 0; k < 3; ++k)
      out[k] =
        p[a + k]! +
        h2 * (p[a + 3 + k]! - p[a + k]!) +
        h1 * tangent(hereFrom, i + 1, k, reachHere) +
        h3 * tangent(i, thereTo, k, reachThere);
    this.push(out[0]!, out[1]!, out[2]!, 0);
  }

  private push(x: number, y: number, z: number, s: number): void {
    if (3 * this.count === this.points.length) this.grow();
    this.points[3 * this.count] = x;
    this.points[3 * this.count + 1] = y;
    this.points[3 * this.count + 2] = z;
    this.s[this.count++] = s;
  }

  private grow(): void {
    const longer = (from: Float64Array): Float64Array => {
      const to = new Float64Array(2 * from.length);
      to.set(from);
      return to;
    };
    this.points = longer(this.points);
    this.across = longer(this.across);
    this.s = longer(this.s);
  }

  /** The direction across each span: the gypsy's shaft, carried along without spin. */
  private layAcross(rig: Rig): void {
    const axes = this.axes;
    let x = axes[0]! * rig.out[0] + axes[1]! * rig.out[1] + axes[2]! * rig.out[2];
    let y = axes[3]! * rig.out[0] + axes[4]! * rig.out[1] + axes[5]! * rig.out[2];
    let z = axes[6]! * rig.out[0] + axes[7]! * rig.out[1] + axes[8]! * rig.out[2];
    const p = this.points;
    for (let i = 0; i < this.count; ++i) {
      const a = 3 * Math.min(i, this.count - 2);
      const tx = p[a + 3]! - p[a]!;
      const ty = p[a + 4]! - p[a + 1]!;
      const tz = p[a + 5]! - p[a + 2]!;
      const square = tx * tx + ty * ty + tz * tz;
      if (square > 0) {
        const off = (x * tx + y * ty + z * tz) / square;
        x -= off * tx;
        y -= off * ty;
        z -= off * tz;
        const l = Math.hypot(x, y, z);
        if (l > 1e-6) {
          x /= l;
          y /= l;
          z /= l;
        }
      }
      this.across[3 * i] = x;
      this.across[3 * i + 1] = y;
      this.across[3 * i + 2] = z;
    }
  }
}
