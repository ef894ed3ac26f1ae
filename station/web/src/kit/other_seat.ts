// The way to the other page of a trainee who has both seats: a tab of its own, which may be dragged out to stand beside
// this one. In its place it would take the hand off this page's levers, as whenever a page is closed.

import type { Connection } from "../wire/connection";
import { h, setShown } from "./dom";
import { t } from "./language";
import { pageAddress } from "./page";

export type SeatPage = "forecastle" | "bridge";
const names: Record<SeatPage, string> = { forecastle: t("Forecastle"), bridge: t("Bridge") };

/** By which links find a page that is open. */
const windowOf = (page: SeatPage): string => `windlass-${page}`;

/** A link to that page, with what this one's address asks for: to the tab in which it lies open, or a new one. */
export function seatLink(to: SeatPage, props: { [name: string]: unknown }, ...text: string[]): HTMLAnchorElement {
  const address = pageAddress(`/${to}`, Object.fromEntries(new URLSearchParams(location.search)));
  // With a fragment, empty or not, a page that is open is shown as it is, and not loaded anew.
  const href = address.includes("#") ? address : `${address}#`;
  return h("a", { class: "plain", target: windowOf(to), href, ...props }, ...text);
}

/** The same in the top bar of the other one, shown to who has both seats alone. */
export function otherSeat(link: Connection, to: SeatPage): HTMLAnchorElement {
  const title = t("in a tab of its own: two windows side by side keep both in hand, a hidden page leaves its windlass");
  const element = seatLink(to, { title, hidden: true }, `${names[to]} \u2197`);
  link.onMessage("hello", () => {
    const both = link.hello?.seat === "trainee";
    setShown(element, both);
    if (both) window.name = windowOf(to === "bridge" ? "forecastle" : "bridge");
  });
  return element;
}
