// What every page of a station has: its link, the top bar, the alerts, and a veil when the connection is lost.

import { Connection } from "../wire/connection";
import type { TopicName } from "../wire/generated";
import { AlertPanel } from "./alerts";
import { byId, h, setShown, setText } from "./dom";
import { LiveWatch, isUnheard } from "./live";
import { proposePalette } from "./palette";
import { TopBar } from "./top_bar";
import { t, titlePage } from "./language";

export interface Page {
  link: Connection;
  topBar: TopBar;
  /** Where the page puts itself: <main id="page">. */
  root: HTMLElement;
  /** For pictures and tests: nothing moves or blinks by time. */
  still: boolean;
}

/** A page of one exercise. */
export interface ExercisePage extends Page {
  alerts: AlertPanel;
}

const kToken = "windlass.token";

/** The token of this page's session; empty before openPage(). */
export const pageToken = (): string => sessionStorage.getItem(kToken) ?? "";

/** The token stands in the address's fragment at first; then the session keeps it and the address forgets it. */
function takeToken(): string {
  const given = new URLSearchParams(location.hash.slice(1)).get("token");
  if (given) {
    sessionStorage.setItem(kToken, given);
    history.replaceState(null, "", location.pathname + location.search);
  }
  return given ?? pageToken();
}

/** The address of another page of this station, with what that page needs; by the door no token is needed. */
export function pageAddress(path: string, query: Record<string, string> = {}): string {
  const search = new URLSearchParams(query).toString();
  const token = pageToken();
  return `${path}${search ? `?${search}` : ""}${token ? `#token=${token}` : ""}`;
}

/** Opens a page of the station, which is of no exercise. */
export function openPage(title: string): Page {
  const page = open(title);
  return dress(page, new TopBar(page.link, title));
}

/** Opens a page of an exercise. title: of the seat; view: the topic by which the seat sees the exercise. */
export function openExercisePage(title: string, view: TopicName): ExercisePage {
  const page = open(title);
  const { link } = page;
  const alerts = new AlertPanel(link);
  const topBar = new TopBar(link, title, alerts);
  document.body.append(alerts.element, silence(link, view, topBar, alerts));
  link.on("Daylight", (light) => proposePalette(light.time_of_day));
  return { ...dress(page, topBar), alerts };
}

function open(title: string): Omit<Page, "topBar"> {
  titlePage(title);
  const query = new URLSearchParams(location.search);
  const still = query.get("still") === "1";
  document.documentElement.classList.toggle("still", still);
  const link = new Connection(takeToken(), query.get("exercise") ?? undefined);
  return { link, root: byId("page"), still };
}

/** Puts around the page what all pages have. */
function dress(page: Omit<Page, "topBar">, topBar: TopBar): Page {
  document.body.classList.add("obc-component-size-regular");
  document.body.prepend(topBar.element);
  document.body.append(veil(page.link));
  return { ...page, topBar };
}

/** Lies over the page while nothing is heard: what it shows then is old. */
function veil(link: Connection): HTMLElement {
  const title = h("strong", {}, t("No connection"));
  const text = h("p", {});
  const element = h("div", { class: "veil", role: "alert", hidden: true }, title, text);
  link.onState((state) => {
    element.hidden = state === "open";
    if (state === "connecting") text.textContent = t("Looking for the station program ...");
    else if (state === "lost")
      text.textContent = t("What is shown is old. Levers were let go. Trying again until the station answers ...");
    else if (state === "refused") {
      title.textContent = link.hello ? t("This station was started again") : t("Not let in");
      text.textContent = link.hello
        ? t("This page is of its earlier run and stays shut. Open the address that the station has printed anew.")
        : t("The station says: {refusal}.", { refusal: link.refusal });
    } else if (state === "closed") text.textContent = t("This page and the station do not fit together: load it anew.");
  });
  return element;
}

/** Says how long the server has not been heard, where it was; what is shown then is grey. */
function silence(link: Connection, view: TopicName, topBar: TopBar, alerts: AlertPanel): HTMLElement {
  const element = h("p", { class: "silence", role: "status", hidden: true });
  const live = new LiveWatch(link, view);
  let unheard = false;
  everySecond(4, (now) => {
    const silent = Math.floor(live.look(now) / 1000); // s
    setShown(element, silent > 0);
    document.documentElement.classList.toggle("stale", silent > 0);
    topBar.showSilent(silent > 0);
    if (isUnheard(link) !== unheard) {
      unheard = !unheard;
      alerts.update();
    }
    if (silent > 0)
      setText(element, t("Nothing heard of the exercise for {silent} s: what is shown is old", { silent }));
  });
  return element;
}

/** Calls back before each frame that the browser draws, with ms of performance.now(); not while the page is hidden. */
export function everyFrame(draw: (now: number) => void): void {
  const next = (now: number): void => {
    requestAnimationFrame(next);
    draw(now);
  };
  requestAnimationFrame(next);
}

/** Calls back so many times a second: 20 for gauges, 4 for digits. */
export function everySecond(times: number, draw: (now: number) => void): void {
  setInterval(() => draw(performance.now()), 1000 / times);
}
