// Tones of the alert panel, that cannot be mistaken for anything on deck, and the talkback's call. MSC.302(87) wants
// alarms and warnings heard until they are acknowledged, cautions silent. The groups are those of IEC 62923-1: three
// short tones for an alarm, again within 10 s, two for a warning, again within 60 s (as remembered; its text was not
// at hand). Here they come sooner: who learns does not wait a minute.

import { AlertPriority } from "../wire/generated";
import { beep, looped } from "./voices";

interface Pattern {
  /** s from one beginning to the next. */
  every: number;
  beeps: readonly { at: number; seconds: number; frequency: number }[];
  level: number;
}
const patterns: Partial<Record<AlertPriority, Pattern>> = {
  [AlertPriority.ALERT_WARNING]: {
    every: 3,
    beeps: [
      { at: 0, seconds: 0.12, frequency: 740 },
      { at: 0.2, seconds: 0.12, frequency: 740 },
    ],
    level: 0.12,
  },
  [AlertPriority.ALERT_ALARM]: {
    every: 1.4,
    beeps: [0, 0.22, 0.44].map((at) => ({ at, seconds: 0.16, frequency: 1480 })),
    level: 0.16,
  },
  [AlertPriority.ALERT_EMERGENCY]: {
    every: 0.5,
    beeps: [
      { at: 0, seconds: 0.25, frequency: 1480 },
      { at: 0.25, seconds: 0.25, frequency: 1110 },
    ],
    level: 0.2,
  },
};

const kEdge = 0.01; // s, of a tone's beginning and end
const kHighest = 12000; // Hz, of what a tone is made of

/** One round of a pattern: square tones with soft ends. */
function roundOf(context: BaseAudioContext, { every, beeps, level }: Pattern): AudioBuffer {
  const { sampleRate } = context;
  const buffer = context.createBuffer(1, Math.round(every * sampleRate), sampleRate);
  const data = buffer.getChannelData(0);
  for (const { at, seconds, frequency } of beeps)
    for (let i = 0; i < seconds * sampleRate; ++i) {
      const t = i / sampleRate;
      let value = 0;
      for (let k = 1; k * frequency < kHighest; k += 2) value += Math.sin(2 * Math.PI * k * frequency * t) / k;
      const edge = Math.min(1, t / kEdge, (seconds - t) / kEdge);
      data[Math.round(at * sampleRate) + i]! += (4 / Math.PI) * level * edge * value;
    }
  return buffer;
}

/** Goes round on the audio's own thread, so that it sounds on while the page is busy. */
export class AlarmSound {
  private sounding: AlertPriority | undefined;
  private source: AudioBufferSourceNode | undefined;

  constructor(
    private readonly context: BaseAudioContext,
    private readonly out: AudioNode,
  ) {}

  /** From time on (s of the context); priority: of what sounds now, undefined: nothing. */
  play(priority: AlertPriority | undefined, time: number): void {
    if (priority === this.sounding) return;
    this.sounding = priority;
    this.source?.stop(time);
    this.source = undefined;
    const pattern = priority === undefined ? undefined : patterns[priority];
    if (!pattern) return;
    this.source = looped(this.context, this.out, roundOf(this.context, pattern), 0, time);
  }
}

/** The talkback's call: an order comes. */
export class TalkbackSound {
  constructor(
    private readonly context: BaseAudioContext,
    private readonly out: AudioNode,
  ) {}

  call(time: number): void {
    beep(this.context, this.out, "sine", 880, time, 0.14, 0.12);
    beep(this.context, this.out, "sine", 660, time + 0.18, 0.22, 0.12);
  }
}
