// A page's link to its station program: samples of the seat's topics, and orders. docs/gateway.md has the protocol.
// It reconnects by itself and then has the whole state again.

import { CdrReader } from "./cdr";
import { type TopicName, type TopicTypes, WIRE_VERSION, decoders, keys } from "./generated";
import { t } from "../kit/language";

export type Seat = "forecastle" | "conning" | "trainee" | "watcher" | "observer" | "assessor" | "instructor";

export interface Hello {
  protocol: number;
  wire_version: number;
  seat: Seat;
  exercise: string;
  name: string;
  commands: TopicName[];
  recording: string | null;
  recorded: string | null;
  live: string[];
  /** s without a word after which nobody has the levers. */
  hand_silent: number;
}

/** Set points of a windlass; units and signs of WindlassCommand. */
export interface WindlassLevers {
  brake: number;
  speed_lever: number;
  clutch_in: boolean;
  stopper_closed: boolean;
  emergency_stop: boolean;
}

/** Set points of the helm; units and signs of HelmCommand. */
export interface HelmLevers {
  engine: number;
  rudder: number;
  bow_thruster: number;
  stern_thruster: number;
}

/** Why an order did not go out. */
const kTryAgain = 500; // ms after which an order is given again that nobody heard yet
const kTries = 20; // of one order

export class Refused extends Error {
  constructor(
    text: string,
    readonly topic = "",
    readonly field = "",
    readonly value = "",
    readonly allowed = "",
    readonly again = false, // nobody hears it yet: the same may be taken in a moment
  ) {
    super(text);
  }
}

/**
 * connecting: not yet heard of; open; lost: tries again; refused: the station does not let this page in, as one that
 * was started again does; closed: by this page, or it must be loaded anew.
 */
export type LinkState = "connecting" | "open" | "lost" | "refused" | "closed";

/** A sample and when it came, ms of performance.now(). */
export interface Heard<T> {
  sample: T;
  at: number;
}

/** As it is kept: with the ms since 1970, by the writer's clock, at which it was said, however late it is heard. */
interface Said<T> extends Heard<T> {
  written: number;
}

/** Enough of a stream to draw the recent past: some 1.5 s at 100 Hz. */
const kKept = 160;
const kForbidden = 403;
/** What the door says to a browser that has no seat, or another one; and when it ends a link for that. */
const kElsewhere = new Set([401, 409]);
const kSentAway = 4001;
/** The same at a class's end: what the page has to show may be read first. */
const kMayRead = 4002;
const kWhySentAway = "windlass.why_sent_away";

/** The door's reason for which the last page of this tab was sent away, told once; empty: it was not. */
export function whySentAway(): string {
  const why = sessionStorage.getItem(kWhySentAway) ?? "";
  sessionStorage.removeItem(kWhySentAway);
  return why;
}
const kHold = 100; // ms between two words of a hand on the levers
const kInTurn = 1e-3; // ms, less than a page needs for a sample: of two that come at once the second came later
/** A server numbers its runs on from the ms at which it was started: those of another one are far off. */
const kRunsOfOneServer = 1000;
/** ms after a server's last status in which it may have written something else: until its next one was due. */
const kLastWords = 200;

/** The channels of a station, by name: a topic's, and beside the exercise's events those of the classroom. */
export type Channels = TopicTypes & { "classroom/Event": TopicTypes["Event"] };
export type ChannelName = keyof Channels;

type Listener<C extends ChannelName> = (sample: Channels[C], key: string, written: number) => void;
type Message = { op: string; [field: string]: unknown };
/** An order: the fields of a command's sample without its origin, enumerators by name. */
export type OrderSample = Record<string, unknown>;

export class Connection {
  hello: Hello | undefined;
  /** The station's reason, once it has refused this page. */
  refusal = "";
  /** Bytes and messages heard since the page was opened, for statistics. */
  readonly heard = { messages: 0, bytes: 0 };

