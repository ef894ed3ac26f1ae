// When somebody last cried "stand clear": the bridge by its order, or the forecastle by its report, as the log has it.

import type { Connection } from "../wire/connection";
import type { SeatEvent } from "../wire/generated";
import { begins } from "../kit/branch";
import type { OwnSeat } from "../kit/instructions";
import { noticedAt } from "../kit/noticed";
import { bareReport, orderText, placeOf, reportText } from "../kit/words";

/** Whether a line of the log says so of any cable. */
export function isStandClear({ code, side, text }: Pick<SeatEvent, "code" | "side" | "text">): boolean {
  if (code === "order.given") return text.includes(orderText(placeOf("BridgeOrderCode", "stand_clear"), side, 0));
  if (code !== "report.made" && code !== "report.not_heard") return false;
  return text.includes(reportText(bareReport(placeOf("ReportCode", "stand_clear"), side)));
}

export class Cry {
  /** s, exercise time; undefined: nobody has. */
  time: number | undefined;

  /** at: the seat whose log it is. */
  constructor(link: Pick<Connection, "on" | "onState">, at: OwnSeat) {
    link.on(noticedAt[at], (event) => {
      if (begins(event) && this.time !== undefined && this.time > event.time) this.time = undefined;
      if (isStandClear(event)) this.time = event.time;
    });
    link.onState((state) => state === "open" && (this.time = undefined)); // all of it comes again
  }
}
