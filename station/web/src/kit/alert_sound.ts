// The sound of alerts, on every page that shows them: of the most urgent one that is neither acknowledged nor silenced.

import { AlarmSound } from "../sound/alarm";
import { SoundPlayer } from "../sound/player";
import type { AlertPriority } from "../wire/generated";
import { h, setAttribute, setText } from "./dom";
import { t } from "./language";

const kTick = 50; // ms; a page that is hidden is called once a second only, and then an alert begins so much later

export class AlertSound {
  /** Mutes the page, and says what is heard of it: also that an alert sounds and nobody hears it. */
  readonly button = h("button", {
    class: "plain sound",
    type: "button",
    title: t("sound of this page"),
    onclick: () => this.toggle(),
  });
  readonly player = new SoundPlayer();
  private alarm: AlarmSound | undefined;

  /** sounding: the priority of what sounds now. */
  constructor(private readonly sounding: () => AlertPriority | undefined) {
    this.player.onStart((context, out) => (this.alarm = new AlarmSound(context, out)));
    this.player.onChange(() => this.update());
    setInterval(() => this.play(), kTick);
    this.update();
  }

  toggle(): void {
    this.player.mute(!this.player.muted);
  }

  /** At once, when alerts have changed. */
  update(): void {
    this.play();
    const { muted, running } = this.player;
    const unheard = this.sounding() !== undefined && (muted || !running);
    const state = muted ? t("sound off") : running ? t("sound on") : t("sound: touch to begin");
    setText(this.button, unheard ? (muted ? t("alert unheard: muted") : t("alert unheard: touch")) : state);
    setAttribute(this.button, "aria-pressed", `${!muted && running}`);
    setAttribute(this.button, "data-unheard", unheard ? "" : undefined);
  }

  private play(): void {
    const { time, running } = this.player;
    if (running) this.alarm?.play(this.sounding(), time);
  }
}
