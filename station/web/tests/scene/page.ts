// A page that draws recorded instants with the scene itself, for tests and pictures.

import { frameOfSeat } from "../../src/scene/from_seat";
import { frameOfTruth } from "../../src/scene/from_truth";
import type { SceneFrame, TackleFrame } from "../../src/scene/frame";
import { type CameraName, ShipScene } from "../../src/scene/ship_scene";
import type { Landmarks, SeaState } from "../../src/wire/generated";
import { OneInstant, type Recorded } from "./samples";

export interface Show {
  instant: string;
  camera: CameraName;
  seat?: boolean;
  loads?: boolean;
  quality?: "software" | "low" | "high" | "auto";
  side?: number;
  sea?: SeaState;
  landmarks?: Landmarks;
  frame?: Partial<SceneFrame>;
  tackle?: Partial<TackleFrame>;
  moving?: boolean;
  /** Turn of the camera by hand, rad, and zoom. */
  hand?: { yaw: number; pitch: number; zoom: number };
  anchor?: string;
}

let recorded: Recorded;
let scene: ShipScene | undefined;
let made = "";
let frame: SceneFrame;

async function show(what: Show): Promise<ReturnType<ShipScene["stats"]>> {
  recorded ??= (await (await fetch("instants.json")).json()) as Recorded;
  const samples = new OneInstant(recorded, what.instant);
  if (what.anchor) for (const t of samples.latest("SceneDescription")!.tackle) t.anchor = what.anchor;
  const key = `${recorded.instants.find((i) => i.name === what.instant)!.scene} ${what.quality} ${what.anchor}`;
  if (!scene || made !== key) {
    scene?.dispose();
    const old = document.querySelector("canvas")!;
    const canvas = document.createElement("canvas");
    old.replaceWith(canvas);
    scene = new ShipScene(canvas, samples.latest("SceneDescription")!, what.quality ?? "software");
    made = key;
  }
  scene.setSeabed(samples.latest("SeabedDescription"));
  scene.setSea(what.sea ?? samples.latest("SeaState"));
  scene.setLandmarks(what.landmarks);
  scene.setSide(what.side ?? 0);
  scene.setCamera(what.camera);
  if (what.hand)
    (scene as unknown as { cameras: { hands: Map<string, object> } }).cameras.hands.set(what.camera, what.hand);
  scene.showLoads = what.loads ?? false;
  scene.still = !what.moving;
  frame = (what.seat ? frameOfSeat(samples, 0) : frameOfTruth(samples, 0))!;
  frame = { ...frame, ...what.frame };
  if (what.tackle) frame.tackle = frame.tackle.map((t) => (t ? { ...t, ...what.tackle } : t));
  scene.draw(frame);
  scene.draw(frame);
  return scene.stats();
}

/** What the page gives to whoever opened it. */
export interface SceneWindow {
  show(what: Show): Promise<ReturnType<ShipScene["stats"]>>;
  places(side: number): number[];
}

const given: SceneWindow = { show, places: (side) => Array.from(scene!.linkPlaces(side)) };
Object.assign(window, given);
