// A class at the door, from the log-in to the history: Chromium contexts join by code, and as many hands, twelve at most,
// play L01 through the page's own controls, each in its own way. Writes what came of it as Markdown on stdout, and
// pictures of each page, in three sizes, into FOLDER; not a test. What twelve computers do is done by the cores of one
// here: seats draw no picture (?picture=off), ten times a second, and make no sound. Where that is still too much for
// real time, the exercises go at TIME_SCALE of it, and the hands with them.
//
// usage: build/release/bin/own_domain node station/web/tools/ts.mjs bench/class_at_the_door.ts FOLDER [HANDS [TIME_SCALE]]
//        (after a build; about 18 min at 1). bench/class_from_outside.sh has the browser in a network of its own.

import assert from "node:assert/strict";
import { mkdirSync } from "node:fs";
import { mkdtemp, rm } from "node:fs/promises";
import { cpus, loadavg, tmpdir } from "node:os";
import { join } from "node:path";

import type { BrowserContextOptions, Locator, Page } from "playwright-core";

import { type TestPage, closeBrowser, closePage, openPage } from "../tests/browser/browser";
import { firstOwner } from "../tests/browser/pages";
import { Rig, eventually, sleep } from "../tests/browser/rig";

const pictures = process.argv[2] ?? "";
assert.ok(pictures, "usage: class_at_the_door.ts FOLDER [HANDS]");
mkdirSync(pictures, { recursive: true });
const timeScale = Number(process.argv[4] ?? 1);
/** ms of the clock for so many of the exercise. */
const ms = (ofExercise: number): number => ofExercise / timeScale;
const kLongest = 14.5 * 60_000; // ms of exercise from the start to when the class is ended
const kSizes = [
  [1280, 800],
  [1024, 768],
  [390, 844],
];
const tls: BrowserContextOptions = { ignoreHTTPSErrors: true };

/** What a hand does its own way. */
interface Style {
  name: string;
  /** ms from one look to the next. */
  looks?: number;
  /** Wheel, 0..1, in the fall, and in paying out: slower and faster. */
  fall?: number;
  pays?: number;
  reports?: boolean;
  idle?: boolean;
  /** Leaves the wheel open until so many shackles. */
  opensUntil?: number;
  /** At so many metres of cable: loads the page anew, loses it for a while, has it on a slow computer. */
  reloads?: number;
  away?: number;
  slow?: boolean;
  late?: number; // ms
}
const kStyles: Style[] = [
  { name: "careful" },
  { name: "hasty", fall: 0.42, pays: 0.36 },
  { name: "leaves it open to four", opensUntil: 4 },
  { name: "tablet flat for 30 s at 70 m", away: 70 },
  { name: "tells nobody", reports: false },
  { name: "careful, looks once a second", looks: 1000 },
  { name: "anxious", fall: 0.6, pays: 0.56 },
  { name: "idle", idle: true },
  { name: "reloads at 70 m", reloads: 70 },
  { name: "careful, looks twice a second", looks: 500 },
  { name: "slow computer (a sixth)", slow: true },
  { name: "joins a minute late", late: 60_000 },
].slice(0, Number(process.argv[3] ?? 12));

interface Seen {
  /** m, m/s, N: by the gauges. */
  out: number;
  speed: number;
  load: number;
  /** 0 open, 1 hard on. */
  wheel: number;
  orders: string[];
}

let clicks = 0;
const press = async (what: Locator): Promise<void> => {
  ++clicks;
  await what.click();
};
const on = (page: Page, name: string | RegExp): Locator => page.getByRole("button", { name, exact: true });

/** The page as a whole in each size, as NAME_WIDTH.png; it is left as it was. */
async function picture(page: Page, name: string): Promise<void> {
  const before = page.viewportSize();
  for (const [width, height] of kSizes) {
    await page.setViewportSize({ width, height });
    await sleep(500);
    await page.screenshot({ path: join(pictures, `${name}_${width}.png`), fullPage: true });
  }
  await page.setViewportSize(before);
}

/** Sixty pictures a second and the deck's sound would be most of what a page costs. */
function atTenHzWithoutSound(): void {
  window.requestAnimationFrame = (draw) => Number(setTimeout(() => draw(performance.now()), 100));
  window.AudioContext = class extends AudioContext {
    constructor() {
      super();
      void super.suspend();
    }
    override resume = () => Promise.resolve();
  };
}

