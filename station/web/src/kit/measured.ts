// Whether a load was computed. The first tick does that: before it an exercise that was just set up says 0 of all of
// them, and one that begins at anchor has those that she lay with.

/** Samples with the s of exercise time that they are of. */
interface OfTime {
  time: number;
}
/** N, of WindlassLoad: one of them bears the cable, whatever the levers are at. */
export interface Bearing extends OfTime {
  hawse_tension: number;
  gypsy_load: number;
  brake_load: number;
  stopper_load: number;
  motor_load: number;
}

/** Of the loads of a side as they are. */
export const loadsMeasured = (load: Bearing): boolean =>
  load.time > 0 ||
  [load.hawse_tension, load.gypsy_load, load.brake_load, load.stopper_load, load.motor_load].some((n) => n !== 0);

/** Of the load cell's gauge. */
export const gaugeMeasured = (view: OfTime & { gypsy_load_indicated: number }): boolean =>
  view.time > 0 || view.gypsy_load_indicated !== 0;
