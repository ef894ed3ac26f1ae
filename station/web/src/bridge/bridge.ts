// The bridge: instruments, plan, helm, and either the line to the forecastle or the anchor watch beside them.

import "./bridge.css";

import { orderAloud, reportAloud } from "../kit/aloud";
import { Briefing } from "../kit/briefing";
import { Freeze } from "../kit/freeze";
import { HintLine } from "../kit/instructions";
import { h, setAttribute } from "../kit/dom";
import { showsTopic } from "../kit/live";
import { LightsAndShapesPanel } from "../kit/lights_and_shapes";
import { type ExercisePage, everyFrame, everySecond, openExercisePage } from "../kit/page";
import { otherSeat } from "../kit/other_seat";
import { OwnMarks } from "../kit/own_marks";
import { Practice } from "../kit/practice";
import { Speech } from "../kit/speech";
import { ParallelIndex } from "../plan/parallel_index";
import { PlanView } from "../plan/plan_view";
import { bridgeEye } from "../surroundings/bridge_eye";
import { AnchorPlot } from "./anchor_plot";
import { HelmBar } from "./helm_bar";
import { ghostFigures } from "./ghost";
import { HelmHand } from "./helm_hand";
import { helpDialog } from "./help";
import { Instruments } from "./instruments";
import { PadHand, listenToKeys } from "./keys";
import { Line } from "./line";
import { OrderPanel } from "./orders";
import { OwnOrder } from "./own_order";
import { PlanFeed } from "./plan_feed";
import { Telegraph } from "./telegraph";
import { Thrusters } from "./thrusters";
import { ViewOut } from "./view_out";
import { WatchPanel } from "./watch_panel";
import { Wheel } from "./wheel";
import { t } from "../kit/language";

const kRudderMax = (35 * Math.PI) / 180; // rad, until the ship's own is heard

/** Opens the page. beside: what stands beside the plan at first. */
export function openBridge(title: string, beside: "orders" | "watch"): ExercisePage {
  const page = openExercisePage(title, "BridgeView");
  const { link } = page;
  const helm = new HelmHand(link, () => link.latest("SceneDescription")?.rudder_max ?? kRudderMax);
  const bar = new HelmBar(helm);
  const instruments = new Instruments();
  const telegraph = new Telegraph(helm);
  const wheel = new Wheel(helm);
  const thrusters = new Thrusters(helm);
  const line = new Line(link);
  const anchors = new AnchorPlot(link, line);
  const watch = new WatchPanel(link, anchors);
  const shown = new LightsAndShapesPanel(link).element;
  const plan = h("section", { class: "plan-panel", "aria-label": t("plan") });
  const help = helpDialog();
  const marks = new OwnMarks(link, "bridge");
  const briefing = new Briefing(link, marks, "bridge");
  const speech = new Speech();
  line.onReport(({ report, fresh }) => fresh && speech.say(reportAloud(report)));
  const own = new OwnOrder(link, line);
  own.onOrder((order) => speech.say(orderAloud(order)));

  page.topBar.middle.append(
    bar.element,
    otherSeat(link, "forecastle"),
    speech.button,
    briefing.button,
    marks.button,
    h("button", { class: "plain", type: "button", "aria-label": t("help"), onclick: () => help.showModal() }, "?"),
  );
  // Where the page is narrow, plan and view take turns.
  const look = (out: boolean): void => setAttribute(page.root, "data-looks-out", out ? "" : undefined);
  const index = new ParallelIndex();
  link.on("ExerciseStatus", ({ exercise }) => index.belongsTo(link.hello?.exercise ?? exercise));
  const chart = new PlanView(plan, index);
  const view = new ViewOut(
    page,
    h("button", { class: "plain to-plan", type: "button", onclick: () => look(false) }, t("Plan")),
    (bearing) => chart.layBearing(bearing, bridgeEye(link.latest("SceneDescription")?.length_overall ?? 0)),
  );
  plan.append(h("button", { class: "plain to-view", type: "button", onclick: () => look(true) }, t("Look out")));
  const orders = new OrderPanel(link, line).element;
  orders.prepend(new HintLine(link, "bridge").element);
  const practice = new Practice(link, "bridge");
  orders.prepend(practice.element);
  page.root.classList.add("bridge");
  page.root.append(
    instruments.element,
    plan,
    view.element,
    h("div", { class: "hands" }, telegraph.element, wheel.element, thrusters.element),
    besidePlan(orders, h("div", { class: "watch-tab" }, shown, watch.element), beside),
  );
  document.body.append(help, briefing.element, marks.element, new Freeze(link, "bridge").element);
  page.topBar.element.after(own.element, briefing.lessonOver);
  new PlanFeed(link, chart, anchors, watch);

  link.on("Landmarks", (landmarks) => instruments.setLandmarks(landmarks));
  link.on("BridgeView", (view) => instruments.update(view));
  for (const shows of [instruments, telegraph, wheel, thrusters, watch]) showsTopic(shows.element, link, "BridgeView");
  showsTopic(plan, link, "BridgeView");
  everySecond(4, () => {
    bar.update();
    watch.update();
  });
  const pad = new PadHand(helm);
  everyFrame((now) => {
    pad.poll();
    helm.tick(now);
    const view = link.latest("BridgeView");
    telegraph.update(view?.engine);
    wheel.update(view?.rudder);
    thrusters.update(view);
    const ghost = practice.hands(now);
    telegraph.showGhost(ghost?.engine);
    wheel.showGhost(ghost?.rudder);
    practice.tell(ghost, ghost ? ghostFigures(ghost) : "");
  });
  listenToKeys(helm, {
    F2: () => page.alerts.acknowledgeTopmost(),
    F3: () => page.alerts.silenceAll(),
    "?": () => (help.open ? help.close() : help.showModal()),
  });
  return page;
}

/** Two panels, of which one is shown: tabs as WAI-ARIA has them. */
function besidePlan(orders: HTMLElement, watch: HTMLElement, first: "orders" | "watch"): HTMLElement {
  const panels = { orders, watch };
  const names = { orders: t("Forecastle"), watch: t("Anchor watch") };
  const keys = Object.keys(panels) as (keyof typeof panels)[];
  const tabs = keys.map((key) =>
    h(
      "button",
      {
        class: "plain",
        type: "button",
        role: "tab",
        id: `tab-${key}`,
        "aria-controls": `panel-${key}`,
        onclick: () => show(key),
      },
      names[key],
    ),
  );
  const show = (shown: string): void =>
    keys.forEach((key, k) => {
      panels[key].hidden = key !== shown;
      setAttribute(tabs[k]!, "aria-selected", `${key === shown}`);
      tabs[k]!.tabIndex = key === shown ? 0 : -1;
    });
  keys.forEach((key) => {
    panels[key].id = `panel-${key}`;
    setAttribute(panels[key], "role", "tabpanel");
    setAttribute(panels[key], "aria-labelledby", `tab-${key}`);
  });
  const list = h("div", { class: "tabs", role: "tablist", "aria-label": t("beside the plan") }, ...tabs);
  list.addEventListener("keydown", (event) => {
    if (event.key !== "ArrowLeft" && event.key !== "ArrowRight") return;
    const other = tabs.find((tab) => tab.tabIndex === -1)!;
    other.click();
    other.focus();
  });
  show(first);
  return h("div", { class: "panel beside" }, list, orders, watch);
}
