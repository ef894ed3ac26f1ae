// Who has a set of levers, as every page tells it: docs/command_authority.md.

import type { Connection, Heard, HelmLevers } from "../wire/connection";
import type { HelmCommand, WindlassCommand } from "../wire/generated";
import { isUnheard } from "./live";
import { clock, sideWord } from "./units";
import { t } from "./language";

/** unheard: no server is heard that would obey anybody. */
export type Owner = "nobody" | "mine" | "instructor" | "other page" | "other" | "unheard";

export interface Authority<Command> {
  owner: Owner;
  /** Under which name the levers' orders come; empty: nobody. */
  name: string;
  /** The newest of them. */
  command: Command | undefined;
}

/** Whom the server obeys. */
interface Speaker<Command> {
  command: Command;
  instructor: boolean;
}

/** Whose levers of a side the server obeys: an instructor who speaks before a trainee. now: ms of performance.now(). */
function windlassSpeaker(link: Connection, side: number, now: number): Speaker<WindlassCommand> | undefined {
  return speaker(link.track("WindlassCommand", side), link.track("InstructorWindlassCommand", side), silent(link), now);
}

/** Whose helm the server obeys; now: ms of performance.now(). */
function helmSpeaker(link: Connection, now: number): Speaker<HelmCommand> | undefined {
  return speaker(link.track("HelmCommand"), link.track("InstructorHelmCommand"), silent(link), now);
}

/** Who has the levers of a side, as this page sees it; now: ms of performance.now(). */
export function windlassAuthority(link: Connection, side: number, now: number): Authority<WindlassCommand> {
  return authority(link, windlassSpeaker(link, side, now), link.holds(side));
}

/** Who has the helm, as this page sees it; now: ms of performance.now(). */
export function helmAuthority(link: Connection, now: number): Authority<HelmCommand> {
  return authority(link, helmSpeaker(link, now), link.holds("helm"));
}

/** Set points of a windlass as they were given last, by whichever hand: they stand when it has left. */
export function windlassOrdered(link: Connection, side: number): WindlassCommand | undefined {
  return newer(link.track("WindlassCommand", side), link.track("InstructorWindlassCommand", side));
}

/** Telegraph, wheel and thruster levers as the server has them, whoever put them there last. */
export function helmOrdered(link: Connection): HelmLevers | undefined {
  const view = link.latest("BridgeView");
  if (!view) return undefined;
  return {
    engine: view.engine_ordered,
    rudder: view.rudder_ordered,
    bow_thruster: view.bow_thruster_ordered,
    stern_thruster: view.stern_thruster_ordered,
  };
}

/** For people: "mine", "instructor has taken over", "trainee-2", "nobody". */
export function ownerWords({ owner, name }: Omit<Authority<unknown>, "command">): string {
  if (owner === "instructor") return t("instructor has taken over");
  if (owner === "unheard") return t("no server");
  if (owner === "other page") return t("another page of this station");
  if (owner === "mine") return t("mine");
  return owner === "nobody" ? t("nobody") : name;
}

/** Of a message that another station has these levers now: "desk-2 has the port windlass, at 0:12: ..."; else "". */
export function takenWords(link: Connection, message: Record<string, unknown>): string {
  const taker = message.taken_by as string | undefined;
  if (!taker) return "";
  const by = taker === link.hello?.name ? t("Another station named {name}", { name: taker }) : taker;
  const time = clock(link.latest("ExerciseStatus")?.time ?? 0);
  if (message.helm === true) return t("{by} has the helm, at {time}: your hand is off it", { by, time });
  const side = sideWord(message.side as number);
  return t("{by} has the {side} windlass, at {time}: your hand is off it", { by, side, time });
}

/** An instructor's own page knows its hand on the instructor's topic. */
function authority<Command extends HelmCommand | WindlassCommand>(
  link: Connection,
  speaks: Speaker<Command> | undefined,
  held: boolean,
): Authority<Command> {
  if (isUnheard(link)) return { owner: "unheard", name: "", command: speaks?.command };
  if (!speaks) return { owner: "nobody", name: "", command: undefined };
  const { command, instructor } = speaks;
  const name = command.origin.source;
  const own = name === link.hello?.name && (link.hello.seat === "instructor") === instructor;
  if (own) return { owner: held ? "mine" : "other page", name, command };
  return { owner: instructor ? "instructor" : "other", name, command };
}

/** ms without a word, after which nobody is there, as the station has it. */
function silent(link: Connection): number {
  return 1000 * (link.hello?.hand_silent ?? 0);
}

function speaker<Command>(
  trainees: readonly Heard<Command>[],
  instructors: readonly Heard<Command>[],
  within: number,
  now: number,
): Speaker<Command> | undefined {
  const instructor = spoken(instructors, within, now);
  const command = instructor ?? spoken(trainees, within, now);
  return command && { command, instructor: instructor !== undefined };
}

function newer<Command>(one: readonly Heard<Command>[], other: readonly Heard<Command>[]): Command | undefined {
  const [a, b] = [one.at(-1), other.at(-1)];
  return (b && (!a || b.at > a.at) ? b : a)?.sample;
}

/** The newest command, while somebody speaks. One sample alone may be an old one, kept by the station. */
function spoken<Command>(track: readonly Heard<Command>[], within: number, now: number): Command | undefined {
  const last = track.at(-1);
  return track.length > 1 && last && now - last.at < within ? last.sample : undefined;
}
