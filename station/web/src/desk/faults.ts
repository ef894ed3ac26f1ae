// Faults: what is armed, active and cleared, and the machines that can be broken.

import { h, setText, setVariable } from "../kit/dom";
import { showsTopic } from "../kit/live";
import { everySecond } from "../kit/page";
import { figure, sideWord } from "../kit/units";
import { capital, nameOf } from "../kit/words";
import { FaultCode, FaultPhase, type FaultStatus } from "../wire/generated";
import type { Desk } from "./desk";
import { faultForm } from "./fault_form";
import { type FaultWords, faultName, faults, machines, phaseWords, waitsFor } from "./fault_words";
import { t, translated } from "../kit/language";

const key = (fault: FaultStatus): string => `${fault.code}/${fault.side}`;

interface Row {
  element: HTMLElement;
  phase: HTMLElement;
  text: HTMLElement;
  bar: HTMLElement;
  clear: HTMLButtonElement;
}

export class FaultPanel {
  readonly element: HTMLElement;
  private readonly given = h("ul", { class: "faults-given", "aria-label": t("faults given"), "aria-live": "polite" });
  private readonly catalogue = h("div", { class: "catalogue", "data-gives": "FaultCommand" });
  private readonly none = h("p", { class: "quiet", hidden: true }, t("No fault is given."));
  private readonly rows = new Map<string, Row>();
  private open: HTMLElement | undefined;

  constructor(private readonly desk: Desk) {
    this.element = h("div", { class: "faults scroll" }, this.given, this.none, this.catalogue);
    this.fill();
    showsTopic(this.given, desk.link, "ExerciseTruth");
    desk.link.on("ExerciseTruth", () => this.update());
    everySecond(2, () => this.update());
  }

  private fill(): void {
    for (const name of machines) {
      const of = faults.filter((fault) => fault.machine === name);
      if (of.length === 0) continue;
      this.catalogue.append(
        h(
          "section",
          { "aria-label": translated(name) },
          h("h3", {}, translated(name)),
          h("div", { class: "tiles" }, ...of.map((fault) => this.tile(fault))),
        ),
      );
    }
  }

  private tile(fault: FaultWords): HTMLElement {
    return h(
      "button",
      {
        class: "tile",
        "data-code": fault.enumerator,
        "aria-expanded": "false",
        title: translated(fault.symptom),
        onclick: (event: Event) => this.show(fault, event.currentTarget as HTMLElement),
      },
      capital(translated(fault.said)),
    );
  }

  /** Its form stands under the tiles of its machine. */
  private show(fault: FaultWords, tile: HTMLElement): void {
    const same = this.open === tile;
    this.hide();
    if (same) return;
    this.open = tile;
    tile.setAttribute("aria-expanded", "true");
    const form = faultForm(
      fault,
      this.desk.side,
      (sample, typed) => void this.desk.give("FaultCommand", sample, typed).then((sent) => sent && this.hide()),
      (text) => this.desk.say(text),
    );
    tile.closest("section")!.append(form);
    form.scrollIntoView({ block: "nearest" });
  }
  private hide(): void {
    this.catalogue.querySelector(".fault-form")?.remove();
    this.open?.setAttribute("aria-expanded", "false");
    this.open = undefined;
  }

  private update(): void {
    const truth = this.desk.link.latest("ExerciseTruth");
    const given = truth?.faults ?? [];
    this.none.hidden = !truth || given.length > 0 || this.desk.may("FaultCommand"); // who may has the catalogue there
    const there = new Set(given.map(key));
    for (const [name, row] of this.rows)
      if (!there.has(name)) {
        row.element.remove();
        this.rows.delete(name);
      }
    const order = [FaultPhase.FAULT_PHASE_ACTIVE, FaultPhase.FAULT_PHASE_ARMED, FaultPhase.FAULT_PHASE_CLEARED];
    const sorted = [...given].sort((a, b) => order.indexOf(a.phase) - order.indexOf(b.phase));
    sorted.forEach((fault, i) => {
      const row = this.row(fault);
      if (this.given.children[i] !== row.element) this.given.insertBefore(row.element, this.given.children[i] ?? null);
      this.fillRow(row, fault);
    });
  }

  private row(fault: FaultStatus): Row {
    const known = this.rows.get(key(fault));
    if (known) return known;
    const name = faultName(fault.code);
    const row: Row = {
      element: h("li", { "data-code": FaultCode[fault.code] }),
      phase: h("strong", {}),
      text: h("span", { class: "quiet" }),
      bar: h("i", { class: "severity", "aria-hidden": "true" }),
      clear: h(
        "button",
        {
          class: "plain",
          "data-gives": "FaultCommand",
          "aria-label": t("clear {name}", { name }),
          onclick: () => this.clear(fault),
        },
        t("Clear|a fault"),
      ),
    };
    row.element.append(
      row.phase,
      h("span", { class: "name" }, `${name}, ${sideWord(fault.side)}`),
      row.clear,
      row.bar,
      row.text,
    );
    this.rows.set(key(fault), row);
    return row;
  }

  private fillRow(row: Row, fault: FaultStatus): void {
    const armed = fault.phase === FaultPhase.FAULT_PHASE_ARMED;
    const active = fault.phase === FaultPhase.FAULT_PHASE_ACTIVE;
    row.element.dataset.phase = nameOf("FaultPhase", fault.phase);
    setText(row.phase, phaseWords(fault.phase));
    const there = t("{now} of {full} %", { now: figure(100 * fault.severity_now), full: figure(100 * fault.severity) });
    const number = fault.target > 0 ? `, ${t("number {number}", { number: fault.target })}` : "";
    setText(
      row.text,
      armed
        ? `${waitsFor(fault, this.desk.link)}, ${figure(100 * fault.severity)} %${number}`
        : active
          ? there + number
          : "",
    );
    setVariable(row.bar, "--now", `${active ? fault.severity_now : 0}`);
    setVariable(row.bar, "--full", `${active || armed ? fault.severity : 0}`);
    row.clear.hidden = !armed && !active;
  }

  private clear(fault: FaultStatus): void {
    void this.desk.give("FaultCommand", { code: FaultCode[fault.code], side: fault.side, clear: true });
  }
}
