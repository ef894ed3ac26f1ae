// Draws pictures of the scene to be looked at.
//
// usage: node station/web/tools/ts.mjs station/web/tests/scene/pictures.ts FOLDER [NAME...]

import { mkdir } from "node:fs/promises";
import type { SeaState } from "../../src/wire/generated";
import { openScene } from "./browser";
import type { Show } from "./page";

/** height (m), period (s), and where it comes from, rad. */
const sea = (height: number, period: number, from: number): SeaState => {
  // A few waves round one period: the recordings have no such sea.
  const components: SeaState["components"] = [];
  for (let i = 0; i < 14; ++i) {
    const omega = ((2 * Math.PI) / period) * (0.7 + 0.08 * i);
    const k = (omega * omega) / 9.81;
    const a = from + Math.PI + 0.5 * Math.sin(7 * i);
    const amplitude = 0.13 * height * Math.exp(-((i - 4) ** 2) / 18);
    components.push({
      k_x: k * Math.sin(a),
      k_y: k * Math.cos(a),
      omega,
      phase: 2.4 * i * i,
      amplitude_before: amplitude,
      amplitude_after: amplitude,
    });
  }
  return { time: 0, ramp_begin: 0, ramp_end: 0, tide_height: 0, components };
};

const kPictures: Record<string, Show> = {
  stand: { instant: "running", camera: "stand" },
  stand_housed: { instant: "housed", camera: "stand" },
  bow: { instant: "long_stay", camera: "bow" },
  bow_hanging: { instant: "hanging", camera: "bow" },
  brake: { instant: "two_shackles", camera: "brake" },
  aft: { instant: "two_shackles", camera: "aft" },
  outside: { instant: "hanging", camera: "outside" },
  outside_brought_up: { instant: "brought_up", camera: "outside", sea: sea(1.5, 6, 0) },
  housed: { instant: "housed", camera: "outside" },
  water: { instant: "brought_up", camera: "water" },
  landed: { instant: "landed", camera: "water" },
  free: { instant: "two_shackles", camera: "free" },
  bridge: { instant: "two_shackles", camera: "bridge" },
  cctv: { instant: "two_shackles", camera: "cctv" },
  loads: { instant: "brought_up", camera: "outside", loads: true },
  fire: { instant: "running", camera: "brake", tackle: { lining: 4, brake: 0.8, brake_noise: 3 } },
  smoke: { instant: "running", camera: "stand", tackle: { lining: 3, brake: 0.8 } },
  dusk: { instant: "two_shackles", camera: "stand", frame: { time_of_day: 18.2 * 3600 } },
  night_fog: {
    instant: "two_shackles",
    camera: "stand",
    frame: { time_of_day: 0.5 * 3600, visibility: 250 },
    sea: sea(2.5, 9, 0.3),
  },
  night: { instant: "long_stay", camera: "outside", frame: { time_of_day: 23 * 3600 } },
  bridge_night: { instant: "two_shackles", camera: "bridge", frame: { time_of_day: 23 * 3600 } },
  swell: { instant: "long_stay", camera: "stand", sea: sea(3, 9, 0.2), frame: { wind_speed: 15 } },
  seat_bow: { instant: "long_stay", camera: "bow", seat: true },
  seat_stand: { instant: "two_shackles", camera: "stand", seat: true },
  at_anchor: { instant: "brought_up", camera: "free", frame: { shows: { anchor_ball: true, anchor_lights: false } } },
  at_anchor_night: {
    instant: "brought_up",
    camera: "outside",
    frame: { time_of_day: 23 * 3600, shows: { anchor_ball: false, anchor_lights: true } },
  },
  weighing: { instant: "aweigh", camera: "bow" },
  high_stand: { instant: "two_shackles", camera: "stand", quality: "high" },
  high_outside: { instant: "hanging", camera: "outside", quality: "high", sea: sea(1, 6, 0.4) },
};

const [folder, ...names] = process.argv.slice(2);
if (!folder) throw new Error("usage: pictures.ts FOLDER [NAME...]");
await mkdir(folder, { recursive: true });
const pictured = (name: string): Show => {
  const show = kPictures[name];
  if (!show) throw new Error(`no picture ${name}: ${Object.keys(kPictures).join(", ")}`);
  return show;
};
const browser = await openScene();
try {
  for (const name of names.length > 0 ? names : Object.keys(kPictures)) {
    const stats = await browser.show(pictured(name));
    await browser.page.screenshot({ path: `${folder}/${name}.png` });
    console.log(name, JSON.stringify(stats));
  }
  if (browser.errors.length > 0) console.log(browser.errors.join("\n"));
} finally {
  await browser.close();
}
