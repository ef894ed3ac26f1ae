// What every page must pass.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { join } from "node:path";

import { web } from "../../station/web/tools/web.mjs";

/** No finding of axe-core that is serious or critical. */
export async function passesAxe(page) {
  await page.evaluate(await readFile(join(web, "node_modules/axe-core/axe.min.js"), "utf8"));
  const { violations } = await page.evaluate(() => window.axe.run(document, { resultTypes: ["violations"] }));
  const serious = violations.filter(({ impact }) => impact === "serious" || impact === "critical");
  assert.deepEqual(
    serious.map(
      ({ id, nodes }) =>
        `${id}: ${nodes
          .map((n) => `${n.target} ${n.failureSummary}`)
          .join("; ")
          .slice(0, 600)}`,
    ),
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
    seen.add(
      await page.evaluate(
        () => `${document.documentElement.dataset.obcTheme} ${getComputedStyle(document.body).color}`,
      ),
    );
    if (axe) await passesAxe(page);
    await page.getByRole("button", { name: /^palette/ }).click();
  }
  assert.equal(new Set([...seen].map((s) => s.split(" ")[0])).size, 4, `${[...seen]}`);
}

/** Nothing on the console, nothing from elsewhere. */
export const hadNoProblems = (page) => assert.deepEqual(page.problems, []);

/**
 * Names of the controls that a hand cannot reach: cut off where nothing scrolls, or under something else. A control
 * that a scrolling box would bring into sight is scrolled there first.
 */
export const unreachable = (page) =>
  page.evaluate(() => {
    const name = (el) =>
      `${el.getAttribute("aria-label") || el.textContent.trim() || el.getAttribute("title") || el.name} <${el.tagName.toLowerCase()} ${el.className.baseVal ?? el.className}>`;
    const boxOf = (el) => {
      const { left, top, right, bottom } = el.getBoundingClientRect();
      return { left, top, right, bottom };
    };
    const inside = (box, of, slack = 2) =>
      box.left >= of.left - slack &&
      box.top >= of.top - slack &&
      box.right <= of.right + slack &&
      box.bottom <= of.bottom + slack;
    /** What cuts it off for good; empty: nothing. */
    const cutBy = (el) => {
      let box = boxOf(el);
      for (
        let around = el.parentElement;
        around && around !== document.documentElement;
        around = around.parentElement
      ) {
        const { overflowX, overflowY, display } = getComputedStyle(around);
        if (display === "contents") continue;
        const own = boxOf(around);
        const scrolls = (overflow) => overflow === "auto" || overflow === "scroll";
        if (scrolls(overflowX)) ((box.left = own.left), (box.right = own.right));
        if (scrolls(overflowY)) ((box.top = own.top), (box.bottom = own.bottom));
        const cut = { left: -Infinity, top: -Infinity, right: Infinity, bottom: Infinity };
        if (overflowX !== "visible") ((cut.left = own.left), (cut.right = own.right));
        if (overflowY !== "visible") ((cut.top = own.top), (cut.bottom = own.bottom));
        if (around === document.body) Object.assign(cut, { left: 0, top: 0, right: innerWidth, bottom: innerHeight });
        if (!inside(box, cut)) return `cut off by <${around.tagName.toLowerCase()} ${around.className}>`;
      }
      return "";
    };
    const found = [];
    const controls =
      "button, input, select, textarea, summary, a[href], [role=slider], [role=switch], [role=button], [role=tab]";
    for (const el of document.querySelectorAll(controls)) {
      if (!el.checkVisibility({ visibilityProperty: true }) || el.matches("[hidden] *, .sr-only *")) continue;
      const { width, height } = el.getBoundingClientRect();
      if (width < 1 || height < 1) continue;
      const cut = cutBy(el);
      if (cut) {
        found.push(`${name(el)}: ${cut}`);
        continue;
      }
      el.scrollIntoView({ block: "nearest", inline: "nearest" });
      const box = boxOf(el);
      const hit = document.elementFromPoint((box.left + box.right) / 2, (box.top + box.bottom) / 2);
      const same = hit && (el.contains(hit) || hit.contains(el) || hit.closest("label")?.control === el);
      if (!same)
        found.push(`${name(el)}: under <${hit?.tagName.toLowerCase()} ${hit?.className?.baseVal ?? hit?.className}>`);
    }
    return found;
  });
