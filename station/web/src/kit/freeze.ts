// A question at a freeze: the exercise holds, and the seat of this page is asked what it ought to know. The sheet lies
// over gauges and picture, whose streams the server does not send meanwhile, until the answer is taken or an instructor
// goes on without.

import type { Connection } from "../wire/connection";
import { type Question, RunState } from "../wire/generated";
import { h, setAttribute, setShown, setText } from "./dom";
import { t, translated, typedFigure, writtenFigure } from "./language";
import { noticedAt } from "./noticed";
import { everySecond } from "./page";
import { stepped } from "./stepped";

const kOf = {
  forecastle: ["ForecastleQuestion", "ForecastleAnswer"],
  bridge: ["BridgeQuestion", "BridgeAnswer"],
} as const;
const kMostTyped = 9; // characters of a figure

export class Freeze {
  readonly element: HTMLDialogElement;
  private readonly text = h("p", { class: "asked", lang: "en" });
  private readonly body = h("div", { class: "answers" });
  private readonly meant = h("p", { class: "quiet" });
  private readonly state = h("p", { role: "status" });
  private question: Question | undefined;
  private since = 0; // ms of performance.now(), when it was first shown

  constructor(
    private readonly link: Connection,
    private readonly seat: keyof typeof kOf,
  ) {
    this.element = h(
      "dialog",
      { class: "freeze", "aria-label": t("question") },
      h(
        "div",
        { class: "sheet" },
        h("h2", {}, t("The exercise holds for a question")),
        this.text,
        this.body,
        this.meant,
        this.state,
      ),
    );
    // Nothing shuts it but the server, and no key of the page works a lever behind it.
    this.element.addEventListener("cancel", (event) => event.preventDefault());
    this.element.addEventListener("close", () => this.show());
    for (const kind of ["keydown", "keyup"]) this.element.addEventListener(kind, (event) => event.stopPropagation());
    link.on(kOf[seat][0], (question) => this.take(question));
    link.on("ExerciseStatus", () => this.show());
    link.on(noticedAt[seat], ({ code, text }) => {
      if (code !== "command.refused" || !this.element.open || !text.includes(kOf[this.seat][1])) return;
      setText(this.state, text);
      this.settle(false);
    });
    everySecond(1, () => this.showTime());
  }

  private take(question: Question): void {
    const again = question.id === this.question?.id && question.run === this.question.run;
    this.question = question.id ? question : undefined;
    if (this.question && !again) this.ask(this.question);
    this.show();
  }

  /** Whoever looks on, and a replay, are not asked. */
  private show(): void {
    const status = this.link.latest("ExerciseStatus");
    const asked =
      this.question?.run === status?.run &&
      this.question !== undefined &&
      status?.state !== RunState.RUN_REPLAY &&
      (this.link.hello?.commands.includes(kOf[this.seat][1]) ?? false);
    if (asked === this.element.open) return;
    if (asked) this.element.showModal();
    else this.element.close();
  }

  private showTime(): void {
    if (!this.element.open || !this.question) return;
    const seconds = Math.floor((performance.now() - this.since) / 1000);
    const { meant_for: meant } = this.question;
    setShown(this.meant, meant > 0);
    setText(
      this.meant,
      t("meant to take {meant} s, {seconds} s so far; nobody is judged by the time", { meant, seconds }),
    );
  }

  private ask(question: Question): void {
    this.since = performance.now();
    setText(this.text, question.text);
    setText(this.state, "");
    this.settle(false);
    const cannotTell = h(
      "button",
      { class: "cannot-tell", onclick: () => void this.answer({ kind: "ANSWER_NOT_KNOWN" }) },
      t("I cannot tell"),
    );
    const answers = question.choices.length > 0 ? this.choices(question) : this.pad(question);
    this.body.replaceChildren(answers, cannotTell);
    this.showTime();
  }

  private choices(question: Question): HTMLElement {
    const buttons = question.choices.map(({ text }, choice) =>
      h("button", { class: "choice", onclick: () => void this.answer({ kind: "ANSWER_CHOICE", choice }) }, text),
    );
    return h("div", { class: "choices", lang: "en", role: "group", "aria-label": t("answers") }, ...buttons);
  }

  private pad({ unit, step }: Question): HTMLElement {
    let typed = "";
    const figure = h("output", { "aria-label": t("your figure") }, "\u2013");
    const say = h("button", { class: "primary say", disabled: true, onclick: () => send() }, t("Answer"));
    const write = (text: string): void => {
      typed = text.slice(0, kMostTyped);
      setText(figure, typed || "\u2013");
      say.disabled = !/\d/.test(typed);
    };
    const send = (): void => {
      if (!say.disabled) void this.answer({ kind: "ANSWER_NUMBER", value: Number(typedFigure(typed)) });
    };
    const mark = writtenFigure(".");
    const press = (key: string): void => {
      if (key === "-") write(typed.startsWith("-") ? typed.slice(1) : `-${typed}`);
      else if (key === "\u232b") write(typed.slice(0, -1));
      else if (key !== mark || !typed.includes(mark)) write(typed + key);
    };
    const names: Record<string, string> = { "-": t("change the sign"), "\u232b": t("delete the last figure") };
    const key = (text: string): HTMLButtonElement =>
      h(
        "button",
        { "aria-label": names[text] ?? t("figure {text}", { text }), onclick: () => press(text) },
        text === "-" ? "\u00b1" : text,
      );
    const by = (sign: 1 | -1): HTMLButtonElement =>
      h(
        "button",
        {
          class: "step",
          "aria-label": sign > 0 ? t("more by {step}", { step }) : t("less by {step}", { step }),
          onclick: () => write(stepped(typed, sign * step)),
        },
        `${sign > 0 ? "+" : "\u2212"}${writtenFigure(`${step}`)}`,
      );
    const pad = h(
      "div",
      { class: "figures", role: "group", "aria-label": t("your figure"), tabIndex: -1 },
      h("div", { class: "shown" }, by(-1), h("span", {}, figure, " ", h("small", {}, translated(unit))), by(1)),
      h("div", { class: "keys" }, ...Array.from(`789456123-0${mark}`, key), key("\u232b"), say),
    );
    this.element.onkeydown = (event) => {
      if (!this.question || this.question.choices.length > 0) return;
      if (/^[\d-]$/.test(event.key)) press(event.key);
      else if (event.key === "." || event.key === ",") press(mark);
      else if (event.key === "Backspace") press("\u232b");
      else if (event.key === "Enter" && !(event.target instanceof HTMLButtonElement)) send();
    };
    return pad;
  }

  private async answer(answer: { kind: string; value?: number; choice?: number }): Promise<void> {
    if (!this.question) return;
    this.settle(true);
    setText(this.state, "");
    try {
      await this.link.order(kOf[this.seat][1], { question: this.question.id, ...answer });
    } catch (why) {
      setText(this.state, t("Not taken: {why}", { why: (why as Error).message }));
      this.settle(false);
    }
  }

  /** Until the server has said what came of it, nothing is sent twice. */
  private settle(sent: boolean): void {
    setAttribute(this.body, "inert", sent ? "" : undefined);
  }
}
