// What an exercise does, in words.

import { RunState } from "../wire/generated";

export const runStateWords: Record<RunState, string> = {
  [RunState.RUN_READY]: "ready",
  [RunState.RUN_RUNNING]: "running",
  [RunState.RUN_PAUSED]: "paused",
  [RunState.RUN_FINISHED]: "finished",
  [RunState.RUN_STOPPED_BY_FAULT]: "stopped by a fault",
  [RunState.RUN_REPLAY]: "REPLAY",
};
