// The way to the other page of a trainee who has both seats. The hand is off the levers of the page that is left, as
// whenever a page is closed.

import type { Connection } from "../wire/connection";
import { h, setShown } from "./dom";
import { t } from "./language";
import { pageAddress } from "./page";

const pages = {
  forecastle: { path: "/forecastle", name: t("Forecastle") },
  bridge: { path: "/bridge", name: t("Bridge") },
};

/** A link to that page, with what this one's address asks for; shown to who has both seats alone. */
export function otherSeat(link: Connection, to: keyof typeof pages): HTMLAnchorElement {
  const { path, name } = pages[to];
  const query = Object.fromEntries(new URLSearchParams(location.search));
  const element = h("a", { class: "plain", href: pageAddress(path, query), hidden: true }, name);
  link.onMessage("hello", () => setShown(element, link.hello?.seat === "trainee"));
  return element;
}
