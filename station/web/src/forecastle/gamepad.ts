// Controllers as the hands of the forecastle: gamepads, joysticks, hand-wheels. One that is unplugged lets go.

import { type Control, type ControllerMemory, controls, rumble, turned, valueOf } from "./controller";
import type { Hands } from "./keyboard";

const kFine = 0.1; // of the hand-wheel's rate, by what turns it finely
const kStill = 1e-4; // turns, below which an axis only trembles
const kShake = 200; // ms that a controller shakes by one order

export interface PadHands extends Hands {
  /** A step through the report pad, and back. */
  menu(step: number): void;
  /** Presses what has the focus, where that is of the report pad or an open choice; false: it is not. */
  choose(): boolean;
}

/** Controllers that are plugged in, in the order of the browser. */
export const connectedPads = (): Gamepad[] =>
  (navigator.getGamepads?.() ?? []).filter((pad): pad is Gamepad => pad?.connected === true);

export class GamepadReader {
  private readonly pressed = new Set<Control>();
  private readonly wheels = new Map<string, number>(); // turns, where each device's hand-wheel stood
  private reads = false;
  private pushes = false;
  private turns = false;
  private shaken = -Infinity;

  /** busy: another has the controllers now, to teach them. */
  constructor(
    private readonly hands: PadHands,
    private readonly memory: ControllerMemory,
    private readonly busy: () => boolean,
  ) {
    addEventListener("blur", () => this.leave());
  }

  /** Reads them; once a frame. */
  poll(): void {
    const pads = connectedPads().filter((pad) => this.memory.of(pad));
    if (pads.length === 0 || this.busy()) {
      if (this.reads) this.leave();
      return;
    }
    if (!document.hasFocus()) return;
    this.reads = true;
    const strongest: Partial<Record<Control, number>> = {};
    for (const pad of pads)
      for (const assignment of this.memory.of(pad)!.mapping) {
        const { control, index } = assignment;
        const value = valueOf(assignment, pad);
        if (control === "wheel") {
          const device = `${pad.index}/${index}`;
          const by = turned(assignment, this.wheels.get(device) ?? value, value);
          this.wheels.set(device, value);
          if (Math.abs(by) > kStill) this.hands.turn(by);
        } else if (Math.abs(value) > Math.abs(strongest[control] ?? 0)) strongest[control] = value;
      }
    this.push(strongest.speed ?? 0);
    this.run((strongest.on ?? 0) ** 2 - (strongest.off ?? 0) ** 2 + kFine * (strongest.fine ?? 0));
    for (const control of Object.keys(controls) as Control[])
      if (controls[control].kind === "press") this.see(control, (strongest[control] ?? 0) > 0);
  }

  /** Shakes the controllers by what is felt; nothing: none of it is. now: ms. */
  shake(view: { vibration: number; brake_noise: number } | undefined, now: number): void {
    if (!this.reads || now - this.shaken < kShake * 0.8) return;
    const { deck, band } = rumble(view);
    if (deck === 0 && band === 0) return;
    this.shaken = now;
    for (const pad of connectedPads())
      if (this.memory.of(pad)?.vibrates)
        void pad.vibrationActuator
          ?.playEffect("dual-rumble", { duration: kShake, strongMagnitude: deck, weakMagnitude: band })
          .catch(() => {}); // one that cannot
  }

  private push(way: number): void {
    if (way !== 0) this.hands.push(way);
    else if (this.pushes) this.hands.release();
    this.pushes = way !== 0;
  }

  private run(rate: number): void {
    const share = Math.min(1, Math.max(-1, Math.round(rate * 1000) / 1000));
    if (share !== 0 || this.turns) this.hands.wheel(share);
    this.turns = share !== 0;
  }

  private see(control: Control, down: boolean): void {
    if (down === this.pressed.has(control)) return;
    if (down) this.pressed.add(control);
    else this.pressed.delete(control);
    const { hands } = this;
    if (control === "clutch") hands.clutch(down);
    else if (control === "stopper") hands.stopper(down);
    else if (control === "stop") hands.stop(down);
    else if (!down) return;
    else if (control === "side") hands.side();
    else if (control === "choose") {
      if (!hands.choose()) hands.repeat();
    } else if (control === "acknowledge") hands.acknowledge();
    else if (control === "help") hands.help();
    else if (control === "back") hands.menu(-1);
    else if (control === "next") hands.menu(1);
  }

  private leave(): void {
    for (const control of this.pressed) this.see(control, false);
    if (this.pushes) this.hands.release();
    if (this.turns) this.hands.wheel(0);
    this.pushes = this.turns = this.reads = false;
    this.wheels.clear(); // where they stand when they come again is no turn
  }
}
