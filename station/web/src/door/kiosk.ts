// A device that stands at one seat: its address lets it in once; from then on it waits here for a class, and is led to
// its seat.

import { h, setText } from "../kit/dom";
import { t } from "../kit/language";
import { Denied, type Me, act, placeWords } from "./ask";
import { doorSaid } from "./door_sentences";
import { frame } from "./frame";

const kAgain = 2000; // ms

type Waits = Me & { why?: string };

export async function makeKiosk(): Promise<void> {
  const root = frame(t("A seat of its own"));
  const seat = h("h2", {});
  const why = h("p", { role: "status" }, t("Asks the door …"));
  const join = h("a", { href: "/join" }, t("Join by a code"));
  root.append(
    h(
      "div",
      { class: "narrow text" },
      h("section", { class: "panel waiting" }, seat, why),
      h("p", { class: "ways" }, join),
    ),
  );
  const key = new URLSearchParams(location.hash.slice(1)).get("key");
  history.replaceState(null, "", location.pathname); // it is nobody's who looks over a shoulder
  try {
    if (key !== null) await act("device", { key });
  } catch (refused) {
    setText(why, (refused as Error).message);
    return;
  }
  /** Whether it is worth asking again. */
  const look = async (): Promise<boolean> => {
    try {
      const me = await act<Waits>("sit", {});
      if (me.who !== "kiosk") {
        location.assign("/");
        return false;
      }
      const place = placeWords[me.place ?? "ship"];
      setText(seat, t("{name}: {place} of exercise {number}", { name: me.name ?? "", place, number: me.number ?? 0 }));
      setText(why, me.why ? doorSaid(me.why) : t("Waits for a class that has this seat. Nothing has to be done here."));
    } catch (refused) {
      const denied = refused instanceof Denied && refused.status === 401;
      setText(why, denied ? refused.message : t("The door is not heard: tries again"));
      return !denied;
    }
    return true;
  };
  while (await look()) await new Promise((done) => setTimeout(done, kAgain));
}
