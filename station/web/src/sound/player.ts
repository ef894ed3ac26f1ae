// The deck's sound on this computer's loudspeaker: begins with the first touch, as browsers demand, and can be muted.

import { DeckSound } from "./deck";
import { gainOf } from "./voices";

const kLevel = 0.7;

export class SoundPlayer {
  private context: AudioContext | undefined;
  private master: GainNode | undefined;
  private deck_: DeckSound | undefined;
  private muted_ = false;
  private readonly listeners = new Set<() => void>();

  constructor() {
    const start = (): void => {
      removeEventListener("pointerdown", start, true);
      removeEventListener("keydown", start, true);
      this.start();
    };
    addEventListener("pointerdown", start, true);
    addEventListener("keydown", start, true);
  }

  /** What sounds, from the first touch on; undefined: not yet. */
  get deck(): DeckSound | undefined {
    return this.deck_;
  }
  /** s of the audio's clock. */
  get time(): number {
    return this.context?.currentTime ?? 0;
  }
  get muted(): boolean {
    return this.muted_;
  }
  get running(): boolean {
    return this.context?.state === "running";
  }

  mute(muted: boolean): void {
    this.muted_ = muted;
    if (this.context && this.master) this.master.gain.setTargetAtTime(muted ? 0 : kLevel, this.context.currentTime, 0.03);
    for (const listener of this.listeners) listener();
  }

  /** Calls back when it begins, and when it is muted or heard again. */
  onChange(listener: () => void): void {
    this.listeners.add(listener);
  }

  private start(): void {
    this.context = new AudioContext();
    this.master = gainOf(this.context, this.context.destination, this.muted_ ? 0 : kLevel);
    const limit = this.context.createDynamicsCompressor(); // a runaway and an alarm together do not clip
    limit.connect(this.master);
    this.deck_ = new DeckSound(this.context, limit);
    void this.context.resume();
    this.context.onstatechange = () => this.listeners.forEach((listener) => listener());
    for (const listener of this.listeners) listener();
  }
}