/** One trainee. */
class Hand {
  page: TestPage;
  readonly said: string[] = [];
  problems: string[] = [];
  private readonly done = new Set<string>();
  private covered = 0; // looks
  private readonly began = Date.now();

  constructor(
    readonly style: Style,
    readonly trainee: string,
    private readonly door: string,
    private readonly code: string,
  ) {}

  async join(): Promise<void> {
    await this.open(`${this.door}?code=${this.code}`);
    await this.page.locator("input[name=name]").fill(this.trainee);
    if (this.style === kStyles[0]) await picture(this.page, "join");
    await on(this.page, "Take a seat").click();
    await this.page.waitForURL(/\/forecastle/);
    await this.page.goto(`${new URL(this.page.url()).origin}/forecastle?picture=off`);
    await this.page.locator(".owner").waitFor();
  }

  private async open(url: string, options: BrowserContextOptions = {}): Promise<void> {
    this.page = await openPage(url, {
      ...tls,
      ...options,
      init: atTenHzWithoutSound,
      viewport: { width: 1024, height: 768 },
    });
    this.page.setDefaultTimeout(ms(20_000)); // a hand that finds no button in that time has lost the thread
    if (this.style.slow) {
      const session = await this.page.context().newCDPSession(this.page);
      await session.send("Emulation.setCPUThrottlingRate", { rate: 6 });
    }
  }

  private look(): Promise<Seen> {
    return this.page.evaluate(() => {
      const view = window.windlass.link.latest("ForecastleView", 0);
      const wheel = document.querySelector("[aria-label='brake hand-wheel']")?.getAttribute("aria-valuenow");
      return {
        out: view?.cable_out_indicated ?? 0,
        speed: view?.cable_speed_indicated ?? 0,
        load: view?.gypsy_load_indicated ?? 0,
        wheel: Number(wheel) / 100,
        orders: [...document.querySelectorAll(".orders li .spoken")].map((each) => each.textContent ?? ""),
      };
    });
  }

  /** Turns the wheel there by its keys, held. */
  private async turn(to: number): Promise<void> {
    if (to >= 1) return this.page.keyboard.press("b");
    if (to <= 0) return this.page.keyboard.press("0");
    for (let tries = 0; tries < 80; ++tries) {
      const { wheel } = await this.look();
      const degrees = (to - wheel) * 1800;
      if (Math.abs(degrees) < 8) return;
      const key = degrees > 0 ? "ArrowUp" : "ArrowDown";
      if (Math.abs(degrees) > 120) {
        await this.page.keyboard.down(key);
        await sleep(Math.min(600, Math.abs(degrees)));
        await this.page.keyboard.up(key);
      } else {
        await this.page.keyboard.press(key);
      }
      await sleep(60);
    }
  }

  private async report(name: string, figure?: number): Promise<void> {
    if (this.style.reports === false) return;
    const pad = this.page.locator(".reports");
    const button = pad.getByRole("button", { name, exact: true });
    if (!(await button.isVisible()))
      for (const leaf of await pad.locator(".leaves button").all()) {
        await leaf.click();
        if (await button.isVisible()) break;
      }
    await button.click();
    if (figure !== undefined)
      await this.page
        .locator(".pad")
        .last()
        .getByRole("button", { name: `${figure}`, exact: true })
        .click();
    this.said.push(
      `${Math.round(((Date.now() - this.began) * timeScale) / 1000)} s: ${name}${figure === undefined ? "" : ` ${figure}`}`,
    );
  }

  /** The newest order that waits for it, with its figure. */
  private async repeatBack(): Promise<void> {
    const [words] = await this.page
      .locator(".orders li", { has: this.page.getByRole("button") })
      .locator(".spoken")
      .allTextContents();
    if (words === undefined) return;
    await this.page.keyboard.press("o");
    const figure = /(\d+) shackles?/.exec(words)?.[1];
    if (figure) await this.page.locator(".pad").last().getByRole("button", { name: figure, exact: true }).click();
  }

  /** Once. */
  private first(what: string): boolean {
    if (this.done.has(what)) return false;
    this.done.add(what);
    return true;
  }

