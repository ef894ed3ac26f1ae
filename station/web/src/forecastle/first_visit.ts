// Four pictures for who is here for the first time: what to look at, to answer, to touch and to say. They lie over the
// picture and keep nobody from working; once put away they come back from the help alone.

import { h, setAttribute, setText, svg } from "../kit/dom";
import { orderLabel } from "../kit/words";
import { BridgeOrderCode } from "../wire/generated";
import { t } from "../kit/language";

const kOrder = orderLabel(BridgeOrderCode.BRIDGE_ORDER_LET_GO); // for example
const kSeen = "windlass.first_visit";

const byFinger = matchMedia("(pointer: coarse)").matches; // then there are no keys to tell of

interface Step {
  title: string;
  text: string;
  /** The part of the page that it is about, by its class. */
  part: string;
  picture: () => SVGElement[];
}

const line = (d: string, kind = ""): SVGElement => svg("path", { d, class: kind });
const word = (x: number, y: number, text: string): SVGElement => svg("text", { x, y }, text);

const steps: readonly Step[] = [
  {
    title: t("Look"),
    text: byFinger
      ? t(
          "You stand at the windlass. The buttons on the picture take you over the bow, to the brake and aft. How " +
            "the cable leads you see over the bow; how fast it runs you hear from where you stand.",
        )
      : t(
          "You stand at the windlass. The buttons on the picture, or the keys 1 to 4, take you over the bow, to the " +
            "brake and aft. How the cable leads you see over the bow; how fast it runs you hear from where you stand.",
        ),
    part: "scene",
    picture: () => [
      line("M 8 22 L 96 22 L 74 66 L 8 66", "hull"),
      line("M 0 78 q 10 -6 20 0 t 20 0 t 20 0 t 20 0 t 20 0 t 20 0 t 20 0 t 20 0"),
      line("M 82 34 Q 104 60 108 96", "chain"),
      line("M 118 24 q 14 -14 28 0 q -14 14 -28 0 Z"),
      svg("circle", { cx: 132, cy: 24, r: 4, class: "dot" }),
    ],
  },
  {
    title: t("Answer"),
    text: t(
      "Orders from the bridge come here. Repeat says one back; where it has a figure, you say the figure as you " +
        "understood it.",
    ),
    part: "heard",
    picture: () => [
      line("M 10 12 h 84 v 30 h -60 l -12 12 v -12 h -12 Z"),
      word(22, 32, kOrder),
      line("M 66 58 h 84 v 30 h -12 v 10 l -12 -10 h -60 Z", "mine"),
      word(78, 78, kOrder),
    ],
  },
  {
    title: t("Work"),
    text: t(
      "The first lever that you touch takes the windlass, with all levers as they were found. Turn the wheel round " +
        "its hub: with the clutch out and the stopper off it alone holds the cable. Hold the buttons of clutch and " +
        "stopper until they move; the speed lever springs back. The button on top with the units gives others.",
    ),
    part: "stand",
    picture: () => [
      svg("circle", { cx: 54, cy: 52, r: 36, class: "wheel" }),
      svg("circle", { cx: 54, cy: 52, r: 8 }),
      line("M 54 44 V 16 M 54 60 V 88 M 46 52 H 18 M 62 52 H 90"),
      line("M 84 12 A 50 50 0 0 1 104 46 m -8 -7 l 8 8 l 6 -10", "mine"),
      line("M 134 10 V 94"),
      svg("rect", { x: 120, y: 42, width: 28, height: 20, rx: 4, class: "mine" }),
    ],
  },
  {
    title: t("Report"),
    text: t(
      "The bridge sees nothing of the cable: it orders by what you say. The pad shows what the work asks for, the " +
        "other leaves are a touch away. The button ? has all keys, and these pictures again.",
    ),
    part: "reports",
    picture: () => [
      ...[0, 1, 2, 3, 4, 5].map((i) =>
        svg("rect", {
          x: 10 + 30 * (i % 3),
          y: 40 + 28 * Math.floor(i / 3),
          width: 26,
          height: 24,
          rx: 3,
          class: i === 1 ? "mine" : "",
        }),
      ),
      line("M 60 34 Q 70 12 104 16 m -9 -7 l 10 7 l -8 9", "mine"),
      line("M 112 46 V 30 h 36 V 46 M 106 46 h 48 v 48 h -48 Z M 114 54 h 32 v 10 h -32 Z"),
    ],
  },
];

function wasSeen(): boolean {
  try {
    return localStorage.getItem(kSeen) !== null;
  } catch {
    return true; // a browser that keeps nothing would show them at every visit
  }
}

export class FirstVisit {
  readonly element: HTMLElement;
  private readonly title = h("h2", {});
  private readonly text = h("p", {});
  private readonly picture = svg("svg", { viewBox: "0 0 160 104", "aria-hidden": "true" });
  private readonly back = h("button", { class: "plain", onclick: () => this.show(this.at - 1) }, t("Back"));
  private readonly next = h("button", { class: "plain primary", onclick: () => this.goOn() });
  private at = 0;

  /** page: in which the parts that it speaks of are found. */
  constructor(private readonly page: HTMLElement) {
    this.element = h(
      "section",
      { class: "first-visit panel", "aria-label": t("first visit"), hidden: true },
      this.picture,
      h("div", { class: "words", "aria-live": "polite" }, this.title, this.text),
      h(
        "div",
        { class: "row" },
        h("button", { class: "plain skip", onclick: () => this.close() }, t("Put away")),
        this.back,
        this.next,
      ),
    );
    this.element.addEventListener("keydown", (event) => {
      if (event.key !== "Escape") return;
      event.stopPropagation();
      this.close();
    });
  }

  /** Shows itself where it never was; the focus stays where it is, since the keys are the levers'. */
  begin(): void {
    if (!wasSeen()) this.show(0);
  }

  /** From its beginning, in the hand of who asks for it. */
  open(): void {
    this.show(0);
    this.next.focus();
  }

  private goOn(): void {
    if (this.at === steps.length - 1) this.close();
    else this.show(this.at + 1);
  }

  private show(at: number): void {
    this.at = at;
    const { title, text, part, picture } = steps[at]!;
    this.element.hidden = false;
    setText(this.title, t("{at} of {all}: {title}", { at: at + 1, all: steps.length, title }));
    setText(this.text, text);
    this.picture.replaceChildren(...picture());
    this.back.disabled = at === 0;
    setText(this.next, at === steps.length - 1 ? t("Done") : t("Next"));
    this.point(part);
  }

  private close(): void {
    this.element.hidden = true;
    this.point(undefined);
    try {
      localStorage.setItem(kSeen, "seen");
    } catch {
      // they are not shown there by themselves either
    }
  }

  /** Rings the part of the page that is spoken of. */
  private point(part: string | undefined): void {
    for (const element of this.page.children)
      setAttribute(element, "data-spoken-of", part && element.classList.contains(part) ? "" : undefined);
  }
}
