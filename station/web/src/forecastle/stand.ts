// The stand in front of the trainee: gauges above, levers below, of the windlass in hand.

import type { Connection } from "../wire/connection";
import { type ForecastleView, RunState, type SceneTackle } from "../wire/generated";
import { ownerWords, takenWords } from "../kit/authority";
import { h, setAttribute, setShown, setText } from "../kit/dom";
import { showsTopic } from "../kit/live";
import { sideWord } from "../kit/units";
import { Practice } from "../kit/practice";
import { Clutch } from "./clutch";
import { EmergencyStop } from "./emergency_stop";
import { Gauges } from "./gauges";
import { ghostFigures } from "./ghost";
import { cableSpeed } from "./heard";
import { LeverHand } from "./levers";
import { kPoleDetents, kSteplessDetents, SpeedLever } from "./speed_lever";
import { Stopper } from "./stopper";
import { HandWheel } from "./wheel";
import { t } from "../kit/language";

const kTravelTime = 6; // s of a hand-wheel, until the scene's description says its own
const kNoticeTime = 7000; // ms
const kTurns = 0.03; // m/s, from which the gypsy is seen to turn

export class Stand {
  readonly element: HTMLElement;
  readonly head: HTMLElement; // whose levers, and what else is of the windlass in hand
  readonly hands: readonly LeverHand[];
  readonly gauges = new Gauges();
  readonly wheel: HandWheel;
  readonly speed: SpeedLever;
  readonly clutch: Clutch;
  readonly stopper: Stopper;
  readonly stop: EmergencyStop;
  readonly practice: Practice<"forecastle">;
  private side_ = 0;
  private readonly sides = h("div", { class: "sides", role: "group", "aria-label": t("windlass in hand") });
  private readonly owner = h("strong", { class: "owner", role: "status" });
  private readonly letGo = h("button", { class: "plain", onclick: () => this.hand.letGo() }, t("Leave them"));
  private readonly notice = h("p", { class: "notice", role: "status", "aria-live": "assertive" });
  private noticeUntil = 0;
  private leftHidden = false;
  private readonly clutchRefused = new Map<number, number>(); // by side, the tick: until a view shows it
  private readonly sideListeners = new Set<(side: number) => void>();

  constructor(private readonly link: Connection) {
    this.hands = [0, 1].map(
      (side) => new LeverHand(link, side, () => this.tackle(side)?.brake_travel_time ?? kTravelTime),
    );
    this.wheel = new HandWheel({
      turn: (turns) => this.hand.turnWheel(turns),
      spin: (to) => this.hand.spinWheel(to),
      stop: () => this.hand.stopWheel(),
    });
    this.speed = new SpeedLever({
      move: (to) => this.hand.moveSpeed(to),
      latch: () => this.hand.latchSpeed(),
      push: (to) => this.hand.pushSpeed(to),
      release: () => this.hand.releaseSpeed(),
    });
    this.clutch = new Clutch((in_) => this.hand.put({ clutch_in: in_ }));
    this.stopper = new Stopper((closed) => this.hand.put({ stopper_closed: closed }));
    this.stop = new EmergencyStop((on) => this.hand.put({ emergency_stop: on }));
    this.practice = new Practice(link, "forecastle");
    this.head = h(
      "div",
      { class: "row head" },
      this.sides,
      h("span", { class: "levers-of" }, `${t("levers:")} `, this.owner),
      this.letGo,
    );
    this.element = h(
      "section",
      { class: "stand panel", "aria-label": t("stand") },
      this.head,
      h("div", {}, this.practice.element, this.gauges.element),
      this.notice,
      h(
        "div",
        { class: "controls" },
        this.wheel.element,
        this.clutch.element,
        this.stopper.element,
        this.speed.element,
        this.stop.element,
      ),
    );
    for (const shows of [this.gauges, this.wheel, this.clutch, this.stopper, this.speed, this.stop])
      showsTopic(shows.element, link, "ForecastleView", () => this.side_);
    link.on("SceneDescription", () => this.showSides());
    link.onMessage("levers", (message) => {
      const side = message.side as number;
      if (message.by === "another") this.lost(side, t("another page of this station has these levers"));
      if (message.helm === true || !message.taken_by) return;
      this.hands[side]?.drop(); // without a word more: they are another's
      this.tell(takenWords(link, message));
    });
    link.onMessage("refused", ({ id, topic, text }) => {
      if (topic !== "WindlassCommand" || (id !== null && id !== undefined)) return;
      for (const hand of this.hands) if (link.holds(hand.side)) this.lost(hand.side, `${text}`);
    });
    link.on("ForecastleEvent", ({ code, side, tick }) => {
      if (code === "clutch.refused") this.clutchRefused.set(side, tick);
      const closed = code === "stopper.refused" ? this.hands[side]?.leave("stopper_closed") : undefined;
      if (closed !== undefined) this.stopper.refuse(side, closed);
    });
    link.on("ForecastleView", ({ side, tick }) => this.seeRefusal(side, tick));
    addEventListener("blur", () => this.release());
    document.addEventListener("visibilitychange", () => this.hide(document.hidden));
  }

