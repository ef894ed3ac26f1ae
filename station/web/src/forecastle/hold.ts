// A weighty act: a button acts only when it has been held.

import { setAttribute } from "../kit/dom";

const kAgain = 3000; // ms

export class HoldGuard {
  private timer: number | undefined;
  private clicked = -Infinity;

  /**
   * element: the button; it shows how far it has been held by the CSS variable --held, 0..1. time: ms that a hand must
   * hold it, 0: acts at the first touch; asked anew at each touch. act: what it does then.
   */
  constructor(
    private readonly element: HTMLButtonElement,
    private readonly time: () => number,
    private readonly act: () => void,
  ) {
    element.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      element.setPointerCapture(event.pointerId);
      this.press();
    });
    for (const name of ["pointerup", "pointercancel", "lostpointercapture", "blur"] as const)
      element.addEventListener(name, () => this.release());
    element.addEventListener("keydown", (event) => {
      if (event.key !== " " && event.key !== "Enter") return;
      event.preventDefault();
      if (!event.repeat) this.press();
    });
    element.addEventListener("keyup", (event) => (event.key === " " || event.key === "Enter") && this.release());
    element.addEventListener("click", (event) => event.detail === 0 && this.clickWithoutHand());
    element.addEventListener("contextmenu", (event) => event.preventDefault()); // of a long touch
  }

  /** A click made by assistive technology cannot be held: a second one soon after does the same. */
  private clickWithoutHand(): void {
    const again = performance.now() - this.clicked < kAgain;
    this.clicked = performance.now();
    if (!this.element.disabled && (again || this.time() <= 0)) this.act();
  }

  press(): void {
    if (this.timer !== undefined || this.element.disabled) return;
    const time = this.time();
    if (time <= 0) {
      this.act();
      return;
    }
    this.element.style.setProperty("--hold-time", `${time}ms`);
    setAttribute(this.element, "data-held", "");
    this.timer = window.setTimeout(() => {
      this.release();
      this.act();
    }, time);
  }

  release(): void {
    if (this.timer === undefined) return;
    clearTimeout(this.timer);
    this.timer = undefined;
    setAttribute(this.element, "data-held", undefined);
  }
}
