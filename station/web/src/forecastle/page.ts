// The forecastle's page, put together: picture, stand, orders, reports, log, sound, and the hands that work it.

import { orderAloud } from "../kit/aloud";
import { Briefing } from "../kit/briefing";
import { h, setAttribute } from "../kit/dom";
import { Freeze } from "../kit/freeze";
import { HintLine } from "../kit/instructions";
import { nextPalette } from "../kit/palette";
import { everyFrame, openExercisePage } from "../kit/page";
import { kByHand } from "../kit/orders";
import { otherSeat } from "../kit/other_seat";
import { OwnMarks } from "../kit/own_marks";
import { Speech } from "../kit/speech";
import { AlertPriority } from "../wire/generated";
import { Captions, perceived } from "./captions";
import { ControllerMemory } from "./controller";
import { ControllerDialog } from "./controller_dialog";
import { FirstVisit } from "./first_visit";
import { GamepadReader } from "./gamepad";
import { cableSpeed } from "./heard";
import { Help } from "./help";
import { listenToKeys } from "./keyboard";
import { Log } from "./log";
import { Men } from "../kit/men";
import { Orders } from "./orders";
import { Popover } from "../kit/popover";
import { Reports } from "./reports";
import { SceneView } from "./scene_view";
import { Sounds } from "./sounds";
import { Stand } from "./stand";
import { Work } from "./work";
import { unfoldButton } from "../kit/unfold";
import { t } from "../kit/language";
import { eventText } from "../kit/words";

const kFresh = 5; // s of exercise time

const alarmWords: Partial<Record<AlertPriority, string>> = {
  [AlertPriority.ALERT_WARNING]: t("a warning sounds"),
  [AlertPriority.ALERT_ALARM]: t("an alarm sounds"),
  [AlertPriority.ALERT_EMERGENCY]: t("the emergency alarm sounds"),
};

/** The panel of the orders. On a phone it is a line of the newest, which a touch of its words or its button unfolds. */
function heard(orders: Orders): HTMLElement {
  const element = h(
    "section",
    { class: "panel heard", "aria-label": t("orders") },
    h("h2", {}, t("Orders from the bridge")),
    orders.element,
  );
  const unfold = unfoldButton(element, t("all orders"), "\u25be");
  orders.element.addEventListener("click", ({ target }) => {
    if (!(target as Element).closest("button")) unfold.click();
  });
  element.append(unfold);
  return element;
}

