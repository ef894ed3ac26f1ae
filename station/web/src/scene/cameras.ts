// From where one looks, and how a hand turns it: drag looks round, wheel or two fingers zoom.

import { type PerspectiveCamera, Vector3 } from "three";
import { bridgeEye } from "../surroundings/bridge_eye";
import type { Rig } from "./rig";
import { type V3, add, along, clamp } from "./vec";

export type CameraName = "stand" | "bow" | "brake" | "aft" | "bridge" | "cctv" | "outside" | "water" | "free";
export const kCameras: readonly CameraName[] = [
  "stand",
  "bow",
  "brake",
  "aft",
  "bridge",
  "cctv",
  "outside",
  "water",
  "free",
];

/** A man's place on deck, m and rad, body frame: eye, and what he looks at. */
export interface Place {
  eye: V3;
  at: V3;
  fov: number;
}

/** An orbit: m round a point, rad clockwise from ahead, and up. */
interface Orbit {
  distance: number;
  azimuth: number;
  height: number;
  fov: number;
}

/** What a hand has done to a camera since it was chosen. */
interface Hand {
  yaw: number;
  pitch: number;
  zoom: number;
}

const kOrbits: Partial<Record<CameraName, Orbit>> = {
  outside: { distance: 62, azimuth: -0.62, height: 0.16, fov: 45 },
  water: { distance: 8.5, azimuth: -2.2, height: 0.3, fov: 58 },
  free: { distance: 30, azimuth: 2.3, height: 0.4, fov: 50 },
};

export class Cameras {
  name: CameraName = "stand";
  private readonly hands = new Map<CameraName, Hand>();
  private readonly pointers = new Map<number, { x: number; y: number }>();
  private pinch = 0;
  private readonly listening = new AbortController();

  /** rail: m, half the ship's breadth over the bulwark, at x of the body frame. */
  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly rail: (x: number) => number,
  ) {
    const { signal } = this.listening;
    canvas.style.touchAction = "none";
    canvas.addEventListener("pointerdown", (e) => this.down(e), { signal });
    canvas.addEventListener("pointermove", (e) => this.move(e), { signal });
    for (const end of ["pointerup", "pointercancel", "lostpointercapture"] as const)
      canvas.addEventListener(end, (e) => this.pointers.delete(e.pointerId), { signal });
    canvas.addEventListener(
      "wheel",
      (e) => {
        e.preventDefault();
        this.zoomBy(Math.exp(clamp(e.deltaY, -200, 200) * 0.0012));
      },
      { signal, passive: false },
    );
    canvas.addEventListener("dblclick", () => this.hands.delete(this.name), { signal });
  }

  /** As it was before a hand turned it. */
  reset(): void {
    this.hands.delete(this.name);
  }

  /** rad clockwise, by which a hand has turned it from where it looks by itself. */
  get turned(): number {
    return -(this.hands.get(this.name)?.yaw ?? 0);
  }

  /** Turns it, rad clockwise. */
  turn(by: number): void {
    this.hand.yaw -= by;
  }

  private get hand(): Hand {
    let hand = this.hands.get(this.name);
    if (!hand) this.hands.set(this.name, (hand = { yaw: 0, pitch: 0, zoom: 1 }));
    return hand;
  }

  private down(e: PointerEvent): void {
    this.canvas.setPointerCapture(e.pointerId);
    this.pointers.set(e.pointerId, { x: e.clientX, y: e.clientY });
    this.pinch = 0;
  }

  private move(e: PointerEvent): void {
    const was = this.pointers.get(e.pointerId);
    if (!was) return;
    const dx = e.clientX - was.x;
    const dy = e.clientY - was.y;
    this.pointers.set(e.pointerId, { x: e.clientX, y: e.clientY });
    if (this.pointers.size > 1) {
      const [a, b] = [...this.pointers.values()];
      const apart = Math.hypot(a!.x - b!.x, a!.y - b!.y);
      if (this.pinch > 0 && apart > 0) this.zoomBy(this.pinch / apart);
      this.pinch = apart;
      return;
    }
    const perPixel = 2.2 / Math.max(200, this.canvas.clientHeight);
    this.hand.yaw += dx * perPixel * Math.min(1, this.hand.zoom);
    this.hand.pitch = clamp(this.hand.pitch + dy * perPixel * Math.min(1, this.hand.zoom), -1.5, 1.5);
  }

  /** Looks closer, below 1, or wider. */
  zoomBy(factor: number): void {
    this.hand.zoom = clamp(this.hand.zoom * factor, kNearest, kOrbits[this.name] ? 6 : 1.4);
  }

  /**
   * Puts the camera. toScene: a body place to the scene (m from its origin); heading: rad; subject: m from the origin,
   * what is looked at under water; clear: keeps the eye on its side of surface and ground.
   */
  aim(
    camera: PerspectiveCamera,
    rig: Rig | undefined,
    bow: V3,
    toScene: (p: V3, out: Vector3) => Vector3,
    up: Vector3,
    heading: number,
    subject: Vector3,
    clear: (eye: Vector3) => void,
  ): void {
    const hand = this.hands.get(this.name) ?? kStill;
    const orbit = kOrbits[this.name];
    if (orbit) {
      const target = kTarget;
      if (this.name === "water") target.copy(subject);
      else toScene(this.name === "outside" ? [bow[0] - 10, 0, bow[2] * 0.35] : [bow[0] - 8, 0, bow[2] + 1], target);
      const azimuth = heading + orbit.azimuth + hand.yaw;
      const height = clamp(orbit.height + hand.pitch, -1.45, 1.45);
      const distance = orbit.distance * hand.zoom;
      camera.position.set(
        target.x + distance * Math.sin(azimuth) * Math.cos(height),
        target.y + distance * Math.cos(azimuth) * Math.cos(height),
        target.z + distance * Math.sin(height),
      );
      clear(camera.position);
      camera.up.set(0, 0, 1);
      camera.lookAt(target);
      camera.fov = orbit.fov;
    } else {
      const place =
        this.name === "bridge"
          ? onBridge(bow)
          : this.name === "cctv"
            ? onForemast(bow)
            : rig
              ? placeOf(this.name, rig, this.rail)
              : { eye: [bow[0] - 14, 0, bow[2] + 1.7] as V3, at: bow, fov: 60 };
      toScene(place.eye, camera.position);
      toScene(place.at, kTarget);
      camera.up.copy(up);
      camera.lookAt(kTarget);
      camera.rotateOnWorldAxis(up, hand.yaw);
      camera.rotateX(hand.pitch);
      camera.fov = clamp(place.fov * hand.zoom, 8, 85);
    }
    // A narrow picture shows as much to either side as one of 16 to 10.
    const narrow = kWide / Math.max(0.4, camera.aspect);
    if (narrow > 1)
      camera.fov = (360 / Math.PI) * Math.atan(Math.min(1.3, Math.tan((camera.fov * Math.PI) / 360) * narrow));
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
  }

  dispose(): void {
    this.listening.abort();
  }
}

