// The model's hands at the helm, in words: engine, rudder, and her speed by the seat's own GPS.

import type { BridgeView } from "../wire/generated";
import { t } from "../kit/language";
import { figure, knots } from "../kit/units";
import { rudderWords } from "./wheel";

export function ghostFigures(hands: BridgeView): string {
  const said = [
    t("engine {percent} %", { percent: figure(100 * hands.engine) }),
    t("rudder {angle}", { angle: rudderWords(hands.rudder) }),
  ];
  if (hands.gps_works) said.push(`${figure(knots(hands.speed_over_ground), 1)} kn`);
  return said.join(", ");
}
