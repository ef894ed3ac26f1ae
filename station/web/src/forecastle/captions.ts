// Ear, nose, feet and eye in words, over the picture: for those who cannot hear it, and for what no picture has.

import { AnchorSeen, ClutchState, type ForecastleView } from "../wire/generated";
import { h, setText } from "../kit/dom";
import { saidOf } from "../kit/words";
import { t } from "../kit/language";

const kKeep = 1500; // ms that a line stays, so that what flickers can be read
const kBeaufortHeard = 5; // from which the wind is loud on deck

const noises = ["", t("brake rubs"), t("brake squeals"), t("brake screams")];
const tremors = ["", t("deck trembles"), t("deck shakes"), t("deck bangs")];

/** How chain that runs at that speed, m/s, sounds; empty: it stands. */
export function chainWords(speed: number): string {
  const way = Math.abs(speed);
  if (way < 0.02) return "";
  if (way < 0.5) return speed > 0 ? t("chain walks out") : t("chain comes in");
  return way < 3 ? t("chain runs") : way < 6 ? t("chain runs fast") : t("chain runs away");
}

/**
 * What is heard, smelt, felt and seen of one windlass, by what it comes from; empty: nothing. cableSpeed: m/s, paying
 * out positive.
 */
export function perceived(view: ForecastleView, cableSpeed: number, hydraulic: boolean): Record<string, string> {
  const motor = Math.abs(view.motor_speed_heard);
  const slow = motor < 0.4;
  const pump = slow ? t("pump turns slowly") : t("pump hums");
  const electric = slow ? t("motor turns slowly") : t("motor hums");
  const turns = motor < 0.05 ? "" : hydraulic ? pump : electric;
  return {
    motor: view.motor_burst ? t("the motor has burst") : motor > 1.05 ? t("the motor sings: overhauled") : turns,
    lining: saidOf("LiningSeen", view.lining),
    gypsy: view.gypsy_jumping ? t("links jump over the gypsy") : "",
    chain: chainWords(cableSpeed),
    brake: noises[view.brake_noise] ?? "",
    clutch: view.clutch === ClutchState.CLUTCH_ENGAGING ? t("clutch clatters") : "",
    deck: tremors[view.vibration] ?? "",
    anchor: view.anchor === AnchorSeen.ANCHOR_SEEN_FOUL ? t("anchor is foul") : "",
    wind: view.wind_felt >= kBeaufortHeard ? t("wind, force {force}", { force: view.wind_felt }) : "",
  };
}

export class Captions {
  readonly element = h("ul", {
    class: "captions",
    "aria-live": "polite",
    "aria-label": t("what is heard, smelt and felt"),
  });
  private readonly seen = new Map<string, { line: HTMLElement; at: number }>();

  /** words: what is there now, by what it comes from; what is no more fades after a while. now: ms. */
  show(words: Record<string, string>, now: number): void {
    for (const [source, text] of Object.entries(words)) {
      if (!text) continue;
      const known = this.seen.get(source) ?? { line: this.element.appendChild(h("li", {})), at: now };
      known.at = now;
      setText(known.line, text);
      this.seen.set(source, known);
    }
    for (const [source, { line, at }] of this.seen) {
      if (now - at < kKeep) continue;
      line.remove();
      this.seen.delete(source);
    }
  }

  toggle(): void {
    this.element.classList.toggle("off");
  }
}
