// The past of a recording: whatever moment a replay jumps to, plots and plan are told what was up to it, as if it came
// now. The station reads it once, a sample a second; without its files plots begin where the replay was opened.

import type { Latest } from "../plots/channels";
import { CdrReader } from "../wire/cdr";
import type { Connection } from "../wire/connection";
import { type TopicName, type TopicTypes, decoders, keys } from "../wire/generated";
import type { Recorded } from "./events";

/** Who draws what was heard over time. */
export interface Drawer {
  /** Nothing of it has been. */
  forget(): void;
  hear<T extends TopicName>(topic: T, sample: TopicTypes[T], then: Latest): void;
}

interface Sample {
  position: number; // s from the recording's beginning
  topic: TopicName;
  sample: TopicTypes[TopicName];
}

const kApart = 2; // s of exercise time, more than lie between two samples of the past
const kLead = 1; // s of the recording that a replay at x1 may have gone on between two of its words, 5 a second

export class RecordedPast {
  private samples: Sample[] = []; // by position
  private recording = "";
  private position = NaN; // s, of the replay's last word
  private readonly drawers: Drawer[] = [];

  constructor(private readonly link: Connection) {
    link.onMessage("recording_events", (message) => {
      const past = message.past as [number, TopicName, string][];
      this.samples = past.map(([position, topic, payload]) => ({ position, topic, sample: opened(topic, payload) }));
      for (const event of message.events as Recorded[])
        this.samples.push({ position: event.position, topic: "Event", sample: event });
      this.samples.sort((a, b) => a.position - b.position);
      this.recording = `${message.recording}`;
      this.tell();
    });
    link.on("ReplayStatus", ({ position, speed, recording }) => {
      const gone = position - this.position;
      this.position = position;
      if (recording === this.recording && !(gone >= 0 && gone < kLead * Math.max(1, speed))) this.tell();
    });
  }

  add(drawer: Drawer): void {
    this.drawers.push(drawer);
  }

  private tell(): void {
    if (Number.isNaN(this.position)) return;
    const heard = new Map<string, unknown>();
    const then = { latest: (topic: TopicName, key?: string | number) => heard.get(`${topic}/${key ?? ""}`) } as Latest;
    for (const drawer of this.drawers) drawer.forget();
    for (const { position, topic, sample } of this.samples) {
      if (position > this.position) break;
      heard.set(`${topic}/${keys[topic](sample as never)}`, sample);
      this.hear(topic, sample, then);
    }
    for (const name of heard.keys()) if (!name.startsWith("Event/")) this.hearNow(name, then);
  }

  /** What is shown of that moment itself: the past is up to a second behind. */
  private hearNow(name: string, then: Latest): void {
    const [topic, key] = name.split("/") as ["ShipState", string]; // as all of the past it has a time
    const last = then.latest(topic, key)!.time;
    const shown = this.link.latest(topic, key);
    if (!shown || shown.time < last || shown.time > last + kApart) return;
    this.hear(topic, shown, this.link);
  }

  private hear<T extends TopicName>(topic: T, sample: TopicTypes[T], then: Latest): void {
    for (const drawer of this.drawers) drawer.hear(topic, sample, then);
  }
}

function opened<T extends TopicName>(topic: T, payload: string): TopicTypes[T] {
  const bytes = Uint8Array.from(atob(payload), (octet) => octet.charCodeAt(0));
  return decoders[topic](new CdrReader(new DataView(bytes.buffer)));
}