  /** Until it is told to stop. */
  async play(stop: () => boolean): Promise<void> {
    const { style } = this;
    const [fall, pays] = [style.fall ?? 0.53, style.pays ?? 0.487];
    let wanted = 0, // shackles
      runs = false,
      quietSince = 0,
      tightest = 0; // N
    while (!stop() && !this.page.isClosed()) {
      await sleep(ms(style.looks ?? 300));
      if (style.idle) continue;
      const now: Seen | undefined = await this.look().catch((): undefined => undefined);
      if (!now) continue;
      const briefing = this.page.locator("dialog[aria-label='briefing'][open]");
      if (now.orders.length > 0 && (await briefing.count()) > 0 && ++this.covered === 10) {
        this.problems.push("its briefing lay over the levers when the exercise ran");
        await this.page.screenshot({ path: join(pictures, `covered_${this.trainee}.png`) });
        await briefing.getByRole("button").last().click();
      }
      await this.repeatBack();
      const has = (words: RegExp): boolean => now.orders.some((text) => words.test(text));
      if (has(/stand by/i) && this.first("stand by")) await this.report("Standing by");
      if (has(/let go/i) && this.first("let go")) {
        await this.turn(style.opensUntil ? 0 : fall);
        await this.report("Let go");
      }
      if (!this.done.has("let go")) continue;
      if (style.opensUntil) {
        if (now.out > style.opensUntil * 27.5 && this.first("check")) await this.turn(1);
      } else if (now.out > 28 && this.first("bottom")) {
        await this.turn(0.86);
        await this.report("On the bottom");
      }
      const ordered = Math.max(
        0,
        ...now.orders.flatMap((text) => {
          const found = /(?:pay out|hold on).* (\d+) shackles?/i.exec(text);
          return found ? [Number(found[1])] : [];
        }),
      );
      if (ordered > wanted) {
        wanted = ordered;
        runs = true;
        await this.turn(pays);
      }
      if (runs && now.out > (wanted - 0.1) * 27.5) {
        runs = false;
        await this.turn(wanted >= 6 ? 1 : 0.86);
        quietSince = Date.now();
      }
      if (!runs && wanted > 0 && now.speed < 0.05 && Date.now() - quietSince > ms(3000) && this.first(`at ${wanted}`))
        await this.report("n in pipe", Math.round(now.out / 27.5));
      if (has(/leading/i) && this.first("leading")) {
        await this.report("Lead");
        await this.page
          .getByRole("button", { name: "Up and down", exact: true })
          .last()
          .click()
          .catch(() => {});
      }
      if (this.done.has("at 6")) {
        // The cable has come tight, and eased as she came up to her anchor.
        tightest = Math.max(tightest, now.load);
        if (tightest > 150e3 && now.load < 0.35 * tightest && this.first("brought up")) await this.report("Brought up");
      }
      if (has(/secure/i) && this.first("secure")) {
        await this.page.keyboard.down("t");
        await sleep(ms(1500));
        await this.page.keyboard.up("t");
        await sleep(ms(3000));
        await this.report("Secured");
      }
      if (style.reloads && now.out > style.reloads && this.first("reload")) await this.page.reload();
      if (style.away && now.out > style.away && this.first("away")) {
        const [url, state] = [this.page.url(), await this.page.context().storageState()];
        this.problems.push(...this.page.problems);
        await closePage(this.page);
        await sleep(ms(30_000));
        await this.open(url, { storageState: state });
      }
    }
  }
}

