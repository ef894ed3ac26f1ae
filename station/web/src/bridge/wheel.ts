// The wheel, and round it the rudder: the pointer on the scale is what the wheel orders, the bar where the rudder is.

import { h, setAttribute, setText, svg } from "../kit/dom";
import { degrees, figure, radians, sideWord } from "../kit/units";
import type { HelmHand } from "./helm_hand";
import { t } from "../kit/language";

const kGain = 3.4; // the wheel turns by so much for the rudder's angle: 119 degrees for 35
const kRadius = 112; // of the scale, units of the drawing
const kWide = 300; // of the drawing; the hub is 100 below its upper edge
const kHigh = 254;
const kSpread = 2.0; // degrees on the scale for one of rudder
const kKeyStep = radians(5);

/** "starboard 5°", "port 12°", "midships". */
export function rudderWords(angle: number): string {
  const whole = Math.round(degrees(angle));
  return whole === 0 ? t("midships") : `${sideWord(whole > 0 ? 1 : 0)} ${Math.abs(whole)}\u00b0`;
}

export class Wheel {
  readonly element: HTMLElement;
  private readonly picture: SVGSVGElement;
  private readonly wheel = svg("g", { class: "wheel" });
  private readonly pointer = svg("path", { class: "order", d: `M0 ${kRadius + 2} l-8 15 h16 z` });
  private readonly ghost = svg("path", { class: "ghost", d: `M0 ${kRadius - 12} l-8 -15 h16 z`, display: "none" });
  private readonly bar = svg("path", { class: "answer" });
  private readonly scale = svg("g", { class: "scale" });
  private readonly reads = h("strong", {});
  private readonly answer = h("span", { class: "quiet" });
  private scaleOf = 0; // rad, for which the scale was drawn
  private taken: { pointer: number; finger: number; rudder: number } | undefined;

  constructor(private readonly helm: HelmHand) {
    this.picture = svg("svg", {
      viewBox: `-150 -100 ${kWide} ${kHigh}`,
      class: "wheel-picture",
      role: "slider",
      tabindex: 0,
      "aria-label": t("wheel"),
      "aria-valuenow": 0, // until more is known
      onpointerdown: (event: PointerEvent) => this.grasp(event),
      onpointermove: (event: PointerEvent) => this.turn(event),
      onpointerup: (event: PointerEvent) => this.release(event),
      onlostpointercapture: (event: PointerEvent) => this.release(event),
      onkeydown: (event: KeyboardEvent) => this.key(event),
    });
    this.wheel.append(
      svg("circle", { class: "rim", r: 78 }),
      ...[60, 180, 300].map((angle) =>
        svg("line", { class: "spoke", x1: 0, y1: -20, x2: 0, y2: -70, transform: `rotate(${angle})` }),
      ),
      svg("circle", { class: "hub", r: 22 }),
      svg("rect", { class: "king", x: -7, y: -90, width: 14, height: 24, rx: 5 }), // marks amidships
    );
    this.picture.append(this.scale, this.bar, this.pointer, this.ghost, this.wheel);
    this.element = h(
      "section",
      { class: "panel wheel-panel", "aria-label": t("helm") },
      h(
        "div",
        { class: "row" },
        h("h2", {}, t("Helm")),
        h(
          "button",
          { class: "plain", type: "button", onclick: () => this.helm.put({ rudder: 0 }), title: t("key z") },
          t("Midships"),
        ),
      ),
      this.picture,
      h("div", { class: "reads", "aria-hidden": "true" }, this.reads, this.answer),
    );
  }

  /** rudder: rad, where it is. */
  update(rudder: number | undefined): void {
    const most = this.helm.rudderMax();
    if (most !== this.scaleOf) this.drawScale(most);
    const order = this.helm.levers()?.rudder;
    setAttribute(this.picture, "aria-disabled", this.helm.movable() ? undefined : "true");
    if (order === undefined) return;
    setAttribute(this.wheel, "transform", `rotate(${(degrees(order) * kGain).toFixed(2)})`);
    setAttribute(this.pointer, "transform", `rotate(${(-degrees(order) * kSpread).toFixed(2)})`);
    setAttribute(this.picture, "aria-valuenow", degrees(order).toFixed(0));
    const is = rudder === undefined ? "" : t("rudder {angle}", { angle: rudderWords(rudder) });
    setAttribute(this.picture, "aria-valuetext", `${t("ordered {order}", { order: rudderWords(order) })}, ${is}`);
    setText(this.reads, rudderWords(order));
    setText(this.answer, is);
    if (rudder !== undefined) setAttribute(this.bar, "d", this.sector(0, rudder));
  }

