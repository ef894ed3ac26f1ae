// A new exercise: of a file that the server has, or of a definition from this computer.

import { h } from "../kit/dom";
import type { OrderSample } from "../wire/connection";

const kLargest = 14000; // bytes of a definition: what a message to the station takes

export class CreateForm {
  readonly element: HTMLElement;
  private readonly server = h("select", { "aria-label": "server" });
  private readonly id = h("input", {
    "aria-label": "name of the exercise",
    placeholder: "name, e.g. anna",
    required: true,
    maxLength: 63,
    pattern: "[A-Za-z0-9._\\-]+",
  });
  private readonly file = h("input", {
    "aria-label": "exercise file of the server",
    placeholder: "file, e.g. let_go_port_25m",
  });
  private readonly definition = h("input", {
    type: "file",
    accept: ".json,application/json",
    "aria-label": "definition from this computer",
  });
  private readonly wait = h("input", { type: "checkbox", checked: true });

  /** give: sends a ClassroomCommand, true when it went out; say: tells what cannot be sent. */
  constructor(
    private readonly give: (sample: OrderSample) => Promise<boolean>,
    private readonly say: (text: string) => void,
  ) {
    this.element = h(
      "form",
      { class: "create panel", "aria-label": "new exercise", onsubmit: (event: Event) => this.send(event) },
      h("h2", {}, "New exercise"),
      this.server,
      this.id,
      this.file,
      h("label", { class: "definition" }, h("span", { class: "quiet" }, "or a definition:"), this.definition),
      h("label", { class: "row" }, this.wait, "wait to be started"),
      h("button", { class: "plain primary" }, "Create"),
    );
  }

  showServers(names: string[]): void {
    if (names.join() === [...this.server.options].map((o) => o.value).join()) return;
    const chosen = this.server.value;
    this.server.replaceChildren(...names.map((name) => h("option", { value: name }, name)));
    if (names.includes(chosen)) this.server.value = chosen;
  }

  private async send(event: Event): Promise<void> {
    event.preventDefault();
    const chosen = this.definition.files?.[0];
    const exercise = this.file.value.trim();
    if (!chosen && !exercise) return this.say("New exercise: name a file of the server, or choose a definition");
    if (chosen && chosen.size > kLargest)
      return this.say(
        `New exercise: ${chosen.name} has ${chosen.size} bytes; ${kLargest} are allowed: ` +
          "put it into the server's folder",
      );
    const sample = {
      action: "CLASSROOM_CREATE",
      server: this.server.value,
      id: this.id.value.trim(),
      wait: this.wait.checked,
      ...(chosen ? { definition: await chosen.text() } : { exercise }),
    };
    if (!(await this.give(sample))) return;
    this.id.value = this.definition.value = "";
  }
}