  private socket: WebSocket | undefined;
  private state_: LinkState = "connecting";
  private retry = 0;
  private opened = 0;
  private came = 0; // ms of performance.now(), the newest sample
  private repeated = performance.now(); // ms, when the words of this page's hands went out again
  private readonly advertised = new Map<ChannelName, number>(); // their numbers
  private readonly wanted = new Set<ChannelName>(); // what was listened to or looked at
  private readonly channels = new Map<number, ChannelName>(); // by subscription
  private readonly kept = new Map<string, Said<unknown>[]>(); // by channel/key, oldest first
  private readonly listeners = new Map<ChannelName, Set<Listener<ChannelName>>>();
  private readonly stateListeners = new Set<(state: LinkState) => void>();
  private readonly serverListeners = new Set<(until: number) => void>();
  private readonly readers = new Set<() => boolean>();
  private readonly messageListeners = new Map<string, Set<(message: Message) => void>>();
  private readonly waiting = new Map<number, { done: () => void; failed: (why: Refused) => void }>();
  private nextId = 1;
  private readonly beat: ReturnType<typeof setInterval>;
  private readonly held = new Map<string, Message>(); // levers in this page's hand, by side or "helm"

  /** token: of the station; empty: the page came by the door, which knows it. exercise: an instructor's choice. */
  constructor(
    private readonly token: string,
    private readonly exercise?: string,
  ) {
    this.open();
    this.beat = setInterval(() => this.repeatHeld(), kHold);
    addEventListener("pagehide", () => this.close());
  }

  get state(): LinkState {
    return this.state_;
  }

  /** The page is of the door and not of a station of this computer. */
  get byDoor(): boolean {
    return !this.token;
  }

  /**
   * The newest sample of a channel; key as the topic's instances are told apart ("0" and "1" for sides). To look at a
   * channel subscribes it, as to listen does: who looks at certain moments only has nothing at the first of them.
   */
  latest<C extends ChannelName>(channel: C, key: string | number = ""): Channels[C] | undefined {
    return this.track(channel, key).at(-1)?.sample;
  }

  /** The recent samples of one instance, oldest first: to draw between them. Not to be kept or changed. */
  track<C extends ChannelName>(channel: C, key: string | number = ""): readonly Heard<Channels[C]>[] {
    this.want(channel);
    return (this.kept.get(`${channel}/${key}`) ?? []) as Heard<Channels[C]>[];
  }

  /** The newest sample of every instance of a channel. */
  all<C extends ChannelName>(channel: C): Channels[C][] {
    this.want(channel);
    const found: Channels[C][] = [];
    for (const [name, track] of this.kept)
      if (name.startsWith(`${channel}/`)) found.push(track.at(-1)!.sample as Channels[C]);
    return found;
  }

  /** When the newest sample of an instance came, ms of performance.now(); without key: of any. -Infinity: none yet. */
  heardAt(channel: ChannelName, key?: string | number): number {
    this.want(channel);
    let newest = -Infinity;
    for (const [name, track] of this.kept)
      if (key === undefined ? name.startsWith(`${channel}/`) : name === `${channel}/${key}`)
        newest = Math.max(newest, track.at(-1)!.at);
    return newest;
  }

  /** Calls back for each sample of a channel; returns what ends it. */
  on<C extends ChannelName>(channel: C, listener: Listener<C>): () => void {
    this.want(channel);
    const set = this.listeners.get(channel) ?? new Set();
    this.listeners.set(channel, set);
    set.add(listener as unknown as Listener<ChannelName>);
    return () => set.delete(listener as unknown as Listener<ChannelName>);
  }

  onState(listener: (state: LinkState) => void): () => void {
    this.stateListeners.add(listener);
    listener(this.state_);
    return () => this.stateListeners.delete(listener);
  }

  /**
   * Calls back when another server is heard than before: nothing that was heard of the last one is so any more. until:
   * when its last word was written, ms since 1970; what was written later is the new one's.
   */
  onAnotherServer(listener: (until: number) => void): void {
    this.serverListeners.add(listener);
  }

  /** Asks when the class is over: whoever still reads here, true, has the page, and leaves it for "/". */
  onClassOver(reads: () => boolean): void {
    this.readers.add(reads);
  }

  /** Calls back for messages of the gateway with that op: hello, levers, refused. */
  onMessage(op: string, listener: (message: Message) => void): () => void {
    const set = this.messageListeners.get(op) ?? new Set();
    this.messageListeners.set(op, set);
    set.add(listener);
    return () => set.delete(listener);
  }

  /** Puts the levers of a side so, and holds them until letGo(). */
  holdLevers(side: number, levers: WindlassLevers): void {
    this.hold(`${side}`, { op: "levers", side, ...levers });
  }
  /** Puts the helm so, and holds it until letGo("helm"). */
  holdHelm(helm: HelmLevers): void {
    this.hold("helm", { op: "helm", ...helm });
  }
  letGo(what: number | "helm"): void {
    if (!this.held.delete(`${what}`)) return;
    this.tell(what === "helm" ? { op: "let_go_levers", helm: true } : { op: "let_go_levers", side: what });
  }
  holds(what: number | "helm"): boolean {
    return this.held.has(`${what}`);
  }

