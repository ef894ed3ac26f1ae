// The instructor's class: its code, who sits where, start and end; and a form for a new one.

import { h, setText } from "../kit/dom";
import { holdButton } from "../kit/hold_button";
import { asksInVain } from "../kit/asks_in_vain";
import { runStateWords } from "../kit/run_state";
import { clock } from "../kit/units";
import { CctvPictures } from "../classroom/cctv";
import { Connection } from "../wire/connection";
import { RunState } from "../wire/generated";
import {
  type ClassExercise,
  type Classes,
  type Me,
  type Lessons,
  type Part,
  type Seat,
  type TrainingClass,
  act,
  ask,
  partWords,
  placeWords,
} from "./ask";
import { type ClassMarks, type Open, classMarks, lessonWords, marksOf } from "./class_marks";
import { doorSaid } from "./door_sentences";
import { frame } from "./frame";
import { kiosks } from "./kiosks";
import { type NewClass, newClass } from "./new_class";
import { qr } from "./qr";
import { doing, isOver, standing } from "./seat_work";
import { toAll } from "./to_all";
import { t, translated } from "../kit/language";

const kNoServer = t(
  "No server is heard. What it has kept is back with it where it stood; what it has not is made then.",
);
const kLook = 1000; // ms
const kConfirmed = 8000; // ms for which it is said that something was given
const kKiosks = "/"; // among the tabs; no class is called so
const kHttps = 443; // which no address names
const kGrouped = /(...)(?=.)/g;

/** The address to come to: by this machine's name in the network, where the instructor sits at the machine itself. */
function address({ names, port }: Classes): string {
  const own = location.hostname;
  const reachable =
    own !== "localhost" && own !== "127.0.0.1"
      ? own
      : (names.find((n) => /^\d/.test(n) && !n.startsWith("127.")) ?? own);
  return `https://${reachable}${port === kHttps ? "" : `:${port}`}/`;
}

class ClassPage {
  private readonly notice = h("p", { class: "notice", role: "status" });
  private readonly tabs = h("nav", { class: "tabs", "aria-label": t("classes") });
  private readonly body = h("div", { class: "class-body" });
  private readonly newClass: NewClass;
  /** The owner's. */
  private readonly devices: HTMLElement | undefined;
  private readonly code = h("div", {});
  private readonly said = h("span", { class: "said" });
  /** Of the class that is looked at, by exercise. */
  private readonly tiles = new Map<string, { state: HTMLElement; trouble: HTMLElement; seats: HTMLElement }>();
  /** Of lessons, by file. */
  private readonly titles = new Map<string, string>();
  private titled = false; // once they were asked for
  private readonly cctv = new CctvPictures(new Connection(""));
  /** Of each part, what it was made of. */
  private readonly made = new Map<HTMLElement, string>();
  /** Of the class that is over and looked at. */
  private marks: ClassMarks | undefined;
  private heard = false;
  /** Which class is looked at; none: a new one is made. */
  private chosen: string | undefined;
  private mover: string | undefined;
  private known: Classes = { classes: [], servers: 0, names: [], port: 0 };

  constructor(
    root: HTMLElement,
    private readonly leads: boolean,
    private readonly judges: boolean,
    owns: boolean,
  ) {
    if (owns) this.devices = kiosks(() => address(this.known));
    const lessons = ask<Lessons>("lessons");
    void lessons
      .then(({ files }) => files.forEach(({ name, title }) => this.titles.set(name, title || name)))
      .catch(() => {}) // then their files' names are shown
      .finally(() => {
        this.titled = true;
        if (this.heard) this.draw();
      });
    this.newClass = newClass(
      lessons,
      () => this.known.classes.map(({ id }) => id),
      (classes) => {
        this.chosen = classes.classes.at(-1)?.id;
        this.show(classes);
      },
    );
    root.classList.add("class");
    root.append(this.tabs, this.notice, this.body);
    void this.look();
    setInterval(() => void this.look(), kLook);
  }

  private async look(): Promise<void> {
    try {
      this.show(await ask<Classes>("classes"));
      if (this.notice.dataset.lost) this.say("");
    } catch (why) {
      if ((why as { status?: number }).status === 401) location.assign("/login");
      this.say(t("The door is not heard: what is shown is old"));
      this.notice.dataset.lost = "1";
    }
  }

