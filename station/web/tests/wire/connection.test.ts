// The link to a station that comes and goes, by a socket and a clock that the test moves.

import assert from "node:assert/strict";
import { type TestContext, test } from "node:test";

import { Connection, type LinkState, Refused, whySentAway } from "../../src/wire/connection";
import { WIRE_VERSION } from "../../src/wire/generated";

type Sent = { op: string; [field: string]: unknown };

class Socket {
  static readonly OPEN = 1;
  static all: Socket[] = [];
  readyState = 0;
  readonly sent: Sent[] = [];
  onmessage?: (event: { data: unknown }) => void;
  onopen?: () => void;
  onclose?: (event: { code: number; reason: string }) => void;
  constructor(readonly address: URL) {
    Socket.all.push(this);
  }
  send(text: string): void {
    this.sent.push(JSON.parse(text) as Sent);
  }
  /** code: of a connection that broke, unless somebody says why. */
  close(code = 1006, reason = ""): void {
    this.readyState = 3;
    this.onclose?.({ code, reason });
  }
  /** The station lets the page in. */
  accept(hello: object = {}): void {
    this.readyState = Socket.OPEN;
    this.onopen?.();
    this.say({ op: "hello", wire_version: WIRE_VERSION, name: "forecastle-1", ...hello });
  }
  say(message: object): void {
    this.onmessage?.({ data: JSON.stringify(message) });
  }
  ops(): string[] {
    return this.sent.map(({ op }) => op);
  }
}

/** Timers that go off when the test moves the clock. */
class Timers {
  private now = 0;
  private next = 1;
  private readonly due = new Map<number, { at: number; every: number; act: () => void }>();

  add(act: () => void, wait: number, every = 0): number {
    this.due.set(this.next, { at: this.now + wait, every, act });
    return this.next++;
  }
  drop(timer: number): void {
    this.due.delete(timer);
  }
  tick(ms: number): void {
    const end = this.now + ms;
    for (;;) {
      const [timer, first] = [...this.due].sort(([, a], [, b]) => a.at - b.at)[0] ?? [];
      if (timer === undefined || !first || first.at > end) break;
      this.now = first.at;
      if (first.every) first.at += first.every;
      else this.due.delete(timer);
      first.act();
    }
    this.now = end;
  }
}
let timers: Timers;

interface Rig {
  link: Connection;
  states: LinkState[];
  /** Where the page was sent. */
  gone: string[];
  /** The newest socket. */
  socket: () => Socket;
}

/** A connection with timers, sockets and the test's clock; answer: of the station by HTTP; token: "" by the door. */
function connect(
  t: TestContext,
  answer: () => Promise<unknown> = () => Promise.reject(new Error("nobody")),
  token = "secret",
): Rig {
  const gone: string[] = [];
  const kept = new Map<string, string>();
  timers = new Timers();
  const clock = timers;
  t.mock.method(globalThis, "setTimeout", (act: () => void, wait: number) => clock.add(act, wait));
  t.mock.method(globalThis, "setInterval", (act: () => void, every: number) => clock.add(act, every, every));
  t.mock.method(globalThis, "clearInterval", (timer: number) => clock.drop(timer));
  t.mock.method(Math, "random", () => 0.5);
  Socket.all = [];
  Object.assign(globalThis, {
    WebSocket: Socket,
    location: {
      href: "http://127.0.0.1:8765/forecastle",
      protocol: "http:",
      pathname: "/forecastle",
      assign: (to: string) => gone.push(to),
    },
    sessionStorage: {
      getItem: (key: string) => kept.get(key) ?? null,
      setItem: (key: string, value: string) => kept.set(key, value),
      removeItem: (key: string) => kept.delete(key),
    },
    addEventListener: () => undefined,
    fetch: answer,
  });
  const link = new Connection(token);
  const states: LinkState[] = [];
  link.onState((state) => states.push(state));
  t.after(() => link.close());
  return { link, states, gone, socket: () => Socket.all.at(-1)! };
}
const settled = () => new Promise<void>((done) => setImmediate(done));

