// The bridge's instruments, as BridgeView has them; what has failed says so instead of a figure.

import "@oicl/openbridge-webcomponents/dist/navigation-instruments/compass/compass.js";

import { h, setAttribute } from "../kit/dom";
import { bearing, bearingToTenth, degrees, figure, kNauticalMile, knots, timeOfDay, sideWord } from "../kit/units";
import { type Position, originOf, positionAt, positionWords } from "../surroundings/position";
import type { BridgeView, Landmarks } from "../wire/generated";
import { DepthTrace } from "./depth_trace";
import { Readout } from "./readout";
import { type Wind, trueWind } from "./wind";
import { t } from "../kit/language";

const kTurn = 30; // degrees a minute, at the end of the compass's bar

/**
 * Two lines of a place, m in the world: its latitude and longitude, or, where the exercise lies nowhere on earth,
 * "12 m E", "340 m S" from the chart's origin.
 */
export function placeWords(x: number, y: number, origin: Position | undefined): [string, string] {
  if (!origin)
    return [`${figure(Math.abs(x))} m ${x < 0 ? "W" : "E"}`, `${figure(Math.abs(y))} m ${y < 0 ? "S" : "N"}`];
  const { latitude, longitude } = positionWords(positionAt(origin, x, y));
  return [latitude, longitude];
}

/** The true wind, where anemometer, gyro and GPS work. */
export function windOf(view: BridgeView): Wind | undefined {
  if (!view.anemometer_works || !view.gyro_works || !view.gps_works) return undefined;
  return trueWind(
    view.wind_speed_apparent,
    view.wind_from_apparent,
    view.heading,
    view.course_over_ground,
    view.speed_over_ground,
  );
}

export class Instruments {
  readonly element: HTMLElement;
  private readonly compass = h("obc-compass" as "div", { "aria-hidden": "true" });
  private readonly dial = h("div", { class: "compass", role: "img" });
  private readonly heading = new Readout("HDG", "\u00b0");
  private readonly turn = new Readout("ROT", "\u00b0/min", 300);
  private readonly overGround = new Readout("SOG", "kn", 30);
  private readonly course = new Readout("COG", "\u00b0");
  private readonly log = new Readout("LOG", "kn", 30);
  private readonly position = new Readout("GPS", "", 1e7);
  private readonly depth = new Readout(t("Below keel"), "m", 1000);
  private readonly trace = new DepthTrace();
  private readonly apparent = new Readout(t("Wind, apparent"), "kn", 120);
  private readonly wind = new Readout(t("Wind, true"), "kn", 120);
  private readonly clock = new Readout(t("Local time"), "", 24);
  private origin: Position | undefined; // of the chart
  private view: BridgeView | undefined; // to be shown with the next frame
  private readonly sight = new Readout(t("Visibility"), t("NM"), 100);

  constructor() {
    Object.assign(this.compass, {
      showLabels: true,
      state: "active",
      priority: "enhanced",
      rotType: "bar",
      rotMaxValue: kTurn,
    });
    this.position.element.classList.add("place");
    // It computes with its size, and complains where it has none: so it is in the page only where there is room.
    const room = matchMedia("(min-height: 901px) and (min-width: 600px)");
    const place = (): void => (room.matches ? this.dial.replaceChildren(this.compass) : this.dial.replaceChildren());
    room.addEventListener("change", place);
    place();
    this.element = h(
      "section",
      { class: "panel instruments", "aria-label": t("instruments") },
      this.dial,
      h(
        "div",
        { class: "readouts" },
        ...[this.heading, this.turn, this.overGround, this.course, this.log, this.position].map((r) => r.element),
        this.depth.element,
        h("div", { class: "trace" }, this.trace.element),
        ...[this.apparent, this.wind, this.clock, this.sight].map((r) => r.element),
      ),
    );
  }

