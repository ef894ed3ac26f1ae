// The cable: one blow on the gypsy for each link, so that its rhythm is the cable's speed, by which a mate brakes, also
// while the page is busy; in the hawse pipe it roars. What it does on the bottom no ear on deck hears.

import { struck } from "./samples";
import { Strikes } from "./strikes";
import { filterOf, gainOf, glide, looped, once } from "./voices";

/** Of a stud link, between one and the next of the same kind: 4 wire diameters. */
const kLinkPitch = 4;
const kLinksATurn = 10; // of the gypsy: five pockets, a flat and an upright link each
const kToneAt78 = 310; // Hz, lowest tone of a link of 78 mm; heavier ones are lower; tuned by ear
const kMost = 12; // m/s, from which it is as loud as it gets

/**
 * Times as loud as a blow at 3 m/s, where a let-go is still held. Up to there by ear; beyond, 35 dB for ten times the
 * speed: 20 of it since a blow's energy grows with its square, the rest for links that leave the whelps and thrash in
 * the pipe, tuned so that with the blows' number a runaway of 9 m/s lies 20 dB over a fall of 3 m/s.
 */
function loudness(speed: number): number {
  const share = Math.min(speed, kMost) / 3;
  return share < 1 ? share ** 0.6 : share ** 1.75;
}

export class ChainSound {
  private readonly links: Strikes;
  private readonly clank: AudioBuffer;
  private readonly roar: GainNode;
  private readonly roarTone: BiquadFilterNode;
  private readonly rumble: GainNode;
  private readonly gypsy: AudioNode;

  /**
   * gypsy, pipe: what goes from these places to the ear. diameter: m of the links' wire. loadStrikes() of the context
   * has been waited for.
   */
  constructor(
    private readonly context: BaseAudioContext,
    { gypsy, pipe }: { gypsy: AudioNode; pipe: AudioNode },
    noise: AudioBuffer,
    private readonly diameter: number,
  ) {
    const lowest = kToneAt78 * (0.078 / diameter);
    const blows = [
      struck(context, lowest, 0.022, 0.9, 3), // a flat link into its pocket
      struck(context, lowest * 1.19, 0.016, 0.7, 5), // an upright one between the whelps
    ].map((blow) => blow.getChannelData(0));
    this.links = new Strikes(context, gypsy, { blows, accent: { every: kLinksATurn, times: 1.3 }, spread: 0.05 });
    this.clank = struck(context, lowest * 0.8, 0.16, 1, 9);
    this.gypsy = gypsy;
    this.roar = gainOf(context, pipe);
    this.roarTone = filterOf(context, this.roar, "bandpass", 500, 0.7);
    looped(context, this.roarTone, noise);
    this.rumble = gainOf(context, pipe);
    looped(context, filterOf(context, this.rumble, "lowpass", 90, 0.8), noise, 1);
  }

  /** A cable of that speed, m/s, from time on; load: 0..1; jumping: links ride over. */
  play(speed: number, load: number, jumping: boolean, time: number): void {
    const way = Math.abs(speed);
    const loud = loudness(way);
    this.links.play(way / (kLinkPitch * this.diameter), (0.09 + 0.03 * load) * loud * (jumping ? 1.8 : 1), time);
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
