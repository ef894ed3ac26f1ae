// Who has the levers of a windlass: docs/command_authority.md.

import type { Connection } from "../wire/connection";
import type { WindlassCommand } from "../wire/generated";

/** ms without a word, after which nobody is there: the server waits 300, and a busy page may be late. */
const kSilent = 600;

export type Owner = "nobody" | "mine" | "instructor" | "other page" | "other";

export interface Authority {
  owner: Owner;
  /** Under which name the levers' orders come; empty: nobody. */
  name: string;
  /** Their orders, the newest. */
  command: WindlassCommand | undefined;
}

/** The newest command of a topic, while somebody speaks there. One sample alone may be an old one, kept by the station. */
function spoken(
  link: Connection,
  topic: "WindlassCommand" | "InstructorWindlassCommand",
  side: number,
  now: number,
): WindlassCommand | undefined {
  const track = link.track(topic, side);
  const last = track.at(-1);
  return track.length > 1 && last && now - last.at < kSilent ? last.sample : undefined;
}

/** Who has the levers of a side; now: ms of performance.now(). */
export function authority(link: Connection, side: number, now: number): Authority {
  const instructor = spoken(link, "InstructorWindlassCommand", side, now);
  if (instructor) return { owner: "instructor", name: instructor.origin.source, command: instructor };
  const command = spoken(link, "WindlassCommand", side, now);
  if (!command) return { owner: "nobody", name: "", command };
  const name = command.origin.source;
  if (name !== link.hello?.name) return { owner: "other", name, command };
  return { owner: link.holds(side) ? "mine" : "other page", name, command };
}

/** For the top bar: "mine", "instructor has taken over", "trainee-2", "nobody". */
export function ownerWords({ owner, name }: Authority): string {
  if (owner === "instructor") return "instructor has taken over";
  if (owner === "other page") return "another page of this station";
  return owner === "other" ? name : owner;
}
