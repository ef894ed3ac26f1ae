// What every page must pass.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { createRequire } from "node:module";

import { web } from "./browser.mjs";

/** No finding of axe-core that is serious or critical. */
export async function passesAxe(page) {
  const axe = createRequire(join(web, "package.json")).resolve("axe-core/axe.min.js");
  await page.evaluate(await readFile(axe, "utf8"));
  const { violations } = await page.evaluate(() => window.axe.run(document, { resultTypes: ["violations"] }));
  const serious = violations.filter(({ impact }) => impact === "serious" || impact === "critical");
  assert.deepEqual(
    serious.map(({ id, nodes }) => `${id}: ${nodes.map((n) => `${n.target} ${n.failureSummary}`).join("; ").slice(0, 600)}`),
    [],
  );
}

/** What a screen reader jumps to first. */
export const hasOneHeading = async (page) =>
  assert.equal(await page.locator("h1").count(), 1, "a page has one heading of the first order");

/** Every palette colours the page anew, and can be read in each. */
export async function hasPalettes(page, { axe = true } = {}) {
  await hasOneHeading(page);
  const seen = new Set();
  for (let i = 0; i < 4; ++i) {
    seen.add(await page.evaluate(() => `${document.documentElement.dataset.obcTheme} ${getComputedStyle(document.body).color}`));
    if (axe) await passesAxe(page);
    await page.getByRole("button", { name: /^palette/ }).click();
  }
  assert.equal(new Set([...seen].map((s) => s.split(" ")[0])).size, 4, `${[...seen]}`);
}

/** Nothing on the console, nothing from elsewhere. */
export const hadNoProblems = (page) => assert.deepEqual(page.problems, []);
