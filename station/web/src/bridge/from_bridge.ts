// What is drawn for those who look out of the bridge's windows: BridgeView alone. GPS has steps of a metre and the
// gyro of a tenth of a degree, so both are evened out. No cable: that is seen from the forecastle.

import { between, mix, mixAngle } from "../scene/follow";
import type { SceneFrame } from "../scene/frame";
import type { Samples } from "../scene/from_truth";
import { trueWind } from "./wind";

const kPlaceTime = 3; // s, over which the steps of GPS are evened out
const kHeadingTime = 1.2; // s, the same for the gyro

export class LookingOut {
  private time = NaN; // s, exercise time of the last frame
  private x = 0;
  private y = 0;
  private heading = 0;
  private wind = { speed: 5, from: 0 };

  /** now: ms of performance.now(). Undefined before BridgeView is heard. */
  frame(link: Samples, now: number): SceneFrame | undefined {
    const found = between(link.track("BridgeView"), now);
    if (!found) return undefined;
    const { from, to, share, time } = found;
    const since = time - this.time;
    const fresh = !(since >= 0 && since < 2);
    const evened = (seconds: number): number => (fresh ? 1 : 1 - Math.exp(-since / seconds));
    this.time = time;
    // The eyes go on where an instrument fails: the world stays where it was.
    if (to.gps_works) {
      this.x = mix(this.x, mix(from.position.x, to.position.x, from.gps_works ? share : 1), evened(kPlaceTime));
      this.y = mix(this.y, mix(from.position.y, to.position.y, from.gps_works ? share : 1), evened(kPlaceTime));
    }
    if (to.gyro_works) {
      const heading = mixAngle(from.heading, to.heading, from.gyro_works ? share : 1);
      this.heading = mixAngle(this.heading, heading, evened(kHeadingTime));
    }
    if (to.anemometer_works)
      this.wind = trueWind(
        to.wind_speed_apparent,
        to.wind_from_apparent,
        this.heading,
        to.course_over_ground,
        to.speed_over_ground,
      );
    return {
      time,
      ship: {
        x: this.x,
        y: this.y,
        z: 0, // GPS tells her height to a metre only
        heading: this.heading,
        roll: mix(from.roll, to.roll, share),
        pitch: mix(from.pitch, to.pitch, share),
      },
      tackle: [undefined, undefined],
      wind_speed: this.wind.speed,
      wind_from: this.wind.from,
      visibility: to.visibility,
      time_of_day: to.time_of_day,
      shows: link.latest("LightsAndShapes"),
    };
  }
}