  private say(text: string): void {
    setText(this.notice, text);
    delete this.notice.dataset.lost;
  }

  /** For a while: no tile shows that it was done. */
  private confirm(text: string): void {
    this.say(text);
    setTimeout(() => this.notice.textContent === text && this.say(""), kConfirmed);
  }

  /** Empty as long as it is not known. */
  private titleOf({ lesson }: TrainingClass): string {
    return this.titles.get(lesson) ?? (this.titled ? lesson : "");
  }

  /** Resolves whether the door did it. */
  private async do(what: string, more: Record<string, unknown> = {}): Promise<boolean> {
    this.say("");
    try {
      this.show(await act<Classes>("class", { do: what, class: this.chosen, ...more }));
      return true;
    } catch (why) {
      this.say((why as Error).message);
      return false;
    }
  }

  private show(known: Classes): void {
    this.known = known;
    const gone = this.chosen !== kKiosks && !known.classes.some(({ id }) => id === this.chosen);
    if (gone) this.chosen = undefined;
    // Who opens none has nothing to look at but a class: one that goes on, or else the last that is over.
    if (this.chosen === undefined && !(this.heard && this.leads))
      this.chosen = (known.classes.find(({ over }) => !over) ?? (this.leads ? undefined : known.classes.at(-1)))?.id;
    this.heard = true;
    this.draw();
  }

  /** A part is made anew only where it differs: a button that is held or pressed stays the same. */
  private fill(part: HTMLElement, of: unknown, make: () => Node[]): void {
    const now = JSON.stringify(of) ?? "";
    if (this.made.get(part) === now) return;
    part.replaceChildren(...make());
    this.made.set(part, now);
  }

  private draw(): void {
    const tabs = this.known.classes.map(({ id, over }) => [id, over]);
    this.fill(this.tabs, [tabs, this.chosen], () => this.tabsNow());
    const it = this.known.classes.find(({ id }) => id === this.chosen);
    const open: Open | undefined = this.leads && it ? (...what) => this.goOn(it.id, ...what) : undefined;
    const over = it?.over && [{ ...it, words: 0 }, this.titleOf(it)]; // a word changes what stands in it, by itself
    this.fill(this.body, over || [it?.id ?? this.chosen, it?.exercises.length], () => {
      if (this.chosen === kKiosks && this.devices) return [this.devices];
      if (it?.over) {
        this.marks = classMarks(it, this.titleOf(it), this.judges, open);
        return [this.marks.element];
      }
      if (it) {
        this.made.clear();
        return [this.code, this.bar(it), this.exercises(it)];
      }
      return [this.leads ? this.newClass.shown() : h("p", { class: "quiet" }, t("There is no class."))];
    });
    if (it?.over) this.marks?.heard(it.words);
    if (it && !it.over) {
      this.fill(this.code, [it.code, this.known.names, this.known.port], () => [this.door(it)]);
      this.fill(this.said, [this.titleOf(it), standing(it), waiting(it), this.mover], () => this.saidNow(it));
      for (const each of it.exercises) this.showExercise(each);
    }
    if (this.known.servers === 0) this.say(kNoServer);
    else if (this.notice.textContent === kNoServer) this.say("");
  }

  /** A new class of those who are to do the same next. */
  private goOn(...what: Parameters<NewClass["fill"]>): void {
    this.newClass.fill(...what);
    this.chosen = undefined;
    this.draw();
  }

  private tabsNow(): Node[] {
    const tab = (text: string, id: string | undefined): HTMLElement =>
      h(
        "button",
        {
          class: "plain",
          "aria-pressed": String(this.chosen === id),
          onclick: () => {
            if (id === undefined) this.newClass.anybody();
            this.chosen = id;
            this.mover = undefined;
            this.draw();
          },
        },
        text,
      );
    return [
      ...this.known.classes.map(({ id, over }) => tab(over ? t("{id}, over", { id }) : id, id)),
      ...(this.leads ? [tab(t("New class"), undefined)] : []),
      ...(this.devices ? [tab(t("Devices"), kKiosks)] : []),
    ];
  }

