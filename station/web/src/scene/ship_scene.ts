// The picture: what a frame says, drawn on a canvas. Everything is placed from an origin near the ship, so that single
// precision holds millimetres; axes are the world's, z up.

import {
  type BufferGeometry,
  Group,
  MathUtils,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  NeutralToneMapping,
  OrthographicCamera,
  PCFShadowMap,
  PerspectiveCamera,
  Scene,
  type Texture,
  Vector3,
  Vector4,
  WebGLRenderer,
} from "three";
import type { Landmarks, SceneDescription, SeaState, SeabedDescription } from "../wire/generated";
import { AnchorSignals } from "./anchor_signals";
import { type CameraName, Cameras } from "./cameras";
import { otherSide, secured } from "./at_home";
import { type Deck, deckGear, railBreadth } from "./deck";
import { draughtMarks } from "./draught_marks";
import { Effects } from "./effects";
import { Flag } from "./flag";
import type { SceneFrame } from "./frame";
import { hullMesh } from "./hull";
import { kBulwark } from "./hull_outline";
import { LandmarksScene } from "./landmarks";
import { LampHalos } from "./lamp_halos";
import { TensionScale, kLegendHeight, kLegendWidth } from "./tension_scale";
import { Materials } from "./materials";
import { MenFigures } from "./men_figures";
import { noiseTexture, rippleTexture } from "./noise";
import { Pace } from "./pace";
import { FrameClock, type Quality, type QualityName, QualityWatch, kQuality, qualityOf } from "./quality";
import { type Rig, deckHeight } from "./rig";
import { SceneLight } from "./scene_light";
import { Sea } from "./sea";
import { Seabed } from "./seabed";
import { Spray, sprayed } from "./spray";
import { Sky, setSky, skyUniforms } from "./sky";
import { TackleScene } from "./tackle_scene";
import { type V3, shipAxes } from "./vec";
import { surface } from "./waves";

export type { CameraName } from "./cameras";
export type { Quality } from "./quality";

const kOriginMoves = 400; // m, from which the origin is laid anew
const kForecastle = 25; // m, its length
const kSeenThrough = -2.6; // m, to which steel is made out in the water from above
const kMatesOwn = new Set<CameraName>(["stand", "bow", "brake", "aft"]); // where who looks is the mate himself
const kClouds = [10, 21] as const; // m/s of wind, from which the sky closes, and at which it is closed
const kStillSteps = 45; // of 0.08 s, that smoke has risen in a still picture

/** What several scenes draw with, each on the whole of its canvas: a browser has 16 WebGL contexts for all pages. */
export class SharedRenderer {
  readonly canvas = document.createElement("canvas");
  readonly renderer: WebGLRenderer;
  readonly gl: WebGL2RenderingContext;
  readonly quality: "software" | "low";

  /** px. Throws where the browser has no WebGL 2. */
  constructor(
    readonly width: number,
    readonly height: number,
  ) {
    this.canvas.width = width;
    this.canvas.height = height;
    this.gl = contextOf(this.canvas, !probeSoftware());
    this.renderer = rendererOf(this.canvas, this.gl);
    this.renderer.setSize(width, height, false);
    this.quality = qualityOf(this.gl) === "software" ? "software" : "low";
  }
}

export interface Stats {
  fps: number;
  frameMs: number;
  calls: number;
  triangles: number;
  geometries: number;
  textures: number;
  quality: string;
}

export class ShipScene {
  /** Links coloured by tension, with a legend: for those who have the truth. */
  showLoads = false;
  /** Nothing moves of itself: the same frame gives the same picture. */
  still = false;

