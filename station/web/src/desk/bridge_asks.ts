// That the lesson's bridge asks in vain, and when that ends the lesson: in sight, since its line of the log goes by.

import { type Asking, askingOf, asksInVain } from "../kit/asks_in_vain";
import { h, setShown, setText } from "../kit/dom";
import type { Desk } from "./desk";

export class BridgeAsks {
  readonly element = h("div", { class: "asked-bar", role: "status", hidden: true });
  private asking: Asking | undefined;

  constructor(private readonly desk: Desk) {
    desk.events.onChange(() => {
      this.asking = askingOf(desk.events.current());
      this.show();
    });
    desk.link.on("ExerciseStatus", () => this.show());
  }

  /** Of a replay's moments nobody is to help any more. */
  private show(): void {
    const { asking, desk } = this;
    const status = desk.link.latest("ExerciseStatus");
    const asks = asking !== undefined && status !== undefined && !desk.replay;
    setShown(this.element, asks);
    if (asks) setText(this.element, asksInVain(asking, status.time));
  }
}
