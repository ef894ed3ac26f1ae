// The brake's hand-wheel: turned by dragging round its hub, clockwise on. The rim stands where the hand has put it,
// the pointer in the hub where the wheel really is.

import { h, setAttribute, setText, setVariable, svg } from "../kit/dom";
import { kFine, kWheelTurns } from "./levers";
import { t } from "../kit/language";

const kSpokes = 6;
const kNotch = 5 / 360; // turns, of the mouse's wheel
const kNotchPixels = 100; // of a mouse's wheel; a touchpad says less at a time
const kGrown = 280; // px, of the rim that a hand has

/** "2 turns 214°". share: 0..1 of the way. */
export function turnsText(share: number): string {
  const degrees = Math.round(share * kWheelTurns * 360);
  const whole = Math.floor(degrees / 360);
  const rest = degrees - 360 * whole;
  return whole === 1 ? t("1 turn {rest}°", { rest }) : t("{whole} turns {rest}°", { whole, rest });
}

/**
 * What stands beside the wheel, and the same in one sentence: "4 turns 78° of 5 turns", "5 turns 0°, hard on". set:
 * where the hand has put it, 0..1; real: where it is.
 */
export function brakeWords(set: number, real: number): { turns: string; state: string; said: string } {
  const turns = turnsText(real);
  const state =
    Math.abs(set - real) > 0.01
      ? t("set {turns}", { turns: turnsText(set) })
      : real > 0.995
        ? t("hard on")
        : real < 0.005
          ? t("open")
          : "";
  if (state) return { turns, state, said: `${turns}, ${state}` };
  const whole = t("of {turns} turns", { turns: kWheelTurns });
  return { turns, state: whole, said: `${turns} ${whole}` };
}

export interface WheelHand {
  /** By so many turns, on positive. */
  turn(turns: number): void;
  /** To 0, open, or 1, hard on, by itself. */
  spin(to: number): void;
  /** The hand stops what spins. */
  stop(): void;
}

export class HandWheel {
  readonly element: HTMLElement;
  private readonly wheel: HTMLElement;
  private readonly rim: SVGGElement;
  private readonly pointer: SVGGElement;
  private readonly ghost = svg("path", { class: "ghost", d: "M -9 -99 L 9 -99 L 0 -78 Z" });
  private readonly picture: SVGSVGElement;
  private readonly turns = h("strong", {});
  private readonly state = h("span", {});
  private readonly buttons: HTMLButtonElement[];
  private held: { pointer: number; angle: number } | undefined;

  constructor(private readonly hand: WheelHand) {
    this.rim = svg("g", { class: "rim" });
    this.pointer = svg("g", { class: "pointer" });
    this.picture = svg(
      "svg",
      { viewBox: "-100 -100 200 200", "aria-hidden": "true" },
      this.rim,
      this.pointer,
      this.ghost,
    );
    this.draw();
    this.showGhost(undefined);
    this.wheel = h("div", { class: "wheel", role: "slider", tabindex: 0, "aria-label": t("brake hand-wheel") });
    setAttribute(this.wheel, "aria-valuemin", "0");
    setAttribute(this.wheel, "aria-valuemax", "100");
    this.wheel.append(this.picture);
    this.buttons = [
      h("button", { "data-act": "open", title: t("key 0"), onclick: () => hand.spin(0) }, t("Open")),
      h("button", { "data-act": "hard-on", title: t("key b"), onclick: () => hand.spin(1) }, t("Hard on")),
    ];
    this.element = h(
      "section",
      { class: "control brake", "aria-label": t("brake") },
      h(
        "div",
        { class: "row top" },
        h("h2", {}, t("Brake")),
        h("output", { class: "figures" }, this.turns, this.state),
      ),
      this.wheel,
      h("div", { class: "row pair" }, ...this.buttons),
    );
    this.listen();
  }

  /** set: where the hand has put it, 0..1; real: where it is. */
  show(set: number, real: number, movable: boolean): void {
    const angle = (share: number): string => `rotate(${(share * kWheelTurns * 360).toFixed(1)})`;
    setAttribute(this.rim, "transform", angle(set));
    setAttribute(this.pointer, "transform", angle(real));
    // One line, of one length: what stands beside the wheel must not push it from under the finger.
    const { turns, state, said } = brakeWords(set, real);
    setText(this.turns, turns);
    setText(this.state, state);
    setAttribute(this.wheel, "aria-valuenow", (100 * set).toFixed(1));
    setAttribute(this.wheel, "aria-valuetext", `${t("brake|hand-wheel")} ${said}`);
    setAttribute(this.wheel, "aria-disabled", movable ? undefined : "true");
    for (const button of this.buttons) button.disabled = !movable;
  }