  private readonly shared: SharedRenderer | undefined;
  private readonly canvas: HTMLCanvasElement;
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly world = new Group();
  private readonly ship = new Group();
  private readonly eye = new PerspectiveCamera(60, 1, 0.12, 20000);
  private readonly cameras: Cameras;
  private readonly materials: Materials;
  private readonly tackle: TackleScene[];
  private readonly halos: LampHalos;
  private readonly signals: AnchorSignals;
  private readonly figures: Mesh<BufferGeometry, MeshBasicMaterial>;
  private readonly untold: readonly number[]; // sides that the exercise does not speak of
  private readonly deck: Deck;
  private readonly men: MenFigures;
  private readonly sky: Sky;
  private readonly skyUniforms = skyUniforms();
  private readonly sea: Sea;
  private readonly seabed: Seabed;
  private readonly landmarks: LandmarksScene;
  private readonly flag = new Flag();
  private readonly effects = new Effects();
  private readonly spray: Spray;
  private readonly light: SceneLight;
  private readonly hud = new Scene();
  private readonly hudEye = new OrthographicCamera();
  private readonly tensions: TensionScale;
  private readonly textures: Texture[] = [noiseTexture(), rippleTexture()];
  private readonly clock = new FrameClock();
  private readonly watch: QualityWatch | undefined;
  private readonly pace: Pace | undefined; // where the processor draws
  private quality: Quality;
  private qualityName: QualityName;
  private scale = 1; // of the canvas's pixels, below the preset's
  private seaState: SeaState | undefined;
  private side: number;
  private origin: [number, number, number] | undefined;
  private drift = 0; // s, that ripples, clouds and flag go on by
  private readonly bow: V3;
  private readonly half: V3; // m: half her length and beam, and her deck's height
  private readonly scratch = new Vector3();
  private readonly toBody = new Matrix4();
  private readonly up = new Vector3();
  private readonly axes = new Float64Array(9);
  private readonly seenThrough = { value: new Vector4() }; // of hullMesh
  private readonly lampAt = new Vector3();
  private readonly subject = new Vector3();

  /** on: a canvas of its own, or what it shares with other scenes; then it draws whenever it is told to. */
  constructor(
    on: HTMLCanvasElement | SharedRenderer,
    description: SceneDescription,
    quality: "auto" | QualityName = "auto",
  ) {
    if (on instanceof SharedRenderer) {
      this.shared = on;
      this.renderer = on.renderer;
      this.canvas = on.canvas;
      this.qualityName = on.quality;
    } else {
      const context = contextOf(on, quality === "high" || (quality === "auto" && !probeSoftware()));
      this.canvas = on;
      this.renderer = rendererOf(on, context);
      this.qualityName = quality === "auto" ? qualityOf(context) : quality;
      this.watch = quality === "auto" ? new QualityWatch(this.qualityName) : undefined;
      this.pace = this.watch && this.qualityName === "software" ? new Pace(context) : undefined;
    }
    const { canvas } = this;
    this.quality = kQuality[this.qualityName];
    this.materials = new Materials(this.qualityName === "high");
    this.eye.up.set(0, 0, 1);

    const deck = deckHeight(description);
    this.cameras = new Cameras(canvas, railBreadth(description, deck));
    const foc = 0.5 * description.length_overall - kForecastle;
    this.bow = [0.5 * description.length_overall, 0, deck];
    this.half = [0.5 * description.length_overall, 0.5 * description.beam, deck];
    const [noise, ripples] = this.textures as [Texture, Texture];
    this.sky = new Sky(this.skyUniforms, noise);
    this.sea = new Sea(this.skyUniforms, ripples, noise, this.quality);
    this.seabed = new Seabed(this.materials, noise, ripples);
    this.landmarks = new LandmarksScene(this.materials);
    const told = description.tackle.filter((t, i, all) => all.findIndex((o) => o.side === t.side) === i);
    const untold = told.length === 1 ? [otherSide(told[0]!)] : [];
    this.untold = untold.map((t) => t.side);
    this.tackle = [...told, ...untold].map(
      (t) => new TackleScene(t, deck, this.materials, noise, this.quality.linksFull, this.ship, this.world),
    );
    this.side = description.tackle[0]?.side ?? 0;
    this.deck = deckGear(
      description,
      this.tackle.map((t) => t.rig),
      this.materials,
      noise,
      foc,
      deck,
    );
    const rail = railBreadth(description, deck);
    this.spray = new Spray([this.bow[0], 0, deck + kBulwark], rail);
    this.men = new MenFigures(
      this.tackle.map((t) => t.rig),
      rail,
      deck,
      this.materials,
    );
    const hull = hullMesh(description, this.materials, noise, this.seenThrough, foc, deck);
    hull.receiveShadow = true;
    this.flag.mesh.position.set(...this.deck.flag);
    this.ship.matrixAutoUpdate = false;
    const marks = draughtMarks(description);
    const figures = new MeshBasicMaterial({
      map: marks.texture,
      transparent: true,
      depthWrite: false,
      color: 0xb8bcbc,
    });
    this.figures = new Mesh(marks.geometry, figures);
    this.textures.push(marks.texture);
    this.halos = new LampHalos(this.deck.halos);
    this.signals = new AnchorSignals(description, this.deck.mast, this.materials);
    this.ship.add(
      hull,
      this.deck.group,
      this.men.group,
      this.flag.mesh,
      this.figures,
      this.halos.mesh,
      this.signals.group,
    );
    this.world.add(
      this.ship,
      this.seabed.mesh,
      this.landmarks.group,
      this.effects.cover.mesh,
      this.effects.shine.mesh,
      this.sea.mesh,
    );
    this.scene.add(this.sky.mesh, this.world);
    this.light = new SceneLight(this.scene, this.ship, this.deck.mast.lamps, this.materials);
    this.tensions = new TensionScale(description.tackle[0]?.breaking_load ?? 1);
    this.hud.add(this.tensions.legend);
    this.setShadows();
    this.resize();
  }

