// A real server, stations and consoles for a test in a browser: each in a process of its own, in the domain that
// own_domain holds, ended with the test whatever becomes of it.
//
// by hand: WINDLASS_DOMAIN=7 node station/web/tools/ts.mjs --test tests/browser/forecastle.test.ts

import { type ChildProcess, spawn } from "node:child_process";
import { join } from "node:path";
import { createInterface } from "node:readline";

import { root } from "./browser";

const bin = () => process.env.WINDLASS_BIN ?? join(root, "build/release/bin"); // of what is started next
const kDomain = process.env.WINDLASS_DOMAIN ?? "";
if (!kDomain) throw new Error("WINDLASS_DOMAIN is not set: run by own_domain, or set it to a domain of your own");
const kPatience = 150000; // ms for what happens within one second on a machine at rest: others may have it to themselves
const kLook = 80; // ms between two looks: each costs the browser work, too

export const sleep = (ms: number): Promise<void> => new Promise((done) => setTimeout(done, ms));

/** Waits until look() gives something true, and returns it; what it last gave or threw is told when it never does. */
export async function eventually<T>(what: string, look: () => T | Promise<T>, patience = kPatience) {
  const end = Date.now() + patience;
  for (let last: unknown; ; await sleep(kLook)) {
    try {
      const now = await look();
      if (now) return now;
      last = now;
    } catch (why) {
      last = why;
    }
    if (Date.now() > end)
      throw new Error(`never: ${what}; at last ${last instanceof Error ? last.stack : JSON.stringify(last)}`);
  }
}

/**
 * One program of ours. Its lines on stdout are kept, its stderr is told when the test fails to find what it waits
 * for.
 */
export class Program {
  readonly lines: string[] = [];
  errors = "";
  /** With which it ended. */
  code: number | undefined;
  readonly ended: Promise<number>;
  private readonly child: ChildProcess;

  constructor(
    private readonly name: string,
    args: string[],
  ) {
    const child = spawn(join(bin(), name), args, { stdio: ["ignore", "pipe", "pipe"] });
    this.child = child;
    child.on("error", (why) => (this.errors += `${why}`));
    child.stderr.on("data", (text: Buffer) => (this.errors += text.toString()));
    this.ended = new Promise((done) => child.on("close", (code) => done((this.code = code ?? -1))));
    createInterface({ input: child.stdout }).on("line", (line) => this.lines.push(line));
  }

  /** Of its process. */
  get pid(): number {
    return this.child.pid;
  }

  /** Its first line on stdout that fits. */
  line(pattern: RegExp): Promise<string> {
    return eventually(`${this.name} says ${pattern}`, () => {
      const found = this.lines.find((line) => pattern.test(line)) ?? "";
      if (!found && this.code !== undefined) throw new Error(`it ended with code ${this.code}: ${this.errors}`);
      return found;
    });
  }

  async stop(signal: NodeJS.Signals = "SIGTERM"): Promise<void> {
    if (this.code === undefined) this.child.kill(signal);
    const late = setTimeout(() => this.child.kill("SIGKILL"), 5000);
    await this.ended;
    clearTimeout(late);
  }
}

/** A station that serves pages. */
export interface Station extends Program {
  /** Of its first page. */
  url: string;
  urls: () => string[];
  port: number;
}

/** What the instructor's console tells of a side; enumerators by name. */
export interface SideTruth {
  windlass: {
    brake_position: number;
    speed_lever: number;
    clutch: string;
    stopper_closed: boolean;
    emergency_stop: boolean;
    gypsy_load: number;
    gypsy_load_indicated: number;
  };
  chain: { cable_out: number };
  anchor: { phase: string };
}
/** A side that the ship does not have, or that nobody has told of yet, is not there, whatever the type says. */
export interface Truth {
  port: SideTruth;
  starboard: SideTruth;
  ship: { rudder: number; engine: number; bow_thruster: number; stern_thruster: number };
  status: { state: string; run: number; time: number; time_scale: number };
  environment: { now: Record<string, number>; after: Record<string, number>; ramp_left: number };
}

let rigs = 0;

export class Rig {
  private readonly programs: Program[] = [];
  private watch: Program | undefined;
  private readonly session: string[];

  /** partition: of its exercise; without, one that no other test has. */
  constructor(readonly partition = `browser-${process.pid}-${++rigs}`) {
    this.session = ["--domain", kDomain, "--partition", this.partition];
  }

  private start(name: string, ...args: string[]): Program {
    const program = new Program(name, args);
    this.programs.push(program);
    return program;
  }

