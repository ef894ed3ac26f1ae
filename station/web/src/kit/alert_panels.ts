// Where alerts are shown. The forecastle's panel has those of the deck, the bridge's those of the bridge; what is about
// the simulation itself is the instructor's.

import type { Seat } from "../wire/connection";
import type { Alert } from "../wire/generated";

/** Of the bridge's panel, of the forecastle's, of none; who has the truth hears them all. */
export const alertTopics = ["Alert", "ForecastleAlert", "ServerAlert"] as const;

/** Whether a seat's panel has an alert. What is not for it does not come to it, but in a replay, where all does. */
export function hasPanel(seat: Seat | undefined, of: Pick<Alert, "deck_panel" | "bridge_panel">): boolean {
  if (seat === "forecastle") return of.deck_panel;
  if (seat === "conning") return of.bridge_panel;
  return seat === "trainee" || seat === "watcher" ? of.deck_panel || of.bridge_panel : true;
}
