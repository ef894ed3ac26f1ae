// Alerts after IMO MSC.302(87): the server owns them, this shows them, sounds, and asks for one to be acknowledged or
// silenced. Acknowledging is one by one; silencing all is one action.

import type { Connection } from "../wire/connection";
import { type Alert, AlertCondition, AlertPriority } from "../wire/generated";
import { alertTopics, hasPanel } from "./alert_panels";
import { AlertSound } from "./alert_sound";
import { h, setText } from "./dom";
import { isUnheard } from "./live";
import { t } from "./language";
import { clock, sideWord } from "./units";
import { alertWords, nameOf, saidOf } from "./words";

/** "1 warning", "2 alarms +1": how many of the worst, and how many others. */
function counted(alerts: readonly Alert[]): string {
  if (!alerts.length) return t("no alerts");
  const worst = worstOf(alerts);
  const most = alerts.filter(({ priority }) => priority === worst).length;
  const others = alerts.length - most;
  return `${most} ${most === 1 ? priorityWords(worst) : priorityMany(worst)}${others ? ` +${others}` : ""}`;
}

function priorityMany(priority: AlertPriority): string {
  if (priority === AlertPriority.ALERT_CAUTION) return t("cautions");
  if (priority === AlertPriority.ALERT_WARNING) return t("warnings");
  return priority === AlertPriority.ALERT_ALARM ? t("alarms") : t("emergencies");
}

/** For style sheets: "alarm". */
export const priorityName = (priority: AlertPriority): string => nameOf("AlertPriority", priority);
/** How a priority is called. */
export const priorityWords = (priority: AlertPriority): string => saidOf("AlertPriority", priority);
const kShown = 20; // MSC.302(87) 9.11
const kJustOpened = 2000; // ms, in which the list does not shut by itself: who opened it would see nothing of it

/** Unacknowledged first, then by priority, then the newest first. */
function byUrgency(a: Alert, b: Alert): number {
  const open = (alert: Alert): number => (alert.condition === AlertCondition.ALERT_ACTIVE_ACKNOWLEDGED ? 1 : 0);
  return open(a) - open(b) || b.priority - a.priority || b.raised_time - a.raised_time;
}

const worstOf = (alerts: readonly Alert[]): AlertPriority =>
  alerts.reduce<AlertPriority>((worst, a) => Math.max(worst, a.priority), AlertPriority.ALERT_CAUTION);

const sounds = (alert: Alert): boolean =>
  alert.condition === AlertCondition.ALERT_ACTIVE_UNACKNOWLEDGED && alert.priority >= AlertPriority.ALERT_WARNING;

export class AlertPanel {
  readonly element: HTMLElement;
  readonly button: HTMLButtonElement;
  /** What is heard of them; its button stands beside theirs. */
  readonly sound: AlertSound;
  private readonly list = h("ol", { class: "alert-list" });
  private readonly more = h("p", { class: "quiet" });
  private readonly count = h("span", {});
  private readonly announce = h("div", { class: "sr-only", role: "status", "aria-live": "assertive" });
  private readonly silence: HTMLButtonElement;
  private readonly listeners = new Set<(alerts: Alert[]) => void>();
  private known = new Set<string>();
  private opened = -Infinity; // ms of performance.now()
  private empty = true;

  constructor(private readonly link: Connection) {
    this.silence = h("button", { class: "plain", onclick: () => this.silenceAll() }, t("Silence"));
    this.button = h(
      "button",
      { class: "alert-button", "aria-expanded": "false", onclick: () => this.toggle() },
      h("span", { "aria-hidden": "true" }, "\u25b3"),
      this.count,
    );
    this.element = h(
      "section",
      { class: "alert-panel", "aria-label": t("alerts"), hidden: true },
      h("div", { class: "row" }, h("h2", {}, t("Alerts")), this.silence),
      this.list,
      this.more,
      this.announce,
    );
    document.body.append(this.announce); // heard also while the panel is shut
    document.addEventListener("pointerdown", ({ target }) => {
      const within = [this.element, this.button].some((each) => each.contains(target as Node));
      if (!within) this.toggle(false);
    });
    document.addEventListener("keydown", (event) => {
      // A dialog that lies over the page shuts first.
      if (event.key !== "Escape" || this.element.hidden || document.querySelector("dialog[open]")) return;
      this.toggle(false);
      this.button.focus();
    });
    // What was heard last is not heard of a link that is lost: the veil says so.
    this.sound = new AlertSound(() => (link.state === "open" ? this.sounding()?.priority : undefined));
    for (const topic of alertTopics) link.on(topic, () => this.update());
    link.onState(() => this.update());
    link.onAnotherServer(() => this.update());
    this.update();
  }

