// The run of a replay: play, jump, speed, loop; and a live exercise that goes on from the instant that is shown.

import { h, setAttribute, setText } from "../kit/dom";
import { holdButton } from "../kit/hold_button";
import { clock, figure } from "../kit/units";
import { DebriefButton } from "./debrief";
import type { Desk } from "./desk";
import { t, writtenFigure } from "../kit/language";

const speeds = [0.1, 0.25, 0.5, 1, 2, 5, 10];
const kOpening = 20; // words of a replay, 5 a second, after which it is no longer sought where the page began

export class ReplayBar {
  readonly element: HTMLElement;
  private readonly play = h("button", { class: "plain play", onclick: () => this.playOrPause() }, t("Play"));
  private readonly speed = h("select", { "aria-label": t("speed"), onchange: () => this.setSpeed() });
  private readonly loop = h(
    "button",
    { class: "plain", "aria-pressed": "false", onclick: () => this.setLoop() },
    t("Loop"),
  );
  private readonly place = h("span", { class: "place" });
  private readonly target = h("select", { "aria-label": t("exercise that goes on from here") });
  private readonly debrief: DebriefButton;
  private opening = kOpening;

  constructor(private readonly desk: Desk) {
    this.debrief = new DebriefButton(desk);
    const gives = { "data-gives": "ReplayCommand" };
    for (const speed of speeds) this.speed.append(h("option", { value: `${speed}` }, `x${writtenFigure(`${speed}`)}`));
    const jump = (text: string, title: string, act: () => void): HTMLButtonElement =>
      h("button", { class: "plain", title, "aria-label": title, onclick: act }, text);
    this.element = h(
      "div",
      { class: "run-bar replay-bar", role: "toolbar", "aria-label": t("replay") },
      h(
        "span",
        { class: "group", ...gives },
        jump("[\u25c2", t("previous event, key ["), () => this.toEvent(-1)),
        jump("\u221210 s", t("back 10 s, Shift and left arrow"), () => this.step(-10)),
        jump("\u22121 s", t("back 1 s, left arrow"), () => this.step(-1)),
        this.play,
        jump("+1 s", t("on 1 s, right arrow"), () => this.step(1)),
        jump("+10 s", t("on 10 s, Shift and right arrow"), () => this.step(10)),
        jump("\u25b8]", t("next event, key ]"), () => this.toEvent(1)),
      ),
      h("span", { class: "group", ...gives }, this.speed, this.loop),
      h("span", { class: "group" }, h("span", { class: "quiet" }, t("time of the recording")), this.place),
      this.debrief.element,
      h(
        "span",
        { class: "group go-on", "data-gives": "RestoreCommand" },
        h("span", { class: "quiet" }, t("Continue live from here in")),
        this.target,
        holdButton(t("Continue live"), 1, () => void this.continueLive(), { class: "plain" }),
      ),
    );
    desk.link.on("ReplayStatus", () => this.update());
    desk.link.on("ReplayStatus", ({ position }) => this.open(position));
    desk.link.onMessage("hello", () => this.update());
    addEventListener("keydown", (event) => this.key(event));
  }

  /** position: s from the recording's beginning. */
  seek(position: number): void {
    const { duration = 0 } = this.desk.link.latest("ReplayStatus") ?? {};
    this.order("REPLAY_SEEK", Math.min(duration, Math.max(0, position)));
  }

  /** Goes where the page's address says (t, s from the recording's beginning), as soon as the replay takes orders. */
  private open(position: number): void {
    const address = new URL(location.href);
    const wanted = Number(address.searchParams.get("t") ?? "");
    if (!address.searchParams.has("t")) return;
    if (Number.isFinite(wanted) && Math.abs(position - wanted) > 0.05 && this.opening-- > 0)
      return void this.desk.link
        .order("ReplayCommand", { action: "REPLAY_SEEK", value: Math.max(0, wanted) })
        .catch(() => undefined);
    address.searchParams.delete("t"); // once: who loads the page anew is where he was
    history.replaceState(null, "", address.pathname + address.search);
  }

