// Teaches a controller: which axis or button is which control, by moving it. Kept by device, in this browser.

import { h, setAttribute, setText, setVariable } from "../kit/dom";
import { figure } from "../kit/units";
import {
  type Assignment,
  type Control,
  type ControllerMemory,
  Learner,
  type Mapping,
  type Settings,
  controlNames,
  controls,
  inverted,
  valueOf,
  withLearned,
} from "./controller";
import { connectedPads } from "./gamepad";
import { t } from "../kit/language";

/** What to do while a control is learned. */
const asks = {
  turn: t("turn it clockwise from one end to the other"),
  way: t("move it all the way to on or heave, then the other way"),
  push: t("press it all the way"),
  press: t("press it"),
} as const;

interface Row {
  element: HTMLElement;
  from: HTMLElement;
  meter: HTMLElement;
  learn: HTMLButtonElement;
  more: HTMLElement;
}

export class ControllerDialog {
  readonly element: HTMLDialogElement;
  private readonly devices = h("select", { "aria-label": t("controller"), onchange: () => this.fill() });
  private readonly none = h(
    "p",
    {},
    t("No controller is heard of. Plug it in and press one of its buttons: a browser tells of it only then."),
  );
  private readonly vibrates = h("input", { type: "checkbox", onchange: () => this.keep(this.settings().mapping) });
  private readonly rows: Record<Control, Row>;
  private readonly say = h("p", { class: "asks", role: "status", "aria-live": "polite" });
  private readonly taught: HTMLElement;
  private learning: { control: Control; learner: Learner } | undefined;
  private known = "";

  constructor(private readonly memory: ControllerMemory) {
    this.rows = Object.fromEntries(controlNames.map((control) => [control, this.row(control)])) as typeof this.rows;
    this.taught = h(
      "div",
      {},
      h(
        "div",
        { class: "row" },
        this.devices,
        h("label", {}, this.vibrates, ` ${t("vibrates")}`),
        h("button", { class: "plain", onclick: () => this.forget() }, t("Forget what it was taught")),
      ),
      h("table", { class: "taught" }, h("tbody", {}, ...controlNames.map((control) => this.rows[control].element))),
    );
    this.element = h(
      "dialog",
      { class: "controller panel", "aria-label": t("controllers"), onclose: () => (this.learning = undefined) },
      h(
        "div",
        { class: "row" },
        h("h2", {}, t("Controllers")),
        h("button", { class: "plain", onclick: () => this.element.close() }, t("Close")),
      ),
      this.none,
      this.say,
      this.taught,
    );
  }

  get open(): boolean {
    return this.element.open;
  }

  show(): void {
    if (!this.open) this.element.showModal();
    this.known = "";
    this.draw();
  }

  /** Shows what the controller does now, and learns; once a frame. */
  draw(): void {
    if (!this.open) return;
    const pads = connectedPads();
    const names = pads.map(({ id }) => id).join("\n");
    if (names !== this.known) {
      this.known = names;
      this.devices.replaceChildren(...pads.map(({ id, index }) => h("option", { value: `${index}` }, id)));
      this.fill();
    }
    this.none.hidden = pads.length > 0;
    this.taught.hidden = pads.length === 0;
    const pad = this.pad();
    if (!pad) return;
    if (this.learning) this.learn(pad, this.learning);
    const { mapping } = this.settings();
    for (const control of controlNames) {
      const values = mapping.filter((one) => one.control === control).map((one) => valueOf(one, pad) / span(one));
      setVariable(this.rows[control].meter, "--at", Math.max(0, ...values.map(Math.abs)).toFixed(3));
    }
  }

  private pad(): Gamepad | undefined {
    return connectedPads().find(({ index }) => `${index}` === this.devices.value);
  }

  private settings(): Settings {
    const pad = this.pad();
    return (pad && this.memory.of(pad)) ?? { mapping: [], vibrates: true };
  }

  private keep(mapping: Mapping): void {
    const pad = this.pad();
    if (!pad) return;
    this.memory.keep(pad.id, { mapping, vibrates: this.vibrates.checked });
    this.fill();
  }

  private forget(): void {
    const pad = this.pad();
    if (pad) this.memory.keep(pad.id, undefined);
    this.fill();
  }

