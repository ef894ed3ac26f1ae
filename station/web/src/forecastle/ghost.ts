// The model's hands at a windlass, in words: where each lever is, and what that seat's own gauges show of it.

import { ClutchState, type ForecastleView } from "../wire/generated";
import { t } from "../kit/language";
import { cableSpeeds, figure, loads } from "../kit/units";
import { turnsText } from "./wheel";

export function ghostFigures(hands: ForecastleView): string {
  const percent = figure(Math.abs(100 * hands.speed_lever));
  const said = [
    turnsText(hands.brake_position),
    hands.speed_lever > 0.005
      ? t("heave {percent} %", { percent })
      : hands.speed_lever < -0.005
        ? t("lower {percent} %", { percent })
        : t("lever at stop"),
    hands.clutch === ClutchState.CLUTCH_IN ? t("clutch in") : t("clutch out"),
    hands.stopper_closed ? t("stopper on") : t("stopper off"),
  ];
  if (hands.counter_fitted) {
    said.push(`${figure(hands.cable_out_indicated, 1)} m`);
    said.push(cableSpeeds.text(hands.cable_speed_indicated));
  } else {
    said.push(cableSpeeds.text(hands.cable_speed_seen));
  }
  if (hands.load_cell_fitted) said.push(loads.text(hands.gypsy_load_indicated));
  return said.join(", ");
}
