// The way from a debriefing to a moment of its recording: /replay?recording=NAME&t=133.5 (s from its beginning). The
// station replays it in an exercise of its own, whose desk opens there.

import { h, setText } from "../kit/dom";
import { openPage, pageAddress } from "../kit/page";
import { t } from "../kit/language";

const query = new URLSearchParams(location.search);
const recording = query.get("recording") ?? "";
const moment = query.get("t") ?? "0";

const page = openPage(t("Replay"));
const words = h("p", { role: "status" }, t("Opening the recording {recording} ...", { recording }));
page.root.append(words);

page.link.onMessage("replay", (message) => {
  location.replace(pageAddress("/instructor", { exercise: `${message["exercise"]}`, t: moment }));
});
let asked = false;
page.link.onMessage("hello", () => {
  if (asked) return;
  asked = true;
  page.link.ask({ op: "replay", recording }).catch((why: Error) => {
    asked = false;
    setText(words, t("The recording {recording} cannot be replayed here: {why}", { recording, why: why.message }));
  });
});
