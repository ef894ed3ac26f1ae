// Whether what is shown is of now. Judged by the age of what the server itself publishes, each topic by its own rate:
// levers come from stations, and go on when there is no server any more.

import type { Connection } from "../wire/connection";
import { RunState, type TopicName, rates } from "../wire/generated";

/** ms without a word of the server: long against what a busy machine delays, short against what a hand believes. */
const kSilent = 4000;
const kMissing = 3; // samples of a stream that may be late or lost
const kSlowest = 5; // Hz, of a stream while the exercise stands still, and of a cable that lies still
const kLeastPace = 0.1; // the slowest time scale there is

/** What a panel shows, and where. */
interface Watched {
  element: Element;
  link: Connection;
  topic: TopicName;
  key: () => string | number | undefined;
  old: boolean;
}

const watched: Watched[] = [];
const unheard = new WeakSet<Connection>();

/** Whether the server that was heard over this link is not heard any more: then nobody takes an order. */
export const isUnheard = (link: Connection): boolean => unheard.has(link);

/**
 * Marks an element with data-old while the topic that it shows, or the server, is silent. key: the instance that it
 * shows; without, any.
 */
export function showsTopic(
  element: Element,
  link: Connection,
  topic: TopicName,
  key: () => string | number | undefined = () => undefined,
): void {
  watched.push({ element, link, topic, key, old: false });
}

/** Looks whether what a link's page shows is of now. view: the topic by which the page's seat sees the exercise. */
export class LiveWatch {
  private before = 0;

  constructor(
    private readonly link: Connection,
    private readonly view: TopicName,
  ) {}

  /** To be called a few times a second. Returns the ms for which server or view have not been heard; 0: they are. */
  look(now: number): number {
    const { link } = this;
    const open = link.state === "open";
    const server = open ? silence(link, "ExerciseStatus", now) : 0;
    const silent = open ? Math.max(server, silence(link, this.view, now)) : 0;
    // Only what is silent twice: a page that was held up itself finds first what has come meanwhile.
    const lasts = silent > 0 && this.before > 0;
    this.before = silent;
    if (lasts && server > 0) unheard.add(link);
    else unheard.delete(link);
    for (const each of watched) {
      if (each.link !== link) continue;
      const old = lasts || (open && silence(link, each.topic, now, each.key()) > 0);
      each.element.toggleAttribute("data-old", old && (lasts || each.old));
      each.old = old;
    }
    return lasts ? silent : 0;
  }
}

/** ms since the newest sample, where that is too long for the topic's rate; 0: it is of now, or was never heard. */
function silence(link: Connection, topic: TopicName, now: number, key?: string | number): number {
  if (isBlanked(link, topic)) return 0;
  const at = link.heardAt(topic, key);
  const age = now - (isReplay(link) ? link.heardAt("ExerciseStatus") : at); // one that stands repeats its status alone
  return at > 0 && age > limit(link, topic) ? age : 0;
}

/** ms. A stream's rate counts in exercise time, where that goes slower than the wall's. */
function limit(link: Connection, topic: TopicName): number {
  const status = link.latest("ExerciseStatus");
  if (topic === "ExerciseStatus" || !status || isReplay(link)) return kSilent;
  const running = status.state === RunState.RUN_RUNNING;
  const pace = running ? Math.min(1, Math.max(kLeastPace, status.time_scale_achieved)) : 1;
  return kSilent + (1000 * kMissing) / (Math.min(kSlowest, rates[topic]) * pace);
}

/** While a seat is asked something at a freeze, its view is not sent. */
function isBlanked(link: Connection, topic: TopicName): boolean {
  if (topic === "ForecastleView") return Boolean(link.latest("ForecastleQuestion")?.id);
  if (topic === "BridgeView" || topic === "ForecastleCamera") return Boolean(link.latest("BridgeQuestion")?.id);
  return false;
}

const isReplay = (link: Connection): boolean =>
  link.latest("ReplayStatus") !== undefined || link.latest("ExerciseStatus")?.state === RunState.RUN_REPLAY;
