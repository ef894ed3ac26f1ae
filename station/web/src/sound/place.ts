// Where things sound from, and whose ears hear them: m, ship's body frame (x forward, y to port, z up).

import type { V3 } from "../scene/vec";
import { glide } from "./voices";

/** A man's ears; ahead: unit vector of where he looks. */
export interface Ears {
  at: V3;
  ahead: V3;
}

/** What sounds of one side's gear. */
export interface Places {
  gypsy: V3;
  /** Where the cable comes through the deck. */
  pipe: V3;
  /** Below the hawse pipe's lip. */
  water: V3;
}

/** m, at which a sound has the level that it was made with: from the stand to the gypsy. */
const kNear = 3;
const kTurns = 0.08; // s, time constant of ears that move

/** What is connected to it sounds from a place: half as loud at twice the distance, and from its side. */
export function placed(context: BaseAudioContext, out: AudioNode, [positionX, positionY, positionZ]: V3): PannerNode {
  const panner = new PannerNode(context, {
    panningModel: "equalpower",
    distanceModel: "inverse",
    refDistance: kNear,
    positionX,
    positionY,
    positionZ,
  });
  panner.connect(out);
  return panner;
}

/** Puts the ears that hear all placed sounds of a context. */
export function listen({ listener }: BaseAudioContext, { at, ahead }: Ears, time: number): void {
  if (!("positionX" in listener)) {
    putAtOnce(listener, { at, ahead });
    return;
  }
  const { positionX, positionY, positionZ, forwardX, forwardY, forwardZ } = listener;
  [positionX, positionY, positionZ].forEach((to, i) => glide(to, at[i]!, time, kTurns));
  [forwardX, forwardY, forwardZ].forEach((to, i) => glide(to, ahead[i]!, time, kTurns));
  glide(listener.upY, 0, time, kTurns); // by default y is up; on deck it is z
  glide(listener.upZ, 1, time, kTurns);
}

/** Of Firefox, whose ears have no parameters that glide: they turn within a frame. */
function putAtOnce(listener: AudioListener, { at, ahead }: Ears): void {
  listener.setPosition(...at);
  listener.setOrientation(...ahead, 0, 0, 1);
}
