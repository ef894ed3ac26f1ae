// Figures of a briefing in the units of the gauges.

import assert from "node:assert/strict";
import { readFile, readdir } from "node:fs/promises";
import { join } from "node:path";
import { beforeEach, test } from "node:test";

import { inChosenUnits } from "../../src/kit/figures_in_text";
import { cableSpeeds, loads } from "../../src/kit/units";
import { root } from "../../tools/web.mjs";

beforeEach(() => {
  loads.choose(loads.options[0]);
  cableSpeeds.choose(cableSpeeds.options[0]);
});

test("the cable's speed is as on the counter, ship, wind and stream are in knots", () => {
  assert.equal(
    inChosenUnits(
      "wind north 8 m/s, stream 0.3 m/s to the south; cable not faster than 5.5 m/s in the fall and 3 m/s later",
    ),
    "wind north 16 kn, stream 0.6 kn to the south; cable not faster than 330 m/min in the fall and 180 m/min later",
  );
  assert.equal(
    inChosenUnits("cable's speed -0.122 m/s, at least -0.12 m/s"),
    "cable's speed -7.3 m/min, at least -7.2 m/min",
  );
  cableSpeeds.next();
  assert.equal(inChosenUnits("cable between 2 and 4 m/s"), "cable between 3.9 and 7.8 kn");
});

test("whose speed it is may stand after it, but not in another sentence", () => {
  assert.equal(inChosenUnits("2.5 m/s ahead over 20 m of sand."), "4.9 kn ahead over 20 m of sand.");
  assert.equal(inChosenUnits("The cable lies still. 1 m/s ahead."), "The cable lies still. 1.9 kn ahead.");
  assert.equal(
    inChosenUnits("The windlass turns. At 3 m/s it is fast. The wind falls."),
    "The windlass turns. At 3 m/s it is fast. The wind falls.",
  );
});

test("a load is as on the load cell's dial, and what is written in the unit that is chosen stays as it is", () => {
  assert.equal(inChosenUnits("not above 289 kN for long"), "not above 29 t for long");
  assert.equal(inChosenUnits("from 20 to 80 kN"), "from 2.0 to 8.2 t");
  loads.next();
  cableSpeeds.choose(cableSpeeds.options.at(-1)!);
  const text = "cable not faster than 5.5 m/s, 289 kN at most, 25 m of water, 6 shackles, 240 kN/m";
  assert.equal(inChosenUnits(text), text);
});

test("no speed or load of a shipped lesson's briefing stays in SI, or without its unit", async () => {
  const folder = join(root, "config/exercises");
  const left: string[] = [];
  let figures = 0;
  for (const file of (await readdir(folder)).filter((name) => name.endsWith(".json"))) {
    const { lesson } = JSON.parse(await readFile(join(folder, file), "utf8")) as { lesson?: { briefing?: string } };
    const text = lesson?.briefing ?? "";
    figures += text.match(/\d (m\/s|kN)\b/g)?.length ?? 0;
    for (const [found] of inChosenUnits(text).matchAll(
      /.{0,30}(?:\d (?:m\/s|kN)\b|(?:rising|rises|falling|falls) to \d+(?:\.\d+)?(?![\d.]*\d| kn\b)).{0,12}/g,
    ))
      left.push(`${file}: ${found}`);
  }
  assert.deepEqual(left, []);
  assert.ok(figures > 20, `${figures}`);
});
