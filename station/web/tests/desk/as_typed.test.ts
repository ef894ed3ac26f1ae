// A refusal is read in the unit that was typed, and what it allows is allowed.

import assert from "node:assert/strict";
import { test } from "node:test";

import { asTyped, inMinutes, inUnit } from "../../src/desk/as_typed";

const knots = (field: string) => (field === "wind_speed" ? inUnit("wind, speed", "kn", 1852 / 3600) : undefined);

test("500 kn are refused as 500 kn, and what is allowed is not more than the server takes", () => {
  assert.equal(
    asTyped(
      "EnvironmentCommand from desk-1: weather.wind_speed = 257.22222222222223 refused; allowed: 0..60 m/s",
      knots,
    ),
    "Environment: wind, speed 500 kn refused; allowed: 0 to 116.6 kn",
  );
});

test("angles, times and limits below zero", () => {
  const degrees = inUnit("wind, from", "\u00b0", Math.PI / 180);
  assert.equal(
    asTyped(
      "EnvironmentCommand from d: weather.wind_from = 12.566370614359172 refused; " +
        "allowed: -6.283185307179586..6.283185307179586 rad",
      () => degrees,
    ),
    "Environment: wind, from 720 \u00b0 refused; allowed: \u2212360 to 360 \u00b0",
  );
  assert.equal(
    asTyped("FaultCommand from d: trigger_value = 7200000 refused; allowed: 0..1000000 s", () => inMinutes("at time")),
    "Fault: at time 2000:00:00 refused; allowed: 0:00 to 277:46:40",
  );
});

test("what is allowed in words stays, and so does what was not typed", () => {
  assert.equal(
    asTyped(
      "EnvironmentCommand from d: weather.wave_period = 1 refused; " +
        "allowed: at least 3.6 s for 2 m: steeper waves break",
      () => inUnit("wind sea, period", "s", 1),
    ),
    "Environment: wind sea, period 1 s refused; allowed: at least 3.6 s for 2 m: steeper waves break",
  );
  for (const other of ["EnvironmentCommand from d: weather.gust_factor = 9 refused; allowed: 1..2", "no server"])
    assert.equal(asTyped(other, knots), other);
});
