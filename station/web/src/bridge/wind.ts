// The true wind of the apparent one.

export interface Wind {
  speed: number; // m/s
  from: number; // rad clockwise from north
}

/**
 * apparent speed (m/s) and direction (rad clockwise from ahead, that it comes from); heading, course (rad), speed over
 * ground (m/s). The air moves over ground as it moves past the ship, and with her.
 */
export function trueWind(speed: number, fromBow: number, heading: number, course: number, overGround: number): Wind {
  const from = heading + fromBow;
  const east = -speed * Math.sin(from) + overGround * Math.sin(course);
  const north = -speed * Math.cos(from) + overGround * Math.cos(course);
  const angle = Math.atan2(-east, -north);
  return { speed: Math.hypot(east, north), from: angle < 0 ? angle + 2 * Math.PI : angle };
}
