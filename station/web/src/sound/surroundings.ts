// Wind in the rigging, the sea at the bow.

import { filterOf, gainOf, glide, looped, tone } from "./voices";

/** m/s, middle of each number of Beaufort. */
const kBeaufort = [0, 1, 2.5, 4.4, 6.7, 9.4, 12.3, 15.5, 19, 22.6, 26.5, 30.6, 34];

export class SurroundingsSound {
  private readonly wind: GainNode;
  private readonly windTone: BiquadFilterNode;
  private readonly sea: GainNode;

  constructor(context: BaseAudioContext, out: AudioNode, noise: AudioBuffer) {
    this.wind = gainOf(context, out);
    this.windTone = filterOf(context, this.wind, "bandpass", 300, 0.9);
    looped(context, this.windTone, noise, 1.5);
    const gusts = context.createGain(); // Hz, by which the pitch goes up and down
    gusts.gain.value = 60;
    gusts.connect(this.windTone.frequency);
    tone(context, gusts, "sine", 0.13);
    this.sea = gainOf(context, out);
    looped(context, filterOf(context, this.sea, "lowpass", 350, 0.5), noise, 0.7);
  }

  /** force: Beaufort, as felt. */
  play(force: number, time: number): void {
    const speed = kBeaufort[Math.min(12, Math.max(0, force))]!;
    glide(this.wind.gain, Math.min(0.5, 0.0011 * speed * speed), time, 0.5);
    glide(this.windTone.frequency, 220 + 22 * speed, time, 0.5);
    glide(this.sea.gain, 0.02 + 0.004 * speed, time, 0.5);
  }
}
