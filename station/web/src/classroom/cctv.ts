// Small pictures of the forecastles of many exercises, each as the bridge's camera there sees it, every few seconds in
// turn. One WebGL context draws them all, and the gateway is asked for what one picture needs when its turn comes: no
// exercise is subscribed. Only what is on the screen is drawn, and nothing while the page is hidden.

import { CameraPicture } from "../bridge/from_camera";
import { LookingOut } from "../bridge/from_bridge";
import { h, setAttribute, setShown, setText } from "../kit/dom";
import { t } from "../kit/language";
import { everyFrame } from "../kit/page";
import type { Samples } from "../scene/from_truth";
import { Pace } from "../scene/pace";
import type { SharedRenderer, ShipScene } from "../scene/ship_scene";
import { CdrReader } from "../wire/cdr";
import { type ChannelName, type Channels, type Connection, type Heard, Refused } from "../wire/connection";
import { type TopicName, decoders, keys } from "../wire/generated";

const kWidth = 320; // px of a picture
const kHeight = 200;
const kRound = 5000; // ms, at least, from one picture of an exercise to its next
const kSoon = 500; // ms, after which an exercise that was not heard yet is asked again
const kShare = 0.1; // of the time, that drawing may take
const kScenes = 16; // ships that are kept, one for each definition
const kChosen = "windlass.cctv";

/** The gateway's answer: `at` is what the next question of this exercise begins from. */
interface Answer {
  exercise: string;
  at: number;
  samples: [TopicName, string][];
}

/** The newest samples of one exercise, as a scene looks at a link. */
class Seen implements Samples {
  private readonly newest = new Map<string, [Heard<unknown>]>();

  take(topic: TopicName, base64: string, now: number): void {
    const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
    const sample = decoders[topic](new CdrReader(new DataView(bytes.buffer))) as never;
    this.newest.set(`${topic}/${keys[topic](sample)}`, [{ sample, at: now }]);
  }
  track(channel: ChannelName, key: string | number = ""): never {
    return (this.newest.get(`${channel}/${key}`) ?? []) as never;
  }
  latest<C extends ChannelName>(channel: C, key: string | number = ""): Channels[C] | undefined {
    return (this.track(channel, key) as Heard<Channels[C]>[])[0]?.sample;
  }
}

/** The picture of one exercise. */
class Picture {
  readonly seen = new Seen();
  readonly camera = new CameraPicture(new LookingOut());
  readonly canvas = h("canvas", { width: kWidth, height: kHeight, role: "img" });
  readonly message = h("p", { class: "quiet" }, t("The picture is coming"));
  readonly element = h("div", { class: "cctv" }, this.canvas, this.message);
  onScreen = false;
  due = 0; // ms of performance.now()
  since = 0; // of the last answer

  constructor(readonly exercise: string) {
    setAttribute(this.canvas, "aria-label", t("forecastle of {id}, by camera", { id: exercise }));
  }

  /** Instead of a picture; empty: the picture. */
  say(text: string): void {
    setText(this.message, text);
    setShown(this.message, text !== "");
  }
}

export class CctvPictures {
  /** Turns them on and off, for this browser; hidden where they cannot be had. */
  readonly button = h("button", {
    class: "plain",
    type: "button",
    hidden: true,
    title: t("small pictures of all forecastles, by their cameras"),
    onclick: () => this.toggle(),
  });
  private readonly pictures = new Map<string, Picture>(); // by exercise
  private readonly places = new Map<Element, Picture>();
  private readonly scenes = new Map<bigint, ShipScene>(); // by definition, the one drawn last at the end
  private readonly watch: IntersectionObserver;
  private on = kept();
  private may = true; // neither the gateway nor the browser has said no
  private asks = false;
  private shared: SharedRenderer | undefined;
  private pace: Pace | undefined;

  constructor(private readonly link: Connection) {
    this.watch = new IntersectionObserver((entries) => {
      for (const { target, isIntersecting } of entries) {
        const picture = this.places.get(target);
        if (picture) picture.onScreen = isIntersecting;
      }
    });
    link.onState((state) => {
      if (state === "open") for (const picture of this.pictures.values()) picture.since = 0; // it may be another one's
    });
    everyFrame((now) => this.turn(now));
    this.show();
  }

  /** Of an exercise, to be put into its tile. */
  of(exercise: string): HTMLElement {
    const known = this.pictures.get(exercise);
    if (known) return known.element;
    const picture = new Picture(exercise);
    this.pictures.set(exercise, picture);
    this.places.set(picture.element, picture);
    this.watch.observe(picture.element);
    this.show();
    return picture.element;
  }