  setSeabed(seabed: SeabedDescription | undefined): void {
    this.seabed.set(seabed);
  }
  setLandmarks(landmarks: Landmarks | undefined): void {
    this.landmarks.set(landmarks);
  }
  setSea(sea: SeaState | undefined): void {
    this.seaState = sea;
    this.seabed.tide = sea?.tide_height ?? 0;
  }
  /** The side whose windlass the cameras on deck stand at. */
  setSide(side: number): void {
    this.side = side;
  }
  setCamera(name: CameraName): void {
    this.cameras.name = name;
  }
  /** rad clockwise from ahead, by which a hand has turned a camera on deck or bridge. */
  get turned(): number {
    return this.cameras.turned;
  }
  /** Turns it, rad clockwise. */
  turn(by: number): void {
    this.cameras.turn(by);
  }
  /** Looks closer, below 1, or wider, from where the camera is. */
  zoom(factor: number): void {
    this.cameras.zoomBy(factor);
  }
  /** The lamp in the hand of who looks. */
  setHandLamp(on: boolean): void {
    this.light.handLamp.switch(on);
  }
  get camera(): CameraName {
    return this.cameras.name;
  }

  /** To the canvas's size on the page. */
  resize(): void {
    const width = this.shared?.width ?? Math.max(1, this.canvas.clientWidth);
    const height = this.shared?.height ?? Math.max(1, this.canvas.clientHeight);
    const ratio = Math.min(devicePixelRatio || 1, this.quality.pixelRatioMax) * (this.watch?.scale ?? 1);
    if (!this.shared) {
      this.renderer.setPixelRatio(ratio);
      this.renderer.setSize(width, height, false);
    }
    this.eye.aspect = width / height;
    this.hudEye.left = 0;
    this.hudEye.right = width;
    this.hudEye.top = height;
    this.hudEye.bottom = 0;
    this.hudEye.near = -1;
    this.hudEye.far = 1;
    this.hudEye.updateProjectionMatrix();
    const size = Math.min((0.5 * width) / kLegendWidth, Math.max(1, width / 1000)); // half the picture at most
    this.tensions.legend.scale.setScalar(size);
    this.tensions.legend.position.set(width - size * (kLegendWidth / 2 + 12), size * (kLegendHeight / 2 + 12), 0);
  }

  /** Nothing, where the processor draws and has other work to do first (Pace). */
  draw(told: SceneFrame): void {
    const begin = performance.now();
    if (this.pace && !this.pace.due(begin)) return;
    const frame = this.completed(told);
    const since = this.clock.tick(begin);
    if (this.watch && !this.still) this.take(this.watch.after(this.pace?.took ?? since), this.watch.scale);
    const seconds = this.still ? 0 : Math.min(0.1, since / 1000);
    this.drift += seconds;
    if (this.still) this.drift = frame.time;

    const origin = this.originNear(frame.ship);
    this.placeShip(frame, origin);
    this.world.updateMatrixWorld(true);
    for (const t of this.tackle) t.place(frame.tackle[t.side], frame.ship, origin, this.still ? 1 : seconds, this.ship);
    this.aim(frame, origin);
    this.men.show(frame, this.side, !kMatesOwn.has(this.cameras.name), this.still, this.ears().at);
    this.light.handLamp.hold(this.eye);
    const under = this.isUnder(frame, origin);
    this.surround(frame, origin, under);
    const pixels = this.renderer.domElement.height / (2 * Math.tan((this.eye.fov * Math.PI) / 360));
    this.halos.show(under ? 0 : this.light.dark, pixels, this.light.fog.density);
    const { x, y } = this.eye.position;
    this.landmarks.show(
      [x + origin[0], y + origin[1]],
      frame.time,
      this.seaDrawn,
      under ? 0 : this.light.dark,
      pixels,
      this.light.fog.density,
    );
    this.signals.show(under ? undefined : frame.shows, this.light.dark, pixels, this.light.fog.density);
    const loads = this.showLoads ? this.tensions : undefined;
    loads?.follow(frame, begin);
    for (const t of this.tackle) {
      const tackle = frame.tackle[t.side];
      if (tackle) t.draw(tackle, this.eye, pixels, loads, under || this.showLoads ? -Infinity : kSeenThrough);
    }
    this.stir(frame, origin, seconds, under);

    this.renderer.info.reset();
    this.renderer.setClearColor(this.light.clear, 1);
    this.renderer.clear();
    this.renderer.render(this.scene, this.eye);
    if (this.showLoads) this.renderer.render(this.hud, this.hudEye);
    this.pace?.given(begin);
    this.clock.took(performance.now() - begin);
  }