  /** Where the model's hands have turned its mark to, 0..1 of the way; undefined: they are not shown. */
  showGhost(share: number | undefined): void {
    setAttribute(this.ghost, "display", share === undefined ? "none" : undefined);
    setAttribute(this.ghost, "transform", `rotate(${((share ?? 0) * kWheelTurns * 360).toFixed(1)})`);
  }

  private listen(): void {
    const wheel = this.wheel;
    wheel.addEventListener("pointerdown", (event) => {
      if (event.button !== 0 || this.held) return;
      wheel.setPointerCapture(event.pointerId);
      wheel.focus({ preventScroll: true });
      this.grow();
      this.held = { pointer: event.pointerId, angle: this.angleOf(event) };
      this.hand.stop();
    });
    wheel.addEventListener("pointermove", (event) => {
      if (this.held?.pointer !== event.pointerId) return;
      const angle = this.angleOf(event);
      let turned = angle - this.held.angle;
      turned -= Math.round(turned); // the short way round
      this.held.angle = angle;
      this.hand.turn(event.shiftKey ? turned * kFine : turned);
    });
    const leave = (event: PointerEvent): void => {
      if (this.held?.pointer !== event.pointerId) return;
      this.held = undefined;
      setAttribute(wheel, "data-held", undefined);
      this.hand.stop();
    };
    wheel.addEventListener("pointerup", leave);
    wheel.addEventListener("pointercancel", leave);
    wheel.addEventListener("lostpointercapture", leave);
    wheel.addEventListener(
      "wheel",
      (event) => {
        event.preventDefault();
        const way = event.deltaY || event.deltaX; // which a browser makes of it while Shift is down
        const notches = event.deltaMode === WheelEvent.DOM_DELTA_PIXEL ? way / kNotchPixels : Math.sign(way);
        this.hand.turn(-Math.min(1, Math.max(-1, notches)) * kNotch * (event.shiftKey ? kFine : 1));
      },
      { passive: false },
    );
  }

  /** The rim in the hand grows about its hub to what it was drawn for, as far as the stand has room. */
  private grow(): void {
    const rim = this.picture.getBoundingClientRect();
    const room = (this.element.parentElement ?? this.element).getBoundingClientRect();
    const [x, y] = [rim.left + rim.width / 2, rim.top + rim.height / 2];
    const most = 2 * Math.min(x - room.left, room.right - x, y - room.top, room.bottom - y);
    const grown = Math.min(kGrown, most) / Math.max(1, rim.width);
    setVariable(this.wheel, "--grown", `${Math.max(1, grown)}`);
    setAttribute(this.wheel, "data-held", "");
  }

  /** Turns, clockwise, of a finger round the hub. */
  private angleOf(event: PointerEvent): number {
    const box = this.picture.getBoundingClientRect();
    const x = event.clientX - box.left - box.width / 2;
    const y = event.clientY - box.top - box.height / 2;
    return Math.atan2(x, -y) / (2 * Math.PI);
  }

  private draw(): void {
    this.rim.append(svg("circle", { r: 84, class: "tyre" }), svg("circle", { r: 84, class: "tyre-light" }));
    for (let i = 0; i < kSpokes; ++i) {
      const turn = `rotate(${(360 / kSpokes) * i})`;
      this.rim.append(
        svg("path", { d: "M -5 -26 L -3.5 -78 L 3.5 -78 L 5 -26 Z", class: "spoke", transform: turn }),
        svg("circle", { cx: 0, cy: -84, r: 6.5, class: "knob", transform: `rotate(${(360 / kSpokes) * (i + 0.5)})` }),
      );
    }
    this.rim.append(
      svg("path", { d: "M -9 -97 L 9 -97 L 0 -86 Z", class: "mark" }), // which way up it is, at a glance
      svg("circle", { r: 28, class: "hub" }),
    );
    this.pointer.append(
      svg("circle", { r: 20, class: "dial" }),
      svg("path", { d: "M -6 6 L 0 -19 L 6 6 Z", class: "needle" }),
      svg("circle", { r: 4, class: "pin" }),
    );
  }
}