  /** A server with an exercise of config/exercises, by name, or of any file; more: further options. */
  server(exercise: string, ...more: string[]): Program {
    return this.start(
      "windlass_server",
      "--exercise",
      exercise.endsWith(".json") ? exercise : join(root, "config/exercises", `${exercise}.json`),
      "--log-level",
      "warn",
      ...this.session,
      ...more,
    );
  }

  /** A shipped script of config/scripts, played by a coach as ./run does. */
  script(name: string, ...more: string[]): Program {
    return this.start(
      "trainee_client",
      "--coach",
      "--name",
      "script",
      "--view",
      "none",
      "--script",
      join(root, "config/scripts", `${name}.json`),
      ...this.session,
      ...more,
    );
  }

  /** A trainee's station with pages; seat: forecastle, bridge, ship. Its url is the first page's. */
  station(seat: string, { name = `${seat}-1`, port = 0 } = {}): Promise<Station> {
    return this.pages(
      "trainee_client",
      "--ui",
      "--seat",
      seat,
      "--name",
      name,
      "--ui-port",
      `${port}`,
      ...this.session,
    );
  }

  /** The instructor's station with pages; more: further options of `ui`. */
  desk({ name = "desk-1", port = 0, more = [] as string[] } = {}): Promise<Station> {
    return this.pages("instructor_console", ...this.session, "--name", name, "ui", "--ui-port", `${port}`, ...more);
  }

  /** Addresses by their names of all pages of a ship's station and of an instructor's. */
  async everyPage(): Promise<Record<string, string>> {
    const urls: Record<string, string> = {};
    for (const station of [await this.station("ship"), await this.desk()]) {
      await eventually("all its pages are told", () => station.urls().length >= 3);
      for (const url of station.urls()) urls[new URL(url).pathname.slice(1)] = url;
    }
    return urls;
  }

  /** A replay of a recording in that partition, paused at its beginning. */
  replay(recording: string, partition: string): Program {
    return this.start(
      "recorder",
      "replay",
      recording,
      "--domain",
      kDomain,
      "--partition",
      partition,
      "--paused",
      "--stay",
    );
  }

  private async pages(name: string, ...args: string[]): Promise<Station> {
    const program = this.start(name, ...args);
    const url = await program.line(/^http:/);
    const urls = (): string[] => program.lines.filter((line) => line.startsWith("http:"));
    return Object.assign(program, { url, urls, port: Number(new URL(url).port) });
  }

  /**
   * The door, by TLS, with its state in that folder; at $WINDLASS_DOOR_ADDRESS of this computer, without at its
   * loopback. setup: the link for the first owner.
   */
  async door(state: string, ...more: string[]): Promise<Program & { url: string; setup: string }> {
    const address = process.env.WINDLASS_DOOR_ADDRESS;
    const options = ["--address", address ?? "127.0.0.1", "--port", "0", "--state", state, "--log-level", "warn"];
    const folders = ["--exercises", join(root, "config/exercises"), "--recordings", join(state, "recordings")];
    const program = this.start("windlass_door", ...this.session, ...options, ...folders, ...more);
    const host = address ?? "localhost";
    const url = await program.line(new RegExp(`^https://${host}:`));
    const setup = /https:\S+/.exec(await program.line(/^set up/))[0].replace("localhost", host);
    return Object.assign(program, { url, setup });
  }

  /** A command of the instructor's console that goes on until stopped, e.g. levers. */
  console(...args: string[]): Program {
    return this.start("instructor_console", ...this.session, "--name", "instructor", ...args);
  }

  /** A command of the instructor's console to its end; throws when it fails. Returns its stdout. */
  async say(...args: string[]): Promise<string> {
    const program = this.console(...args);
    if ((await program.ended) !== 0)
      throw new Error(`instructor_console ${args.join(" ")}: ${program.errors || program.lines.join("\n")}`);
    return program.lines.join("\n");
  }

  /** The whole truth as the instructor hears it over DDS, not older than about a second: port, starboard, ship ... */
  async truth(): Promise<Truth> {
    if (!this.watch || this.watch.code !== undefined) this.watch = this.console("--json", "watch");
    await this.watch.line(/"windlass"/);
    return JSON.parse(this.watch.lines.findLast((line) => line.startsWith("{"))) as Truth;
  }

  /** Waits until the truth is so, and returns it. */
  async truly(what: string, is: (truth: Truth) => unknown): Promise<Truth> {
    let truth = await this.truth();
    await eventually(what, async () => is((truth = await this.truth())));
    return truth;
  }

  /** Ends everything that was started, the last first. */
  async end(): Promise<void> {
    for (const program of this.programs.reverse()) await program.stop();
  }
}
