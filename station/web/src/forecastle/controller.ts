// What the axes and buttons of a controller do: of a gamepad, a joystick, or a hand-wheel that presents itself as one.
// Nothing here touches the browser but the memory, which is kept by device.

import { t } from "../kit/language";

/** What of the Gamepad API is read. */
export interface Pad {
  axes: readonly number[];
  buttons: readonly { value: number; pressed: boolean }[];
}

/**
 * How a control goes: "turn" by where its axis stands, in turns of the hand-wheel; "way" -1..1 about its rest; "push"
 * 0..1 from its rest; "press" while it is down.
 */
export type Kind = "turn" | "way" | "push" | "press";

/** What can be moved, in the order of the dialog. */
export const controls = {
  wheel: { kind: "turn", name: t("hand-wheel, turned as it is") },
  on: { kind: "push", name: t("brake on, by rate") },
  off: { kind: "push", name: t("brake off, by rate") },
  fine: { kind: "way", name: t("brake on and off, fine") },
  speed: { kind: "way", name: t("speed lever") },
  clutch: { kind: "press", name: t("clutch (held)") },
  stopper: { kind: "press", name: t("stopper (held)") },
  stop: { kind: "press", name: t("emergency stop") },
  side: { kind: "press", name: t("the other windlass") },
  choose: { kind: "press", name: t("repeat the order, or choose") },
  next: { kind: "press", name: t("next report") },
  back: { kind: "press", name: t("report before") },
  acknowledge: { kind: "press", name: t("acknowledge") },
  help: { kind: "press", name: t("help") },
} as const satisfies Record<string, { kind: Kind; name: string }>;
export type Control = keyof typeof controls;
export const controlNames = Object.keys(controls) as Control[];

/** A control and what moves it. An axis gives -1..1, a button 0..1. */
export interface Assignment {
  control: Control;
  source: "axis" | "button";
  index: number;
  /** Where it stands when no hand is on it; of "turn": not used. */
  rest: number;
  /** Its end the one way, and the other: on, heave, clockwise. */
  from: number;
  to: number;
  /** Share of its way about the rest that does nothing. */
  dead: number;
  /** Of "turn": turns of the hand-wheel between its ends. */
  turns: number;
  /** Of "turn": beyond one end it goes on at the other. */
  endless: boolean;
}
export type Mapping = readonly Assignment[];

/** How a device is used. */
export interface Settings {
  mapping: Mapping;
  vibrates: boolean;
}

const kDead = 0.12; // of a stick's way
const kTrigger = 0.05; // of a trigger's
const kDown = 0.5; // of a button's way
const kTurns = 5; // of a hand-wheel from end to end, until it is told
const clamp = (value: number, low: number, high: number): number => Math.min(high, Math.max(low, value));

const made = (control: Control, source: "axis" | "button", index: number, more: Partial<Assignment>): Assignment => ({
  control,
  source,
  index,
  rest: 0,
  from: source === "axis" ? -1 : 0,
  to: 1,
  dead: 0,
  turns: kTurns,
  endless: false,
  ...more,
});
const button = (control: Control, index: number): Assignment => made(control, "button", index, {});

/** Of the API's standard gamepad: triggers turn the brake, right stick finely, left stick is the speed lever. */
export const standardMapping: Mapping = [
  made("on", "button", 7, { dead: kTrigger }),
  made("off", "button", 6, { dead: kTrigger }),
  made("fine", "axis", 2, { dead: kDead }),
  made("speed", "axis", 1, { from: 1, to: -1, dead: kDead }), // away from one heaves
  button("clutch", 2),
  button("stopper", 3),
  button("stop", 8),
  button("side", 4),
  button("side", 5),
  button("choose", 0),
  button("next", 13),
  button("next", 15),
  button("back", 12),
  button("back", 14),
  button("acknowledge", 1),
  button("help", 9),
];

const raw = ({ source, index }: Pick<Assignment, "source" | "index">, pad: Pad): number | undefined =>
  source === "axis" ? pad.axes[index] : pad.buttons[index]?.value;

/** What it gives now: turns, -1..1, 0..1, or 0 and 1, by the control's kind; 0 where the device has no such source. */
export function valueOf(assignment: Assignment, pad: Pad): number {
  const at = raw(assignment, pad);
  if (at === undefined || !Number.isFinite(at)) return 0;
  const { rest, from, to, dead } = assignment;
  const share = (end: number): number => (end === rest ? 0 : clamp((at - rest) / (end - rest), 0, 1));
  const alive = (value: number): number => (value <= dead ? 0 : (value - dead) / (1 - dead));
  switch (controls[assignment.control].kind) {
    case "turn":
      return to === from ? 0 : ((at - from) / (to - from)) * assignment.turns;
    case "way":
      return alive(share(to)) || -alive(share(from)) || 0;
    case "push":
      return alive(share(to));
    case "press":
      return share(to) >= kDown ? 1 : 0;
  }
}

/** Turns that an endless hand-wheel, or one with ends, went on from one reading to the next. */
export function turned({ endless, turns }: Pick<Assignment, "endless" | "turns">, before: number, now: number): number {
  const by = now - before;
  return endless ? by - Math.round(by / turns) * turns : by; // the short way round
}

/** The same source the other way about. */
export function inverted(assignment: Assignment): Assignment {
  const { rest, from, to } = assignment;
  const oneWay = ["push", "press"].includes(controls[assignment.control].kind);
  return oneWay ? { ...assignment, rest: to, to: rest } : { ...assignment, from: to, to: from };
}