test("it says its token, and is open once the station has said hello", (t) => {
  const { link, states, socket } = connect(t);
  assert.equal(socket().address.href, "ws://127.0.0.1:8765/ws?token=secret");
  socket().accept();
  assert.deepEqual(states, ["connecting", "open"]);
  assert.equal(link.hello?.name, "forecastle-1");
});

test("a link that is lost is opened anew, later each time, and 4 s later at most", (t) => {
  const { states, socket } = connect(t);
  socket().accept();
  const waits: number[] = [];
  for (let i = 0; i < 6; ++i) {
    socket().close();
    const before = Socket.all.length;
    let wait = 0;
    for (; Socket.all.length === before && wait < 10000; wait += 50) timers.tick(50);
    waits.push(wait);
  }
  assert.deepEqual(waits, [250, 500, 1000, 2000, 4000, 4000]);
  assert.deepEqual(states, ["connecting", "open", "lost"]);
  socket().accept();
  assert.equal(states.at(-1), "open");
});

test("a station that was started again refuses the page, which says why and tries no more", async (t) => {
  const { link, states, socket } = connect(t, () =>
    Promise.resolve({ status: 403, text: () => Promise.resolve("another token\n") }),
  );
  socket().close();
  await settled();
  assert.equal(states.at(-1), "refused");
  assert.equal(link.refusal, "another token");
  timers.tick(10000);
  assert.equal(Socket.all.length, 1);
});

test("a seat that the door holds open for another address is asked for again", async (t) => {
  const { states, socket } = connect(t, () => Promise.resolve({ status: 423, text: () => Promise.resolve("") }), "");
  socket().close();
  await settled();
  assert.equal(states.at(-1), "lost");
  timers.tick(1000);
  socket().accept();
  assert.equal(states.at(-1), "open");
});

test("a page of the door says which it is, and goes where the door leads when its seat is another's", (t) => {
  const { gone, socket } = connect(t, undefined, "");
  assert.equal(socket().address.href, "ws://127.0.0.1:8765/ws?page=forecastle");
  socket().accept();
  socket().close(4001, "the class is over");
  assert.deepEqual(gone, ["/"]);
  assert.deepEqual([whySentAway(), whySentAway()], ["the class is over", ""], "told once");
  timers.tick(10000);
  assert.equal(Socket.all.length, 1);
});

test("at the end of a class who still reads has the page, and nobody else", (t) => {
  const { link, states, gone, socket } = connect(t, undefined, "");
  let reads = true;
  link.onClassOver(() => reads);
  socket().accept();
  socket().close(4002, "the class is over");
  assert.deepEqual(gone, []);
  assert.equal(states.at(-1), "open", "nothing is said of a connection that was lost");
  timers.tick(10000);
  assert.equal(Socket.all.length, 1, "nor is it opened anew");
  reads = false;
  socket().close(4002, "the class is over");
  assert.deepEqual(gone, ["/"]);
});

test("nor does a page try again that the door no longer knows", async (t) => {
  const { gone, socket } = connect(t, () => Promise.resolve({ status: 401, text: () => Promise.resolve("") }), "");
  socket().close();
  await settled();
  assert.deepEqual(gone, ["/"]);
  timers.tick(10000);
  assert.equal(Socket.all.length, 1);
});

test("what is wanted is subscribed in one message, and anew when the link is", async (t) => {
  const { link, socket } = connect(t);
  const channels = [
    { id: 3, topic: "/ExerciseStatus" },
    { id: 4, topic: "/Report" },
    { id: 5, topic: "/ShipState" },
  ];
  socket().accept();
  socket().say({ op: "advertise", channels });
  assert.deepEqual(socket().ops(), []);
  link.latest("ExerciseStatus");
  link.on("Report", () => undefined);
  await settled();
  const subscribed = [{ op: "subscribe", subscriptions: [3, 4].map((id) => ({ id, channelId: id })) }];
  assert.deepEqual(socket().sent, subscribed);
  socket().close();
  timers.tick(1000);
  socket().accept();
  socket().say({ op: "advertise", channels });
  assert.deepEqual(socket().sent, subscribed);
});

