// One click from a recording to its debriefing, in a window of its own.

import { h } from "../kit/dom";
import type { Desk } from "./desk";
import { t } from "../kit/language";

/** A button that opens the debriefing of the recording that is meant when it is pressed; none: it is disabled. */
export class DebriefButton {
  readonly element = h(
    "button",
    { class: "plain", "data-gives": "files", onclick: () => void this.open() },
    t("Debrief"),
  );
  private recording_ = "";

  constructor(private readonly desk: Desk) {
    this.recording = "";
  }

  set recording(name: string) {
    this.recording_ = name;
    this.element.disabled = name === "";
    this.element.title = name
      ? t("talk over {name}: marks, plots, track, orders and reports", { name })
      : t("nothing was recorded here yet");
  }

  private async open(): Promise<void> {
    // The window is opened within the click: later a browser takes it for an advertisement. It shares this page's
    // session, and so its token, with which its links open replays.
    const recording = this.recording_;
    const view = window.open("about:blank", "_blank");
    let address = "";
    const end = this.desk.link.onMessage("debrief", (message) => {
      if (message["recording"] === recording) address = `${message["address"]}`;
    });
    const made = await this.desk.ask(() => this.desk.link.ask({ op: "debrief", recording }));
    end();
    if (made && view) view.location.replace(address);
    else if (made) this.desk.say(t("Debrief: the browser lets no new window open; allow it for this page"));
    else view?.close();
  }
}