  /** Those that are not back to normal, the most urgent first. None while no server is heard: nobody owns them. */
  alerts(): Alert[] {
    if (isUnheard(this.link)) return [];
    const seat = this.link.hello?.seat;
    const all = new Map<string, Alert>(); // one that is of two panels once
    for (const alert of alertTopics.flatMap((topic) => this.link.all(topic)))
      if (alert.condition !== AlertCondition.ALERT_NORMAL && hasPanel(seat, alert))
        all.set(`${alert.code}/${alert.side}`, alert);
    return [...all.values()].sort(byUrgency);
  }

  /** Calls back whenever one changes. */
  onChange(listener: (alerts: Alert[]) => void): void {
    this.listeners.add(listener);
  }

  /** The most urgent that sounds now. */
  sounding(): Alert | undefined {
    return this.alerts().find(sounds);
  }

  acknowledge(alert: Alert): void {
    this.tell(alert, "ALERT_ACKNOWLEDGE");
  }
  acknowledgeTopmost(): void {
    const top = this.alerts().find((a) => a.condition !== AlertCondition.ALERT_ACTIVE_ACKNOWLEDGED);
    if (top) this.acknowledge(top);
  }
  silenceAll(): void {
    for (const alert of this.alerts().filter(sounds)) this.tell(alert, "ALERT_SILENCE");
  }
  /** Opens or shuts the list; a touch elsewhere or Escape shuts it, too, and that the last of them is gone. */
  toggle(open = this.element.hidden): void {
    if (open === !this.element.hidden) return;
    if (open) this.opened = performance.now();
    this.element.hidden = !open;
    this.button.setAttribute("aria-expanded", `${open}`);
  }

  private tell(alert: Alert, action: string): void {
    this.link
      .order("AlertCommand", { code: alert.code, side: alert.side, action })
      .catch((why: Error) => setText(this.announce, why.message));
  }

  /** To be called also when the server falls silent, or is heard again. */
  update(): void {
    const alerts = this.alerts();
    const open = alerts.filter((a) => a.condition !== AlertCondition.ALERT_ACTIVE_ACKNOWLEDGED);
    this.button.dataset.priority = alerts.length ? priorityName(worstOf(alerts)) : "none";
    this.button.classList.toggle("flashes", open.length > 0);
    setText(this.count, isUnheard(this.link) ? t("alerts not heard") : counted(alerts));
    this.silence.disabled = !alerts.some(sounds);
    this.list.replaceChildren(...alerts.slice(0, kShown).map((alert) => this.row(alert)));
    setText(
      this.more,
      alerts.length > kShown
        ? t("and {count} more", { count: alerts.length - kShown })
        : alerts.length
          ? ""
          : t("None."),
    );
    for (const alert of open)
      if (!this.known.has(`${alert.code}/${alert.side}`))
        setText(this.announce, `${priorityWords(alert.priority)}: ${alertWords(alert).text}`);
    this.known = new Set(open.map((a) => `${a.code}/${a.side}`));
    const gone = alerts.length === 0 && !this.empty;
    this.empty = alerts.length === 0;
    if (gone && performance.now() - this.opened > kJustOpened) this.toggle(false);
    this.sound.update();
    for (const listener of this.listeners) listener(alerts);
  }

  private row(alert: Alert): HTMLElement {
    const acknowledged = alert.condition === AlertCondition.ALERT_ACTIVE_ACKNOWLEDGED;
    const place = alert.side >= 0 ? `${sideWord(alert.side)}, ` : "";
    const { text, explanation } = alertWords(alert);
    return h(
      "li",
      { "data-priority": priorityName(alert.priority), "data-code": alert.code },
      h("strong", {}, priorityWords(alert.priority)),
      h("span", { class: "text" }, text, h("small", {}, explanation)),
      h(
        "span",
        { class: "quiet" },
        `${place}${clock(alert.raised_time)}, ${saidOf("AlertCondition", alert.condition)}`,
      ),
      !acknowledged &&
        h(
          "button",
          {
            class: "plain",
            "aria-label": t("ACK: acknowledge {text}", { text }),
            onclick: () => this.acknowledge(alert),
          },
          t("ACK"),
        ),
    );
  }
}