  /** What the projector shows. */
  private door(it: TrainingClass): HTMLElement {
    const to = address(this.known);
    if (!it.code)
      return h("p", { class: "panel" }, t("The code of this class is good no longer; who has a seat keeps it."));
    const big = h("dialog", { class: "projector", onclick: () => big.close() });
    const content = (): Node[] => [
      qr(`${to}?code=${it.code}`),
      h("div", {}, h("p", { class: "address" }, to), h("p", { class: "letters" }, it.code.replace(kGrouped, "$1 "))),
    ];
    const show = h("button", { class: "plain" }, t("Show large"));
    show.onclick = () => {
      big.replaceChildren(...content());
      document.body.append(big);
      big.showModal();
      big.onclose = () => big.remove();
    };
    return h("section", { class: "panel code-panel", "aria-label": t("code of the class") }, ...content(), show);
  }

  private bar(it: TrainingClass): HTMLElement {
    const bar = h("div", { class: "bar", role: "toolbar", "aria-label": t("class {id}", { id: it.id }) });
    if (this.leads)
      bar.append(
        h("button", { class: "primary", onclick: () => void this.do("start") }, t("Start all")),
        h("button", { onclick: () => void this.do("pause") }, t("Pause all")),
        ...toAll(
          async (topic, sample, what) => {
            const taken = await this.do("give", { topic, sample });
            if (taken) this.confirm(inAll(what, it.exercises.length));
            return taken;
          },
          (text) => this.say(text),
        ),
      );
    bar.append(this.said, this.cctv.button);
    if (this.leads) bar.append(holdButton(t("End the class"), 1, () => void this.do("end"), { class: "end" }));
    return bar;
  }

  private lessonOf(it: TrainingClass): (Node | string)[] {
    const title = this.titleOf(it);
    return title ? [...lessonWords(title, it.practice), "; "] : [];
  }

  /** In the bar: how many there are, and what becomes of who is to be moved. */
  private saidNow(it: TrainingClass): Node[] {
    const name = this.mover;
    return [
      h("span", { class: "quiet" }, ...this.lessonOf(it), standing(it)),
      ...waiting(it).map((line) => h("strong", { class: "waits" }, line)),
      ...(name === undefined
        ? []
        : [
            h("strong", {}, t("{name}: choose another seat, or", { name })),
            h(
              "button",
              { onclick: () => this.choose(undefined, () => this.do("remove", { name })) },
              t("Free the seat"),
            ),
          ]),
    ];
  }

  private choose(name: string | undefined, then?: () => Promise<unknown>): void {
    this.mover = name;
    this.draw();
    void then?.();
  }

  private exercises(it: TrainingClass): HTMLElement {
    for (const exercise of this.tiles.keys()) this.cctv.forget(exercise);
    this.tiles.clear();
    for (const { exercise } of it.exercises)
      this.tiles.set(exercise, {
        state: h("span", { class: "state" }),
        trouble: h("p", { class: "trouble", role: "status" }),
        seats: h("div", { class: "seats" }),
      });
    return h(
      "ol",
      { class: "exercises" },
      ...[...this.tiles].map(([exercise, { state, trouble, seats }]) =>
        h(
          "li",
          { class: "panel", "data-exercise": exercise },
          h(
            "header",
            {},
            h("h3", {}, exercise),
            state,
            h(
              "a",
              { href: `/instructor?exercise=${exercise}`, "aria-label": t("Desk of {exercise}", { exercise }) },
              t("Desk"),
            ),
          ),
          trouble,
          this.cctv.of(exercise),
          seats,
        ),
      ),
    );
  }

  private showExercise(each: ClassExercise): void {
    const tile = this.tiles.get(each.exercise);
    if (!tile) return;
    tile.state.toggleAttribute("data-lost", each.state !== null && !each.heard);
    const begun = each.points !== null && each.state !== RunState.RUN_READY;
    setText(tile.state, begun ? `${stateOf(each)}, ${marksOf(each)}` : stateOf(each));
    setText(tile.trouble, doorSaid(each.trouble) || asks(each));
    const seats = each.seats.map((seat) => ({ ...seat, doing: doing(each, seat) }));
    const gone = each.parts.filter(({ until }) => until !== null);
    this.fill(tile.seats, [seats.map(({ place, name, doing: it }) => [place, name, it]), gone, this.mover], () => [
      ...seats.map((seat) => this.seat(each, seat)),
      ...gone.map((part) => h("p", { class: "quiet relieved" }, relieved(part))),
    ]);
  }