  /** Whether a hand of this page is on any levers. */
  holdsAny(): boolean {
    return this.held.size > 0;
  }

  /** Gives an order, and again while nobody hears it yet: resolves when it is on its way, rejects with Refused. */
  async order(topic: TopicName, sample: OrderSample): Promise<void> {
    for (let tries = 1; ; ++tries)
      try {
        return await this.ask({ op: "order", topic, sample });
      } catch (why) {
        if (!(why instanceof Refused && why.again && tries < kTries)) throw why;
        await new Promise((later) => setTimeout(later, kTryAgain));
      }
  }

  /** Any message that is answered with sent or refused. */
  ask(message: Message): Promise<void> {
    if (this.state_ !== "open") return Promise.reject(new Refused(t("no connection to the station")));
    const id = this.nextId++;
    return new Promise((done, failed) => {
      this.waiting.set(id, { done, failed });
      this.tell({ ...message, id });
    });
  }

  close(): void {
    clearInterval(this.beat);
    this.setState("closed");
    this.socket?.close();
  }

  private hold(what: string, message: Message): void {
    this.held.set(what, message);
    this.tell(message);
  }

  private repeatHeld(): void {
    this.repeated = performance.now();
    for (const message of this.held.values()) this.tell(message);
  }

  private tell(message: Message): void {
    if (this.socket?.readyState === WebSocket.OPEN) this.socket.send(JSON.stringify(message));
  }

  /** Whether nothing more comes over this link. */
  private ended(): boolean {
    return this.state_ === "closed" || this.state_ === "refused";
  }

  private setState(state: LinkState): void {
    if (this.state_ === state || this.ended()) return;
    this.state_ = state;
    for (const listener of this.stateListeners) listener(state);
  }

  private address(): URL {
    const address = new URL("/ws", location.href);
    address.search = new URLSearchParams({
      ...(this.token ? { token: this.token } : { page: location.pathname.slice(1) }),
      ...(this.exercise ? { exercise: this.exercise } : {}),
    }).toString();
    address.hash = "";
    return address;
  }

  private open(): void {
    const address = this.address();
    address.protocol = location.protocol === "https:" ? "wss:" : "ws:";
    this.opened = Infinity;
    this.advertised.clear();
    this.channels.clear();
    const socket = new WebSocket(address, "windlass.v1");
    socket.binaryType = "arraybuffer";
    socket.onmessage = (event) =>
      typeof event.data === "string" ? this.takeText(event.data) : this.takeSample(event.data as ArrayBuffer);
    socket.onopen = () => (this.opened = performance.now());
    socket.onclose = ({ code, reason }) => {
      if (code === kSentAway) this.goHome(reason);
      else if (code === kMayRead) this.classOver(reason);
      else this.lost();
    };
    this.socket = socket;
  }

  private lost(): void {
    this.held.clear(); // the server has given them up; a hand takes them anew
    for (const { failed } of this.waiting.values()) failed(new Refused(t("the connection to the station was lost")));
    this.waiting.clear();
    if (this.ended()) return;
    this.setState("lost");
    if (this.opened === Infinity) void this.askWhy();
    if (performance.now() - this.opened > 5000) this.retry = 0;
    const wait = Math.min(4000, 250 * 2 ** this.retry++) * (0.8 + 0.4 * Math.random());
    setTimeout(() => !this.ended() && this.open(), wait);
  }

  /** A WebSocket does not say why it was not let in; the same asked for by HTTP does. */
  private async askWhy(): Promise<void> {
    try {
      const answer = await fetch(this.address(), { cache: "no-store" });
      if (kElsewhere.has(answer.status) && !this.token) return this.goHome();
      if (answer.status !== kForbidden || this.state_ === "open") return;
      this.refusal = (await answer.text()).trim();
      this.setState("refused");
    } catch {
      // nobody is there: it is tried again
    }
  }

  /** To where the door has a place for this browser. why: the door's, for the page that is there. */
  private goHome(why = ""): void {
    this.close();
    sessionStorage.setItem(kWhySentAway, why);
    location.assign("/");
  }

  /** The state stays with a reader: no veil of a lost connection lies over what is read. */
  private classOver(why: string): void {
    if (![...this.readers].some((reads) => reads())) return this.goHome(why);
    clearInterval(this.beat);
    this.held.clear();
    sessionStorage.setItem(kWhySentAway, why);
  }

