// The band brake: rubs, squeals, screams, as it gets more to do; lower as it gets hot.

import { filterOf, gainOf, glide, looped, tone } from "./voices";

const kHeat = 0.06; // of its pitch, by which each step of heat lowers the squeal

export class BrakeSound {
  private readonly rub: GainNode;
  private readonly squeal: GainNode;
  private readonly scream: GainNode;
  private readonly tones: { node: OscillatorNode; ratio: number }[];
  private readonly squealFilter: BiquadFilterNode;

  constructor(context: BaseAudioContext, out: AudioNode, noise: AudioBuffer) {
    this.rub = gainOf(context, out);
    looped(context, filterOf(context, this.rub, "lowpass", 420, 0.7), noise, 0.5);
    this.squeal = gainOf(context, out);
    this.squealFilter = filterOf(context, this.squeal, "bandpass", 700, 4);
    this.scream = gainOf(context, out);
    const screamFilter = filterOf(context, this.scream, "highpass", 900, 0.7);
    this.tones = [
      { node: tone(context, this.squealFilter, "sawtooth", 500), ratio: 1 },
      { node: tone(context, this.squealFilter, "sawtooth", 507), ratio: 1.013 },
      { node: tone(context, screamFilter, "sawtooth", 1050), ratio: 2.07 },
      { node: tone(context, screamFilter, "square", 1580), ratio: 3.11 },
    ];
  }

  /** noise: 0 none, 1 rubs, 2 squeals, 3 screams; speed: m/s of the cable; heat: LiningSeen, 0..4. */
  play(noise: number, speed: number, heat: number, time: number): void {
    const fast = Math.min(1, Math.abs(speed) / 6);
    const pitch = (350 + 550 * fast) * (1 - kHeat * heat);
    for (const { node, ratio } of this.tones) glide(node.frequency, pitch * ratio, time, 0.08);
    glide(this.squealFilter.frequency, 1.4 * pitch, time, 0.08);
    glide(this.rub.gain, noise >= 1 ? 0.05 + 0.08 * fast : 0, time);
    glide(this.squeal.gain, noise >= 2 ? 0.12 : 0, time, 0.08);
    glide(this.scream.gain, noise >= 3 ? 0.06 : 0, time, 0.08);
  }
}
