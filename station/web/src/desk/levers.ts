// Levers live: how they are set and how they are, whose hand has them; and the instructor's own hand.

import { h, setAttribute, setText, setVariable } from "../kit/dom";
import {
  type Authority,
  helmAuthority,
  helmOrdered,
  ownerWords,
  takenWords,
  windlassAuthority,
  windlassOrdered,
} from "../kit/authority";
import { holdButton } from "../kit/hold_button";
import { showsTopic } from "../kit/live";
import { Men } from "../kit/men";
import { everySecond } from "../kit/page";
import { Popover } from "../kit/popover";
import { degrees, figure, radians, sideWord } from "../kit/units";
import type { HelmLevers, WindlassLevers } from "../wire/connection";
import { ClutchState, type HelmCommand, type WindlassCommand } from "../wire/generated";
import type { Desk } from "./desk";
import { t } from "../kit/language";

/** One lever: what is set, what is. In hand it is a slider or a switch. */
interface Lever {
  element: HTMLElement;
  /** set: as ordered by whoever has it; now: as it is; NaN where unknown. */
  show: (set: number, now: number) => void;
  /** Its slider or switch, as the hand has it. */
  put: (value: number) => void;
  inHand: (held: boolean) => void;
}

function slider(
  label: string,
  unit: string,
  low: number,
  high: number,
  step: number,
  moved: (value: number) => void,
): Lever {
  const set = h("b", {}, "-");
  const now = h("b", {}, "-");
  const input = h("input", { type: "range", min: `${low}`, max: `${high}`, step: `${step}`, disabled: true });
  input.setAttribute("aria-label", `${label}, ${unit}`);
  const bar = h("i", { class: "meter", "aria-hidden": "true" });
  const words = (value: number): string => figure(value, step < 1 ? 1 : 0);
  input.addEventListener("input", () => moved(Number(input.value)));
  const zero = h(
    "button",
    {
      class: "plain zero",
      disabled: true,
      "aria-label": t("0: {label} to zero", { label }),
      onclick: () => ((input.value = "0"), moved(0)),
    },
    "0",
  );
  const place = (value: number): string =>
    `${Math.min(100, Math.max(0, (100 * (value - low)) / (high - low))).toFixed(1)}%`;
  bar.style.setProperty("--zero", place(0));
  return {
    element: h(
      "div",
      { class: "lever" },
      h("span", { class: "label" }, label, low < 0 && zero),
      h("span", { class: "track" }, bar, input),
      h("span", { class: "set" }, set),
      h("span", { class: "now" }, now),
      h("span", { class: "unit" }, unit),
    ),
    show: (s, n) => {
      setText(set, words(s));
      setText(now, words(n));
      setVariable(bar, "--now", place(n));
      const shown = `${Math.round(Number.isFinite(s) ? s : n)}`;
      if (input.disabled && input.value !== shown) input.value = shown;
    },
    put: (value) => (input.value = `${value}`),
    inHand: (held) => {
      input.disabled = !held;
      zero.disabled = !held;
    },
  };
}

function toggle(label: string, on: string, off: string, moved: (value: number) => void): Lever {
  const now = h("b", {}, "-");
  const button = h("button", { class: "plain switch", role: "switch", "aria-label": label, disabled: true });
  const put = (value: number): void => {
    setAttribute(button, "aria-checked", `${value > 0}`);
    setText(button, value > 0 ? on : off);
  };
  put(0);
  button.addEventListener("click", () => {
    const value = button.getAttribute("aria-checked") === "true" ? 0 : 1;
    put(value);
    moved(value);
  });
  return {
    element: h(
      "div",
      { class: "lever two" },
      h("span", { class: "label" }, label),
      button,
      h("span", { class: "now" }, `${t("is|set and is")} `, now),
    ),
    show: (s, n) => {
      if (button.disabled) put(Number.isFinite(s) ? s : n); // as it is, where nobody has set it
      setText(now, Number.isNaN(n) ? "-" : n === 0.5 ? t("moving") : n > 0 ? on : off);
    },
    put,
    inHand: (held) => (button.disabled = !held),
  };
}

/** A card of levers that a hand can take. */
abstract class Card {
  readonly element: HTMLElement;
  private readonly who = h("span", { class: "who" });
  private readonly take: HTMLButtonElement;
  private readonly back = h("button", { class: "plain", hidden: true, onclick: () => this.letGo() }, t("Hand back"));
  protected held = false;
  private readonly header: HTMLElement;

