// The desk put together: run bar on top, what breaks and blows on the left, pictures and plots in the middle, levers,
// truth, talk and log on the right, the timeline below.

import { h } from "../kit/dom";
import { showsTopic } from "../kit/live";
import { type Page, pageAddress } from "../kit/page";
import { sideWord } from "../kit/units";
import { PlotBoard } from "../plots/board";
import { Ahead } from "./ahead";
import { AskedBar } from "./asked";
import { BridgeAsks } from "./bridge_asks";
import { Desk } from "./desk";
import { EnvironmentPanel } from "./environment";
import { FaultPanel } from "./faults";
import { LeverPanel } from "./levers";
import { LogPanel } from "./log";
import { MarksPanel } from "./marks";
import { Projector } from "./projector";
import { ReplayBar } from "./replay_bar";
import { RunBar } from "./run_bar";
import { tabs } from "./tabs";
import { TalkPanel } from "./talk";
import { Timeline } from "./timeline";
import { TruthPanel } from "./truth";
import { Views } from "./views";
import { t } from "../kit/language";

/** Which windlass is plotted and proposed: port or starboard. */
function sideChoice(desk: Desk): HTMLElement {
  const buttons = [0, 1].map((side) =>
    h("button", { class: "chip", "data-side": side, onclick: () => (desk.side = side) }, sideWord(side)),
  );
  desk.onSide((side) => buttons.forEach((button, i) => button.setAttribute("aria-pressed", `${i === side}`)));
  desk.onSides((sides) => {
    buttons.forEach((button, side) => (button.hidden = !sides.includes(side)));
    if (!sides.includes(desk.side)) desk.side = sides[0] ?? 0;
  });
  return h("div", { class: "chips", role: "group", "aria-label": t("windlass that is plotted") }, ...buttons);
}

export function makeDesk(page: Page): void {
  const desk = new Desk(page);
  const run = new RunBar(desk);
  run.element.append(new AskedBar(desk).element, new BridgeAsks(desk).element);
  const replay = new ReplayBar(desk);
  const plots = new PlotBoard(desk.link);
  desk.past.add(plots);
  const ahead = new Ahead(desk, page.root);
  plots.ahead = () => ahead.shown;
  const views = new Views(desk, page.still, () => ahead.shown);
  const pick = (time: number): void => (desk.replay ? replay.seek(replay.positionOf(time)) : run.suggest(time));
  const timeline = new Timeline(desk, {
    pick,
    seek: (position) => replay.seek(position),
    positionOf: (time) => replay.positionOf(time),
  });
  const projector = new Projector(desk, page.root, plots, timeline);
  plots.element.querySelector(".plot-bar")!.prepend(views.choice, sideChoice(desk), projector.choice, projector.button);
  plots.element.querySelector(".plot-bar")!.append(ahead.element);
  desk.onSide((side) => (plots.side = side));
  desk.events.onChange(() => (plots.flags = timeline.flags()));
  plots.onCursor((time) => timeline.showCursor(time));
  const panel = (title: string, content: HTMLElement): HTMLElement =>
    h("section", { class: "panel", "aria-label": title }, h("h2", {}, title), content);
  page.topBar.middle.append(
    ...(page.link.byDoor ? [h("a", { class: "plain", href: "/class" }, t("Class"))] : []),
    h("a", { class: "plain", href: pageAddress("/classroom") }, t("Classroom")),
    h("a", { class: "plain", href: pageAddress("/lessons"), "data-gives": "files" }, t("Lessons")),
  );
  page.root.classList.add("desk");
  page.root.append(
    run.element,
    replay.element,
    projector.figures,
    desk.notice,
    h(
      "div",
      { class: "left panel" },
      tabs(t("what breaks, what blows, what it earns"), [
        { id: "faults", title: t("Faults"), content: new FaultPanel(desk).element },
        { id: "environment", title: t("Environment"), content: new EnvironmentPanel(desk).element },
        { id: "marks", title: t("Marks"), content: new MarksPanel(desk).element },
      ]),
    ),
    h("div", { class: "middle" }, views.element, plots.element),
    h(
      "div",
      { class: "right" },
      tabs(t("levers, truth, talk, log"), [
        { id: "levers", title: t("Levers"), content: panel(t("Levers"), new LeverPanel(desk).element) },
        { id: "truth", title: t("Truth"), content: panel(t("Truth beside gauges"), new TruthPanel(desk).element) },
        { id: "talk", title: t("Talk"), content: panel(t("Orders and reports"), new TalkPanel(desk).element) },
        { id: "log", title: t("Log"), content: panel(t("Log"), new LogPanel(desk, pick).element) },
      ]),
    ),
    timeline.element,
  );
  showsTopic(views.element, desk.link, "ShipState");
  showsTopic(plots.element, desk.link, "WindlassLoad", () => desk.side);
  const showMode = (): void => {
    page.root.classList.toggle("in-replay", desk.replay);
    desk.withholdFrom(document.body);
    run.element.hidden = desk.replay;
    replay.element.hidden = !desk.replay;
  };
  desk.link.on("ExerciseStatus", showMode);
  desk.link.on("ReplayStatus", showMode);
  desk.link.onMessage("hello", showMode);
  showMode();
}
