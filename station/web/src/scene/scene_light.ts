// What light falls on the scene: sun or moon, sky, deck lights and the lamp in a hand, and the haze that all of it is
// seen through; above the water and below it.

import { Color, DirectionalLight, FogExp2, type Group, HemisphereLight, PointLight, type Scene, Vector3 } from "three";
import { type Daylight, daylight, empty, toneMapped } from "./daylight";
import { HandLamp } from "./hand_lamp";
import type { Light, Materials } from "./materials";
import type { V3 } from "./vec";

const kUnderWater = { red: 0.035, green: 0.2, blue: 0.2, sight: 24 }; // colour by full day; m

export class SceneLight {
  /** Of the hour, as of the last shine(). */
  readonly day: Daylight = empty();
  readonly handLamp = new HandLamp();
  readonly fog = new FogExp2(0, 0);
  /** The haze's colour; and what is seen below the horizon, through water. */
  readonly haze = new Color();
  readonly clear = new Color();
  private readonly sun = new DirectionalLight();
  private readonly ambient = new HemisphereLight();
  private readonly lamps: PointLight[];
  /** What lamps add to the haze. */
  readonly hazeLit = new Color();
  private readonly glow = new Color();
  private readonly scratch = new Vector3();
  private readonly corners: Light = {
    sunTowards: new Vector3(),
    sun: new Color(),
    sky: new Color(),
    ground: new Color(),
    lampAt: new Vector3(),
    lamp: new Color(),
    handAt: this.handLamp.at,
    handTowards: this.handLamp.towards,
    hand: this.handLamp.colour,
    fog: new Color(),
    fogDensity: 0,
    wet: 0,
  };

  /** floodlights: m, body frame, on the ship. */
  constructor(
    scene: Scene,
    ship: Group,
    floodlights: readonly V3[],
    private readonly materials: Materials,
  ) {
    const { physical } = materials;
    this.lamps = floodlights.slice(0, physical ? 2 : 1).map((at) => {
      const lamp = new PointLight(0xffe2b4, 0, 70, 1.6);
      lamp.position.set(at[0] + 0.5, physical ? at[1] : 0, at[2] + 0.3);
      lamp.visible = false;
      ship.add(lamp);
      return lamp;
    });
    scene.add(this.sun, this.sun.target, this.ambient);
    if (physical) scene.add(this.handLamp.light, this.handLamp.light.target);
    scene.fog = this.fog;
  }

  set shadows(on: boolean) {
    this.sun.castShadow = on;
    if (!on) return;
    this.sun.shadow.mapSize.set(2048, 2048);
    this.sun.shadow.bias = -0.0004;
    this.sun.shadow.normalBias = 0.02;
    const c = this.sun.shadow.camera;
    c.left = c.bottom = -17;
    c.right = c.top = 17;
    c.near = 5;
    c.far = 120;
    c.updateProjectionMatrix();
  }

  /** 0 day .. 1 night. */
  get dark(): number {
    return this.day.dark;
  }
  /** How brightly the floodlights shine; 0: they are off. */
  get floodlight(): number {
    return this.lamps[0]?.visible ? 1.4 * this.dark : 0;
  }

  /**
   * At s since local midnight and m of visibility; overcast: 0..1, of the sky; focus: where shadows are wanted, m from
   * the scene's origin.
   */
  shine(timeOfDay: number, visibility: number, overcast: number, focus: Vector3): void {
    const light = daylight(timeOfDay, visibility, overcast, this.day);
    this.sun.color.copy(light.sun);
    this.sun.intensity = light.sunStrength;
    this.sun.target.position.copy(focus);
    this.sun.position.copy(focus).addScaledVector(light.towards, 60);
    this.ambient.color.copy(light.horizon).lerp(light.zenith, 0.12);
    this.ambient.groundColor.copy(light.ground);
    this.ambient.position.set(0, 0, 1);
    this.ambient.intensity = light.skyStrength * 1.9;
    // by night the deck lights come back from deck and bulwark
    const back = 0.075 * light.dark;
    this.ambient.color.add(this.glow.setRGB(0.8 * back, 0.75 * back, 0.7 * back));
    this.ambient.groundColor.add(this.glow.setRGB(back, 0.85 * back, 0.6 * back));
    const lit = light.dark > 0.25;
    for (const lamp of this.lamps) {
      lamp.visible = lit;
      lamp.intensity = lit ? (150 * light.dark * 2) / this.lamps.length : 0;
    }
  }

  /**
   * The haze over the water, which lamps light up; after shine(). ahead: where one looks, whose haze is over all but
   * sky and sea; wet: 0..1, of steel.
   */
  inAir(visibility: number, ahead: Vector3, wet: number): void {
    this.corners.wet = wet;
    const { glow, away, sunwards } = this.day;
    const side = 0.5 + (0.5 * (ahead.x * sunwards.x + ahead.y * sunwards.y)) / (Math.hypot(ahead.x, ahead.y) || 1);
    this.haze.lerpColors(away, glow, side * side);
    const lamps = this.dark * Math.min(1, 300 / Math.max(50, visibility));
    this.haze.add(this.hazeLit.setRGB(0.075, 0.066, 0.05).multiplyScalar(lamps));
    this.fog.density = Math.sqrt(3) / Math.max(50, visibility);
    this.spread(this.day.deep);
  }

  /** What comes down to an eye so many m under water; after shine(). */
  underWater(deep: number): void {
    this.corners.wet = 0;
    const day = 0.06 + 0.94 * (1 - this.dark);
    this.haze.setRGB(kUnderWater.red, kUnderWater.green, kUnderWater.blue).multiplyScalar(day);
    this.haze.multiplyScalar(Math.exp(-deep / 28));
    this.fog.density = Math.sqrt(3) / (1.6 * kUnderWater.sight);
    this.ambient.color.setRGB(0.45, 0.8, 0.8);
    this.ambient.groundColor.setRGB(0.4, 0.55, 0.45);
    this.ambient.intensity = 4.6 * day * Math.exp(-deep / 60);
    this.sun.color.setRGB(0.5, 0.85, 0.85);
    this.sun.intensity = 2.6 * day * Math.exp(-deep / 50);
    this.sun.position.copy(this.sun.target.position).addScaledVector(this.scratch.set(0.2, -0.25, 0.95), 60);
    this.spread(this.haze);
  }

  /** On the screen's scale, and the same light for materials that do not take three's. */
  private spread(below: Color): void {
    toneMapped(this.haze, this.fog.color);
    toneMapped(below, this.clear);
    const { corners, sun, ambient } = this;
    corners.sunTowards.copy(sun.position).sub(sun.target.position).normalize();
    corners.sun.copy(sun.color).multiplyScalar(sun.intensity / Math.PI);
    corners.sky.copy(ambient.color).multiplyScalar(ambient.intensity / Math.PI);
    corners.ground.copy(ambient.groundColor).multiplyScalar(ambient.intensity / Math.PI);
    const lamp = this.lamps[0];
    if (lamp) {
      lamp.getWorldPosition(corners.lampAt);
      corners.lamp.copy(lamp.color).multiplyScalar(lamp.intensity / Math.PI);
    }
    corners.fog.copy(this.haze);
    corners.fogDensity = this.fog.density;
    this.materials.lit(corners);
  }
}
