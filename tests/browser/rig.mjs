// A real server, stations and consoles for a test in a browser: each in a process of its own, in the domain that
// own_domain holds, ended with the test whatever becomes of it.
//
// by hand: WINDLASS_DOMAIN=7 node --test tests/browser/forecastle.test.mjs

import { spawn } from "node:child_process";
import { join } from "node:path";
import { createInterface } from "node:readline";

import { root } from "./browser.mjs";

const bin = process.env.WINDLASS_BIN ?? join(root, "build/release/bin");
const kDomain = process.env.WINDLASS_DOMAIN;
const kPatience = 60000; // ms for what happens within one second on a machine at rest

export const sleep = (ms) => new Promise((done) => setTimeout(done, ms));

/** Waits until look() gives something true, and returns it; what it last gave or threw is told when it never does. */
export async function eventually(what, look, patience = kPatience) {
  const end = Date.now() + patience;
  for (let last; ; await sleep(40)) {
    try {
      last = await look();
      if (last) return last;
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
class Program {
  constructor(name, args) {
    this.lines = [];
    this.errors = "";
    this.child = spawn(join(bin, name), args, { stdio: ["ignore", "pipe", "pipe"] });
    this.child.on("error", (why) => (this.errors += `${why}`));
    this.child.stderr.on("data", (text) => (this.errors += text));
    this.name = name;
    this.ended = new Promise((done) => this.child.on("close", (code) => done((this.code = code ?? -1))));
    createInterface({ input: this.child.stdout }).on("line", (line) => this.lines.push(line));
  }

  /** Its first line on stdout that fits. */
  line(pattern) {
    return eventually(`${this.name} says ${pattern}`, () => {
      const found = this.lines.find((line) => pattern.test(line));
      if (!found && this.code !== undefined) throw new Error(`it ended with code ${this.code}: ${this.errors}`);
      return found;
    });
  }

  async stop(signal = "SIGTERM") {
    if (this.code === undefined) this.child.kill(signal);
    const late = setTimeout(() => this.child.kill("SIGKILL"), 5000);
    await this.ended;
    clearTimeout(late);
  }
}

let rigs = 0;

export class Rig {
  #programs = [];
  #watch;

  /** partition: of its exercise; without, one that no other test has. */
  constructor(partition = `browser-${process.pid}-${++rigs}`) {
    if (!kDomain) throw new Error("WINDLASS_DOMAIN is not set: run by own_domain, or set it to a domain of your own");
    this.partition = partition;
    this.session = ["--domain", kDomain, "--partition", this.partition];
  }

  #start(name, ...args) {
    const program = new Program(name, args);
    this.#programs.push(program);
    return program;
  }

  /** A server with an exercise of config/exercises; more: further options. */
  server(exercise, ...more) {
    return this.#start(
      "windlass_server",
      "--exercise",
      join(root, "config/exercises", `${exercise}.json`),
      "--log-level",
      "warn",
      ...this.session,
      ...more,
    );
  }

  /** A shipped script of config/scripts, played by a coach as ./run does. */
  script(name, ...more) {
    return this.#start(
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
  async station(seat, { name = `${seat}-1`, port = 0 } = {}) {
    return this.#pages(
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
  async desk({ name = "desk-1", port = 0, more = [] } = {}) {
    return this.#pages("instructor_console", ...this.session, "--name", name, "ui", "--ui-port", `${port}`, ...more);
  }

  /** A replay of a recording in that partition, paused at its beginning. */
  replay(recording, partition) {
    return this.#start(
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

  async #pages(...command) {
    const program = this.#start(...command);
    program.url = await program.line(/^http:/);
    program.urls = () => program.lines.filter((line) => line.startsWith("http:"));
    program.port = Number(new URL(program.url).port);
    return program;
  }

  /** A command of the instructor's console that goes on until stopped, e.g. levers. */
  console(...args) {
    return this.#start("instructor_console", ...this.session, "--name", "instructor", ...args);
  }

  /** A command of the instructor's console to its end; throws when it fails. Returns its stdout. */
  async say(...args) {
    const program = this.console(...args);
    if ((await program.ended) !== 0)
      throw new Error(`instructor_console ${args.join(" ")}: ${program.errors || program.lines.join("\n")}`);
    return program.lines.join("\n");
  }

  /** The whole truth as the instructor hears it over DDS, not older than about a second: port, starboard, ship ... */
  async truth() {
    if (!this.#watch || this.#watch.code !== undefined) this.#watch = this.console("--json", "watch");
    await this.#watch.line(/"windlass"/);
    return JSON.parse(this.#watch.lines.filter((line) => line.startsWith("{")).at(-1));
  }

  /** Waits until the truth is so, and returns it. */
  async truly(what, is) {
    return eventually(what, async () => {
      const truth = await this.truth();
      return is(truth) && truth;
    });
  }

  /** Ends everything that was started, the last first. */
  async end() {
    for (const program of this.#programs.reverse()) await program.stop();
  }
}
