// What an exercise does, in words.

import { RunState } from "../wire/generated";
import { saidOf } from "./words";

/** A replay in capitals: nobody is to take it for what is now. */
export function runStateWords(state: RunState): string {
  const said = saidOf("RunState", state);
  return state === RunState.RUN_REPLAY ? said.toUpperCase() : said;
}