  constructor(
    protected readonly desk: Desk,
    protected readonly what: number | "helm",
    title: string,
    protected readonly levers: Lever[],
  ) {
    this.take = holdButton(t("Take over"), 0.6, () => this.takeOver(), {
      class: "plain",
      "data-gives": what === "helm" ? "InstructorHelmCommand" : "InstructorWindlassCommand",
      "aria-label": t("take over {title}", { title }),
    });
    this.back.setAttribute("aria-label", t("hand back {title}", { title }));
    const isSwitch = (lever: Lever): boolean => lever.element.classList.contains("two");
    this.header = h("header", {}, h("h3", {}, title), this.who, this.take, this.back);
    this.element = h(
      "section",
      { class: "lever-card", "data-what": `${what}`, "aria-label": t("levers, {title}", { title }) },
      this.header,
      h(
        "div",
        { class: "lever-head", "aria-hidden": "true" },
        h("span", {}, t("set")),
        h("span", {}, t("now")),
        h("span", {}),
      ),
      ...levers.filter((lever) => !isSwitch(lever)).map((lever) => lever.element),
      h("div", { class: "switches" }, ...levers.filter(isSwitch).map((lever) => lever.element)),
    );
    desk.link.onState((state) => state !== "open" && this.drop());
    desk.link.onMessage("levers", (message) => {
      const ours = what === "helm" ? message.helm === true : message.side === what;
      const another = message.by === "another"; // page of this station, while this one was silent for too long
      if (!ours || !this.held || (message.held !== false && !another)) return;
      if (another) desk.link.letGo(what);
      else if (desk.link.holds(what)) return;
      this.drop();
      const taken = another ? t("another page of this station has these levers") : takenWords(desk.link, message);
      if (taken) desk.say(taken);
    });
  }

  /** Beside the title: what is ordered without a hand on the levers. */
  protected offer(button: HTMLButtonElement): void {
    this.header.insertBefore(button, this.take);
  }

  /** Puts the levers into the hand as they are; false: they are not known. */
  protected abstract begin(): boolean;
  abstract update(): void;
  /** Whose these levers are, by what is heard: this desk's hand is one of several. */
  protected abstract authority(): Authority<WindlassCommand | HelmCommand>;

  private takeOver(): void {
    if (this.desk.replay) return this.desk.say(t("This is a replay: levers move nothing"));
    if (!this.begin()) return this.desk.say(t("Nothing is known of these levers yet"));
    this.held = true;
    this.showHeld();
  }
  letGo(): void {
    this.desk.link.letGo(this.what);
    this.drop();
  }
  private drop(): void {
    this.held = false;
    this.showHeld();
  }
  private showHeld(): void {
    this.element.classList.toggle("in-command", this.held);
    this.take.hidden = this.held;
    this.back.hidden = !this.held;
    for (const lever of this.levers) lever.inHand(this.held);
    document.body.classList.toggle("in-command", document.querySelector(".lever-card.in-command") !== null);
  }
  protected showHand(): void {
    const { owner, name } = this.authority();
    const words =
      owner === "mine"
        ? t("in your hand")
        : owner === "instructor"
          ? t("{name}, instructor", { name })
          : ownerWords({ owner, name });
    setText(this.who, this.desk.replay ? t("as recorded") : words);
    this.who.dataset.hand = owner === "other" ? "trainee" : owner;
  }
}

class WindlassCard extends Card {
  private hand: WindlassLevers = {
    brake: 1,
    speed_lever: 0,
    clutch_in: false,
    stopper_closed: false,
    emergency_stop: false,
  };
  private readonly men: Men;

  constructor(
    desk: Desk,
    private readonly side: number,
  ) {
    super(desk, side, t("{side} windlass", { side: sideWord(side) }), [
      slider(t("brake on"), "%", 0, 100, 1, (v) => this.move({ brake: v / 100 })),
      slider(t("speed, heave +"), "%", -100, 100, 5, (v) => this.move({ speed_lever: v / 100 })),
      toggle(t("clutch"), t("in"), t("out"), (v) => this.move({ clutch_in: v > 0 })),
      toggle(t("stopper"), t("closed"), t("open"), (v) => this.move({ stopper_closed: v > 0 })),
      toggle(t("emergency stop"), t("pressed"), t("free|emergency stop"), (v) => this.move({ emergency_stop: v > 0 })),
    ]);
    this.men = new Men(
      desk.link,
      () => side,
      new Popover(this.element),
      (text) => desk.say(text),
    );
    this.offer(this.men.button);
  }

  private move(change: Partial<WindlassLevers>): void {
    if (!this.held) return;
    this.hand = { ...this.hand, ...change };
    this.desk.link.holdLevers(this.side, this.hand);
  }

