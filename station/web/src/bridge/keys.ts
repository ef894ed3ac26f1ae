// Keys and gamepad of the bridge, those of the terminal form where it has them.

import { typeIntoOpenPad } from "../kit/pad";
import { radians } from "../kit/units";
import type { HelmHand } from "./helm_hand";
import { stepRudder } from "./wheel";
import { t } from "../kit/language";

/** For the page's help. */
export const kKeys: readonly [string, string, string][] = [
  ["w s", t("telegraph, one order up or down"), t("d-pad up, down")],
  ["a d", t("rudder 5\u00b0 to port, to starboard"), t("left stick")],
  ["z", t("rudder amidships"), "A"],
  [", .", t("bow thruster to port, to starboard while held (Shift: full)"), t("triggers")],
  ["F2", t("acknowledge the topmost alert"), ""],
  ["F3", t("silence alerts"), ""],
  ["?", t("this help"), ""],
];

const kThrust = 0.5;
const kDead = 0.12; // of a stick's way

/** Calls back acts that are not the helm's: F2, F3, ?. */
export function listenToKeys(helm: HelmHand, acts: Record<string, () => void>): void {
  const thrust = (key: string): number => (key === "," || key === "<" ? -1 : key === "." || key === ">" ? 1 : 0);
  let pushes = false;
  addEventListener("keydown", (event) => {
    const typing = event.target instanceof HTMLInputElement || event.target instanceof HTMLSelectElement;
    if (typing || event.ctrlKey || event.altKey || event.metaKey || typeIntoOpenPad(event)) return;
    const act = acts[event.key];
    const side = thrust(event.key);
    if (act) act();
    else if (event.key === "w") helm.stepTelegraph(1);
    else if (event.key === "s") helm.stepTelegraph(-1);
    else if (event.key === "a") stepRudder(helm, -1);
    else if (event.key === "d") stepRudder(helm, 1);
    else if (event.key === "z") helm.put({ rudder: 0 });
    else if (side !== 0) {
      pushes = true;
      helm.put({ bow_thruster: side * (event.shiftKey ? 1 : kThrust) });
    } else return;
    event.preventDefault();
  });
  const leave = (): void => {
    if (pushes && helm.thrustersSpring) helm.put({ bow_thruster: 0 });
    pushes = false;
  };
  addEventListener("keyup", (event) => thrust(event.key) !== 0 && leave());
  // Of a key that is let go elsewhere no page hears.
  addEventListener("blur", leave);
  document.addEventListener("visibilitychange", () => document.hidden && leave());
}

/** The standard mapping's gamepad, asked each frame. */
export class PadHand {
  private before: boolean[] = [];
  private steered = false;
  private thrust = 0;

  constructor(private readonly helm: HelmHand) {}

  /** Moves what the first gamepad moves. */
  poll(): void {
    const pad = navigator.getGamepads().find((p) => p?.connected);
    if (!pad || document.hidden) {
      this.rest();
      return;
    }
    const pressed = pad.buttons.map((button) => button.pressed);
    const struck = (button: number): boolean => (pressed[button] ?? false) && !this.before[button];
    if (struck(12)) this.helm.stepTelegraph(1);
    if (struck(13)) this.helm.stepTelegraph(-1);
    if (struck(0)) this.helm.put({ rudder: 0 });
    this.before = pressed;
    const stick = pad.axes[0] ?? 0;
    if (Math.abs(stick) > kDead) {
      const share = (Math.abs(stick) - kDead) / (1 - kDead);
      const degree = radians(1);
      const rudder = Math.round((Math.sign(stick) * share * this.helm.rudderMax()) / degree) * degree;
      if (rudder !== this.helm.levers()?.rudder) this.helm.put({ rudder });
      this.steered = true;
    } else if (this.steered) {
      this.steered = false;
      this.helm.put({ rudder: 0 });
    }
    this.push(Math.round(20 * ((pad.buttons[7]?.value ?? 0) - (pad.buttons[6]?.value ?? 0))) / 20);
  }

  private push(thrust: number): void {
    if (thrust === this.thrust) return;
    this.thrust = thrust;
    this.helm.put({ bow_thruster: thrust });
  }

  /** It was pulled out, or the page is hidden: what springs goes back. */
  private rest(): void {
    if (this.steered) this.helm.put({ rudder: 0 });
    this.steered = false;
    this.push(0);
    this.before = [];
  }
}
