// What the bridge's camera on the forecastle tells of men and of the windlass that is worked.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { test } from "node:test";

import { WorkedWindlass } from "../../src/bridge/from_camera";
import type { TackleFrame } from "../../src/scene/frame";
import { nothingSeen, tackleSeen } from "../../src/scene/from_seat";
import type { Samples } from "../../src/scene/from_truth";
import { DeckHindrance, DeckWork } from "../../src/wire/generated";
import { root } from "../../tools/web.mjs";
import { OneInstant, type Recorded } from "../scene/samples";

const recorded = JSON.parse(await readFile(join(root, "station/web/tests/scene/instants.json"), "utf8")) as Recorded;

/** What the camera shows of the port windlass, the men being so. */
function camera(men: object): TackleFrame {
  const told = new OneInstant(recorded, "hanging", { "ForecastleView/0": men });
  const link: Samples = {
    latest: told.latest.bind(told),
    track: (topic, key) =>
      (topic === "ForecastleCamera" ? told.track("ForecastleView", key) : told.track(topic, key)) as never,
  };
  return tackleSeen(link, "ForecastleCamera", 0, 0, nothingSeen(), undefined)!;
}

test("men are at the work that the camera shows them at, for which it tells no time", () => {
  const shown = camera({ deck_work: DeckWork.DECK_WORK_BREAK_CABLE, deck_work_left: 0 });
  assert.deepEqual(shown.men, { work: DeckWork.DECK_WORK_BREAK_CABLE, goes: true });
  const none = camera({ deck_work: DeckWork.DECK_WORK_NONE, deck_work_waits: DeckHindrance.DECK_HINDRANCE_NONE });
  assert.deepEqual(none.men, { work: DeckWork.DECK_WORK_NONE, goes: true });
});

test("the windlass whose lever was moved last, or whose cable moves, is the one that is worked", () => {
  const worked = new WorkedWindlass();
  const at = (side: number, changes: Partial<TackleFrame> = {}): TackleFrame => ({
    ...camera({}),
    side,
    cable_speed: 0,
    ...changes,
  });
  worked.see([at(0), at(1)]);
  assert.equal(worked.side, undefined);
  worked.see([at(0), at(1, { brake: 0.3 })]);
  worked.see([at(0), at(1, { brake: 0.3 })]);
  assert.equal(worked.side, 1);
  worked.see([at(0, { cable_speed: -0.25 }), at(1, { brake: 0.3 })]);
  assert.equal(worked.side, 0);
});
