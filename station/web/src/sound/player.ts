// This computer's loudspeaker: begins as soon as the browser lets it, which most do with the first touch of the page,
// and can be muted.

import { gainOf, limiter } from "./voices";

const kLevel = 0.7;

export class SoundPlayer {
  private readonly context = new AudioContext();
  private readonly master = gainOf(this.context, this.context.destination, kLevel);
  private readonly out = limiter(this.context, this.master); // a runaway and an alarm together do not clip
  private muted_ = false;
  private started = false;
  private readonly starters = new Set<(context: AudioContext, out: AudioNode) => void>();
  private readonly listeners = new Set<() => void>();

  constructor() {
    const resume = (): void => void this.context.resume();
    addEventListener("pointerdown", resume, true);
    addEventListener("keydown", resume, true);
    this.context.onstatechange = () => this.changed();
    resume();
  }

  /** s of the audio's clock. */
  get time(): number {
    return this.context.currentTime;
  }
  get muted(): boolean {
    return this.muted_;
  }
  get running(): boolean {
    return this.context.state === "running";
  }

  mute(muted: boolean): void {
    this.muted_ = muted;
    this.master.gain.setTargetAtTime(muted ? 0 : kLevel, this.time, 0.03);
    this.tell();
  }

  /** Calls back once, when it can be heard first: to make what sounds, whose output goes to `out`. */
  onStart(start: (context: AudioContext, out: AudioNode) => void): void {
    if (this.started) start(this.context, this.out);
    else this.starters.add(start);
  }

  /** Calls back when it begins or stops, and when it is muted or heard again. */
  onChange(listener: () => void): void {
    this.listeners.add(listener);
  }

  private changed(): void {
    if (this.running && !this.started) {
      this.started = true;
      for (const start of this.starters) start(this.context, this.out);
    }
    this.tell();
  }

  private tell(): void {
    for (const listener of this.listeners) listener();
  }
}