const kMoved = 0.4; // of an axis's unit, from which a hand means it
const kLeap = 1; // of it, from one reading to the next: a hand-wheel has gone round

/** Watches a device while a hand moves what shall be a control: first the way that is on, heave or clockwise. */
export class Learner {
  private readonly axes: {
    rest: number;
    low: number;
    high: number;
    /** As read last; how far it has come, gone round or not; which way it went at first; how often it went round. */
    at: number;
    way: number;
    first: number;
    rounds: number;
  }[];
  private readonly buttons: { rest: number; most: number }[];

  /** at: the device while no hand moves it. */
  constructor(
    private readonly control: Control,
    at: Pad,
  ) {
    this.axes = at.axes.map((rest) => ({ rest, low: rest, high: rest, at: rest, way: 0, first: 0, rounds: 0 }));
    this.buttons = at.buttons.map(({ value }) => ({ rest: value, most: value }));
  }

  /** To be called with each reading. */
  see(pad: Pad): void {
    this.axes.forEach((axis, i) => {
      const at = pad.axes[i] ?? axis.rest;
      axis.low = Math.min(axis.low, at);
      axis.high = Math.max(axis.high, at);
      const by = at - axis.at;
      axis.at = at;
      if (controls[this.control].kind === "turn" && Math.abs(by) > kLeap) ++axis.rounds;
      else axis.way += by;
      if (axis.first === 0 && Math.abs(axis.way) >= kMoved) axis.first = Math.sign(axis.way);
    });
    this.buttons.forEach((one, i) => (one.most = Math.max(one.most, pad.buttons[i]?.value ?? 0)));
  }

  /** What has moved farthest, and how far; undefined: nothing that a hand would mean. */
  found(): Assignment | undefined {
    const kind = controls[this.control].kind;
    let best: { way: number; as: Assignment } | undefined;
    const offer = (way: number, as: Assignment): void => {
      if (way >= kMoved && way > (best?.way ?? 0)) best = { way, as };
    };
    this.axes.forEach(({ rest, low, high, first, rounds }, index) => {
      if (first === 0) return;
      const to = first > 0 ? high : low;
      const other = first > 0 ? low : high;
      // Of a stick that was only moved one way the other is as long.
      const from = Math.abs(other - rest) >= kMoved || kind === "turn" ? other : clamp(2 * rest - to, -1, 1);
      const dead = kind === "turn" ? 0 : kind === "way" ? kDead : kTrigger;
      // What has gone round is endless, from one end of the axis to the other in one turn.
      const round = rounds > 0 ? { from: -first, to: first, endless: true, turns: 1 } : {};
      offer(high - low, made(this.control, "axis", index, { rest, from, to, dead, ...round }));
    });
    if (kind === "push" || kind === "press")
      this.buttons.forEach(({ rest, most }, index) => {
        const dead = kind === "push" ? kTrigger : 0;
        offer(most - rest, made(this.control, "button", index, { rest, to: most, dead }));
      });
    return best?.as;
  }
}

/** The mapping with one control given to another source. */
export const withLearned = (mapping: Mapping, learned: Assignment): Mapping => [
  ...mapping.filter(({ control }) => control !== learned.control),
  learned,
];

/** Settings out of what was kept; undefined: it is none of ours. */
export function settingsFrom(kept: unknown): Settings | undefined {
  const { mapping, vibrates } = (kept ?? {}) as Partial<Settings>;
  if (!Array.isArray(mapping) || typeof vibrates !== "boolean") return undefined;
  const isAssignment = (one: Partial<Assignment> | null): boolean =>
    typeof one === "object" &&
    one !== null &&
    one.control !== undefined &&
    Object.hasOwn(controls, one.control) &&
    (one.source === "axis" || one.source === "button") &&
    [one.index, one.rest, one.from, one.to, one.dead, one.turns].every(Number.isFinite) &&
    typeof one.endless === "boolean";
  return mapping.every(isAssignment) ? { mapping, vibrates } : undefined;
}

const kKept = "windlass.controllers";

/** What this browser keeps of the devices that were taught, by the name that each gives itself. */
export class ControllerMemory {
  private all: { [id: string]: unknown } = {};

  constructor() {
    try {
      this.all = (JSON.parse(localStorage.getItem(kKept) ?? "{}") as typeof this.all | null) ?? {};
    } catch {
      // a browser that keeps nothing learns anew
    }
  }

  /** As taught, or of the standard gamepad; undefined: a device that nobody has taught yet. */
  of({ id, mapping }: { id: string; mapping: string }): Settings | undefined {
    const standard = mapping === "standard" ? { mapping: standardMapping, vibrates: true } : undefined;
    return settingsFrom(this.all[id]) ?? standard;
  }

  /** settings undefined: as if it had never been taught. */
  keep(id: string, settings: Settings | undefined): void {
    if (settings) this.all[id] = settings;
    else delete this.all[id];
    try {
      localStorage.setItem(kKept, JSON.stringify(this.all));
    } catch {
      // it is known until the page is closed
    }
  }
}

/** How a controller shakes: the deck under the feet, the band in the hand. Shares 0..1 of both of its motors. */
export function rumble(view: { vibration: number; brake_noise: number } | undefined): { deck: number; band: number } {
  return {
    deck: [0, 0.2, 0.6, 1][view?.vibration ?? 0] ?? 0,
    band: [0, 0.15, 0.4, 0.8][view?.brake_noise ?? 0] ?? 0,
  };
}