  /** Where the model's rudder is, rad; undefined: they are not shown. */
  showGhost(rudder: number | undefined): void {
    setAttribute(this.ghost, "display", rudder === undefined ? "none" : undefined);
    setAttribute(this.ghost, "transform", `rotate(${(-degrees(rudder ?? 0) * kSpread).toFixed(2)})`);
  }

  /** The scale hangs below the wheel: starboard rudder to the right, as the stern is seen from above. */
  private drawScale(most: number): void {
    this.scaleOf = most;
    setAttribute(this.picture, "aria-valuemin", figure(-degrees(most)).replace("\u2212", "-"));
    setAttribute(this.picture, "aria-valuemax", figure(degrees(most)));
    const whole = Math.round(degrees(most));
    const marks: SVGElement[] = [svg("path", { class: "track", d: this.sector(-most, most) })];
    for (let angle = -whole; angle <= whole; angle += 5) {
      const long = angle % 10 === 0 || Math.abs(angle) === whole;
      const turn = -angle * kSpread;
      marks.push(
        svg("line", { class: "tick", y1: kRadius, y2: kRadius - (long ? 12 : 7), transform: `rotate(${turn})` }),
      );
      if (!long || (Math.abs(angle) === 30 && whole === 35)) continue;
      const at = ((90 + turn) * Math.PI) / 180;
      marks.push(
        svg(
          "text",
          { x: (kRadius + 29) * Math.cos(at), y: (kRadius + 29) * Math.sin(at) + 5, "text-anchor": "middle" },
          `${Math.abs(angle)}`,
        ),
      );
    }
    this.scale.replaceChildren(...marks);
  }

  /** A ring sector of the scale between two rudder angles, rad. */
  private sector(from: number, to: number): string {
    const at = (angle: number, radius: number): string => {
      const turn = ((90 - degrees(angle) * kSpread) * Math.PI) / 180;
      return `${(radius * Math.cos(turn)).toFixed(2)} ${(radius * Math.sin(turn)).toFixed(2)}`;
    };
    const [outer, inner] = [kRadius, kRadius - 12];
    const sweep = to > from ? 0 : 1;
    const arc = (radius: number, turns: number, to_: number): string =>
      `A${radius} ${radius} 0 0 ${turns} ${at(to_, radius)}`;
    return `M${at(from, outer)} ${arc(outer, sweep, to)} L${at(to, inner)} ${arc(inner, 1 - sweep, from)} Z`;
  }

  private angle(event: PointerEvent): number {
    const box = this.picture.getBoundingClientRect();
    const unit = Math.min(box.width / kWide, box.height / kHigh);
    const x = event.clientX - (box.left + box.width / 2);
    const y = event.clientY - (box.top + box.height / 2) + (kHigh / 2 - 100) * unit; // the hub is above the middle
    return Math.atan2(x, -y);
  }

  private grasp(event: PointerEvent): void {
    const rudder = this.helm.levers()?.rudder;
    if (rudder === undefined || !this.helm.movable()) return;
    this.picture.setPointerCapture(event.pointerId);
    this.taken = { pointer: event.pointerId, finger: this.angle(event), rudder };
    this.helm.take();
  }

  private turn(event: PointerEvent): void {
    if (this.taken?.pointer !== event.pointerId) return;
    const finger = this.angle(event);
    const by = Math.atan2(Math.sin(finger - this.taken.finger), Math.cos(finger - this.taken.finger));
    const most = this.helm.rudderMax();
    // Adds up, so that the hand may go round; at the stops the wheel waits for it.
    const rudder = Math.min(most, Math.max(-most, this.taken.rudder + by / kGain));
    this.taken = { ...this.taken, finger, rudder };
    this.helm.put({ rudder: radians(Math.round(degrees(rudder))) });
  }

  private release(event: PointerEvent): void {
    if (this.taken?.pointer === event.pointerId) this.taken = undefined;
  }

  private key(event: KeyboardEvent): void {
    const steps: Record<string, number> = { ArrowLeft: -1, ArrowRight: 1, ArrowDown: -1, ArrowUp: 1 };
    const step = steps[event.key];
    if (step === undefined && event.key !== "Home") return;
    event.preventDefault();
    this.helm.put({ rudder: step === undefined ? 0 : (this.helm.levers()?.rudder ?? 0) + radians(step) });
  }
}

/** 5 degrees of rudder more, to starboard (1) or port (-1), on fives. */
export function stepRudder(helm: HelmHand, by: number): void {
  const rudder = helm.levers()?.rudder ?? 0;
  const fives = rudder / kKeyStep;
  const next = by > 0 ? Math.floor(fives + 1e-6) + 1 : Math.ceil(fives - 1e-6) - 1;
  helm.put({ rudder: next * kKeyStep });
}
