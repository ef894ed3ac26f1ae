// What the parts of the desk share: the link, orders with their refusals in sight, which windlass is looked at.

import { h, setAttribute, setText } from "../kit/dom";
import type { Page } from "../kit/page";
import type { Connection, OrderSample } from "../wire/connection";
import { RunState, type TopicName } from "../wire/generated";
import { type TypedFields, asTyped } from "./as_typed";
import { EventStore } from "./events";
import { type Gives, mayGive, withheld } from "./may_give";
import { RecordedPast } from "./recorded_past";
import { t } from "../kit/language";

const kAnswer = 4000; // ms after an order in which a refusal by the server is taken to be meant for it

export class Desk {
  readonly link: Connection;
  readonly events: EventStore;
  /** Of a replay: tells what is drawn over time what was. */
  readonly past: RecordedPast;
  /** Says what was refused, and why; heard by screen readers. */
  readonly notice: HTMLElement;
  private readonly words = h("span", {});
  private ordered = -Infinity;
  private typed: TypedFields = () => undefined; // of the order given last
  private side_ = 0;
  private readonly sideListeners = new Set<(side: number) => void>();

  constructor(readonly page: Page) {
    this.link = page.link;
    this.events = new EventStore(page.link);
    this.past = new RecordedPast(page.link);
    this.notice = h(
      "div",
      { class: "notice", role: "status", "aria-live": "polite", hidden: true },
      this.words,
      h("button", { class: "plain", onclick: () => (this.notice.hidden = true) }, t("Close")),
    );
    this.events.onChange((event) => {
      if (event?.code !== "command.refused" || performance.now() - this.ordered > kAnswer) return;
      if (!event.text.includes(this.link.hello?.name ?? "")) return;
      event.text = asTyped(event.text, this.typed); // the log, which is told after us, says it in the same words
      this.say(event.text);
    });
  }

  /** Gives an order; a refusal is shown, its figures as they were typed. Resolves to whether it went out. */
  give(topic: TopicName, sample: OrderSample, typed: TypedFields = () => undefined): Promise<boolean> {
    this.typed = typed;
    if (this.link.hello && !this.may(topic)) {
      this.say(t("This seat may not order that.")); // it came by a key: what would be touched is not there
      return Promise.resolve(false);
    }
    return this.ask(() => this.link.order(topic, sample));
  }

  /** Any message that is answered, e.g. () => link.ask({ op: "record", on: true }). */
  async ask(send: () => Promise<void>): Promise<boolean> {
    this.ordered = performance.now();
    this.notice.hidden = true;
    try {
      await send();
      return true;
    } catch (why) {
      this.say((why as Error).message);
      return false;
    }
  }

  say(text: string): void {
    this.notice.hidden = false;
    setText(this.words, text);
  }

  /** Whether this is a replay: nothing here can be ordered then but the replay itself. */
  get replay(): boolean {
    return (
      this.link.latest("ReplayStatus") !== undefined ||
      this.link.latest("ExerciseStatus")?.state === RunState.RUN_REPLAY
    );
  }

  /** Whether this seat may give that now. */
  may(what: Gives): boolean {
    return mayGive(this.link.hello, this.replay, what);
  }

  /** Names on an element what is not given, so that the controls within it that give it are not there. */
  withholdFrom(element: HTMLElement): void {
    setAttribute(element, "data-withheld", withheld(this.link.hello, this.replay).join(" "));
  }

  /** The windlass whose figures are plotted: 0 port, 1 starboard. */
  get side(): number {
    return this.side_;
  }
  set side(side: number) {
    if (side === this.side_) return;
    this.side_ = side;
    for (const listener of this.sideListeners) listener(side);
  }
  onSide(listener: (side: number) => void): void {
    this.sideListeners.add(listener);
    listener(this.side_);
  }

  /** Calls back with the sides that the exercise has, at each set-up. */
  onSides(listener: (sides: number[]) => void): void {
    this.link.on("SceneDescription", (scene) => listener(scene.tackle.map((tackle) => tackle.side)));
  }
}
