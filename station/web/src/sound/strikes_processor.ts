// Runs on the audio's own thread, as a module of its own: blows at a rate, one after the other for as long as it goes,
// however busy the page is. sound/strikes.ts has the page's end of it.

import type { StrikesOptions } from "./strikes";

/** What the scope of an audio worklet has beside a page's; TypeScript knows none of it. */
declare const sampleRate: number;
declare const AudioWorkletProcessor: new () => object;
declare function registerProcessor(name: string, processor: unknown): void;

interface Voice {
  blow: Float32Array;
  at: number; // samples into it; negative: it has not begun
  pitch: number;
  level: number;
}

class Strikes extends AudioWorkletProcessor {
  static readonly parameterDescriptors = ["rate", "level"].map((name) => ({
    name,
    defaultValue: 0,
    minValue: 0,
    automationRate: "k-rate",
  }));
  private readonly options: StrikesOptions;
  private passed = 0; // blows, and how far it is to the next one
  private voices: Voice[] = [];

  constructor({ processorOptions }: { processorOptions: StrikesOptions }) {
    super();
    this.options = processorOptions;
  }

  process(_: unknown, outputs: Float32Array[][], parameters: Record<"rate" | "level", Float32Array>): boolean {
    const out = outputs[0]?.[0];
    if (!out) return true;
    const step = parameters.rate[0]! / sampleRate; // blows a sample
    const then = this.passed + step * out.length;
    for (let n = Math.floor(this.passed) + 1; n <= then; ++n)
      this.begin(n, (n - this.passed) / step, parameters.level[0]!);
    this.passed = then;
    for (const voice of this.voices) sound(voice, out);
    this.voices = this.voices.filter(({ blow, at }) => at < blow.length - 1);
    return true;
  }

  /** Blow number n, so many samples from now on. */
  private begin(n: number, samples: number, level: number): void {
    const { blows, accent, spread } = this.options;
    const pitch = 1 + spread * Math.sin(7 * n);
    const accented = accent && n % accent.every === 0 ? accent.times * level : level;
    this.voices.push({ blow: blows[n % blows.length]!, at: -samples * pitch, pitch, level: accented });
  }
}

/** Adds what a voice sounds of one block. */
function sound(voice: Voice, out: Float32Array): void {
  const { blow, pitch, level } = voice;
  let { at } = voice;
  for (let i = 0; i < out.length && at < blow.length - 1; ++i, at += pitch) {
    if (at < 0) continue;
    const k = Math.floor(at);
    out[i]! += level * (blow[k]! + (at - k) * (blow[k + 1]! - blow[k]!));
  }
  voice.at = at;
}

registerProcessor("windlass-strikes", Strikes);