  protected begin(): boolean {
    const now = this.desk.link.latest("WindlassLoad", this.side);
    if (!now) return false;
    this.hand = {
      brake: now.brake_position,
      speed_lever: now.speed_lever,
      clutch_in: now.clutch !== ClutchState.CLUTCH_OUT,
      stopper_closed: now.stopper_closed,
      emergency_stop: now.emergency_stop,
    };
    const values = [
      100 * this.hand.brake,
      100 * this.hand.speed_lever,
      this.hand.clutch_in,
      this.hand.stopper_closed,
      this.hand.emergency_stop,
    ];
    values.forEach((value, i) => this.levers[i]!.put(Number(value)));
    this.desk.link.holdLevers(this.side, this.hand);
    return true;
  }

  protected authority(): Authority<WindlassCommand> {
    return windlassAuthority(this.desk.link, this.side, performance.now());
  }

  update(): void {
    const { link } = this.desk;
    const now = link.latest("WindlassLoad", this.side);
    const set = this.authority().command ?? windlassOrdered(link, this.side);
    const clutch = now
      ? now.clutch === ClutchState.CLUTCH_ENGAGING
        ? 0.5
        : Number(now.clutch === ClutchState.CLUTCH_IN)
      : NaN;
    const [brake, speed, claws, bar, stop] = this.levers as [Lever, Lever, Lever, Lever, Lever];
    brake.show(100 * (set?.brake ?? NaN), 100 * (now?.brake_position ?? NaN));
    speed.show(100 * (set?.speed_lever ?? NaN), 100 * (now?.speed_lever ?? NaN));
    claws.show(Number(set?.clutch_in ?? NaN), clutch);
    bar.show(Number(set?.stopper_closed ?? NaN), Number(now?.stopper_closed ?? NaN));
    stop.show(Number(set?.emergency_stop ?? NaN), Number(now?.emergency_stop ?? NaN));
    this.men.show();
    this.showHand();
  }
}

class HelmCard extends Card {
  private hand: HelmLevers = { engine: 0, rudder: 0, bow_thruster: 0, stern_thruster: 0 };

  constructor(desk: Desk) {
    super(desk, "helm", t("helm|levers"), [
      slider(t("engine"), "%", -100, 100, 5, (v) => this.move({ engine: v / 100 })),
      slider(t("rudder"), "\u00b0", -35, 35, 1, (v) => this.move({ rudder: radians(v) })),
      slider(t("bow thruster"), "%", -100, 100, 5, (v) => this.move({ bow_thruster: v / 100 })),
      slider(t("stern thruster"), "%", -100, 100, 5, (v) => this.move({ stern_thruster: v / 100 })),
    ]);
    desk.link.on("SceneDescription", (scene) => {
      const input = this.levers[1]!.element.querySelector("input")!;
      input.max = `${Math.round(degrees(scene.rudder_max))}`;
      input.min = `-${input.max}`;
    });
  }

  private move(change: Partial<HelmLevers>): void {
    if (!this.held) return;
    this.hand = { ...this.hand, ...change };
    this.desk.link.holdHelm(this.hand);
  }

  protected begin(): boolean {
    const found = helmOrdered(this.desk.link);
    if (!found) return false;
    this.hand = found;
    const { engine, rudder, bow_thruster, stern_thruster } = found;
    [100 * engine, degrees(rudder), 100 * bow_thruster, 100 * stern_thruster].forEach((value, i) =>
      this.levers[i]!.put(value),
    );
    this.desk.link.holdHelm(this.hand);
    return true;
  }

  protected authority(): Authority<HelmCommand> {
    return helmAuthority(this.desk.link, performance.now());
  }

  update(): void {
    const { link } = this.desk;
    const now = link.latest("ShipState");
    const set = helmOrdered(link);
    const [engine, rudder, bow, stern] = this.levers as [Lever, Lever, Lever, Lever];
    engine.show(100 * (set?.engine ?? NaN), 100 * (now?.engine ?? NaN));
    rudder.show(degrees(set?.rudder ?? NaN), degrees(now?.rudder ?? NaN));
    bow.show(100 * (set?.bow_thruster ?? NaN), 100 * (now?.bow_thruster ?? NaN));
    stern.show(100 * (set?.stern_thruster ?? NaN), 100 * (now?.stern_thruster ?? NaN));
    this.showHand();
  }
}

export class LeverPanel {
  readonly element: HTMLElement;

  constructor(desk: Desk) {
    const cards = [new WindlassCard(desk, 0), new WindlassCard(desk, 1), new HelmCard(desk)];
    [0, 1].forEach((side) => showsTopic(cards[side]!.element, desk.link, "WindlassLoad", () => side));
    showsTopic(cards[2]!.element, desk.link, "ShipState");
    desk.onSides((sides) => [0, 1].forEach((side) => (cards[side]!.element.hidden = !sides.includes(side))));
    this.element = h("div", { class: "levers scroll" }, ...cards.map((card) => card.element));
    everySecond(8, () => cards.forEach((card) => card.update()));
  }
}
