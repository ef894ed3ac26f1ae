// The keyboard as the hands of the forecastle. Keys that move a lever act while they are held.

import { t } from "../kit/language";
import { typeIntoOpenPad } from "../kit/pad";

export interface Hands {
  /** Turns the hand-wheel at a share -1..1 of its rate. */
  wheel(share: number): void;
  /** By so many turns. */
  turn(turns: number): void;
  /** A key of the hand-wheel is down (1 on, -1 off) or up (0). at, here and below: when, ms; else now. */
  key(way: number, fine: boolean, at?: number): void;
  spin(to: number): void;
  push(to: number, at?: number): void;
  release(at?: number): void;
  zero(): void;
  clutch(held: boolean): void;
  stopper(held: boolean): void;
  stop(held: boolean): void;
  side(): void;
  camera(number: number): void;
  mute(): void;
  palette(): void;
  captions(): void;
  lamp(): void;
  report(): void;
  repeat(): void;
  acknowledge(): void;
  silence(): void;
  help(): void;
}

/** What ? shows: keys, what they do. */
export const keyTable: readonly (readonly [string, string])[] = [
  [t("Up, Down"), t("brake on, off: tap for 10\u00b0, hold to turn; with Shift a fifth of it")],
  ["b, 0", t("brake hard on, open")],
  [t("Right, Left"), t("heave, lower while held; with Shift 10 %")],
  ["x", t("speed lever to zero")],
  [t("c, t (hold)"), t("clutch, stopper")],
  ["e", t("emergency stop; hold 1.5 s to release")],
  ["p, Tab", t("the other windlass; next control")],
  [t("1 to 4"), t("stand, over the bow, at the brake, aft")],
  ["r, o", t("report, repeat the order back")],
  ["F2, F3", t("acknowledge the topmost alert, silence")],
  ["m, n, k, l", t("sound, palette, captions, hand lamp")],
  ["?", t("this help")],
];

const typing = (target: EventTarget | null): boolean =>
  target instanceof HTMLInputElement || target instanceof HTMLTextAreaElement || target instanceof HTMLSelectElement;

export function listenToKeys(hands: Hands): void {
  const held = new Set<string>();
  const pushed = (): boolean => held.has("ArrowLeft") || held.has("ArrowRight");
  const turns = (): boolean => held.has("ArrowUp") || held.has("ArrowDown");
  const levers = (fine: boolean, at: number): void => {
    const up = held.has("ArrowUp");
    const down = held.has("ArrowDown");
    hands.key(up === down ? 0 : up ? 1 : -1, fine, at);
  };
  const push = (shift: boolean, at: number): void => {
    const right = held.has("ArrowRight");
    const left = held.has("ArrowLeft");
    if (right === left) hands.release(at);
    else hands.push((right ? 1 : -1) * (shift ? 0.1 : 1), at);
  };
  const holds: { [key: string]: (held: boolean) => void } = {
    c: (down) => hands.clutch(down),
    t: (down) => hands.stopper(down),
    e: (down) => hands.stop(down),
  };
  const once: { [key: string]: () => void } = {
    "0": () => hands.spin(0),
    b: () => hands.spin(1),
    x: () => hands.zero(),
    p: () => hands.side(),
    m: () => hands.mute(),
    n: () => hands.palette(),
    k: () => hands.captions(),
    l: () => hands.lamp(),
    r: () => hands.report(),
    o: () => hands.repeat(),
    F2: () => hands.acknowledge(),
    F3: () => hands.silence(),
    "?": () => hands.help(),
  };
  for (let n = 1; n <= 9; ++n) once[`${n}`] = () => hands.camera(n);

  const key = (event: KeyboardEvent): string => (event.key.length === 1 ? event.key.toLowerCase() : event.key);
  addEventListener("keydown", (event) => {
    const name = key(event);
    const at = event.timeStamp; // not when it is heard: a page that is slow hears late of a key that was let go
    if (name === "Shift" && pushed()) push(true, at);
    if (name === "Shift" && turns()) levers(true, at);
    if (typing(event.target) || event.ctrlKey || event.altKey || event.metaKey || typeIntoOpenPad(event)) return;
    if (name.startsWith("Arrow")) {
      event.preventDefault();
      if (held.has(name)) return;
      held.add(name);
      if (name === "ArrowUp" || name === "ArrowDown") levers(event.shiftKey, at);
      else push(event.shiftKey, at);
    } else if (holds[name]) {
      if (held.has(name)) return;
      held.add(name);
      holds[name](true);
    } else if (once[name] && !event.repeat) {
      event.preventDefault();
      once[name]();
    }
  });
  addEventListener("keyup", (event) => {
    const name = key(event);
    const at = event.timeStamp;
    if (name === "Shift" && pushed()) push(false, at);
    if (name === "Shift" && turns()) levers(false, at);
    if (!held.delete(name)) return;
    if (name === "ArrowUp" || name === "ArrowDown") levers(event.shiftKey, at);
    else if (name.startsWith("Arrow")) push(event.shiftKey, at);
    else holds[name]?.(false);
  });
  const leave = (): void => {
    for (const name of held) holds[name]?.(false);
    held.clear();
    hands.wheel(0);
    hands.key(0, false);
    hands.release();
  };
  addEventListener("blur", leave);
  document.addEventListener("visibilitychange", () => document.hidden && leave());
}
