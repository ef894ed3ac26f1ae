// What the deck sounds like, from what the seat is given.

import { everySecond, type ExercisePage } from "../kit/page";
import { kByHand } from "../kit/orders";
import { DeckSound } from "../sound/deck";
import type { Ears, Places } from "../sound/place";
import type { SoundPlayer } from "../sound/player";
import { loadStrikes } from "../sound/strikes";
import { standOf } from "../scene/cameras";
import { type Rig, deckHeight, rig } from "../scene/rig";
import { sub, unit } from "../scene/vec";
import { AnchorSeen, RunState, type SceneDescription } from "../wire/generated";
import { heardOf } from "./heard";
import type { Orders } from "./orders";
import type { Stand } from "./stand";
import { t } from "../kit/language";

const kNoteTime = 3000; // ms that a short sound's caption stays
const kFast = 0.5; // m/s, from which an anchor that goes under is heard to

function rigsOf(scene: SceneDescription): Rig[] {
  const deck = deckHeight(scene);
  return scene.tackle.map((tackle) => rig(tackle, deck));
}

/** Where the gear of a side sounds from. */
const placesOf = ({ gypsy, deckPipe, tackle: { lip } }: Rig): Places => ({
  gypsy,
  pipe: deckPipe,
  water: [lip.x, lip.y, 0],
});

/** Of a man at the stand. */
function earsAtStand(side: Rig): Ears {
  const { eye, at } = standOf(side);
  return { at: eye, ahead: unit(sub(at, eye)) };
}

export class Sounds {
  private readonly player: SoundPlayer; // the page's, which the alerts have, too
  private deck: DeckSound | undefined;
  private rigs: readonly Rig[] = [];
  private readonly anchors = new Map<number, AnchorSeen>();
  private readonly stoppers = new Map<number, boolean>();
  private readonly notes = new Map<string, { text: string; until: number }>(); // by what sounded

  constructor(
    private readonly page: ExercisePage,
    private readonly stand: Stand,
    orders: Orders,
    private readonly ears: () => Ears | undefined,
  ) {
    this.player = page.alerts.sound.player;
    this.player.onStart((context, out) => void this.begin(context, out));
    const { link } = page;
    link.on("SceneDescription", (scene) => (this.rigs = rigsOf(scene)));
    link.on("ForecastleEvent", (event) => {
      if (event.code !== "cable.shackle" || event.time < (this.time() ?? 0) - 2) return;
      this.deck?.shackle(event.side, this.player.time);
      this.note("mark", t("a joining shackle passes"));
    });
    orders.onOrder((order) => {
      if (order.text === kByHand) return;
      this.deck?.talkback.call(this.player.time);
      this.note("talkback", t("talkback calls"));
    });
    everySecond(20, (now) => this.play(now));
  }

  private async begin(context: AudioContext, out: AudioNode): Promise<void> {
    await loadStrikes(context);
    this.deck = new DeckSound(context, out);
  }

  /** Short sounds of the last seconds in words, by what sounded. */
  captions(now: number): Record<string, string> {
    for (const [source, { until }] of this.notes) if (until <= now) this.notes.delete(source);
    return Object.fromEntries([...this.notes].map(([source, { text }]) => [source, text]));
  }

  private time(): number | undefined {
    return this.page.link.latest("ExerciseStatus")?.time;
  }

  private note(source: string, text: string): void {
    this.notes.set(source, { text, until: performance.now() + kNoteTime });
  }

  private play(now: number): void {
    const { link } = this.page;
    const state = link.latest("ExerciseStatus")?.state;
    const running = link.state === "open" && (state === RunState.RUN_RUNNING || state === RunState.RUN_REPLAY);
    this.watch();
    const { deck } = this;
    const { time } = this.player;
    if (!deck) return;
    deck.level(running ? 1 : 0.15, time);
    for (const side of this.rigs) {
      const { tackle } = side;
      deck.fit(tackle.side, placesOf(side), tackle.chain_diameter, tackle.drive === "hydraulic");
      const heard = heardOf(link, tackle, now, running);
      if (heard) deck.windlass(tackle.side, heard, time);
    }
    const inHand = this.rigs.find(({ tackle }) => tackle.side === this.stand.side);
    const ears = this.ears() ?? (inHand && earsAtStand(inHand));
    if (ears) deck.listen(ears, time);
    deck.wind(link.latest("ForecastleView", this.stand.side)?.wind_felt ?? 0, time);
  }

  /** Blows and splashes: what changed since. */
  private watch(): void {
    for (const view of this.page.link.all("ForecastleView")) {
      const before = this.anchors.get(view.side);
      this.anchors.set(view.side, view.anchor);
      if (
        before !== undefined &&
        before !== view.anchor &&
        view.anchor === AnchorSeen.ANCHOR_SEEN_UNDER_WATER &&
        view.cable_speed_seen >= kFast
      ) {
        this.deck?.splash(view.side, this.player.time);
        this.note("water", t("the anchor splashes"));
      }
      const closed = this.stoppers.get(view.side);
      this.stoppers.set(view.side, view.stopper_closed);
      if (closed !== undefined && closed !== view.stopper_closed) {
        this.deck?.blow(view.side, this.player.time);
        this.note("stopper", view.stopper_closed ? t("the stopper bar falls") : t("the stopper bar lifts"));
      }
    }
  }
}