  forget(exercise: string): void {
    const picture = this.pictures.get(exercise);
    if (!picture) return;
    this.watch.unobserve(picture.element);
    this.places.delete(picture.element);
    this.pictures.delete(exercise);
  }

  private toggle(): void {
    this.on = !this.on;
    try {
      localStorage.setItem(kChosen, this.on ? "on" : "off");
    } catch {
      // it holds for this page
    }
    this.show();
  }

  private show(): void {
    this.button.hidden = !this.may || this.pictures.size === 0;
    setText(this.button, this.on ? t("CCTV on") : t("CCTV off"));
    setAttribute(this.button, "aria-pressed", `${this.on}`);
    for (const { element } of this.pictures.values()) setShown(element, this.on && this.may);
  }

  /** Whose turn it is, where there is time for a picture. */
  private turn(now: number): void {
    if (!this.on || !this.may || this.asks || this.link.state !== "open") return;
    if (this.pace && !this.pace.due(now)) return;
    let next: Picture | undefined;
    for (const picture of this.pictures.values())
      if (picture.onScreen && picture.due <= now && picture.due < (next?.due ?? Infinity)) next = picture;
    if (next) void this.ask(next, now);
  }

  private async ask(picture: Picture, now: number): Promise<void> {
    this.asks = true;
    picture.due = now + kRound;
    try {
      const answer = await this.answer(picture);
      const before = picture.seen.latest("BridgeView")?.tick;
      for (const [topic, payload] of answer.samples) picture.seen.take(topic, payload, performance.now());
      const view = picture.seen.latest("BridgeView");
      const stands = view?.tick === before && answer.samples.every(([topic]) => kStreams.has(topic));
      picture.since = answer.at;
      if (!view || !picture.seen.latest("SceneDescription")) picture.due = now + kSoon;
      else if (!view.cctv_works) picture.say(`\u26a0 ${t("No picture")}`);
      else if (!stands) await this.draw(picture);
    } catch (why) {
      // An exercise that is being removed is nobody's mistake; a seat that may not look never may.
      if (!(why instanceof Refused)) console.warn(`${why}`);
      this.may = why instanceof Refused && (why.field === "exercise" || this.link.state !== "open");
      this.show();
    } finally {
      this.asks = false;
    }
  }

  private async answer({ exercise, since }: Picture): Promise<Answer> {
    let answer: Answer | undefined;
    const listened = this.link.onMessage("camera", (message) => {
      if (message.exercise === exercise) answer = message as unknown as Answer;
    });
    try {
      await this.link.ask({ op: "camera", exercise, since });
    } finally {
      listened();
    }
    if (!answer) throw new Error("a camera's answer has nothing in it");
    return answer;
  }

  /** The scene's code is most of the page: it is loaded with the first picture. */
  private async draw(picture: Picture): Promise<void> {
    const { SharedRenderer, ShipScene } = await import("../scene/ship_scene");
    this.shared ??= new SharedRenderer(kWidth, kHeight);
    this.pace ??= new Pace(this.shared.gl, kShare);
    const { seen, camera } = picture;
    const begin = performance.now();
    const frame = camera.frame(seen, begin);
    const description = seen.latest("SceneDescription");
    if (!frame || !description) return;
    const scene = this.scenes.get(description.definition_hash) ?? new ShipScene(this.shared, description);
    this.keep(description.definition_hash, scene);
    scene.still = true;
    scene.setCamera("cctv");
    scene.setSea(seen.latest("SeaState"));
    scene.setLandmarks(seen.latest("Landmarks"));
    if (camera.worked.side !== undefined) scene.setSide(camera.worked.side);
    scene.draw(frame);
    picture.canvas.getContext("2d")?.drawImage(this.shared.canvas, 0, 0);
    this.pace.given(begin);
    picture.say("");
  }

  private keep(definition: bigint, scene: ShipScene): void {
    this.scenes.delete(definition);
    this.scenes.set(definition, scene);
    const [oldest] = this.scenes;
    if (this.scenes.size <= kScenes || !oldest) return;
    oldest[1].dispose();
    this.scenes.delete(oldest[0]);
  }
}

/** What comes anew with each answer, also where nothing has changed. */
const kStreams = new Set<TopicName>(["BridgeView", "ForecastleCamera", "LightsAndShapes"]);

/** On, unless the user has turned them off. */
function kept(): boolean {
  try {
    return localStorage.getItem(kChosen) !== "off";
  } catch {
    return true;
  }
}