  private get seaDrawn(): SeaState | undefined {
    return this.quality.sea === "flat" ? undefined : this.seaState;
  }

  /** With what is secured on the side that the exercise does not speak of. */
  private completed(frame: SceneFrame): SceneFrame {
    if (this.untold.length === 0) return frame;
    const tackle = [...frame.tackle];
    for (const t of this.tackle) if (this.untold.includes(t.side)) tackle[t.side] ??= secured(t.rig, frame.ship);
    return { ...frame, tackle };
  }

  stats(): Stats {
    const { render, memory } = this.renderer.info;
    return {
      fps: this.clock.fps,
      frameMs: this.clock.frameMs,
      calls: render.calls,
      triangles: render.triangles,
      geometries: memory.geometries,
      textures: memory.textures,
      quality: this.qualityName,
    };
  }

  /** m, world: x y z of every drawn link's middle, from the locker out; as of the last draw. */
  linkPlaces(side: number): Float32Array {
    const tackle = this.tackle.find((t) => t.side === side);
    const origin = this.origin;
    if (!tackle || !origin) return new Float32Array(0);
    return tackle.links.middle.slice(0, 3 * tackle.links.count).map((v, i) => v + origin[i % 3]!);
  }

  /** Of a side's windlass, m, body frame; undefined: the ship has none there. */
  gear(side: number): Rig | undefined {
    return this.tackle.find((t) => t.side === side)?.rig;
  }

  /**
   * Where a place (m, of the world or of the ship's body frame) is in the last picture: px of the canvas, and m from
   * the eye. undefined: behind it.
   */
  onCanvas(at: V3, frame: "world" | "ship"): { x: number; y: number; far: number } | undefined {
    const p = this.scratch.set(...at);
    if (frame === "ship") p.applyMatrix4(this.ship.matrix);
    else if (this.origin) p.set(at[0] - this.origin[0], at[1] - this.origin[1], at[2] - this.origin[2]);
    const far = p.distanceTo(this.eye.position);
    if (p.applyMatrix4(this.eye.matrixWorldInverse).z > -this.eye.near) return undefined;
    p.applyMatrix4(this.eye.projectionMatrix);
    return { x: 0.5 * (1 + p.x) * this.canvas.clientWidth, y: 0.5 * (1 - p.y) * this.canvas.clientHeight, far };
  }

  /** Where the eye was in the last picture, m, and where it looked, unit vector: ship's body frame. */
  ears(): { at: V3; ahead: V3 } {
    this.toBody.copy(this.ship.matrixWorld).invert();
    const { x, y, z } = this.scratch.copy(this.eye.position).applyMatrix4(this.toBody);
    const at: V3 = [x, y, z];
    const ahead = this.eye.getWorldDirection(this.scratch).transformDirection(this.toBody);
    return { at, ahead: [ahead.x, ahead.y, ahead.z] };
  }

  dispose(): void {
    this.cameras.dispose();
    for (const t of this.tackle) t.dispose();
    this.sky.dispose();
    this.sea.dispose();
    this.seabed.dispose();
    this.flag.dispose();
    this.halos.dispose();
    this.signals.dispose();
    this.effects.dispose();
    this.men.dispose();
    this.landmarks.dispose();
    this.ship.traverse((o) => (o as { geometry?: { dispose(): void } }).geometry?.dispose());
    this.tensions.dispose();
    this.figures.material.dispose();
    this.materials.dispose();
    for (const texture of this.textures) texture.dispose();
    if (!this.shared) this.renderer.dispose();
  }

