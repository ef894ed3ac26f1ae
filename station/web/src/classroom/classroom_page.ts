// All exercises of all servers at a glance: run them together, make and remove some, go to the desk of one.

import { h, setText } from "../kit/dom";
import { type Page, pageAddress } from "../kit/page";
import { clock, figure } from "../kit/units";
import { eventText } from "../kit/words";
import type { OrderSample } from "../wire/connection";
import type { ClassroomStatus, Event } from "../wire/generated";
import { CctvPictures } from "./cctv";
import { CreateForm } from "./create_form";
import { orderIn } from "./exercise_order";
import { Tile, type TileAlert, type TileWishes } from "./tile";
import { t } from "../kit/language";

const kLines = 30;

class Classroom {
  private readonly notice = h("p", { class: "notice", role: "status", "aria-live": "polite" });
  private readonly servers = h("div", { class: "servers" });
  private readonly log = h("ol", { class: "log", "aria-label": t("what was done in the classroom") });
  private readonly groups = new Map<string, { element: HTMLElement; figures: HTMLElement; list: HTMLElement }>();
  private readonly tiles = new Map<string, Tile>(); // by server/id
  private readonly create: CreateForm;
  private readonly cctv: CctvPictures;
  private alerts: Record<string, TileAlert> = {}; // by exercise

  constructor(private readonly page: Page) {
    this.cctv = new CctvPictures(page.link);
    this.create = new CreateForm(
      (sample) => this.give(sample),
      (text) => setText(this.notice, text),
    );
    const all = (on: boolean): void => this.tiles.forEach((tile) => (tile.chosen = on));
    const button = (text: string, act: () => void): HTMLButtonElement =>
      h("button", { class: "plain", onclick: act }, text);
    page.topBar.middle.append(
      ...(page.link.byDoor ? [h("a", { class: "plain", href: "/class" }, t("Class"))] : []),
      h("a", { class: "plain", href: pageAddress("/lessons") }, t("Lessons")),
    );
    page.root.classList.add("classroom");
    page.root.append(
      h(
        "div",
        { class: "bar", role: "toolbar", "aria-label": t("chosen exercises") },
        button(t("Choose all"), () => all(true)),
        button(t("none"), () => all(false)),
        h("span", { class: "quiet" }, t("chosen ones:")),
        button(t("Start"), () => void this.runChosen("EXERCISE_START")),
        button(t("Pause"), () => void this.runChosen("EXERCISE_PAUSE")),
        this.notice,
        this.cctv.button,
      ),
      this.servers,
      h(
        "aside",
        {},
        this.create.element,
        h(
          "section",
          { class: "panel done", "aria-label": t("done"), tabIndex: 0 },
          h("h2", {}, t("Done|list of what was done")),
          this.log,
        ),
      ),
    );
    page.link.on("ClassroomStatus", () => this.update());
    page.link.onState(
      (state) => state === "open" && void page.link.ask({ op: "watch_classroom" }).catch(() => undefined),
    );
    page.link.onMessage("classroom_alerts", (message) =>
      this.showAlerts(message.exercises as Record<string, TileAlert>),
    );
    page.link.on("classroom/Event", (event) => event.code.startsWith("classroom.") && this.tell(event));
    page.link.on(
      "classroom/Event",
      (event) => event.code === "command.refused" && event.text.includes("Classroom") && this.tell(event),
    );
    this.update();
  }

  private async give(sample: OrderSample): Promise<boolean> {
    setText(this.notice, "");
    try {
      await this.page.link.order("ClassroomCommand", sample);
      return true;
    } catch (why) {
      setText(this.notice, (why as Error).message);
      return false;
    }
  }

  private async run(id: string, action: string): Promise<void> {
    setText(this.notice, "");
    try {
      await orderIn(id, "ExerciseCommand", { action });
    } catch (why) {
      setText(this.notice, `${id}: ${(why as Error).message}`);
    }
  }
  /** One after the other: a station takes few links at a time. */
  private async runChosen(action: string): Promise<void> {
    const chosen = [...this.tiles.values()].filter((tile) => tile.chosen);
    if (chosen.length === 0) setText(this.notice, t("No exercise is chosen"));
    for (const tile of chosen) await this.run(tile.id, action);
  }

  private showAlerts(alerts: Record<string, TileAlert>): void {
    this.alerts = alerts;
    for (const tile of this.tiles.values()) tile.showAlert(alerts[tile.id]);
  }

  private tell(event: Event): void {
    this.log.prepend(h("li", { "data-code": event.code }, eventText(event)));
    while (this.log.children.length > kLines) this.log.lastElementChild!.remove();
    if (event.code === "command.refused") setText(this.notice, event.text);
  }

  private update(): void {
    const all = this.page.link.all("ClassroomStatus").sort((a, b) => a.server.localeCompare(b.server));
    this.create.showServers(new Map(all.map((status) => [status.server, status.exercises.length])));
    const there = new Set<string>();
    for (const status of all) {
      const group = this.group(status);
      setText(group.figures, summary(status));
      for (const exercise of status.exercises) {
        const name = `${status.server}/${exercise.id}`;
        there.add(name);
        let tile = this.tiles.get(name);
        if (!tile) {
          const wishes: TileWishes = {
            run: (id, action) => void this.run(id, action),
            remove: (server, id) => void this.give({ action: "CLASSROOM_REMOVE", server, id }),
          };
          tile = new Tile(status.server, exercise.id, wishes, this.cctv.of(exercise.id));
          this.tiles.set(name, tile);
          const next = [...group.list.children].find((other) => (other as HTMLElement).dataset.id! > exercise.id);
          group.list.insertBefore(tile.element, next ?? null);
        }
        tile.show(exercise);
        tile.showAlert(this.alerts[exercise.id]);
      }
    }
    for (const [name, tile] of this.tiles)
      if (!there.has(name)) {
        tile.element.remove();
        this.cctv.forget(tile.id);
        this.tiles.delete(name);
      }
    for (const [name, group] of this.groups)
      if (!all.some((status) => status.server === name)) {
        group.element.remove();
        this.groups.delete(name);
      }
  }

  private group(status: ClassroomStatus): { figures: HTMLElement; list: HTMLElement } {
    const known = this.groups.get(status.server);
    if (known) return known;
    const figures = h("span", { class: "quiet" });
    const list = h("ul", { class: "tiles" });
    const element = h(
      "section",
      { "aria-label": t("server {name}", { name: status.server }) },
      h("header", {}, h("h2", {}, status.server), figures),
      list,
    );
    this.servers.append(element);
    const group = { element, figures, list };
    this.groups.set(status.server, group);
    return group;
  }
}

function heard(servers: number): string {
  if (servers === 0) return "";
  return servers === 1 ? t("hears 1 other server") : t("hears {count} other servers", { count: servers });
}

/** "5 of 64 exercises, 2 threads, load 1.2 of a core, longest 12:30". */
function summary(status: ClassroomStatus): string {
  const load = status.exercises.reduce((sum, exercise) => sum + exercise.load, 0);
  const longest = Math.max(0, ...status.exercises.map((exercise) => exercise.time));
  return [
    t("{count} of {most} exercises", { count: status.exercises.length, most: status.max_exercises }),
    status.threads === 1 ? t("1 thread") : t("{count} threads", { count: status.threads }),
    t("load {percent} % of a core", { percent: figure(100 * load) }),
    t("longest {time}", { time: clock(longest) }),
    heard(status.neighbours),
  ]
    .filter(Boolean)
    .join(", ");
}

export function makeClassroom(page: Page): void {
  new Classroom(page);
}
