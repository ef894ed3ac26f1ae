// The cable: one blow on the gypsy for each link, so that its rhythm is the cable's speed, by which a mate brakes; in
// the hawse pipe it roars. What it does on the bottom no ear on deck hears.

import { struck } from "./samples";
import { type CallOff, filterOf, gainOf, glide, looped, once } from "./voices";

/** Of a stud link, between one and the next of the same kind: 4 wire diameters. */
const kLinkPitch = 4;
const kLinksATurn = 10; // of the gypsy: five pockets, a flat and an upright link each
const kToneAt78 = 310; // Hz, lowest tone of a link of 78 mm; heavier ones are lower; tuned by ear
const kMost = 12; // m/s, from which it is as loud as it gets

/** s, for which blows are laid out: a page that is held up for less leaves no link out. */
const kAheadOfStall = 1;
const kAsFast = 0.03; // of the speed: blows that are laid out stay until it has changed by more

/**
 * Times as loud as a blow at 3 m/s, where a let-go is still held. Up to there by ear; beyond, 35 dB for ten times the
 * speed: 20 of it since a blow's energy grows with its square, the rest for links that leave the whelps and thrash in
 * the pipe, tuned so that with the blows' number a runaway of 9 m/s lies 20 dB over a fall of 3 m/s.
 */
function loudness(speed: number): number {
  const share = Math.min(speed, kMost) / 3;
  return share < 1 ? share ** 0.6 : share ** 1.75;
}

interface Blow {
  time: number;
  callOff: CallOff;
}

export class ChainSound {
  private readonly blows: AudioBuffer[];
  private readonly clank: AudioBuffer;
  private readonly roar: GainNode;
  private readonly roarTone: BiquadFilterNode;
  private readonly rumble: GainNode;
  private readonly gypsy: AudioNode;
  private rate = 0; // links a second
  private from = 0; // s of the context, since when
  private link = 0; // passed until then; whole numbers are blows
  private laid: Blow[] = []; // not heard yet
  private next = 1; // number of the first blow that is not laid out

  /** gypsy, pipe: what goes from these places to the ear. diameter: m of the links' wire. */
  constructor(
    private readonly context: BaseAudioContext,
    { gypsy, pipe }: { gypsy: AudioNode; pipe: AudioNode },
    noise: AudioBuffer,
    private readonly diameter: number,
  ) {
    const lowest = kToneAt78 * (0.078 / diameter);
    this.blows = [
      struck(context, lowest, 0.022, 0.9, 3), // a flat link into its pocket
      struck(context, lowest * 1.19, 0.016, 0.7, 5), // an upright one between the whelps
    ];
    this.clank = struck(context, lowest * 0.8, 0.16, 1, 9);
    this.gypsy = gypsy;
    this.roar = gainOf(context, pipe);
    this.roarTone = filterOf(context, this.roar, "bandpass", 500, 0.7);
    looped(context, this.roarTone, noise);
    this.rumble = gainOf(context, pipe);
    looped(context, filterOf(context, this.rumble, "lowpass", 90, 0.8), noise, 1);
  }

  /** Lays out the blows of a cable of that speed, m/s, from time on; load: 0..1; jumping: links ride over. */
  play(speed: number, load: number, jumping: boolean, time: number): void {
    const way = Math.abs(speed);
    const rate = way / (kLinkPitch * this.diameter);
    this.laid = this.laid.filter((blow) => blow.time > time);
    if (Math.abs(rate - this.rate) > kAsFast * this.rate) {
      this.link += this.rate * Math.max(0, time - this.from);
      this.from = time;
      this.rate = rate;
      for (const blow of this.laid) blow.callOff();
      this.laid = [];
      this.next = Math.floor(this.link) + 1;
    }
    const loud = loudness(way);
    const at = (n: number): number => this.from + (n - this.link) / this.rate;
    for (; this.rate > 0 && at(this.next) < time + kAheadOfStall; ++this.next) {
      const n = this.next;
      if (at(n) < time) continue; // held up for longer than was laid out
      const accent = n % kLinksATurn === 0 ? 1.3 : 1;
      const hard = (0.09 + 0.03 * load) * loud * accent * (jumping ? 1.8 : 1);
      const pitch = 1 + 0.05 * Math.sin(7 * n); // no two links are alike
      const callOff = once(this.context, this.gypsy, this.blows[n % 2]!, at(n), hard, pitch);
      this.laid.push({ time: at(n), callOff });
    }
    const share = way / 3;
    glide(this.roar.gain, 0.045 * loud * Math.sqrt(share), time);
    glide(this.roarTone.frequency, 350 + 230 * Math.min(share, 4), time);
    glide(this.rumble.gain, 0.09 * loud * Math.sqrt(share), time);
  }

  /** A joining shackle passes. */
  shackle(time: number): void {
    once(this.context, this.gypsy, this.clank, time, 0.3);
  }

  /** The stopper's bar falls or is lifted, claws meet, something of that weight. */
  blow(time: number, level: number): void {
    once(this.context, this.gypsy, this.clank, time, level, 0.7);
  }
}