const rig = new Rig("nine-oclock");
const folder = await mkdtemp(join(tmpdir(), "windlass-class-"));
try {
  const began = Date.now();
  const minutes = (): string => ((Date.now() - began) / 60_000).toFixed(1);
  const note = (text: string): void => console.error(`${minutes()} min: ${text}`);
  rig.server("L01_let_go_25m", "--wait", "--time-scale", `${timeScale}`); // and makes the class's exercises
  const door = await rig.door(join(folder, "door"));
  await closePage(await firstOwner(door.setup));

  // Nine o'clock: from the log-in.
  const owner = await openPage(`${door.url}login`, tls);
  await press(owner.locator("input[name=name]"));
  await owner.keyboard.type("anna");
  await press(owner.locator("input[name=password]"));
  await owner.keyboard.type("a long password");
  await press(on(owner, "Log in"));
  await owner.waitForURL(/\/class$/);
  await owner.locator("select option").first().waitFor({ state: "attached" });
  clicks += 2; // the lesson's list, and its row
  await owner.locator("select").first().selectOption("L01_let_go_25m");
  const howMany = owner.locator("input[type=number]");
  if ((await howMany.inputValue()) !== `${kStyles.length}`) {
    ++clicks;
    await howMany.fill(`${kStyles.length}`);
  }
  await press(on(owner, "Open the class"));
  const code = (await owner.locator(".code-panel .letters").textContent()).replace(/ /g, "");
  await press(on(owner, "Show large"));
  await press(owner.locator(".projector"));
  const hands = kStyles.map((style, i) => new Hand(style, `${"abcdefghijklmnop"[i]}-${i + 1}`, door.url, code));
  for (const hand of hands.filter(({ style }) => !style.late)) await hand.join();
  note("joined");
  await eventually("all ready", async () => {
    const states = await owner.locator(".exercises .state").allTextContents();
    return states.length === kStyles.length && states.every((state) => state.startsWith("ready"));
  });
  const toReady = clicks;
  await picture(owner, "ready");
  await press(on(owner, "Start all"));
  note(`started after ${toReady} clicks`);
  const started = Date.now();
  let ended = false;
  const playing = hands.map(async (hand) => {
    try {
      if (hand.style.late) {
        await sleep(ms(hand.style.late));
        await hand.join();
        await on(owner, "Start all").click(); // an exercise in which nobody sat has waited
      }
      await hand.play(() => ended);
    } catch (why) {
      const [what, ...more] = (why instanceof Error ? why.message : "?").split("\n");
      hand.problems.push(`fell over: ${what} ${more.find((line) => line.includes("waiting for"))?.trim() ?? ""}`);
      note(`${hand.trainee}: ${hand.problems.at(-1)}`);
    }
  });
  for (const at of [2, 6, 11]) {
    await sleep(Math.max(0, started + ms(at * 60_000) - Date.now()));
    await picture(owner, `at_${at}_min`);
    note(`load ${loadavg()[0].toFixed(1)}; ${hands.map(({ said }) => said.length).join(" ")} reports`);
  }
  await sleep(Math.max(0, started + ms(kLongest) - Date.now()));
  ended = true;
  await Promise.all(playing);
  await picture(hands[0].page, "forecastle");
  await on(owner, "End the class").focus();
  await owner.keyboard.down("Enter");
  await owner.locator(".class-marks tbody tr").first().waitFor();
  await owner.keyboard.up("Enter");
  await eventually(
    "marked, in the history",
    async () =>
      (await owner.locator(".class-marks .next").allTextContents()).filter((text) => text.trim()).length >=
      kStyles.length,
  );
  await picture(owner, "over");
  const asked = Date.now();
  const [aside] = await Promise.all([
    owner.waitForEvent("popup"),
    owner.getByRole("link", { name: "The class side by side" }).click(),
  ]);
  await aside.getByRole("heading", { name: "Who did what when" }).waitFor();
  const sideBySide = (Date.now() - asked) / 1000;
  await picture(aside, "side_by_side");
  const [debriefing] = await Promise.all([
    owner.waitForEvent("popup"),
    owner.getByRole("link", { name: "Debriefing" }).first().click(),
  ]);
  await debriefing.getByRole("heading", { name: "Key moments", exact: true }).waitFor();
  await picture(debriefing, "debriefing");
  const rows = await owner.locator(".class-marks tbody tr").all();
  console.log(`Clicks from the log-in to all ready: ${toReady}. Class side by side: ${sideBySide.toFixed(1)} s.\n`);
  console.log("| hand | marks | reports | the page's problems |\n|---|---|---|---|");
  for (const hand of hands) {
    const row =
      rows[
        (await Promise.all(rows.map((each) => each.textContent()))).findIndex((text) => text.startsWith(hand.trainee))
      ];
    const problems = [...hand.problems, ...hand.page.problems];
    console.log(
      `| ${hand.style.name} | ${await row.locator(".marks").textContent()} | ${hand.said.join("; ")} | ${problems.join("; ")} |`,
    );
  }
  const kept = await rig.say("history", "--file", join(folder, "door/recordings/history.sqlite"), "list");
  console.log(`\nThe history:\n\n${kept}`);
  console.log(
    `\nAt ${timeScale} of real time. ${cpus().length} cores (${cpus()[0].model}), load ${loadavg()[0].toFixed(1)} at the end`,
  );
  if (owner.problems.length) console.log(`The instructor's page: ${owner.problems.join("; ")}`);
} catch (why) {
  console.error(why);
  process.exitCode = 1;
} finally {
  await closeBrowser();
  await rig.end();
  if (process.env.KEEP) console.log(`kept: ${folder}`);
  else await rm(folder, { recursive: true, force: true });
}