test("levers are said again ten times a second while held, and are in no hand after the link was lost", (t) => {
  const { link, socket } = connect(t);
  socket().accept();
  const levers = { brake: 1, speed_lever: 0, clutch_in: true, stopper_closed: false, emergency_stop: false };
  link.holdLevers(1, levers);
  timers.tick(300);
  assert.deepEqual(socket().sent, Array(4).fill({ op: "levers", side: 1, ...levers }));
  link.letGo(1);
  assert.deepEqual(socket().sent.at(-1), { op: "let_go_levers", side: 1 });
  link.holdLevers(1, levers);
  socket().close();
  assert.equal(link.holds(1), false);
  timers.tick(1000);
  socket().accept();
  timers.tick(1000);
  assert.deepEqual(socket().ops(), []);
});

test("levers that another station has taken are let go", (t) => {
  const { link, socket } = connect(t);
  socket().accept();
  link.holdHelm({ engine: 0, rudder: 0, bow_thruster: 0, stern_thruster: 0 });
  socket().say({ op: "levers", helm: true, taken_by: "desk-2" });
  assert.equal(link.holds("helm"), false);
});

test("an order that nobody hears yet is given again until it is on its way", async (t) => {
  const { link, socket } = connect(t);
  socket().accept();
  const settled = async (): Promise<void> => {
    for (let k = 0; k < 9; ++k) await Promise.resolve();
  };
  const order = link.order("Report", {});
  socket().say({ op: "refused", id: socket().sent[0]!.id, text: "not heard yet", again: true });
  await settled();
  timers.tick(500);
  await settled();
  assert.deepEqual(socket().ops(), ["order", "order"]);
  socket().say({ op: "sent", id: socket().sent[1]!.id });
  await order;
});

test("an order is done when it was sent, fails when it is refused, and when the link is lost", async (t) => {
  const { link, socket } = connect(t);
  await assert.rejects(link.order("Report", {}), /no connection/);
  socket().accept();
  const sent = link.order("Report", { code: "REPORT_TEXT" });
  socket().say({ op: "sent", id: socket().sent[0]!.id });
  await sent;
  const refused = link.order("Report", {});
  socket().say({ op: "refused", id: socket().sent[1]!.id, text: "no", field: "code", value: "7", allowed: "0..6" });
  await assert.rejects(refused, (why) => why instanceof Refused && why.field === "code" && why.allowed === "0..6");
  const lost = link.order("Report", {});
  socket().close();
  await assert.rejects(lost, /was lost/);
});

test("a station of another version of the wire is left for good", (t) => {
  t.mock.method(console, "warn", () => undefined);
  const { states, socket } = connect(t);
  socket().accept({ wire_version: WIRE_VERSION + 1 });
  timers.tick(10000);
  assert.equal(states.at(-1), "closed");
  assert.equal(Socket.all.length, 1);
});

/** A field of a sample: u32 in brackets, u64, f64 or string. */
type Field = [number] | bigint | number | string;

/** A sample as a station sends it; written: ms since 1970. */
function sampleOf(subscription: number, written: number, fields: Field[]): ArrayBuffer {
  const view = new DataView(new ArrayBuffer(400));
  view.setUint8(0, 1);
  view.setUint32(1, subscription, true);
  view.setBigUint64(5, BigInt(written) * 1_000_000n, true);
  view.setUint16(13, 1); // little-endian CDR
  let at = 17;
  const next = (size: number) => {
    at += -(at - 17) & (size - 1);
    at += size;
    return at - size;
  };
  for (const value of fields)
    if (typeof value === "string") {
      view.setUint32(next(4), value.length + 1, true);
      for (const letter of `${value}\0`) view.setUint8(next(1), letter.charCodeAt(0));
    } else if (typeof value === "bigint") view.setBigUint64(next(8), value, true);
    else if (typeof value === "number") view.setFloat64(next(8), value, true);
    else view.setUint32(next(4), value[0], true);
  return view.buffer;
}

