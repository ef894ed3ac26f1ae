// The past of a recording, which the station reads, a sample a second. In a replay, whatever moment it jumps to, plots
// and plan are told what was up to it, as if it came now; without its files plots begin where the replay was opened.
// A desk that is opened in the midst of an exercise is told what was before it was heard here, where the station was
// recording it already.

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
  /** All of the past has been told, of an exercise that goes on. */
  caughtUp?(): void;
}

interface Sample {
  position: number; // s from the recording's beginning
  topic: TopicName;
  sample: TopicTypes[TopicName];
}

/** An exercise in the midst of which the desk was opened, until its recording is read. */
interface Late {
  recording: string;
  asked: boolean;
  /** All of it, of what is drawn. */
  heard: [TopicName, TopicTypes[TopicName]][];
}

const kApart = 2; // s of exercise time, more than lie between two samples of the past
const kLead = 1; // s of the recording that a replay at x1 may have gone on between two of its words, 5 a second
const kFromBegin = 5; // s, in which the first sample of an exercise that was heard from its beginning has come
/** What a desk draws over time. */
const kDrawn = ["ShipState", "AnchorState", "WindlassLoad", "EnvironmentState"] as const;

export class RecordedPast {
  private samples: Sample[] = []; // by position
  private recording = "";
  private position = NaN; // s, of the replay's last word
  private late: Late | undefined;
  private greeted = false;
  private readonly drawers: Drawer[] = [];

  constructor(private readonly link: Connection) {
    link.onMessage("hello", ({ recording }) => {
      // Of one that is begun later, nothing was before.
      if (!this.greeted && typeof recording === "string") this.late = { recording, asked: false, heard: [] };
      this.greeted = true;
    });
    for (const topic of kDrawn) link.on(topic, (sample) => this.late && this.takeLate(this.late, topic, sample));
    link.onMessage("recording_events", (message) => {
      const past = message.past as [number, TopicName, string][];
      this.samples = past.map(([position, topic, payload]) => ({ position, topic, sample: opened(topic, payload) }));
      for (const event of message.events as Recorded[])
        this.samples.push({ position: event.position, topic: "Event", sample: event });
      this.samples.sort((a, b) => a.position - b.position);
      this.recording = `${message.recording}`;
      if (this.late?.recording === this.recording) this.catchUp(this.late);
      else this.tell();
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

  private takeLate<T extends (typeof kDrawn)[number]>(late: Late, topic: T, sample: TopicTypes[T]): void {
    late.heard.push([topic, sample]);
    if (late.asked) return;
    late.asked = true;
    if (sample.time > kFromBegin) void this.read(late.recording);
    else this.late = undefined;
  }

  /** Where it cannot be, plots begin where the desk was opened. */
  private async read(recording: string): Promise<void> {
    try {
      await this.link.ask({ op: "read_recording", recording });
    } catch (why) {
      console.info((why as Error).message);
    }
    this.late = undefined;
  }

  /** What was recorded, and then once more what was heard here, which is more than a sample a second. */
  private catchUp({ heard }: Late): void {
    const known = this.tellUntil(Infinity);
    for (const [topic, sample] of heard) this.hear(topic, sample, known);
    for (const drawer of this.drawers) drawer.caughtUp?.();
    this.late = undefined;
    this.samples = [];
    this.recording = "";
  }

  private tell(): void {
    if (Number.isNaN(this.position)) return;
    const known = this.tellUntil(this.position);
    for (const name of known.keys()) if (!name.startsWith("Event/")) this.hearNow(name, known);
  }

  /** The samples up to a position; by topic and key, the last of them. */
  private tellUntil(end: number): Map<string, TopicTypes[TopicName]> {
    const known = new Map<string, TopicTypes[TopicName]>();
    for (const drawer of this.drawers) drawer.forget();
    for (const { position, topic, sample } of this.samples) {
      if (position > end) break;
      this.hear(topic, sample, known);
    }
    return known;
  }

  /** What is shown of that moment itself: the past is up to a second behind. */
  private hearNow(name: string, known: ReadonlyMap<string, TopicTypes[TopicName]>): void {
    const [topic, key] = name.split("/") as ["ShipState", string]; // as all of the past it has a time
    const last = (known.get(name) as TopicTypes["ShipState"]).time;
    const shown = this.link.latest(topic, key);
    if (!shown || shown.time < last || shown.time > last + kApart) return;
    for (const drawer of this.drawers) drawer.hear(topic, shown, this.link);
  }

  /** known: what was heard last, this then among it. */
  private hear(topic: TopicName, sample: TopicTypes[TopicName], known: Map<string, TopicTypes[TopicName]>): void {
    known.set(`${topic}/${keys[topic](sample as never)}`, sample);
    const then = { latest: (of: TopicName, key?: string | number) => known.get(`${of}/${key ?? ""}`) } as Latest;
    for (const drawer of this.drawers) drawer.hear(topic, sample, then);
  }
}

function opened<T extends TopicName>(topic: T, payload: string): TopicTypes[T] {
  const bytes = Uint8Array.from(atob(payload), (octet) => octet.charCodeAt(0));
  return decoders[topic](new CdrReader(new DataView(bytes.buffer)));
}
