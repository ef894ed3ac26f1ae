// The men on deck: what the mate sets them to, how long they still need, and what they wait for.

import type { Connection } from "../wire/connection";
import { DeckHindrance, DeckWork } from "../wire/generated";
import { h, setText } from "./dom";
import { t } from "./language";
import { allSaid, capital, saidOf } from "./words";
import type { Popover } from "./popover";

const clock = (seconds: number): string => `${Math.floor(seconds / 60)}:${`${seconds % 60}`.padStart(2, "0")}`;

export class Men {
  /** Opens the choice; says in short how they get on. */
  readonly button: HTMLButtonElement;

  constructor(
    private readonly link: Connection,
    private readonly side: () => number,
    private readonly popover: Popover,
    private readonly tell: (text: string) => void,
  ) {
    this.button = h("button", { class: "plain", onclick: () => this.choose() }, t("Men"));
    link.on("ForecastleView", (view) => view.side === this.side() && this.show());
  }

  show(): void {
    setText(this.button, `${t("Men")}${this.briefly()}`);
    this.button.disabled = !(this.link.hello?.commands.includes("DeckWorkCommand") ?? false);
    this.button.title = this.atLength();
  }

  private briefly(): string {
    const view = this.link.latest("ForecastleView", this.side());
    if (!view || view.deck_work === DeckWork.DECK_WORK_NONE) return "";
    if (view.deck_work_waits !== DeckHindrance.DECK_HINDRANCE_NONE) return `: ${t("wait|men")}`;
    return `: ${view.deck_work_left > 0 ? clock(view.deck_work_left) : t("done|men")}`;
  }

  private atLength(): string {
    const view = this.link.latest("ForecastleView", this.side());
    if (!view) return "";
    const { deck_work, deck_work_waits } = view;
    const why = deck_work_waits === DeckHindrance.DECK_HINDRANCE_NONE ? "" : saidOf("DeckHindrance", deck_work_waits);
    return `${capital(saidOf("DeckWork", deck_work))}${this.briefly()}${why && `: ${why}`}`;
  }

  private choose(): void {
    const choices = allSaid("DeckWork").map((said, work) =>
      h("button", { onclick: () => void this.order(work as DeckWork) }, capital(said)),
    );
    this.popover.show(
      t("Set the men to"),
      this.button,
      h("p", { class: "men-at-work", role: "status" }, this.atLength()),
      h("div", { class: "men" }, ...choices),
    );
  }

  private async order(work: DeckWork): Promise<void> {
    this.popover.close();
    try {
      await this.link.order("DeckWorkCommand", { side: this.side(), work: DeckWork[work] });
    } catch (why) {
      this.tell(t("Not done: {why}", { why: (why as Error).message }));
    }
  }
}