  /** The windlass in hand: 0 port, 1 starboard. */
  get side(): number {
    return this.side_;
  }
  get hand(): LeverHand {
    return this.hands[this.side_]!;
  }
  /** What the ship has on a side; undefined: no windlass, or not heard of yet. */
  tackle(side = this.side_): SceneTackle | undefined {
    return this.link.latest("SceneDescription")?.tackle.find((tackle) => tackle.side === side);
  }

  /** Takes the other windlass in hand; the one before stays as left, its speed lever springs back. */
  nextSide(): void {
    this.setSide(1 - this.side_);
  }
  setSide(side: number): void {
    if (side === this.side_ || (this.link.latest("SceneDescription") && !this.tackle(side))) return;
    this.release();
    this.side_ = side;
    this.showSides();
    for (const listener of this.sideListeners) listener(side);
  }
  onSide(listener: (side: number) => void): void {
    this.sideListeners.add(listener);
  }

  /** Says something plainly for some seconds. */
  tell(text: string): void {
    setText(this.notice, text);
    this.noticeUntil = performance.now() + kNoticeTime;
  }

  /** Shows everything as it is; once a frame. now: ms. */
  draw(now: number): void {
    for (const hand of this.hands) hand.tick(now);
    const view: ForecastleView | undefined = this.link.latest("ForecastleView", this.side_);
    const levers = this.hand.levers();
    const authority = this.hand.authority();
    setText(this.owner, view || authority.owner !== "nobody" ? ownerWords(authority) : t("waiting …"));
    setAttribute(this.element, "data-owner", authority.owner);
    // While the instructor has them there is nothing to leave, and his name takes the room.
    setShown(this.letGo, this.link.holds(this.side_) && authority.owner !== "instructor");
    const state = this.link.latest("ExerciseStatus")?.state;
    const waits = state === RunState.RUN_READY && this.link.holds(this.side_);
    if (waits) setText(this.notice, t("Not started yet: what you move now acts as it starts."));
    else if (now > this.noticeUntil) setText(this.notice, "");
    if (!view || !levers) return;
    const movable = this.hand.movable();
    const tackle = this.tackle();
    const turns =
      Math.abs(cableSpeed(this.link.track("ForecastleView", this.side_), tackle?.chain_diameter ?? 0.078, now)) >
      kTurns;
    this.gauges.show(view, tackle, now);
    this.wheel.show(levers.brake, view.brake_position, movable);
    this.speed.setDetents(tackle?.drive === "electric_pole_changing" ? kPoleDetents : kSteplessDetents);
    this.speed.show(levers.speed_lever, view.speed_lever, movable, this.hand.latched);
    const runs = state === RunState.RUN_RUNNING;
    this.clutch.show(levers, view, turns, movable, runs);
    this.stopper.show(levers, view, movable, runs);
    this.stop.show(levers, view, movable);
    const ghost = this.practice.hands(now, this.side_);
    this.wheel.showGhost(ghost?.brake_position);
    this.speed.showGhost(ghost?.speed_lever);
    this.practice.tell(ghost, ghost ? ghostFigures(ghost) : "");
  }

  /** Every hand off what springs back. */
  release(): void {
    for (const hand of this.hands) hand.release();
  }

  /** A page that is hidden leaves its levers, and says so when it is in sight again. */
  private hide(hidden: boolean): void {
    if (hidden) {
      this.leftHidden = this.hands.some(({ side }) => this.link.holds(side));
      for (const hand of this.hands) hand.letGo();
    } else if (this.leftHidden) {
      this.leftHidden = false;
      this.tell(t("The page was hidden, and its levers were left: windows side by side keep them in hand."));
    }
  }

  /** A clutch that was refused is left, unless it seeks, which a view from before does not show. */
  private seeRefusal(side: number, tick: number): void {
    if (tick < (this.clutchRefused.get(side) ?? Infinity)) return;
    this.clutchRefused.delete(side);
    const stands = this.hands[side]?.leave("clutch_in");
    if (stands !== undefined) this.clutch.refuse(side, stands);
  }

  private lost(side: number, why: string): void {
    if (!this.link.holds(side)) return;
    this.hands[side]?.letGo();
    this.tell(why);
  }

  private showSides(): void {
    const tackle = this.link.latest("SceneDescription")?.tackle ?? [];
    const sides = tackle.map((t) => t.side).sort((a, b) => a - b);
    if (sides.length && !sides.includes(this.side_)) this.setSide(sides[0]!);
    this.sides.replaceChildren(
      ...sides.map((side) =>
        h(
          "button",
          {
            "aria-pressed": `${side === this.side_}`,
            "data-side": side,
            title: t("key p"),
            onclick: () => this.setSide(side),
          },
          sideWord(side),
        ),
      ),
    );
  }
}
