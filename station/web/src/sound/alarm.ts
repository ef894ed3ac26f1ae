// Tones of the alert panel, that cannot be mistaken for anything on deck, and the talkback's call. MSC.302(87) wants
// alarms and warnings heard until they are acknowledged, cautions silent. The groups are those of IEC 62923-1: three
// short tones for an alarm, again within 10 s, two for a warning, again within 60 s (as remembered; its text was not
// at hand). Here they come sooner: who learns does not wait a minute.

import { AlertPriority } from "../wire/generated";
import { beep } from "./voices";

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

export class AlarmSound {
  private next = 0;

  constructor(
    private readonly context: BaseAudioContext,
    private readonly out: AudioNode,
  ) {}

  /** Lays out the tones up to `until`; priority: of what sounds now, undefined: nothing. */
  play(priority: AlertPriority | undefined, time: number, until: number): void {
    const pattern = priority === undefined ? undefined : patterns[priority];
    if (!pattern) return;
    if (this.next < time) this.next = time;
    for (; this.next < until; this.next += pattern.every)
      for (const { at, seconds, frequency } of pattern.beeps)
        beep(this.context, this.out, "square", frequency, this.next + at, seconds, pattern.level);
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
