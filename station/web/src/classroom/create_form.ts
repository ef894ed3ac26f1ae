// A new exercise: of a file that the server has, or of a definition from this computer.

import { h } from "../kit/dom";
import type { OrderSample } from "../wire/connection";
import { t } from "../kit/language";

const kLargest = 14000; // bytes of a definition: what a message to the station takes

export class CreateForm {
  readonly element: HTMLElement;
  private readonly server = h("select", {
    "aria-label": t("server"),
    onchange: () => (this.byHand = this.server.value),
  });
  private readonly id = h("input", {
    "aria-label": t("name of the exercise"),
    placeholder: t("name, e.g. anna"),
    required: true,
    maxLength: 63,
    pattern: "[A-Za-z0-9._\\-]+",
  });
  private readonly file = h("input", {
    "aria-label": t("exercise file of the server"),
    placeholder: t("file, e.g. let_go_port_25m"),
  });
  private readonly definition = h("input", {
    type: "file",
    accept: ".json,application/json",
    "aria-label": t("definition from this computer"),
  });
  /** The server that was chosen; empty: none was. */
  private byHand = "";
  private readonly practice = h("input", { type: "checkbox" });
  private readonly wait = h("input", { type: "checkbox", checked: true });

  /** give: sends a ClassroomCommand, true when it went out; say: tells what cannot be sent. */
  constructor(
    private readonly give: (sample: OrderSample) => Promise<boolean>,
    private readonly say: (text: string) => void,
  ) {
    this.element = h(
      "form",
      { class: "create panel", "aria-label": t("new exercise"), onsubmit: (event: Event) => this.send(event) },
      h("h2", {}, t("New exercise")),
      this.server,
      this.id,
      this.file,
      h("label", { class: "definition" }, h("span", { class: "quiet" }, t("or a definition:")), this.definition),
      h("label", { class: "row" }, this.practice, t("for practice, with hints")),
      h("label", { class: "row" }, this.wait, t("wait to be started")),
      h("button", { class: "plain primary" }, t("Create")),
    );
  }

  /** Until one is chosen by hand the one that has fewest exercises is. */
  showServers(servers: ReadonlyMap<string, number>): void {
    const names = [...servers.keys()];
    if (names.join() !== [...this.server.options].map((o) => o.value).join())
      this.server.replaceChildren(...names.map((name) => h("option", { value: name }, name)));
    if (!servers.has(this.byHand)) this.byHand = "";
    const fewest = Math.min(...servers.values());
    this.server.value = this.byHand || (names.find((name) => servers.get(name) === fewest) ?? "");
  }

  private async send(event: Event): Promise<void> {
    event.preventDefault();
    const chosen = this.definition.files?.[0];
    const exercise = this.file.value.trim();
    if (!chosen && !exercise) return this.say(t("New exercise: name a file of the server, or choose a definition"));
    if (chosen && chosen.size > kLargest)
      return this.say(
        t("New exercise: {name} has {size} bytes; {most} are allowed: put it into the server's folder", {
          name: chosen.name,
          size: chosen.size,
          most: kLargest,
        }),
      );
    const sample = {
      action: "CLASSROOM_CREATE",
      server: this.server.value,
      id: this.id.value.trim(),
      wait: this.wait.checked,
      practice: this.practice.checked,
      ...(chosen ? { definition: await chosen.text() } : { exercise }),
    };
    if (!(await this.give(sample))) return;
    this.id.value = this.definition.value = "";
  }
}