const kWide = 1.6; // width to height
const kNearest = 0.15; // of the whole angle: 600 lines are a minute of arc each then, as an eye tells apart
const kStill: Hand = { yaw: 0, pitch: 0, zoom: 1 };
const kTarget = new Vector3();
const kEye = 1.68; // m over the deck

/** Looking over the bow. */
function onBridge(bow: V3): Place {
  return { eye: [bridgeEye(2 * bow[0]), 0, bow[2] + 16], at: [bow[0] + 200, 0, bow[2] - 6], fov: 42 };
}

/** A camera on the fore side of the foremast of deck.ts, over both windlasses. */
function onForemast(bow: V3): Place {
  return { eye: [bow[0] - 22, 0, bow[2] + 7.2], at: [bow[0] - 9, 0, bow[2] + 0.4], fov: 62 };
}

/** By the gear of one side: aft along the cable and outboard in sizes of it from the gypsy, up in m from the deck. */
function from({ d, gypsy, lead, out, deck }: Rig, aft: number, outboard: number, up: number): V3 {
  const k = d / 0.078;
  const p = along(along(gypsy, aft * k, lead), outboard * k, out);
  return [p[0], p[1], deck + up];
}

/** Of who works the windlass. */
export const standOf = (rig: Rig): Place => ({
  eye: from(rig, 1.5, -2.55, kEye + 0.25),
  at: from(rig, -1.7, 0.1, 0.75),
  fov: 66,
});

/** rail: m, half the breadth over the bulwark at x. */
function placeOf(name: CameraName, rig: Rig, rail: (x: number) => number): Place {
  const { deck } = rig;
  if (name === "brake")
    return { eye: from(rig, 1.55, -1.05, kEye + 0.72), at: from(rig, -0.75, 0.1, (1.1 * rig.d) / 0.078), fov: 56 };
  if (name === "aft")
    return { eye: from(rig, -3.2, -1.4, kEye), at: add(from(rig, 3, 0.6, 1.2), [-10, 0, 0]), fov: 65 };
  if (name === "bow") {
    // Leaning out over the bulwark, a little abaft the pipe.
    const { lip } = rig.tackle;
    const x = lip.x - 2.4;
    return {
      eye: [x, rig.sign * (rail(x) + 1.0), deck + 1.85],
      at: [lip.x + 1.2, lip.y + rig.sign * 0.8, 0],
      fov: 66,
    };
  }
  return standOf(rig);
}