  private seat({ exercise }: ClassExercise, { place, name, here, doing: it }: Seat & { doing: string }): HTMLElement {
    const target = this.mover !== undefined && this.mover !== name;
    return h(
      "button",
      {
        class: "seat-button",
        disabled: !this.leads || (name === null && !target),
        "data-here": String(here),
        "aria-pressed": String(name !== null && this.mover === name),
        onclick: () => {
          const mover = this.mover;
          if (target) this.choose(undefined, () => this.do("move", { name: mover, exercise, place }));
          else this.choose(mover === name ? undefined : (name ?? undefined));
        },
      },
      h("span", { class: "quiet" }, placeWords[place]),
      h("span", { class: "who" }, name ?? t("free")),
      name !== null && h("span", { class: "here" }, it),
    );
  }
}

const isManned = ({ seats }: ClassExercise): boolean => seats.some(({ name }) => name !== null);

/** Once some have been started: which have not, a line each for those without and with somebody. */
function waiting({ exercises }: TrainingClass): string[] {
  const ready = exercises.filter(({ state }) => state === RunState.RUN_READY);
  const held = exercises.filter(({ state }) => state === RunState.RUN_PAUSED);
  if (ready.length + held.length === exercises.filter(({ state }) => state !== null).length) return [];
  const empty = [...ready, ...held].filter((each) => !isManned(each)).length;
  const manned = ready.filter(isManned).length;
  return [
    empty === 1 && t("1 exercise waits: nobody sits in it"),
    empty > 1 && t("{count} exercises wait: nobody sits in them", { count: empty }),
    manned === 1 && t("1 exercise waits for Start all"),
    manned > 1 && t("{count} exercises wait for Start all", { count: manned }),
  ].filter((line) => line !== false);
}

/** "anna, bridge, to 4:00". */
const relieved = (part: Part): string => [part.name, placeWords[part.place], partWords(part)].join(", ");

/** "Load cell dead in 12 exercises". */
const inAll = (what: string, count: number): string =>
  count === 1 ? t("{what} in 1 exercise", { what }) : t("{what} in {count} exercises", { what, count });

/** That the lesson's bridge asks in vain; empty: it has not had to. */
const asks = (each: ClassExercise): string =>
  each.asking && each.heard && !isOver(each) ? asksInVain(each.asking, each.time) : "";

function stateOf(each: ClassExercise): string {
  const { state, time, heard, outcome } = each;
  if (state === null) return t("is being made");
  if (outcome && isOver(each) && state !== RunState.RUN_STOPPED_BY_FAULT) return t("lesson over");
  if (each.asked && heard && state === RunState.RUN_PAUSED)
    return t("holds for a question to a seat {time}", { time: clock(time) });
  const last = `${runStateWords(state)} ${clock(time)}`;
  return heard ? last : t("not heard, was {last}", { last });
}

export async function makeClass(): Promise<void> {
  const me = await ask<Me>("me");
  const leads = me.rank === "owner" || me.rank === "instructor";
  const link = (href: string, text: string): Node => h("a", { href }, text);
  const root = frame(
    t("Class"),
    link("/classroom", t("Classroom")),
    ...(leads ? [link("/lessons", t("Lessons"))] : []),
    ...(me.rank === "owner" ? [link("/people", t("People"))] : []),
    link("/trust", t("Certificate")),
    h("span", { class: "quiet" }, `${me.name ?? ""}, ${translated(me.rank ?? "")}`),
    h(
      "button",
      { class: "plain", onclick: () => void act("logout", {}).then(() => location.assign("/")) },
      t("Log out"),
    ),
  );
  new ClassPage(root, leads, leads || me.rank === "assessor", me.rank === "owner");
}
