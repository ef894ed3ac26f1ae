// What this seat may give. A control says by data-gives what it gives, and is not there (desk.css) where the seat may
// not, by what its station tells of it: who looks on is shown no lever that would move nothing.

import type { Hello } from "../wire/connection";
import type { TopicName } from "../wire/generated";

/** A topic of orders, or "files": recordings, debriefings and lessons, which are an instructor's. */
export type Gives = TopicName | "files";

/** A replay takes none of these. */
const ofLive: readonly Gives[] = [
  "InstructorWindlassCommand",
  "InstructorHelmCommand",
  "ExerciseCommand",
  "EnvironmentCommand",
  "FaultCommand",
  "BridgeOrderCommand",
  "AssessmentCommand",
];

/** All that the desk has controls for. */
const kControls: readonly Gives[] = [...ofLive, "ReplayCommand", "RestoreCommand", "files"];

export type SeatTold = Pick<Hello, "seat" | "commands">;

/** seat: as it was told; undefined: not yet, and then nothing is given. */
export function mayGive(seat: SeatTold | undefined, replay: boolean, what: Gives): boolean {
  if (!seat || (replay && ofLive.includes(what))) return false;
  return what === "files" ? seat.seat === "instructor" : seat.commands.includes(what);
}

/** The controls that are not there. */
export const withheld = (seat: SeatTold | undefined, replay: boolean): Gives[] =>
  kControls.filter((what) => !mayGive(seat, replay, what));