  /** Where an exercise time lies in the recording, s; as far as what is shown now tells. */
  positionOf(time: number): number {
    const { position = 0 } = this.desk.link.latest("ReplayStatus") ?? {};
    return position + time - (this.desk.link.latest("ExerciseStatus")?.time ?? 0);
  }

  private order(action: string, value = 0): void {
    void this.desk.give("ReplayCommand", { action, value });
  }
  private playOrPause(): void {
    this.order(this.desk.link.latest("ReplayStatus")?.playing ? "REPLAY_PAUSE" : "REPLAY_PLAY");
  }
  private setSpeed(): void {
    this.order("REPLAY_SPEED", Number(this.speed.value));
  }
  private setLoop(): void {
    this.order("REPLAY_LOOP", this.desk.link.latest("ReplayStatus")?.loop ? 0 : 1);
  }
  private step(by: number): void {
    this.seek((this.desk.link.latest("ReplayStatus")?.position ?? 0) + by);
  }

  /** To the next event, a moment before it, so that it is seen to happen. */
  private toEvent(direction: 1 | -1): void {
    const lead = 0.5; // s
    const now = this.desk.link.latest("ReplayStatus")?.position ?? 0;
    const { recorded } = this.desk.events;
    const known = recorded.length
      ? recorded.map((e) => e.position)
      : this.desk.events.current().map((e) => this.positionOf(e.time));
    const places = known
      .map((position) => position - lead)
      .filter((p) => p >= 0 && (direction > 0 ? p > now + 0.3 : p < now - 1));
    if (places.length > 0) this.seek(direction > 0 ? Math.min(...places) : Math.max(...places));
  }

  private async continueLive(): Promise<void> {
    const { link } = this.desk;
    const status = link.latest("ReplayStatus");
    const exercise = this.target.value;
    if (!status || !exercise) return this.desk.say(t("Continue live: no live exercise is there to go on in"));
    const { recording, position } = status;
    if (await this.desk.ask(() => link.ask({ op: "continue_live", recording, position, exercise })))
      this.desk.say(
        t("{exercise} stands at {time}, paused: open its desk to start it", {
          exercise,
          time: clock(link.latest("ExerciseStatus")?.time ?? 0),
        }),
      );
  }

  private key(event: KeyboardEvent): void {
    const target = event.target as HTMLElement;
    if (!this.desk.replay || !this.desk.may("ReplayCommand") || event.ctrlKey || event.altKey || event.metaKey) return;
    if (target.closest("input, select, textarea, [role=slider], [role=tab]")) return;
    if (event.key === " " && target.closest("button")) return; // it presses the button
    const acts: Record<string, () => void> = {
      " ": () => this.playOrPause(),
      ArrowLeft: () => this.step(event.shiftKey ? -10 : -1),
      ArrowRight: () => this.step(event.shiftKey ? 10 : 1),
      "[": () => this.toEvent(-1),
      "]": () => this.toEvent(1),
    };
    const act = acts[event.key];
    if (!act) return;
    event.preventDefault();
    act();
  }

  private update(): void {
    const { hello } = this.desk.link;
    const status = this.desk.link.latest("ReplayStatus");
    if (hello) {
      const names = hello.live.filter((name) => name !== hello.exercise && !name.startsWith("replay"));
      if (names.join() !== [...this.target.options].map((o) => o.value).join())
        this.target.replaceChildren(...names.map((name) => h("option", { value: name }, name)));
    }
    if (!status) return;
    this.debrief.recording = status.recording;
    setText(this.play, status.playing ? t("Pause") : t("Play"));
    setText(
      this.place,
      t("{position} of {duration}, {recording}", {
        position: clock(status.position),
        duration: clock(status.duration),
        recording: status.recording,
      }),
    );
    setAttribute(this.loop, "aria-pressed", `${status.loop}`);
    if (document.activeElement === this.speed) return;
    if (!speeds.includes(status.speed) && !this.speed.querySelector(`[value="${status.speed}"]`))
      this.speed.append(h("option", { value: `${status.speed}` }, `x${figure(status.speed, 2)}`));
    this.speed.value = `${status.speed}`;
  }
}
