// Who has the helm: docs/command_authority.md.

import type { Connection } from "../wire/connection";
import type { HelmCommand } from "../wire/generated";

/** ms without a word, after which nobody is there: the server waits 300, and a busy page may be late. */
const kSilent = 600;

export type HelmOwner = "nobody" | "mine" | "instructor" | "other page" | "other";

export interface HelmAuthority {
  owner: HelmOwner;
  /** Under which name the helm's orders come; empty: nobody. */
  name: string;
  /** The newest of them. */
  command: HelmCommand | undefined;
}

/** The newest command of a topic, while somebody speaks there. One sample alone may be an old one, kept by the station. */
function spoken(
  link: Connection,
  topic: "HelmCommand" | "InstructorHelmCommand",
  now: number,
): HelmCommand | undefined {
  const track = link.track(topic);
  const last = track.at(-1);
  return track.length > 1 && last && now - last.at < kSilent ? last.sample : undefined;
}

/** now: ms of performance.now(). */
export function helmAuthority(link: Connection, now: number): HelmAuthority {
  const instructor = spoken(link, "InstructorHelmCommand", now);
  const command = instructor ?? spoken(link, "HelmCommand", now);
  if (!command) return { owner: "nobody", name: "", command };
  const name = command.origin.source;
  const own = name === link.hello?.name && (link.hello.seat === "instructor") === (instructor !== undefined);
  if (own) return { owner: link.holds("helm") ? "mine" : "other page", name, command };
  return { owner: instructor ? "instructor" : "other", name, command };
}

/** For people: "mine", "instructor has taken over", "trainee-2", "nobody". */
export function helmOwnerWords({ owner, name }: HelmAuthority): string {
  if (owner === "instructor") return "instructor has taken over";
  if (owner === "other page") return "another page of this station";
  return owner === "other" ? name : owner;
}
