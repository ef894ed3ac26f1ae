// The lamp in a mate's hand: a cone of light from a little beside his eye to where he looks.

import { type Camera, Color, SpotLight, Vector3 } from "three";

const kColour = 0xfff1d8;
const kCandela = 40; // in the scene's exposure by night; tuned
const kReach = 60; // m
const kHalfAngle = 0.24; // rad
const kFade = 1.2; // power of the distance by which it fades: less than a lamp's 2, as eyes get used to the dark; tuned
const kHand: readonly [number, number, number] = [0.28, -0.3, 0]; // m from the eye: right, up, back

export class HandLamp {
  readonly light = new SpotLight(kColour, 0, kReach, kHalfAngle, 0.6, kFade);
  /** For materials that work light out at the corners: where it is and shines, m and unit vector of the scene. */
  readonly at = new Vector3();
  readonly towards = new Vector3(0, 1, 0);
  readonly colour = new Color(0);

  constructor() {
    this.light.visible = false;
  }

  switch(on: boolean): void {
    this.light.visible = on;
    this.light.intensity = on ? kCandela : 0;
    this.colour.set(kColour).multiplyScalar(this.light.intensity / Math.PI);
  }

  /** Into the hand of who looks through that camera. */
  hold(eye: Camera): void {
    if (!this.light.visible) return;
    eye.getWorldDirection(this.towards);
    this.at
      .set(...kHand)
      .applyQuaternion(eye.quaternion)
      .add(eye.position);
    this.light.position.copy(this.at);
    this.light.target.position.copy(eye.position).addScaledVector(this.towards, 10); // where hand and eye agree
    this.towards.copy(this.light.target.position).sub(this.at).normalize();
  }
}
