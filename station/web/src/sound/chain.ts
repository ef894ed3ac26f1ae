// Chain over the gypsy: one blow for each link, so that its rhythm is the cable's speed. A mate brakes by it.

import { struck } from "./samples";
import { filterOf, gainOf, glide, looped, once } from "./voices";

/** Of a stud link, between one and the next of the same kind: 4 wire diameters. */
const kLinkPitch = 4;
const kLinksATurn = 10; // of the gypsy: five pockets, a flat and an upright link each
const kToneAt78 = 310; // Hz, lowest tone of a link of 78 mm; heavier ones are lower; tuned by ear
const kLoudest = 6; // m/s, from which it is as loud as it gets; tuned by ear

export class ChainSound {
  private readonly blows: AudioBuffer[];
  private readonly clank: AudioBuffer;
  private readonly out: GainNode;
  private readonly roar: GainNode;
  private readonly roarTone: BiquadFilterNode;
  private readonly rumble: GainNode;
  private link = 0; // passed so far; whole numbers are blows
  private until: number | undefined; // s of the context, up to which blows are laid out

  constructor(
    private readonly context: BaseAudioContext,
    out: AudioNode,
    noise: AudioBuffer,
    private readonly diameter: number,
  ) {
    const lowest = kToneAt78 * (0.078 / diameter);
    this.blows = [
      struck(context, lowest, 0.022, 0.9, 3), // a flat link into its pocket
      struck(context, lowest * 1.19, 0.016, 0.7, 5), // an upright one between the whelps
    ];
    this.clank = struck(context, lowest * 0.8, 0.16, 1, 9);
    this.out = gainOf(context, out, 1);
    this.roar = gainOf(context, this.out);
    this.roarTone = filterOf(context, this.roar, "bandpass", 500, 0.7);
    looped(context, this.roarTone, noise);
    this.rumble = gainOf(context, this.out);
    looped(context, filterOf(context, this.rumble, "lowpass", 90, 0.8), noise, 1);
  }

  /** Lays out the blows up to `until` for a cable of that speed, m/s; load: 0..1; jumping: links ride over. */
  play(speed: number, load: number, jumping: boolean, time: number, until: number): void {
    const way = Math.abs(speed);
    const rate = way / (kLinkPitch * this.diameter);
    const from = this.until === undefined || this.until < time ? time : this.until;
    this.until = Math.max(from, until);
    const before = this.link;
    this.link += rate * (this.until - from);
    for (let n = Math.floor(before) + 1; n <= this.link; ++n) {
      const accent = n % kLinksATurn === 0 ? 1.3 : 1;
      const hard = (0.1 + 0.35 * Math.min(1, way / kLoudest) + 0.1 * load) * accent * (jumping ? 1.8 : 1);
      const pitch = 1 + 0.05 * Math.sin(7 * n); // no two links are alike
      once(this.context, this.out, this.blows[n % 2]!, from + (n - before) / rate, hard, pitch);
    }
    const share = Math.min(1.3, way / kLoudest);
    glide(this.roar.gain, 0.22 * share ** 1.6, time);
    glide(this.roarTone.frequency, 350 + 700 * share, time);
    glide(this.rumble.gain, 0.5 * share ** 1.3, time);
  }

  /** A joining shackle passes. */
  shackle(time: number): void {
    once(this.context, this.out, this.clank, time, 0.5);
  }

  /** The stopper's bar falls or is lifted, claws meet, something of that weight. */
  blow(time: number, level: number): void {
    once(this.context, this.out, this.clank, time, level, 0.7);
  }
}