  /** The chart by which a position is told. */
  setLandmarks(landmarks: Landmarks): void {
    this.origin = originOf(landmarks);
  }

  update(view: BridgeView): void {
    this.trace.add(view.time, view.echo_sounder_works ? view.depth_below_keel : undefined);
    const due = this.view !== undefined;
    this.view = view;
    if (!due) requestAnimationFrame(() => this.show()); // once a frame: the past comes all at once
  }

  private show(): void {
    const view = this.view!;
    this.view = undefined;
    if (view.gyro_works) {
      this.heading.show(degrees(view.heading), bearingToTenth(view.heading));
      const turn = degrees(view.rate_of_turn) * 60;
      this.turn.show(
        turn,
        figure(Math.abs(turn), 1),
        Math.abs(turn) < 0.05 ? t("steady") : turn > 0 ? t("to starboard") : t("to port"),
      );
    } else {
      this.heading.fail();
      this.turn.fail();
    }
    if (view.gps_works) {
      const speed = knots(view.speed_over_ground);
      this.overGround.show(speed, figure(speed, 1));
      if (view.speed_over_ground > 0)
        this.course.show(degrees(view.course_over_ground), bearingToTenth(view.course_over_ground));
      else this.course.show(0, "---");
      this.position.show(view.position.x, ...placeWords(view.position.x, view.position.y, this.origin));
    } else for (const readout of [this.overGround, this.course, this.position]) readout.fail();
    if (view.log_works) {
      const speed = knots(view.speed_through_water);
      this.log.show(
        speed,
        figure(Math.abs(speed), 1),
        Math.abs(speed) < 0.05 ? "" : speed > 0 ? t("ahead") : t("astern"),
      );
    } else this.log.fail();
    if (view.echo_sounder_works) this.depth.show(view.depth_below_keel, figure(view.depth_below_keel, 1));
    else this.depth.fail();
    this.showWind(view);
    this.clock.show(view.time_of_day / 3600, timeOfDay(view.time_of_day));
    const miles = view.visibility / kNauticalMile;
    this.sight.show(miles, figure(miles, miles < 10 ? 1 : 0));
    this.showDial(view);
  }

  private showWind(view: BridgeView): void {
    if (!view.anemometer_works) {
      this.apparent.fail();
      this.wind.fail();
      return;
    }
    const bow = Math.atan2(Math.sin(view.wind_from_apparent), Math.cos(view.wind_from_apparent));
    const speed = knots(view.wind_speed_apparent);
    const side =
      Math.abs(degrees(bow)) < 0.5
        ? t("ahead")
        : `${figure(Math.abs(degrees(bow)))}\u00b0 ${sideWord(bow > 0 ? 1 : 0)}`;
    this.apparent.show(speed, figure(speed, 1), side);
    const wind = windOf(view);
    if (wind)
      this.wind.show(
        knots(wind.speed),
        figure(knots(wind.speed), 1),
        t("from {bearing}°", { bearing: bearing(wind.from) }),
      );
    else this.wind.fail();
  }

  private showDial(view: BridgeView): void {
    setAttribute(this.dial, "data-failed", view.gyro_works ? undefined : "");
    setAttribute(
      this.dial,
      "aria-label",
      view.gyro_works
        ? t("compass: heading {heading} degrees", { heading: bearing(view.heading) })
        : t("compass: gyro failed"),
    );
    if (!this.compass.isConnected) return;
    const wind = windOf(view);
    Object.assign(this.compass, {
      heading: degrees(view.heading),
      rotationsPerMinute: Math.max(-kTurn, Math.min(kTurn, degrees(view.rate_of_turn) * 60)), // of the bar: degrees
      courseOverGround:
        view.gps_works && view.speed_over_ground > 0 ? degrees(view.course_over_ground) : degrees(view.heading),
      windSpeed: wind ? knots(wind.speed) : null,
      windFromDirection: wind ? degrees(wind.from) : null,
    });
  }
}