  /** Another preset, as far as it can change under way. */
  private take(name: QualityName, scale: number): void {
    if (name === this.qualityName && scale === this.scale) return;
    this.scale = scale;
    this.qualityName = name;
    this.quality = kQuality[name];
    for (const t of this.tackle) t.chain.full = this.quality.linksFull;
    this.setShadows();
    this.resize();
  }

  private setShadows(): void {
    const on = this.quality.shadows;
    this.renderer.shadowMap.enabled = on;
    this.light.shadows = on;
    for (const t of this.tackle) t.shadows = on;
    this.men.shadows = on;
    for (const mesh of this.deck.group.children) {
      mesh.castShadow = on;
      mesh.receiveShadow = on;
    }
  }

  private originNear(ship: SceneFrame["ship"]): [number, number, number] {
    const was = this.origin;
    if (was && Math.hypot(ship.x - was[0], ship.y - was[1]) < kOriginMoves) return was;
    const now: [number, number, number] = [Math.round(ship.x), Math.round(ship.y), 0];
    if (was) {
      this.scratch.set(was[0] - now[0], was[1] - now[1], 0);
      this.effects.cover.shift(this.scratch);
      this.effects.shine.shift(this.scratch);
    }
    this.origin = now;
    return now;
  }

  private placeShip(frame: SceneFrame, origin: readonly number[]): void {
    const a = shipAxes(frame.ship, this.axes);
    const { x, y, z } = frame.ship;
    this.ship.matrix.set(
      a[0]!, a[1]!, a[2]!, x - origin[0]!,
      a[3]!, a[4]!, a[5]!, y - origin[1]!,
      a[6]!, a[7]!, a[8]!, z - origin[2]!,
      0, 0, 0, 1,
    ); // prettier-ignore
    this.up.set(a[2]!, a[5]!, a[8]);
    this.landmarks.group.position.set(-origin[0]!, -origin[1]!, 0);
    const wind = frame.wind_from + Math.PI; // towards
    this.flag.show(frame.wind_speed, frame.ship.heading - wind, this.drift, 0.25 + 0.75 * (1 - this.light.dark));
  }

  private aim(frame: SceneFrame, origin: readonly number[]): void {
    const tackle = this.tackle.find((t) => t.side === this.side) ?? this.tackle[0];
    const seen = tackle ? frame.tackle[tackle.side] : undefined;
    if (seen?.anchor) this.subject.set(seen.anchor.x, seen.anchor.y, seen.anchor.z);
    else if (seen && seen.nodes.length >= 3) this.subject.fromArray(seen.nodes, seen.nodes.length - 3);
    else this.subject.set(frame.ship.x, frame.ship.y, -2);
    this.subject.set(this.subject.x - origin[0]!, this.subject.y - origin[1]!, this.subject.z - origin[2]!);
    const water = this.cameras.name === "water";
    this.cameras.aim(
      this.eye,
      tackle?.rig,
      this.bow,
      (p, out) => out.set(...p).applyMatrix4(this.ship.matrix),
      this.up,
      frame.ship.heading,
      this.subject,
      (eye) => {
        const x = eye.x + origin[0]!;
        const y = eye.y + origin[1]!;
        const eta = surface(this.seaState, x, y, frame.time) - origin[2]!;
        if (water) {
          eye.z = Math.min(eye.z, eta - 0.4);
          if (this.seabed.known) eye.z = Math.max(eye.z, this.seabed.height(x, y) - origin[2]! + 0.5);
        } else eye.z = Math.max(eye.z, eta + 0.6);
      },
    );
  }

  private isUnder(frame: SceneFrame, origin: readonly number[]): boolean {
    const { x, y, z } = this.eye.position;
    return z + origin[2]! < surface(this.seaState, x + origin[0]!, y + origin[1]!, frame.time);
  }

