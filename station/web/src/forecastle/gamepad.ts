// A gamepad of the standard mapping as the hands of the forecastle. One that is unplugged lets go.

import type { Hands } from "./keyboard";

const kDead = 0.12; // of a stick's way
const kTrigger = 0.05; // of a trigger's

/** Buttons of the standard mapping. */
enum Button {
  a,
  b,
  x,
  y,
  lb,
  rb,
  lt,
  rt,
  back,
  start,
  leftStick,
  rightStick,
  up,
  down,
  left,
  right,
}

export interface PadHands extends Hands {
  /** A step through the report pad, and back. */
  menu(step: number): void;
  /** Presses what has the focus, where that is of the report pad or an open choice; false: it is not. */
  choose(): boolean;
}

export class GamepadReader {
  private readonly pressed = new Set<number>();
  private index: number | undefined;
  private pushes = false;
  private turns = false;

  constructor(private readonly hands: PadHands) {
    addEventListener("gamepaddisconnected", (event) => event.gamepad.index === this.index && this.leave());
    addEventListener("blur", () => this.leave());
  }

  /** Reads it; once a frame. */
  poll(): void {
    const pad = (navigator.getGamepads?.() ?? []).find((p) => p?.connected && p.mapping === "standard");
    if (!pad) {
      if (this.index !== undefined) this.leave();
      return;
    }
    if (!document.hasFocus()) return;
    this.index = pad.index;
    const stick = -(pad.axes[1] ?? 0); // away from one heaves
    const way = Math.abs(stick) < kDead ? 0 : (Math.sign(stick) * (Math.abs(stick) - kDead)) / (1 - kDead);
    if (way !== 0) this.hands.push(way);
    else if (this.pushes) this.hands.release();
    this.pushes = way !== 0;
    const trigger = (pad.buttons[Button.rt]?.value ?? 0) - (pad.buttons[Button.lt]?.value ?? 0);
    const turn = Math.abs(trigger) < kTrigger ? 0 : Math.round(trigger * 20) / 20;
    if (turn !== 0 || this.turns) this.hands.wheel(turn);
    this.turns = turn !== 0;
    pad.buttons.forEach((button, i) => this.see(i, button.pressed));
  }

  private see(button: number, down: boolean): void {
    if (down === this.pressed.has(button)) return;
    if (down) this.pressed.add(button);
    else this.pressed.delete(button);
    const { hands } = this;
    if (button === Button.x) hands.clutch(down);
    else if (button === Button.y) hands.stopper(down);
    else if (button === Button.back) hands.stop(down);
    else if (!down) return;
    else if (button === Button.lb || button === Button.rb) hands.side();
    else if (button === Button.a) {
      if (!hands.choose()) hands.repeat();
    } else if (button === Button.b) hands.acknowledge();
    else if (button === Button.start) hands.help();
    else if (button === Button.up || button === Button.left) hands.menu(-1);
    else if (button === Button.down || button === Button.right) hands.menu(1);
  }

  private leave(): void {
    for (const button of this.pressed) this.see(button, false);
    if (this.pushes) this.hands.release();
    if (this.turns) this.hands.wheel(0);
    this.pushes = this.turns = false;
    this.index = undefined;
  }
}
