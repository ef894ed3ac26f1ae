// A weighty act must be held: by a pointer, a key or a gamepad, each of which lets go of what is its own.

import assert from "node:assert/strict";
import { type TestContext, test } from "node:test";

import { HoldGuard, holdButton } from "../../src/kit/hold_button";

const kTime = 600; // ms

/** What of a button is asked for. */
class Button extends EventTarget {
  disabled = false;
  textContent = "";
  inside: Button | undefined;
  readonly attributes = new Map<string, string>();
  readonly classList = new Set<string>();
  readonly style = { setProperty: () => {} };
  setPointerCapture(): void {}
  append(child: Button | string): void {
    if (typeof child === "string") this.textContent += child;
    else this.inside = child;
  }
  setAttribute(name: string, value: string): void {
    this.attributes.set(name, value);
  }
  getAttribute(name: string): string | null {
    return this.attributes.get(name) ?? null;
  }
  removeAttribute(name: string): void {
    this.attributes.delete(name);
  }
  get held(): boolean {
    return this.attributes.has("data-held");
  }
  /** An event as the browser makes it. */
  get(type: string, fields: object = {}): void {
    this.dispatchEvent(Object.assign(new Event(type, { cancelable: true }), fields));
  }
}

/** Timers by the test's clock: go(ms) lets time pass. */
function clock(t: TestContext): (ms: number) => void {
  let now = 0;
  let last = 0;
  const waiting = new Map<number, { at: number; act: () => void }>();
  t.mock.method(globalThis, "setTimeout", ((act: () => void, ms: number) => {
    waiting.set(++last, { at: now + ms, act });
    return last;
  }) as unknown as typeof setTimeout);
  t.mock.method(globalThis, "clearTimeout", ((which: number) => waiting.delete(which)) as typeof clearTimeout);
  return (ms) => {
    now += ms;
    for (const [which, { at, act }] of [...waiting].sort(([, a], [, b]) => a.at - b.at))
      if (at <= now && waiting.delete(which)) act();
  };
}

/** A guarded button; time goes on by the test's clock. */
function guarded(t: TestContext, time = kTime) {
  const wait = clock(t);
  const button = new Button();
  const seen = { acts: 0, waits: [] as boolean[], tooShort: 0 };
  const guard = new HoldGuard(
    button as unknown as HTMLButtonElement,
    () => time,
    () => ++seen.acts,
    (again) => seen.waits.push(again),
    () => ++seen.tooShort,
  );
  return { button, guard, seen, wait };
}
const down = (pointerId: number): object => ({ pointerId, button: 0 });

test("it acts when it was held, and not when it was touched", (t) => {
  const { button, seen, wait } = guarded(t);
  button.get("pointerdown", down(1));
  assert.ok(button.held);
  wait(kTime - 1);
  button.get("pointerup", down(1));
  wait(kTime);
  assert.equal(seen.acts, 0);
  assert.ok(!button.held);
  button.get("pointerdown", down(1));
  wait(kTime);
  assert.equal(seen.acts, 1);
  assert.ok(!button.held);
});

test("who has only touched it is told that it is to be held, and who has held it is not", (t) => {
  const { button, seen, wait } = guarded(t);
  button.get("pointerdown", down(1));
  button.get("pointerup", down(1));
  assert.equal(seen.tooShort, 1);
  button.get("lostpointercapture", down(1)); // comes behind each release
  assert.equal(seen.tooShort, 1);
  button.get("pointerdown", down(1));
  wait(kTime);
  button.get("pointerup", down(1));
  assert.deepEqual([seen.acts, seen.tooShort], [1, 1]);
});

test("a second finger, on another control or on this one, does not let go of it", (t) => {
  const { button, seen, wait } = guarded(t);
  button.get("pointerdown", down(1));
  wait(kTime / 2);
  button.get("blur"); // the other control has the focus now
  button.get("pointerdown", down(2));
  button.get("pointerup", down(2));
  wait(kTime / 2);
  assert.equal(seen.acts, 1);
});

test("a key holds it as long as it is down and the button has the focus", (t) => {
  const { button, seen, wait } = guarded(t);
  button.get("keydown", { key: "Enter", repeat: false });
  wait(kTime / 2);
  button.get("keydown", { key: "Enter", repeat: true });
  button.get("blur");
  wait(kTime);
  assert.equal(seen.acts, 0);
  button.get("keydown", { key: " ", repeat: false });
  wait(kTime);
  assert.equal(seen.acts, 1);
});

test("a gamepad holds it, and a button that is off is not held", (t) => {
  const { button, guard, seen, wait } = guarded(t);
  button.disabled = true;
  guard.press();
  wait(kTime);
  assert.equal(seen.acts, 0);
  button.disabled = false;
  guard.press();
  guard.release();
  wait(kTime);
  assert.equal(seen.acts, 0);
  guard.press();
  wait(kTime);
  assert.equal(seen.acts, 1);
});

test("a click without a hand does it at the second, within 3 s", (t) => {
  const { button, seen, wait } = guarded(t);
  button.get("click", { detail: 1 }); // of a pointer: it has to be held
  assert.deepEqual(seen.waits, []);
  button.get("click", { detail: 0 });
  wait(3001);
  button.get("click", { detail: 0 });
  assert.equal(seen.acts, 0);
  assert.deepEqual(seen.waits, [true, false, true]);
  button.get("click", { detail: 0 });
  assert.equal(seen.acts, 1);
  assert.deepEqual(seen.waits, [true, false, true, false]);
});

test("where nothing is to be held it acts at the touch", (t) => {
  const { button, seen } = guarded(t, 0);
  button.get("pointerdown", down(1));
  assert.equal(seen.acts, 1);
  button.get("click", { detail: 0 });
  assert.equal(seen.acts, 2);
});

test("a button that was only touched says that it is to be held, until it was or some seconds are over", (t) => {
  const wait = clock(t);
  Object.assign(globalThis, { Node: Button, document: { createElement: () => new Button() } });
  let acts = 0;
  const button = holdButton("Take over", 0.6, () => ++acts) as unknown as Button;
  const says = () => button.inside?.textContent;
  const touch = () => {
    button.get("pointerdown", down(1));
    button.get("pointerup", down(1));
  };
  touch();
  wait(5900);
  assert.deepEqual([says(), button.attributes.has("data-told"), acts], ["Hold: Take over", true, 0]);
  wait(200);
  assert.deepEqual([says(), button.attributes.has("data-told")], ["Take over", false]);
  touch();
  button.get("pointerdown", down(1));
  wait(600);
  assert.deepEqual([says(), acts], ["Take over", 1]);
});
