// The plan: own ship to scale, track, anchors, circles, chart with coast and marks, bearings. It knows nothing of the
// link: update() feeds it.
//
//   const plan = new PlanView(container);
//   plan.update({ ship, lines: [{ kind: "track", points }], circles, marks, soundings, landmarks, wind, stream });
//   plan.onCircle((id, radius) => ...);   // a rim was dragged
//
// A plan that is made with a ParallelIndex has its lines and its button, too.
//
// It draws only what changed, 20 times a second at most, and follows palette, size and pixel density by itself.

import "./plan.css";

import { h } from "../kit/dom";
import { onPalette } from "../kit/palette";
import { Popover } from "../kit/popover";
import { degrees, radians } from "../kit/units";
import { planColours } from "./colours";
import * as layers from "./layers";
import { Lettering } from "./lettering";
import { indexForm } from "./index_form";
import { type Grip, Measuring } from "./measuring";
import { type ParallelIndex, kIndexUnits } from "./parallel_index";
import { type PlanPicture, type PlanShip, emptyPicture } from "./picture";
import { type Pixel, Projection, distance } from "./projection";
import { land, surroundings } from "./surroundings";
import { PlanTools } from "./tools";
import { t } from "../kit/language";

const kBetweenDraws = 50; // ms
const kReach = 16; // px, within which a grip is taken

export class PlanView {
  readonly element: HTMLElement;
  readonly measuring = new Measuring();
  readonly at = new Projection();
  private readonly canvas = h("canvas", {
    class: "plan-canvas",
    tabIndex: 0,
    role: "application",
    "aria-label": t("plan: arrows move it, plus and minus zoom, Home brings own ship back"),
  });
  private readonly tools: PlanTools;
  private readonly popover: Popover;
  private picture: PlanPicture = emptyPicture();
  private colours = planColours();
  private headUp_ = false;
  private rings_ = true;
  private follows_ = true;
  private drawn = 0; // ms, when last
  private waiting = false;
  private placed = false; // whether it has come to own ship once
  private readonly fingers = new Map<number, Pixel>();
  private held: Grip | undefined;
  private readonly circleListeners = new Set<(id: string, radius: number) => void>();

  constructor(
    container: HTMLElement,
    readonly index?: ParallelIndex,
  ) {
    this.tools = new PlanTools(this);
    this.element = h("div", { class: "plan" }, this.canvas, this.tools.element);
    this.popover = new Popover(this.element);
    index?.onChange(() => this.redraw());
    container.append(this.element);
    this.at.scale = 0.8; // px/m: a ship of 225 m is 180 px long
    this.listen();
    new ResizeObserver(() => this.resize()).observe(this.element);
    onPalette(() => {
      this.colours = planColours();
      this.redraw();
    });
    this.resize();
  }

  /** Takes what is given and keeps the rest of what it showed. */
  update(change: Partial<PlanPicture>): void {
    this.picture = { ...this.picture, ...change };
    this.redraw();
  }

  get ship(): PlanShip | undefined {
    return this.picture.ship;
  }

  /** Calls back with the id and new radius (m) of an editable circle whose rim is dragged. */
  onCircle(listener: (id: string, radius: number) => void): void {
    this.circleListeners.add(listener);
  }

  get headUp(): boolean {
    return this.headUp_;
  }
  set headUp(on: boolean) {
    this.headUp_ = on;
    this.redraw();
  }
  get rings(): boolean {
    return this.rings_;
  }
  set rings(on: boolean) {
    this.rings_ = on;
    this.redraw();
  }
  /** Whether own ship stays in the middle; a hand that moves the plan ends it. */
  get follows(): boolean {
    return this.follows_;
  }
  set follows(on: boolean) {
    this.follows_ = on;
    this.redraw();
  }

  zoom(factor: number, about: Pixel = { x: this.at.width / 2, y: this.at.height / 2 }): void {
    this.at.zoom(factor, about);
    this.redraw();
  }