  /** Light, sky, sea, ground, haze. */
  private surround(frame: SceneFrame, origin: readonly number[], under: boolean): void {
    const { light } = this;
    const overcast = MathUtils.smoothstep(frame.wind_speed, ...kClouds);
    light.shine(
      frame.time_of_day,
      frame.visibility,
      overcast,
      this.scratch.set(this.bow[0] - 12, 0, this.bow[2]).applyMatrix4(this.ship.matrix),
    );
    if (under) light.underWater(Math.max(0, -(this.eye.position.z + origin[2]!)));
    else {
      const ahead = this.eye.getWorldDirection(this.scratch);
      light.inAir(frame.visibility, ahead, sprayed(frame, this.seaState));
    }
    const { r, g, b } = under ? light.haze : light.day.deep;
    this.seenThrough.value.set(r, g, b, under ? 0.5 : 1);
    this.figures.material.color.setScalar(0.1 + 0.5 * (1 - light.dark));
    setSky(this.skyUniforms, light.day, light.fog.density, light.hazeLit, under ? light.haze : undefined);
    this.sky.mesh.visible = !under;
    this.sky.show(this.drift, overcast);
    this.seabed.show(this.subject.x + origin[0]!, this.subject.y + origin[1]!, origin, under, this.drift);
    const { ship } = frame;
    this.sea.setShip(ship.x - origin[0]!, ship.y - origin[1]!, ship.heading, this.half);
    this.lampAt.set(this.bow[0] - 20, 0, this.bow[2] + 7).applyMatrix4(this.ship.matrix);
    this.sea.show(
      this.seaDrawn,
      this.eye.position,
      origin,
      frame.time,
      this.drift,
      frame.wind_speed,
      frame.wind_from,
      this.lampAt,
      light.floodlight,
      light.day.onWater,
      this.showLoads ? 0.42 : 1,
    );
    this.landmarks.group.visible = !under;
    // From above, foam lies on the water; from below, the water hides what is above it.
    this.sea.mesh.material.depthWrite = under;
  }

  private stir(frame: SceneFrame, origin: readonly number[], seconds: number, under: boolean): void {
    if (!this.quality.particles) return;
    const steps = this.still ? kStillSteps : 1;
    const dt = this.still ? 0.08 : seconds;
    if (this.still) {
      this.effects.restart();
      this.spray.restart();
    }
    const windX = -Math.sin(frame.wind_from) * frame.wind_speed * 0.55;
    const windY = -Math.cos(frame.wind_from) * frame.wind_speed * 0.55;
    const light = 0.12 + 0.9 * (1 - this.light.dark);
    for (let i = 0; i < steps; ++i) {
      for (const t of this.tackle) {
        const tackle = frame.tackle[t.side];
        if (!tackle) continue;
        this.effects.stir(
          tackle,
          t.links,
          origin,
          frame.time,
          dt,
          t.places,
          (x, y) => surface(this.seaState, x, y, frame.time),
          (x, y) => (under ? this.seabed.height(x, y) : -Infinity),
          (x, y) => this.seabed.soilColour(x, y),
        );
      }
      if (!under)
        this.spray.stir(
          this.effects.cover,
          frame,
          frame.time - (steps - 1 - i) * dt,
          dt,
          this.seaState,
          origin,
          (p) => p.applyMatrix4(this.ship.matrix),
          this.quality.spray,
          this.effects.next,
        );
      this.effects.cover.step(dt, windX, windY, light, this.light.fog.density);
      this.effects.shine.step(dt, windX, windY, 1, this.light.fog.density);
    }
  }
}

function contextOf(canvas: HTMLCanvasElement, antialias: boolean): WebGL2RenderingContext {
  const context = canvas.getContext("webgl2", { antialias, alpha: false, powerPreference: "high-performance" });
  if (!context) throw new Error("this browser has no WebGL 2: the scene cannot be drawn");
  return context;
}

function rendererOf(canvas: HTMLCanvasElement, context: WebGL2RenderingContext): WebGLRenderer {
  const renderer = new WebGLRenderer({ canvas, context });
  renderer.toneMapping = NeutralToneMapping;
  renderer.info.autoReset = false;
  renderer.autoClear = false;
  renderer.shadowMap.type = PCFShadowMap;
  return renderer;
}

/** Whether this machine draws by its processor: asked of a canvas of its own, since antialiasing is chosen first. */
function probeSoftware(): boolean {
  const gl = document.createElement("canvas").getContext("webgl2");
  const software = !gl || qualityOf(gl) === "software";
  gl?.getExtension("WEBGL_lose_context")?.loseContext();
  return software;
}
