// What the ear makes of the view: the cable's speed from the gypsy's turn, and what the sound needs.

import type { WindlassHeard } from "../sound/deck";
import type { Connection, Heard } from "../wire/connection";
import type { ForecastleView, SceneTackle } from "../wire/generated";

const kLooked = 400; // ms of samples that a speed is judged by
const kSlow = 1; // m/s, from which the eye's steps will do
const kTurn = 40; // wire diameters of cable to a turn of the gypsy
const kMotorFull = { ampere: 300, pascal: 1.3e7 }; // a gauge at its end, for how loud the drive labours

/** rad turned between two samples, the short way. */
function turned(from: number, to: number): number {
  const d = to - from;
  return d - 2 * Math.PI * Math.round(d / (2 * Math.PI));
}

/** m/s, paying out positive: finer than the eye's steps as long as the gypsy turns slowly with its cable. */
export function cableSpeed(track: readonly Heard<ForecastleView>[], diameter: number, now: number): number {
  const last = track.at(-1);
  if (!last) return 0;
  const seen = last.sample.cable_speed_seen;
  if (last.sample.gypsy_jumping || Math.abs(seen) >= kSlow) return seen;
  let turn = 0;
  let first = last.sample;
  for (let i = track.length - 1; i > 0 && now - track[i - 1]!.at < kLooked; --i) {
    turn += turned(track[i - 1]!.sample.gypsy_turn, track[i]!.sample.gypsy_turn);
    first = track[i - 1]!.sample;
  }
  const time = last.sample.time - first.time;
  return time > 0 ? ((turn / (2 * Math.PI)) * kTurn * diameter) / time : 0;
}

/** For the sound of a side. running: false while exercise time stands still. */
export function heardOf(
  link: Connection,
  tackle: SceneTackle,
  now: number,
  running: boolean,
): WindlassHeard | undefined {
  const track = link.track("ForecastleView", tackle.side);
  const view = track.at(-1)?.sample;
  if (!view) return undefined;
  const hydraulic = tackle.drive === "hydraulic";
  const load = hydraulic ? view.motor_pressure / kMotorFull.pascal : view.motor_current / kMotorFull.ampere;
  return {
    cableSpeed: running ? cableSpeed(track, tackle.chain_diameter, now) : 0,
    load: view.load_cell_fitted ? Math.min(1, view.gypsy_load_indicated / view.breaking_load) : 0,
    jumping: view.gypsy_jumping,
    brakeNoise: running ? view.brake_noise : 0,
    heat: view.lining,
    drive: {
      speed: running ? view.motor_speed_heard : 0,
      load: running ? Math.min(1, load) : 0,
      power: view.power,
      tripped: view.tripped,
    },
    clutch: view.clutch,
  };
}