  /** Brings own ship, plotted anchors and all circles into sight. */
  fit(): void {
    const { ship, marks, circles } = this.picture;
    const round = [...circles, ...marks.map((m) => ({ ...m, radius: 0 })), ...(ship ? [{ ...ship, radius: 150 }] : [])];
    if (!round.length) return;
    const west = Math.min(...round.map((r) => r.x - r.radius));
    const east = Math.max(...round.map((r) => r.x + r.radius));
    const south = Math.min(...round.map((r) => r.y - r.radius));
    const north = Math.max(...round.map((r) => r.y + r.radius));
    this.follows_ = false;
    this.at.centre = { x: (west + east) / 2, y: (south + north) / 2 };
    const widest = this.headUp_ ? Math.hypot(east - west, north - south) : 0; // however she heads
    this.at.scale =
      0.94 *
      Math.min(
        this.at.width / Math.max(east - west, widest, 50),
        (this.at.height - 50) / Math.max(north - south, widest, 50),
      );
    this.redraw();
  }

  /** Puts the ruler on the screen, or takes it away. */
  toggleRuler(): void {
    const { ruler } = this.measuring;
    ruler.on = !ruler.on;
    ruler.from = this.at.toWorld({ x: this.at.width * 0.4, y: this.at.height * 0.35 });
    ruler.to = this.at.toWorld({ x: this.at.width * 0.6, y: this.at.height * 0.35 });
    this.redraw();
  }

  /** Opens the form of the parallel index, or shuts it. */
  showIndex(from: HTMLElement): void {
    if (!this.index) return;
    const inSight = (0.2 * Math.min(this.at.width, this.at.height)) / this.at.scale;
    const fresh = (): { course: number; off: number } => ({
      course: Math.round(degrees(this.ship?.heading ?? 0)) * radians(1),
      off: Math.max(1, Math.round(inSight / kIndexUnits.cable)) * kIndexUnits.cable,
    });
    this.popover.show(t("Parallel index"), from, ...indexForm(this.index, fresh));
  }

  /** Puts a bearing line on own ship, half the screen long, or takes it away. */
  toggleBearing(which: 0 | 1): void {
    const l = this.measuring.lines[which];
    l.on = !l.on;
    l.forward = 0;
    if (l.on) this.fitRange(which);
    this.redraw();
  }

  /** Lays the first bearing line in that direction, rad clockwise from north, from m forward of midships. */
  layBearing(bearing: number, forward: number): void {
    const l = this.measuring.lines[0];
    l.forward = forward;
    l.bearing = bearing;
    if (!l.on) this.fitRange(0);
    l.on = true;
    this.redraw();
  }

  private fitRange(which: 0 | 1): void {
    this.measuring.lines[which].range = layers.roundLength(
      (0.35 * Math.min(this.at.width, this.at.height)) / this.at.scale,
    );
  }

  /** Draws as soon as it may. */
  redraw(): void {
    if (this.waiting) return;
    this.waiting = true;
    const wait = Math.max(0, this.drawn + kBetweenDraws - performance.now());
    setTimeout(() => requestAnimationFrame(() => this.draw()), wait);
  }

  private draw(): void {
    this.waiting = false;
    this.drawn = performance.now();
    const { picture, at } = this;
    const c = this.canvas.getContext("2d");
    if (!c) return;
    if (picture.ship && (this.follows_ || !this.placed)) {
      at.centre = { x: picture.ship.x, y: picture.ship.y };
      this.placed = true;
    }
    at.up = this.headUp_ ? (picture.ship?.heading ?? 0) : 0;
    c.setTransform(this.canvas.width / at.width, 0, 0, this.canvas.height / at.height, 0, 0);
    c.fillStyle = this.colours.sea;
    c.fillRect(0, 0, at.width, at.height);
    c.font = `12px "Noto Sans", sans-serif`;
    const sheet = { c, at, colours: this.colours, lettering: new Lettering() };
    sheet.lettering.cover(...this.tools.boxes());
    layers.contours(sheet, picture.soundings);
    if (picture.landmarks) land(sheet, picture.landmarks.coasts);
    layers.soundings(sheet, picture.soundings);
    if (picture.landmarks) surroundings(sheet, picture.landmarks);
    if (picture.ship && this.rings_)
      layers.rings(sheet, picture.ship, layers.roundLength((0.3 * Math.min(at.width, at.height)) / at.scale));
    layers.lines(sheet, picture.lines);
    layers.circles(sheet, picture.circles);
    if (picture.ship) layers.ownShip(sheet, picture.ship);
    if (picture.ahead) layers.ahead(sheet, picture.ahead);
    layers.marks(sheet, picture.marks);
    layers.compassRose(sheet, picture);
    layers.scaleBar(sheet);
    sheet.lettering.write();
    this.index?.draw(sheet, picture.ship);
    this.measuring.draw(sheet, picture.ship);
    this.tools.update();
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.element;
    if (!clientWidth || !clientHeight) return;
    this.at.width = clientWidth;
    this.at.height = clientHeight;
    this.canvas.width = Math.round(clientWidth * devicePixelRatio);
    this.canvas.height = Math.round(clientHeight * devicePixelRatio);
    this.draw(); // at once: a canvas that was resized is empty
  }

