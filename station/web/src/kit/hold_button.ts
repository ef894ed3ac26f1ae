// A weighty act: a button acts when it has been held down, not when it was touched. For those who cannot hold (a click
// made by assistive technology, which has no pointer), a second click within 3 s does the same.

import { h, setAttribute, setText } from "./dom";
import { t } from "./language";

const kAgain = 3000; // ms
const kTold = 6000; // ms for which who has only touched it is told so

const isPress = (event: KeyboardEvent): boolean => event.key === " " || event.key === "Enter";

export class HoldGuard {
  private timer: ReturnType<typeof setTimeout> | undefined;
  private by: number | "key" | undefined; // pointer that holds it, or a key: each lets go of what is its own
  private waiting: ReturnType<typeof setTimeout> | undefined; // for the second click

  /**
   * element: the button; it shows how far it has been held (kit.css, .hold). time: ms that a hand must hold it, 0: acts
   * at the first touch; asked anew at each touch. act: what it does then. waits: told when a click without a hand waits
   * for the second, and when it does no more. tooShort: told when a hand has let go before it acted.
   */
  constructor(
    private readonly element: HTMLButtonElement,
    private readonly time: () => number,
    private readonly act: () => void,
    private readonly waits: (again: boolean) => void = () => {},
    private readonly tooShort: () => void = () => {},
  ) {
    element.classList.add("hold");
    element.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      element.setPointerCapture(event.pointerId);
      this.pressBy(event.pointerId);
    });
    for (const name of ["pointerup", "pointercancel", "lostpointercapture"] as const)
      element.addEventListener(name, (event) => this.releaseBy(event.pointerId));
    element.addEventListener("blur", () => this.releaseBy("key")); // another finger may be on another control
    element.addEventListener("keydown", (event) => {
      if (!isPress(event)) return;
      event.preventDefault(); // no click of its own
      if (!event.repeat) this.pressBy("key");
    });
    element.addEventListener("keyup", (event) => isPress(event) && this.releaseBy("key"));
    element.addEventListener("click", (event) => event.detail === 0 && this.clickWithoutHand());
    element.addEventListener("contextmenu", (event) => event.preventDefault()); // of a long touch
  }

  private pressBy(whom: number | "key"): void {
    if (this.timer !== undefined) return;
    this.by = whom;
    this.press();
  }
  private releaseBy(whom: number | "key"): void {
    if (this.by === whom) this.release();
  }

  /** A hand is on it: one of a gamepad, or a key of the page. */
  press(): void {
    if (this.timer !== undefined || this.element.disabled) return;
    const time = this.time();
    if (time <= 0) {
      this.act();
      return;
    }
    this.element.style.setProperty("--hold-time", `${time}ms`);
    setAttribute(this.element, "data-held", "");
    this.timer = setTimeout(() => {
      this.leave();
      this.act();
    }, time);
  }

  release(): void {
    if (this.timer === undefined) return;
    this.leave();
    this.tooShort();
  }

  private leave(): void {
    clearTimeout(this.timer);
    this.timer = this.by = undefined;
    setAttribute(this.element, "data-held", undefined);
  }

  private clickWithoutHand(): void {
    if (this.element.disabled) return;
    if (this.time() <= 0 || this.waiting !== undefined) {
      this.waitNoMore();
      this.act();
      return;
    }
    this.waiting = setTimeout(() => this.waitNoMore(), kAgain);
    this.waits(true);
  }

  private waitNoMore(): void {
    if (this.waiting === undefined) return;
    clearTimeout(this.waiting);
    this.waiting = undefined;
    this.waits(false);
  }
}

/** A button that acts when it was held for so many seconds, and says so to who has only touched it. */
export function holdButton(
  text: string,
  seconds: number,
  act: () => void,
  props: { [name: string]: unknown } = {},
): HTMLButtonElement {
  const words = h("span", {}, text);
  const button = h(
    "button",
    { title: t("hold for {seconds} s", { seconds }), "aria-description": t("hold to do it"), ...props },
    words,
  );
  const waits = (again: boolean): void => setText(words, again ? t("{text}: again to confirm", { text }) : text);
  let told: ReturnType<typeof setTimeout> | undefined;
  const plain = (): void => {
    clearTimeout(told);
    setText(words, text);
    setAttribute(button, "data-told", undefined);
  };
  const tooShort = (): void => {
    plain();
    setText(words, t("Hold: {text}", { text }));
    setAttribute(button, "data-told", "");
    told = setTimeout(plain, kTold);
  };
  const held = (): void => {
    plain();
    act();
  };
  new HoldGuard(button, () => seconds * 1000, held, waits, tooShort);
  return button;
}
