// Where the gear of one side stands on deck, m, body frame: worked out of the wire's description, which has hawse
// pipe, chain and gypsy, and of what is usual between them. From the lip to the pipe's straight part the cable lies
// as in the physics; from there to the gypsy only its length counts there, and its place is drawn.

import type { SceneDescription, SceneTackle } from "../wire/generated";
import { type V3, add, along, cross, dot, length, level, scale, sub, unit, vec } from "./vec";

/** Pitch of the links, in diameters of the chain. */
export const kPitch = 4;

/** m, of the gypsy's pitch circle: ten links a turn. */
export const pitchRadius = (d: number): number => (10 * kPitch * d) / (2 * Math.PI);

export interface Rig {
  tackle: SceneTackle;
  /** +1 port, -1 starboard. */
  sign: number;
  /** m, of the forecastle deck. */
  deck: number;
  /** Chain diameter, m. */
  d: number;
  /** m, of the pitch circle: ten links a turn. */
  radius: number;
  /** Middle of the gypsy. */
  gypsy: V3;
  /** Unit vectors: inboard and aft along the cable, level; along the shaft, towards the ship's side. */
  lead: V3;
  out: V3;
  /** Where the hawse pipe comes through the deck, and the bolster above it. */
  deckPipe: V3;
  /** Middle of the stopper, on the cable's line; the cable's direction there, inboard. */
  stopper: V3;
  stopperLead: V3;
  /** Where the cable goes down to the locker. */
  spurling: V3;
  /** Cable inboard of the lip, outwards from the locker: x y z, and m of cable to the lip (at the lip 0). */
  inboard: { points: Float64Array; toLip: Float64Array };
  /** m of cable from the lip to where it meets the gypsy; rad from the top, towards the locker, of that place. */
  toGypsy: number;
  meets: number;
}

const kAxisAboveDeck = 1.18; // m of the shaft, for 78 mm chain
const kStep = 0.06; // m, between points of the cable on bends

/** Height of the deck that both windlasses stand on. */
export function deckHeight(scene: SceneDescription): number {
  const heights = scene.tackle.map((t) => t.lip.z + t.pipe_length * t.bore.z - kAxisAboveDeck * size(t));
  let top = 0;
  for (let i = 2; i < scene.hull_corners.length; i += 3) top = Math.max(top, scene.hull_corners[i]!);
  return heights.length > 0 ? Math.max(top + 0.3, Math.min(...heights)) : top + 2;
}

/** Of the gear, against that for 78 mm chain. */
export const size = (tackle: SceneTackle): number => tackle.chain_diameter / 0.078;

/** m inboard of the lip along the pipe: as HawsePipe::chain_at of the server. */
export function chainAt(tackle: SceneTackle, inboard: number): V3 {
  const bore = vec(tackle.bore);
  const turn = Math.acos(bore[2]);
  const turned = Math.min(Math.max(inboard / tackle.bend, 0), turn);
  const round: V3 = add(
    scale(tackle.bend * Math.sin(turned), [0, 0, 1]),
    scale(tackle.bend * (1 - Math.cos(turned)), level(bore)),
  );
  return along(add(vec(tackle.lip), round), Math.max(0, inboard - tackle.bend * turn), bore);
}

export function rig(tackle: SceneTackle, deck: number): Rig {
  const sign = tackle.lip.y >= 0 ? 1 : -1;
  const d = tackle.chain_diameter;
  const k = size(tackle);
  const radius = pitchRadius(d);
  const bore = vec(tackle.bore);
  // On deck the cable leads more nearly fore and aft than the pipe does.
  const lead = level(add(scale(0.5, level(bore)), [-0.9, 0, 0]));
  const out = scale(-sign, cross([0, 0, 1], lead));

  const points: V3[] = []; // from the lip inwards
  // Up the pipe to a corner above the deck, from there to the gypsy.
  const corner = deck + 0.5 * k;
  const round = tackle.bend * Math.acos(bore[2]);
  const straight = (corner - chainAt(tackle, round)[2]) / bore[2];
  const corneredAt = chainAt(tackle, round + Math.max(0.5, straight));
  const gypsy = along([corneredAt[0], corneredAt[1], deck + kAxisAboveDeck * k], 3.7 * k, lead);
  const rise = gypsy[2] - corneredAt[2];
  const run = 3.7 * k;
  const slope = Math.atan2(rise, run) + Math.asin(radius / Math.hypot(rise, run));
  const rising: V3 = add(scale(Math.cos(slope), lead), [0, 0, Math.sin(slope)]);
  const meet = add(gypsy, add(scale(-radius * Math.sin(slope), lead), [0, 0, radius * Math.cos(slope)]));

  for (let u = 0; u < round; u += kStep) points.push(chainAt(tackle, u));
  points.push(chainAt(tackle, round));
  // The corner is rounded by the bolster.
  const bolster = 1.1 * k;
  const turn = Math.acos(Math.min(1, dot(bore, rising)));
  const cut = bolster * Math.tan(turn / 2);
  const from = along(corneredAt, -cut, bore);
  const inwards = unit(sub(rising, scale(dot(rising, bore), bore)));
  for (let a = 0; a < turn; a += kStep / bolster)
    points.push(add(from, add(scale(bolster * Math.sin(a), bore), scale(bolster * (1 - Math.cos(a)), inwards))));
  points.push(along(corneredAt, cut, rising), meet);
  const atGypsy = points.length - 1;
  // Over the gypsy until it hangs plumb, and down.
  const wrapTo = Math.PI / 2 + slope;
  for (let a = kStep / radius; a < wrapTo; a += kStep / radius) points.push(onGypsy(gypsy, lead, radius, a - slope));
  const plumb = onGypsy(gypsy, lead, radius, Math.PI / 2);
  points.push(plumb, [plumb[0], plumb[1], deck - 1.5]);

  const n = points.length;
  const coordinates = new Float64Array(3 * n);
  const toLip = new Float64Array(n);
  let cable = 0;
  let toGypsy = 0;
  points.forEach((p, i) => {
    if (i > 0) cable += length(sub(p, points[i - 1]!));
    if (i === atGypsy) toGypsy = cable;
    coordinates.set(p, 3 * (n - 1 - i));
    toLip[n - 1 - i] = cable;
  });
  const stopper = along(meet, -2.1 * k, rising);
  return {
    tackle,
    sign,
    deck,
    d,
    radius,
    gypsy,
    lead,
    out,
    deckPipe: chainAt(tackle, round + (deck - chainAt(tackle, round)[2]) / bore[2]),
    stopper,
    stopperLead: rising,
    spurling: [plumb[0], plumb[1], deck],
    inboard: { points: coordinates, toLip },
    toGypsy,
    meets: -slope,
  };
}

/** A place of the pitch circle, angle from its top towards the locker. */
function onGypsy(gypsy: V3, lead: V3, radius: number, angle: number): V3 {
  return add(gypsy, add(scale(radius * Math.sin(angle), lead), [0, 0, radius * Math.cos(angle)]));
}

/** rad from its top towards the locker, of the pocket in which the flat link that covers the first pitch lies. */
export function pocketAngle(rig: Rig, gypsyTurn: number): number {
  return rig.meets + ((kPitch / 2) * rig.d - rig.toGypsy) / rig.radius - gypsyTurn;
}
