// A page's link to its station program: samples of the seat's topics, and orders. docs/gateway.md has the protocol.
// It reconnects by itself and then has the whole state again.

import { CdrReader } from "./cdr";
import { type TopicName, type TopicTypes, WIRE_VERSION, decoders, keys } from "./generated";

export type Seat = "forecastle" | "conning" | "trainee" | "instructor";

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
export class Refused extends Error {
  constructor(
    text: string,
    readonly topic = "",
    readonly field = "",
    readonly value = "",
    readonly allowed = "",
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

/** Enough of a stream to draw the recent past: some 1.5 s at 100 Hz. */
const kKept = 160;
const kForbidden = 403;
const kHold = 100; // ms between two words of a hand on the levers

type Listener<T extends TopicName> = (sample: TopicTypes[T], key: string) => void;
type Message = { op: string; [field: string]: unknown };
/** An order: the fields of a command's sample without its origin, enumerators by name. */
export type OrderSample = Record<string, unknown>;

export class Connection {
  hello: Hello | undefined;
  /** The station's reason, once it has refused this page. */
  refusal = "";
  /** Bytes and messages heard since the page was opened, for statistics; at: ms of performance.now(), the last sample. */
  readonly heard = { messages: 0, bytes: 0, at: -Infinity };

  private socket: WebSocket | undefined;
  private state_: LinkState = "connecting";
  private retry = 0;
  private opened = 0;
  private readonly channels = new Map<number, TopicName>(); // by subscription
  private readonly kept = new Map<string, Heard<unknown>[]>(); // by topic/key, oldest first
  private readonly listeners = new Map<TopicName, Set<Listener<TopicName>>>();
  private readonly stateListeners = new Set<(state: LinkState) => void>();
  private readonly messageListeners = new Map<string, Set<(message: Message) => void>>();
  private readonly waiting = new Map<number, { done: () => void; failed: (why: Refused) => void }>();
  private nextId = 1;
  private readonly beat: ReturnType<typeof setInterval>;
  private readonly held = new Map<string, Message>(); // levers in this page's hand, by side or "helm"

  /** topics: those the page wants, of those the seat has; undefined: all. exercise: an instructor's choice. */
  constructor(
    private readonly token: string,
    private readonly topics?: readonly TopicName[],
    private readonly exercise?: string,
  ) {
    this.open();
    this.beat = setInterval(() => this.repeatHeld(), kHold);
    addEventListener("pagehide", () => this.close());
  }

  get state(): LinkState {
    return this.state_;
  }

  /** The newest sample of a topic; key as the topic's instances are told apart ("0" and "1" for sides). */
  latest<T extends TopicName>(topic: T, key: string | number = ""): TopicTypes[T] | undefined {
    return this.track(topic, key).at(-1)?.sample;
  }

  /** The recent samples of one instance, oldest first: to draw between them. Not to be kept or changed. */
  track<T extends TopicName>(topic: T, key: string | number = ""): readonly Heard<TopicTypes[T]>[] {
    return (this.kept.get(`${topic}/${key}`) ?? []) as Heard<TopicTypes[T]>[];
  }

  /** The newest sample of every instance of a topic. */
  all<T extends TopicName>(topic: T): TopicTypes[T][] {
    const found: TopicTypes[T][] = [];
    for (const [name, track] of this.kept)
      if (name.startsWith(`${topic}/`)) found.push(track.at(-1)!.sample as TopicTypes[T]);
    return found;
  }

  /** Calls back for each sample of a topic; returns what ends it. */
  on<T extends TopicName>(topic: T, listener: Listener<T>): () => void {
    const set = this.listeners.get(topic) ?? new Set();
    this.listeners.set(topic, set);
    set.add(listener as unknown as Listener<TopicName>);
    return () => set.delete(listener as unknown as Listener<TopicName>);
  }

  onState(listener: (state: LinkState) => void): () => void {
    this.stateListeners.add(listener);
    listener(this.state_);
    return () => this.stateListeners.delete(listener);
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

  /** Gives an order: resolves when it is on its way, rejects with Refused. */
  order(topic: TopicName, sample: OrderSample): Promise<void> {
    return this.ask({ op: "order", topic, sample });
  }

  /** Any message that is answered with sent or refused. */
  ask(message: Message): Promise<void> {
    if (this.state_ !== "open") return Promise.reject(new Refused("no connection to the station"));
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
      token: this.token,
      ...(this.exercise ? { exercise: this.exercise } : {}),
    }).toString();
    address.hash = "";
    return address;
  }

  private open(): void {
    const address = this.address();
    address.protocol = location.protocol === "https:" ? "wss:" : "ws:";
    this.opened = Infinity;
    const socket = new WebSocket(address, "windlass.v1");
    socket.binaryType = "arraybuffer";
    socket.onmessage = (event) =>
      typeof event.data === "string" ? this.takeText(event.data) : this.takeSample(event.data as ArrayBuffer);
    socket.onopen = () => (this.opened = performance.now());
    socket.onclose = () => this.lost();
    this.socket = socket;
  }

  private lost(): void {
    this.held.clear(); // the server has given them up; a hand takes them anew
    for (const { failed } of this.waiting.values()) failed(new Refused("the connection to the station was lost"));
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
      if (answer.status !== kForbidden || this.state_ === "open") return;
      this.refusal = (await answer.text()).trim();
      this.setState("refused");
    } catch {
      // nobody is there: it is tried again
    }
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
      this.subscribe(message.channels as { id: number; topic: string }[]);
    } else if (message.op === "sent" || message.op === "refused") {
      const asked = this.waiting.get(message.id as number);
      this.waiting.delete(message.id as number);
      if (message.op === "sent") asked?.done();
      else
        asked?.failed(
          new Refused(`${message.text}`, `${message.topic}`, `${message.field}`, `${message.value}`, `${message.allowed}`),
        );
    }
    for (const listener of this.messageListeners.get(message.op) ?? []) listener(message);
  }

  private subscribe(channels: { id: number; topic: string }[]): void {
    const subscriptions = [];
    for (const { id, topic } of channels) {
      const inClassroom = topic.startsWith("/classroom/"); // beside the exercise's topic of that name
      if (inClassroom && !this.topics?.includes("ClassroomStatus")) continue;
      const name = topic.replace(/^.*\//, "") as TopicName;
      if (!(name in decoders) || (this.topics && !this.topics.includes(name))) continue;
      this.channels.set(id, name);
      subscriptions.push({ id, channelId: id });
    }
    this.tell({ op: "subscribe", subscriptions });
  }

  private takeSample(data: ArrayBuffer): void {
    const view = new DataView(data);
    const topic = this.channels.get(view.getUint32(1, true));
    if (view.getUint8(0) !== 1 || !topic) return;
    this.heard.messages += 1;
    this.heard.bytes += data.byteLength;
    this.heard.at = performance.now();
    this.keep(topic, decoders[topic](new CdrReader(new DataView(data, 13))));
  }

  private keep<T extends TopicName>(topic: T, sample: TopicTypes[T]): void {
    const key = keys[topic](sample);
    const name = `${topic}/${key}`;
    const track = this.kept.get(name) ?? [];
    this.kept.set(name, track);
    track.push({ sample, at: performance.now() });
    if (track.length > kKept) track.shift();
    for (const listener of this.listeners.get(topic) ?? []) listener(sample as never, key);
  }
}
