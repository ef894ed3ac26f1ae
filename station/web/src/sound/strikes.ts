// Blows at a rate, made on the audio's own thread: they go on while the page is busy. What the page sets is how many a
// second and how hard; strikes_processor.ts makes them.

/** What a row of blows sounds of. */
export interface StrikesOptions {
  /** Played in turn, each once. */
  blows: Float32Array[];
  /** One of so many is so many times as loud. */
  accent?: { every: number; times: number };
  /** Of the pitch, by which one blow differs from the next. */
  spread: number;
}

/** Of strikes_processor.ts, as build.mjs bundles it. */
const kModule = "/assets/strikes_processor.js";
const kAgain = 3000; // ms after which it is asked for again where the station did not answer

/** Before the first Strikes of a context: loads what makes them. Where it cannot be had it is tried again. */
export async function loadStrikes(context: BaseAudioContext): Promise<void> {
  for (;;)
    try {
      return await context.audioWorklet.addModule(kModule);
    } catch (why) {
      console.warn(`no sound yet: ${kModule}: ${why}`);
      await new Promise((later) => setTimeout(later, kAgain));
    }
}

export class Strikes {
  private readonly rate: AudioParam;
  private readonly level: AudioParam;

  /** Silent at first; loadStrikes() of the context has been waited for. */
  constructor(context: BaseAudioContext, out: AudioNode, options: StrikesOptions) {
    const node = new AudioWorkletNode(context, "windlass-strikes", {
      numberOfInputs: 0,
      outputChannelCount: [1],
      processorOptions: options,
    });
    node.connect(out);
    this.rate = node.parameters.get("rate")!;
    this.level = node.parameters.get("level")!;
  }

  /** From time on (s of the context): so many blows a second, and how loud each that begins then is. */
  play(rate: number, level: number, time: number): void {
    this.rate.setValueAtTime(rate, time);
    this.level.setValueAtTime(level, time);
  }
}
