// The instructor's class: its code, who sits where, start and end; and a form for a new one.

import { h, setText } from "../kit/dom";
import { holdButton } from "../kit/hold_button";
import { runStateWords } from "../kit/run_state";
import { clock } from "../kit/units";
import type { RunState } from "../wire/generated";
import { type ClassExercise, type Classes, type Me, type Seat, type TrainingClass, act, ask } from "./ask";
import { frame } from "./frame";
import { newClass } from "./new_class";
import { qr } from "./qr";

const kLook = 1000; // ms
const kGrouped = /(...)(?=.)/g;

/** The address to come to: by this machine's name in the network, where the instructor sits at the machine itself. */
function address(names: string[]): string {
  const own = location.hostname;
  const reachable =
    own !== "localhost" && own !== "127.0.0.1"
      ? own
      : (names.find((n) => /^\d/.test(n) && !n.startsWith("127.")) ?? own);
  return `https://${reachable}${location.port ? `:${location.port}` : ""}/`;
}

class ClassPage {
  private readonly notice = h("p", { class: "notice", role: "status" });
  private readonly tabs = h("nav", { class: "tabs", "aria-label": "classes" });
  private readonly body = h("div", { class: "class-body" });
  private readonly form: HTMLElement;
  private shown = "";
  /** Which class is looked at; none: a new one is made. */
  private chosen: string | undefined;
  private mover: string | undefined;
  private known: Classes = { classes: [], servers: 0, names: [] };

  constructor(
    root: HTMLElement,
    private readonly leads: boolean,
  ) {
    this.form = newClass((classes) => {
      this.chosen = classes.classes.at(-1)?.id;
      this.show(classes);
    });
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
      this.say("The door is not heard: what is shown is old");
      this.notice.dataset.lost = "1";
    }
  }

  private say(text: string): void {
    setText(this.notice, text);
    delete this.notice.dataset.lost;
  }

  private async do(what: string, more: Record<string, unknown> = {}): Promise<void> {
    this.say("");
    try {
      this.show(await act<Classes>("class", { do: what, class: this.chosen, ...more }));
    } catch (why) {
      this.say((why as Error).message);
    }
  }

  private show(known: Classes): void {
    this.known = known;
    if (this.chosen !== undefined && !known.classes.some(({ id }) => id === this.chosen)) this.chosen = undefined;
    else if (this.shown === "") this.chosen = known.classes[0]?.id;
    this.draw();
  }

  private draw(): void {
    const now = JSON.stringify([this.known, this.chosen, this.mover]);
    if (now === this.shown) return;
    this.shown = now;
    const tab = (text: string, id: string | undefined): HTMLElement =>
      h(
        "button",
        {
          class: "plain",
          "aria-pressed": String(this.chosen === id),
          onclick: () => {
            this.chosen = id;
            this.mover = undefined;
            this.draw();
          },
        },
        text,
      );
    this.tabs.replaceChildren(
      ...this.known.classes.map(({ id }) => tab(id, id)),
      ...(this.leads ? [tab("New class", undefined)] : []),
    );
    const it = this.known.classes.find(({ id }) => id === this.chosen);
    if (it) this.body.replaceChildren(this.door(it), this.acts(it), this.exercises(it));
    else if (this.leads) {
      if (!this.body.contains(this.form)) this.body.replaceChildren(this.form); // what is typed stays
    } else this.body.replaceChildren(h("p", { class: "quiet" }, "There is no class."));
    if (this.known.servers === 0) this.say("No server is heard: exercises are made as soon as there is one");
    else if (this.notice.textContent?.startsWith("No server")) this.say("");
  }

  /** What the projector shows. */
  private door(it: TrainingClass): HTMLElement {
    const to = address(this.known.names);
    if (!it.code)
      return h("p", { class: "panel" }, "The code of this class is good no longer; who has a seat keeps it.");
    const big = h("dialog", { class: "projector", onclick: () => big.close() });
    const content = (): Node[] => [
      qr(`${to}?code=${it.code}`),
      h("div", {}, h("p", { class: "address" }, to), h("p", { class: "letters" }, it.code.replace(kGrouped, "$1 "))),
    ];
    const show = h("button", { class: "plain" }, "Show large");
    show.onclick = () => {
      big.replaceChildren(...content());
      document.body.append(big);
      big.showModal();
      big.onclose = () => big.remove();
    };
    return h("section", { class: "panel code-panel", "aria-label": "code of the class" }, ...content(), show);
  }

  private acts(it: TrainingClass): HTMLElement {
    const seats = it.exercises.flatMap(({ seats: all }) => all);
    const bar = h("div", { class: "bar", role: "toolbar", "aria-label": "the class" });
    if (this.leads)
      bar.append(
        h("button", { class: "primary", onclick: () => void this.do("start") }, "Start all"),
        h("button", { onclick: () => void this.do("pause") }, "Pause all"),
      );
    bar.append(
      h(
        "span",
        { class: "quiet" },
        `${it.lesson}; ${seats.filter(({ name }) => name).length} of ${seats.length} seats taken, ` +
          `${seats.filter(({ here }) => here).length} at work`,
      ),
    );
    if (this.mover !== undefined) {
      const name = this.mover;
      bar.append(
        h("strong", {}, `${name}: choose another seat, or`),
        h("button", { onclick: () => this.choose(undefined, () => this.do("remove", { name })) }, "Free the seat"),
      );
    }
    if (this.leads) bar.append(holdButton("End the class", 1, () => void this.do("end"), { class: "end" }));
    return bar;
  }

  private choose(name: string | undefined, then?: () => Promise<void>): void {
    this.mover = name;
    this.draw();
    void then?.();
  }

  private exercises(it: TrainingClass): HTMLElement {
    return h(
      "ol",
      { class: "exercises" },
      ...it.exercises.map((each) =>
        h(
          "li",
          { class: "panel", "data-exercise": each.exercise },
          h(
            "header",
            {},
            h("h3", {}, each.exercise),
            h("span", { class: "state" }, stateOf(each)),
            h("a", { href: `/instructor?exercise=${each.exercise}`, "aria-label": `desk of ${each.exercise}` }, "Desk"),
          ),
          ...each.seats.map((seat) => this.seat(each, seat)),
        ),
      ),
    );
  }

  private seat({ exercise }: ClassExercise, { place, name, here }: Seat): HTMLElement {
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
      h("span", { class: "quiet" }, place),
      h("span", { class: "who" }, name ?? "free"),
      name !== null && h("span", { class: "here" }, here ? "at work" : "away"),
    );
  }
}

function stateOf({ state, time }: ClassExercise): string {
  return state === null ? "is being made" : `${runStateWords[state as RunState]} ${clock(time)}`;
}

export async function makeClass(): Promise<void> {
  const me = await ask<Me>("me");
  const leads = me.rank === "owner" || me.rank === "instructor";
  const link = (href: string, text: string): Node => h("a", { href }, text);
  const root = frame(
    "Class",
    link("/classroom", "Classroom"),
    ...(leads ? [link("/lessons", "Lessons")] : []),
    ...(me.rank === "owner" ? [link("/people", "People")] : []),
    link("/trust", "Certificate"),
    h("span", { class: "quiet" }, `${me.name ?? ""}, ${me.rank ?? ""}`),
    h("button", { class: "plain", onclick: () => void act("logout", {}).then(() => location.assign("/")) }, "Log out"),
  );
  new ClassPage(root, leads);
}