test("a page that was held up tells a lost server from the next one by when their words were written", (t) => {
  const { link, socket } = connect(t);
  const codes: string[] = [];
  let until = 0;
  link.on("Event", ({ code }, _, written) => codes.push(`${code} ${written}`));
  link.on("ExerciseStatus", () => undefined);
  link.onAnotherServer((at) => (until = at));
  socket().accept();
  socket().say({
    op: "advertise",
    channels: [
      { id: 1, topic: "/ExerciseStatus" },
      { id: 2, topic: "/Event" },
    ],
  });
  const wanted = socket().sent.flatMap(
    (message) => (message.subscriptions as { id: number; channelId: number }[]) ?? [],
  );
  const [status, event] = [1, 2].map((channel) => wanted.find(({ channelId }) => channelId === channel)!.id);
  const tell = (data: ArrayBuffer) => socket().onmessage?.({ data });
  const tellStatus = (run: bigint, written: number) =>
    tell(sampleOf(status!, written, [0n, 0, [1], 1, 1, "one", "One", run]));
  const tellEvent = (code: string, written: number) =>
    tell(sampleOf(event!, written, [0n, 0, 1n, [0], code, [0], 0, code]));
  // All at once: the next one speaks 0.3 s after the last one's status, and says first what it goes on from.
  tellStatus(1_000n, 50_000);
  tellEvent("last.word", 50_150);
  tellEvent("exercise.taken_up", 50_300);
  tellStatus(900_000n, 50_310);
  assert.deepEqual(codes, ["last.word 50150", "exercise.taken_up 50300"]);
  assert.ok(until > 50_150 && until <= 50_300, `${until}`);
  assert.equal(link.latest("Event")?.code, "exercise.taken_up");
});

test("of samples that come in one moment the second came later", (t) => {
  const { link, socket } = connect(t);
  link.on("Event", () => undefined);
  socket().accept();
  socket().say({ op: "advertise", channels: [{ id: 1, topic: "/Event" }] });
  t.mock.method(performance, "now", () => 5000);
  for (const code of ["first", "second"])
    socket().onmessage?.({ data: sampleOf(1, 50_000, [0n, 0, 1n, [0], code, [0], 0, code]) });
  const [first, second] = link.track("Event");
  assert.deepEqual([first?.sample.code, second?.sample.code], ["first", "second"]);
  assert.ok(first!.at < second!.at);
});

test("a page whose timers are slowed, as those of a hidden one are, holds its levers by what it hears", (t) => {
  let now = 5000;
  t.mock.method(performance, "now", () => now);
  const { link, socket } = connect(t);
  link.on("Event", () => undefined);
  socket().accept();
  socket().say({ op: "advertise", channels: [{ id: 1, topic: "/Event" }] });
  link.holdHelm({ engine: 0.4, rudder: 0, bow_thruster: 0, stern_thruster: 0 });
  const wordsAfter = (ms: number): number => {
    now += ms;
    socket().onmessage?.({ data: sampleOf(1, 50_000, [0n, 0, 1n, [0], "code", [0], 0, "code"]) });
    return socket()
      .ops()
      .filter((op) => op === "helm").length;
  };
  assert.equal(wordsAfter(100), 1, "its timer's turn");
  assert.equal(wordsAfter(150), 2);
  assert.equal(wordsAfter(100), 2);
  assert.equal(wordsAfter(150), 3);
});