  private takeText(text: string): void {
    const message = JSON.parse(text) as Message;
    if (message.op === "hello") {
      this.hello = message as unknown as Hello;
      if (this.hello.wire_version !== WIRE_VERSION) {
        console.warn(`the station speaks version ${this.hello.wire_version} of the wire, this page ${WIRE_VERSION}`);
        this.close();
        return;
      }
      if (this.state_ !== "open") this.kept.clear();
      this.setState("open");
    } else if (message.op === "advertise") {
      for (const { id, topic } of message.channels as { id: number; topic: string }[])
        if (topicOf(topic) in decoders) this.advertised.set(topic.slice(1) as ChannelName, id);
      this.subscribe();
    } else if (message.op === "levers" && message.taken_by) {
      this.letGo(message.helm === true ? "helm" : (message.side as number)); // another station has them
    } else if (message.op === "sent" || message.op === "refused") {
      const asked = this.waiting.get(message.id as number);
      this.waiting.delete(message.id as number);
      if (message.op === "sent") asked?.done();
      else
        asked?.failed(
          new Refused(
            `${message.text}`,
            `${message.topic}`,
            `${message.field}`,
            `${message.value}`,
            `${message.allowed}`,
            message.again === true,
          ),
        );
    }
    for (const listener of this.messageListeners.get(message.op) ?? []) listener(message);
  }

  /** What is listened to or looked at is what is subscribed: there is no list of it. */
  private want(channel: ChannelName): void {
    if (this.wanted.has(channel)) return;
    this.wanted.add(channel);
    queueMicrotask(() => this.subscribe()); // one message for all that a panel wants
  }

  /** Asks for what is wanted of what this seat has, once for each opening of the link. */
  private subscribe(): void {
    const subscriptions = [];
    for (const [name, id] of this.advertised) {
      if (!this.wanted.has(name) || this.channels.has(id)) continue;
      this.channels.set(id, name);
      subscriptions.push({ id, channelId: id });
    }
    if (subscriptions.length) this.tell({ op: "subscribe", subscriptions });
  }

  private takeSample(data: ArrayBuffer): void {
    const view = new DataView(data);
    const channel = this.channels.get(view.getUint32(1, true));
    if (view.getUint8(0) !== 1 || !channel) return;
    // A browser slows the timers of a page that is hidden, to one turn a minute at last: what comes is its clock then.
    if (performance.now() - this.repeated > 2 * kHold) this.repeatHeld();
    this.heard.messages += 1;
    this.heard.bytes += data.byteLength;
    const topic = topicOf(channel);
    const sample = decoders[topic](new CdrReader(new DataView(data, 13)));
    this.keep(channel, sample, keyOf(topic, sample), Number(view.getBigUint64(5, true)) / 1e6);
  }

  private keep<C extends ChannelName>(channel: C, sample: Channels[C], key: string, written: number): void {
    if (channel === "ExerciseStatus") this.lookWhoseWord(sample as Channels["ExerciseStatus"]);
    const name = `${channel}/${key}`;
    const track = this.kept.get(name) ?? [];
    this.kept.set(name, track);
    this.came = Math.max(performance.now(), this.came + kInTurn);
    track.push({ sample, at: this.came, written });
    if (track.length > kKept) track.shift();
    for (const listener of this.listeners.get(channel) ?? []) listener(sample, key, written);
  }

  /** Forgets what a server said that was killed, once another one speaks in its place. */
  private lookWhoseWord(status: Channels["ExerciseStatus"]): void {
    const last = this.kept.get("ExerciseStatus/")?.at(-1) as Said<Channels["ExerciseStatus"]> | undefined;
    if (!last || this.kept.has("ReplayStatus/") || Math.abs(status.run - last.sample.run) < kRunsOfOneServer) return;
    const until = last.written + kLastWords;
    for (const [name, track] of this.kept)
      if (!/^(classroom\/|Classroom)/.test(name) && track.at(-1)!.written < until) this.kept.delete(name);
    for (const listener of this.serverListeners) listener(until);
  }
}

/** The topic of a channel, with or without the slash that names begin with on the wire. */
const topicOf = (channel: string): TopicName => channel.replace(/^.*\//, "") as TopicName;
const keyOf = <T extends TopicName>(topic: T, sample: TopicTypes[T]): string => keys[topic](sample);