/** Opens the page in <main id="page">. */
export function openForecastle(): void {
  const page = openExercisePage(t("Forecastle"), "ForecastleView");
  const { link } = page;
  const stand = new Stand(link);
  const scene = new SceneView(page);
  const captions = new Captions();
  scene.over.append(captions.element);
  // Over the picture: in the panel of the orders it would leave these no room.
  scene.element.append(new HintLine(link, "forecastle").element);
  const popover = new Popover(scene.element);
  const tell = (text: string): void => stand.tell(text);
  const reports = new Reports(link, new Work(link), () => stand.side, tell);
  // Over the reports: the men who are set to work are to be seen in the picture meanwhile.
  const men = new Men(link, () => stand.side, new Popover(reports.element), tell);
  stand.head.append(men.button);
  const orders = new Orders(link, popover, (question, from) => reports.answer(question, from), tell);
  const sounds = new Sounds(page, stand, orders, () => scene.ears());
  const speech = new Speech();
  orders.onOrder((order) => order.text !== kByHand && isFresh(order.time) && speech.say(orderAloud(order)));
  link.on(
    "ForecastleEvent",
    (event) => event.code === "report.not_heard" && isFresh(event.time) && tell(eventText(event)),
  );
  const marks = new OwnMarks(link, "forecastle");
  const briefing = new Briefing(link, marks, "forecastle");
  const firstVisit = new FirstVisit(page.root);
  const help = new Help(
    () => controllers.show(),
    () => firstVisit.open(),
  );
  const helpButton = h("button", { class: "plain", "aria-label": t("help: keys"), onclick: () => help.toggle() }, "?");
  page.topBar.middle.append(otherSeat(link, "bridge"), speech.button, briefing.button, marks.button, helpButton);
  page.root.className = "forecastle";
  page.root.append(
    firstVisit.element,
    scene.element,
    stand.element,
    heard(orders),
    reports.element,
    h("section", { class: "panel noticed", "aria-label": t("log") }, h("h2", {}, t("Log")), new Log(link).element),
  );
  if (!page.still) firstVisit.begin();
  document.body.append(help.element, briefing.element, marks.element, new Freeze(link, "forecastle").element);
  page.topBar.element.after(briefing.lessonOver);
  stand.onSide((side) => {
    scene.setSide(side);
    reports.showSide();
    men.show();
  });

  const memory = new ControllerMemory();
  const controllers = new ControllerDialog(memory);
  const pad = new GamepadReader({ ...hands(), menu: step, choose }, memory, () => controllers.open);
  document.body.append(controllers.element);
  addEventListener("gamepadconnected", ({ gamepad }) => {
    if (!memory.of(gamepad)) tell(t("{name}: not yet taught what it moves (?, Controllers)", { name: gamepad.id }));
  });
  listenToKeys(hands());
  everyFrame((now) => {
    pad.poll();
    controllers.draw();
    if (!page.still) pad.shake(link.latest("ForecastleView", stand.side), now);
    stand.draw(now);
    showHeard(now);
  });
  Object.assign(window, { windlass: { link, stats: () => scene.stats() } }); // for tests and measurements

  function hands() {
    return {
      wheel: (share: number) => stand.hand.runWheel(share),
      turn: (turns: number) => stand.hand.turnWheel(turns),
      key: (way: number, fine: boolean, at?: number) => stand.hand.pressWheel(way, fine, at),
      spin: (to: number) => stand.hand.spinWheel(to),
      push: (to: number, at?: number) => stand.hand.pushSpeed(to, at),
      release: (at?: number) => stand.hand.releaseSpeed(at),
      zero: () => stand.hand.releaseSpeed(),
      clutch: (held: boolean) => (held ? stand.clutch.guard.press() : stand.clutch.guard.release()),
      stopper: (held: boolean) => (held ? stand.stopper.guard.press() : stand.stopper.guard.release()),
      stop: (held: boolean) => (held ? stand.stop.guard.press() : stand.stop.guard.release()),
      side: () => stand.nextSide(),
      camera: (number: number) => scene.lookNumber(number),
      mute: () => page.alerts.sound.toggle(),
      palette: nextPalette,
      captions: () => captions.toggle(),
      lamp: () => scene.switchLamp(),
      report: () => reports.focus(),
      repeat: () => orders.repeatNewest(),
      acknowledge: () => page.alerts.acknowledgeTopmost(),
      silence: () => page.alerts.silenceAll(),
      help: () => help.toggle(),
    };
  }

  /** Of now, not told again to a page that came late. time: s, exercise time. */
  function isFresh(time: number): boolean {
    return time > (link.latest("ExerciseStatus")?.time ?? Infinity) - kFresh;
  }

  /** Buttons of an open choice, or of the report pad. */
  function choices(): HTMLElement[] {
    const open = page.root.querySelector(".popover");
    return [...(open ?? reports.element).querySelectorAll<HTMLElement>("button, [role=button]")];
  }
  function step(by: number): void {
    const all = choices();
    const at = all.indexOf(document.activeElement as HTMLElement);
    all[at < 0 ? 0 : (at + by + all.length) % all.length]?.focus();
  }
  function choose(): boolean {
    const focused = document.activeElement as HTMLElement;
    if (!choices().includes(focused)) return false;
    focused.dispatchEvent(new MouseEvent("click", { bubbles: true }));
    return true;
  }

  function showHeard(now: number): void {
    const view = link.latest("ForecastleView", stand.side);
    const tackle = stand.tackle();
    setAttribute(page.root, "data-vibration", page.still ? undefined : `${view?.vibration ?? 0}`);
    if (!view || !tackle) return;
    const speed = cableSpeed(link.track("ForecastleView", stand.side), tackle.chain_diameter, now);
    const alarm = page.alerts.sounding();
    captions.show(
      {
        ...perceived(view, speed, tackle.drive === "hydraulic"),
        alarm: (alarm && alarmWords[alarm.priority]) ?? "",
        ...sounds.captions(now),
      },
      now,
    );
  }
}