  private grips(): Grip[] {
    const rims = this.picture.circles
      .filter((circle) => circle.editable)
      .map((circle): Grip => {
        const centre = this.at.toScreen(circle.x, circle.y);
        const at = { x: centre.x + circle.radius * this.at.scale, y: centre.y };
        return {
          at,
          hit: (finger) => Math.hypot(finger.x - at.x, finger.y - at.y),
          move: (to) => {
            const radius = Math.round(distance(circle, to));
            for (const listener of this.circleListeners) listener(circle.id, radius);
          },
        };
      });
    const { ship } = this.picture;
    return [...this.measuring.grips(this.at, ship), ...(this.index?.grips(this.at, ship) ?? []), ...rims];
  }

  private listen(): void {
    const place = (event: PointerEvent | WheelEvent): Pixel => {
      const box = this.canvas.getBoundingClientRect();
      return { x: event.clientX - box.left, y: event.clientY - box.top };
    };
    this.canvas.addEventListener("pointerdown", (event) => {
      this.canvas.setPointerCapture(event.pointerId);
      const finger = place(event);
      this.fingers.set(event.pointerId, finger);
      const nearest = this.grips()
        .map((grip) => ({ grip, far: grip.hit(finger) }))
        .sort((a, b) => a.far - b.far)[0];
      this.held = this.fingers.size === 1 && nearest && nearest.far < kReach ? nearest.grip : undefined;
    });
    this.canvas.addEventListener("pointermove", (event) => {
      const before = this.fingers.get(event.pointerId);
      if (!before) return;
      const now = place(event);
      this.fingers.set(event.pointerId, now);
      if (this.held) this.held.move(this.at.toWorld(now));
      else this.drag(event.pointerId, before, now);
      this.redraw();
    });
    for (const end of ["pointerup", "pointercancel", "lostpointercapture"] as const)
      this.canvas.addEventListener(end, (event) => {
        this.fingers.delete(event.pointerId);
        if (!this.fingers.size) this.held = undefined;
      });
    this.canvas.addEventListener(
      "wheel",
      (event) => {
        event.preventDefault();
        this.zoom(Math.exp(-event.deltaY / 600), this.follows_ ? undefined : place(event));
      },
      { passive: false },
    );
    this.canvas.addEventListener("keydown", (event) => this.key(event));
  }

  /** One finger moves the plan, two zoom it. */
  private drag(moved: number, before: Pixel, now: Pixel): void {
    const other = [...this.fingers].find(([id]) => id !== moved)?.[1];
    if (other) {
      const apart = (p: Pixel): number => Math.max(8, Math.hypot(p.x - other.x, p.y - other.y));
      this.at.zoom(apart(now) / apart(before), { x: (now.x + other.x) / 2, y: (now.y + other.y) / 2 });
    } else {
      this.follows_ = false;
      this.at.pan(now.x - before.x, now.y - before.y);
    }
  }

  private key(event: KeyboardEvent): void {
    const step = 60; // px
    const moves: Record<string, [number, number]> = {
      ArrowLeft: [step, 0],
      ArrowRight: [-step, 0],
      ArrowUp: [0, step],
      ArrowDown: [0, -step],
    };
    const move = moves[event.key];
    if (move) {
      this.follows_ = false;
      this.at.pan(...move);
    } else if (event.key === "+" || event.key === "=")
      this.at.zoom(1.25, { x: this.at.width / 2, y: this.at.height / 2 });
    else if (event.key === "-") this.at.zoom(0.8, { x: this.at.width / 2, y: this.at.height / 2 });
    else if (event.key === "Home") this.follows_ = true;
    else return;
    event.preventDefault();
    event.stopPropagation(); // the page's own keys do not act as well
    this.redraw();
  }
}
