// The events of an exercise as the desk keeps them: each once, in order, those of branches that were left apart.

import { events } from "../../../../words/words.json";
import { begins, leave } from "../kit/branch";
import type { Connection } from "../wire/connection";
import { type Event, EventSeverity } from "../wire/generated";
import { inChosenUnits } from "../kit/figures_in_text";
import { eventText } from "../kit/words";

export interface Logged extends Event {
  /** It happened in a branch that a reset or restore has left since: not on the way to what is now. */
  left: boolean;
  /** ms since 1970, by the server's clock */
  written: number;
}

/** An event of a recording, wherever its replay stands. */
export interface Recorded extends Event {
  /** s from the recording's beginning. */
  position: number;
}

const kKept = 5000;
const kRepeated = 100;

const keyOf = ({ number, time, code, side, text }: Event): string => `${number}/${time}/${code}/${side}/${text}`;

/** Plots and timeline mark these: what somebody would look for afterwards. */
export const isMark = (event: Event): boolean => marks.get(event.code) ?? event.severity !== EventSeverity.EVENT_INFO;
const marks = new Map(
  [...events.waited_for.oneOf, ...events.told.oneOf].map((row: { const: string; mark?: boolean }) => [
    row.const,
    row.mark === true,
  ]),
);

export class EventStore {
  /** As they came, the newest last. */
  readonly all: Logged[] = [];
  /** In a replay: all of its recording, by position; empty until the station has read them. */
  recorded: readonly Recorded[] = [];
  private recording = "";
  private readonly known = new Set<string>();
  private ofLastServer: Logged[] = [];
  private readonly repeated: Logged[] = []; // in the words of a known one, lately
  private readonly listeners = new Set<(event: Logged | undefined) => void>();

  constructor(private readonly link: Connection) {
    link.on("Event", (event, _, written) => this.take(event, written));
    link.onState((state) => state === "lost" && this.clear());
    link.onAnotherServer((until) => this.leave(until));
    link.on("ReplayStatus", (status) => this.read(status.recording));
    link.onMessage("recording_events", (message) => {
      if (message.recording !== this.recording) return;
      this.recorded = message.events as Recorded[];
      this.tell(undefined);
    });
  }

  /** Calls back for each new one; undefined: all were forgotten. */
  onChange(listener: (event: Logged | undefined) => void): void {
    this.listeners.add(listener);
  }

  /** Those of the branch that runs, by time. */
  current(): Logged[] {
    return this.all.filter((event) => !event.left);
  }

  /** Once for each recording. Refused when the station does not have its files: marks then come as they are shown. */
  private read(recording: string): void {
    if (recording === this.recording) return;
    this.recording = recording;
    this.recorded = [];
    this.link.ask({ op: "read_recording", recording }).catch((why: Error) => console.info(why.message));
  }

  private clear(): void {
    this.recording = "";
    this.all.length = 0;
    this.ofLastServer = [];
    this.known.clear();
    this.tell(undefined);
  }

  /** What was written until then is of a server that is no more: whether it has happened, the next one says first. */
  private leave(until: number): void {
    // The next one's, those among them that the last one said in the same words.
    const again = [...this.repeated.splice(0), ...this.all]
      .filter(({ written }) => written >= until)
      .sort((a, b) => a.written - b.written);
    this.ofLastServer = this.all.filter(({ written }) => written < until);
    this.all.splice(0, this.all.length, ...this.ofLastServer);
    this.known.clear();
    this.tell(undefined);
    for (const event of again) this.take(event, event.written);
  }

  /** An exercise that was taken up goes on from its moment; any other beginning is of another course. */
  private goOn(event: Logged): void {
    const takenUp = event.code === "exercise.taken_up";
    if (!takenUp && !begins(event)) return;
    if (!takenUp) for (const before of this.ofLastServer) before.left = true;
    this.ofLastServer = [];
    leave(this.all, event);
  }

  private take(sample: Event, written: number): void {
    // A replay sends them again after each jump; a run of a restore counts from 1 again.
    const key = keyOf(sample);
    if (this.known.has(key)) {
      this.repeated.push({ ...sample, left: false, written });
      if (this.repeated.length > kRepeated) this.repeated.shift();
      return;
    }
    this.known.add(key);
    const event = { ...sample, left: false, written };
    this.goOn(event);
    // A replay that jumped back tells what lies before what is known.
    let at = this.all.length;
    if (this.link.latest("ReplayStatus")) while (at > 0 && this.all[at - 1]!.time > event.time) --at;
    this.all.splice(at, 0, event);
    if (this.all.length > kKept) this.all.shift();
    this.tell(event);
  }

  private tell(event: Logged | undefined): void {
    for (const listener of this.listeners) listener(event);
  }
}

/** An event's sentence as it is read: in the person's language where it can be, else with the units that are chosen. */
export function eventWords(event: Pick<Event, "code" | "text">): string {
  const text = eventText(event);
  return text === event.text ? inChosenUnits(text) : text;
}