  private learn(pad: Gamepad, { control, learner }: { control: Control; learner: Learner }): void {
    learner.see(pad);
    const found = learner.found();
    setText(
      this.say,
      `${controls[control].name}: ${asks[controls[control].kind]}${found ? `. ${sourceWords(found)}` : " ..."}`,
    );
    // A button is learned when it is let go; an axis when that is said.
    if (found && controls[control].kind === "press" && valueOf(found, pad) === 0) this.learned(found);
  }

  private begin(control: Control): void {
    const pad = this.pad();
    const found = this.learning?.control === control ? this.learning.learner.found() : undefined;
    if (found) this.learned(found);
    else if (this.learning?.control === control || !pad) this.end("");
    else {
      this.learning = { control, learner: new Learner(control, pad) };
      this.fill();
    }
  }

  private learned(found: Assignment): void {
    this.keep(withLearned(this.settings().mapping, found));
    this.end(`${controls[found.control].name}: ${sourceWords(found)}`);
  }

  private end(words: string): void {
    this.learning = undefined;
    setText(this.say, words);
    this.fill();
  }

  private fill(): void {
    const { mapping, vibrates } = this.settings();
    this.vibrates.checked = vibrates;
    for (const control of controlNames) {
      const row = this.rows[control];
      const of = mapping.filter((one) => one.control === control);
      setText(row.from, of.map(sourceWords).join("; ") || "\u2013");
      const learning = this.learning?.control === control;
      setText(row.learn, learning ? t("Done") : t("Learn"));
      setAttribute(row.learn, "aria-pressed", `${learning}`);
      row.more.replaceChildren(...(of.length === 1 ? this.more(of[0]!) : []));
    }
  }

  private row(control: Control): Row {
    const { name } = controls[control];
    const from = h("span", { class: "from" });
    const meter = h("i", { class: "meter", "aria-hidden": "true" });
    const learn = h(
      "button",
      { class: "plain", "aria-label": t("learn {name}", { name }), onclick: () => this.begin(control) },
      t("Learn"),
    );
    const more = h("span", { class: "row" });
    const cells = [meter, from, learn, more].map((cell) => h("td", {}, cell));
    return { element: h("tr", {}, h("th", { scope: "row" }, name), ...cells), from, meter, learn, more };
  }

  /** What can be changed of one that was learned. */
  private more(one: Assignment): HTMLElement[] {
    const { kind, name } = controls[one.control];
    const change = (now: Assignment): void => this.keep(withLearned(this.settings().mapping, now));
    const number = (label: string, value: number, most: number, set: (value: number) => Assignment): HTMLElement => {
      const input = h("input", {
        type: "number",
        min: "0",
        max: `${most}`,
        step: "any",
        value: `${value}`,
        "aria-label": `${name}: ${label}`,
        onchange: () => input.checkValidity() && input.value !== "" && change(set(Number(input.value))),
      });
      return h("label", {}, `${label} `, input);
    };
    const invert = h(
      "button",
      { class: "plain", "aria-label": t("invert {name}", { name }), onclick: () => change(inverted(one)) },
      t("Invert"),
    );
    if (kind === "press") return [];
    if (kind !== "turn")
      return [invert, number(t("dead zone, %"), Math.round(100 * one.dead), 90, (v) => ({ ...one, dead: v / 100 }))];
    const endless = h("input", {
      type: "checkbox",
      checked: one.endless,
      onchange: () => change({ ...one, endless: endless.checked }),
    });
    return [
      invert,
      number(t("turns from end to end"), one.turns, 100, (turns) => ({ ...one, turns: turns || one.turns })),
      h("label", {}, endless, ` ${t("goes round")}`),
    ];
  }
}

/** What its value is at its end. */
const span = ({ control, turns }: Assignment): number => (controls[control].kind === "turn" ? turns : 1);

/** "axis 2, -1.00 to 1.00"; axes and buttons are counted from 1. */
const sourceWords = ({ source, index, from, rest, to, control }: Assignment): string => {
  const { kind } = controls[control];
  const number = index + 1;
  if (source === "button") return t("button {number}", { number });
  const begin = figure(kind === "push" || kind === "press" ? rest : from, 2);
  return t("axis {number}, {begin} to {end}", { number, begin, end: figure(to, 2) });
};
