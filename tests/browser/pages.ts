// What every page must pass.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { join } from "node:path";

import { root } from "../../station/web/tools/web.mjs";
import type { Locator, Page } from "playwright-core";
import { type TestPage, openPage } from "./browser";
import { eventually } from "./rig";

/** What shows that a page has heard of the exercise, by its name. */
export const heard = {
  forecastle: ".counter strong",
  bridge: ".readout strong",
  watch: ".readout strong",
  instructor: ".truth tbody tr",
  classroom: ".tile",
  lessons: "main button",
};

/** No finding of axe-core that is serious or critical. */
export async function passesAxe(page: Page): Promise<void> {
  await page.evaluate(await readFile(join(root, "build/web/node_modules/axe-core/axe.min.js"), "utf8"));
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
export const hasOneHeading = async (page: TestPage): Promise<void> =>
  assert.equal(await page.locator("h1").count(), 1, "a page has one heading of the first order");

/** Every palette colours the page anew, and can be read in each. */
export async function hasPalettes(page: TestPage, { axe = true } = {}): Promise<void> {
  await hasOneHeading(page);
  const seen = new Set<string>();
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

/** The page Class of a door's first owner, anna, set up by the link that the door has printed. */
export async function firstOwner(setup: string): Promise<TestPage> {
  const owner = await openPage(setup, { ignoreHTTPSErrors: true });
  await owner.locator("input[name=name]").fill("anna");
  await owner.locator("input[name=password]").fill("a long password");
  await owner.locator("input[type=password]").last().fill("a long password");
  await owner.getByRole("button", { name: "Set up", exact: true }).click();
  await owner.waitForURL(/\/class$/);
  return owner;
}

/** Opens a class of L01 by the form for a new one. crew: trainees to each exercise. Returns its code. */
export async function openClass(owner: Page, exercises: number, crew = 1): Promise<string> {
  await owner.locator("select option").first().waitFor({ state: "attached" });
  await owner.locator("select").first().selectOption("L01_let_go_25m");
  await owner.locator("input[type=number]").fill(`${exercises}`);
  await owner.locator("select").last().selectOption(`${crew}`);
  await owner.getByRole("button", { name: "Open the class", exact: true }).click();
  return (await owner.locator(".code-panel .letters").textContent()).replace(/ /g, "");
}

/** Holds a button down until it acts, however long a busy page takes for that. */
export async function holdDown(page: Page, button: Locator): Promise<void> {
  const held = button.and(page.locator("[data-held]"));
  await button.hover();
  await page.mouse.down(); // comes back when the page has seen it
  assert.equal(await held.count(), 1, "it is a button that is held, and can be");
  await eventually("it acts", async () => (await held.count()) === 0);
  await page.mouse.up();
}

/** Nothing on the console, nothing from elsewhere. */
export const hadNoProblems = (page: TestPage): void => assert.deepEqual(page.problems, []);

/**
 * Names of the controls that a hand cannot reach: cut off where nothing scrolls, or under something else. A control
 * that a scrolling box would bring into sight is scrolled there first.
 */
export const unreachable = (page: TestPage): Promise<string[]> => outOfReach(page, "controls");

/** What is written and cannot be read whole: cut off where nothing scrolls and not by three dots, or beyond its button. */
export const cutOff = (page: TestPage): Promise<string[]> => outOfReach(page, "texts");

/** Controls that are smaller than a finger needs, px (WCAG 2.5.5): their names and sizes. */
export const smallTargets = (page: TestPage): Promise<string[]> => outOfReach(page, "targets");

const outOfReach = (page: TestPage, what: "controls" | "texts" | "targets"): Promise<string[]> =>
  page.evaluate((of) => {
    const kFinger = 44;
    const kindOf = (el: Element): string => `<${el.tagName.toLowerCase()} ${el.getAttribute("class") ?? ""}>`;
    const name = (el: Element): string => {
      const label = ["aria-label", "title", "name"].map((attribute) => el.getAttribute(attribute));
      return `${label[0] || el.textContent.trim() || label[1] || label[2]} ${kindOf(el)}`;
    };
    type Box = Record<"left" | "top" | "right" | "bottom", number>;
    const boxOf = (at: Element | Range): Box => {
      const { left, top, right, bottom } = at.getBoundingClientRect();
      return { left, top, right, bottom };
    };
    const inside = (box: Box, around: Box, slack = 2) =>
      box.left >= around.left - slack &&
      box.top >= around.top - slack &&
      box.right <= around.right + slack &&
      box.bottom <= around.bottom + slack;
    /** What cuts a box off for good, from the innermost element around it on; empty: nothing. */
    const cutBy = (box: Box, innermost: Element): string => {
      for (let around = innermost; around && around !== document.documentElement; around = around.parentElement) {
        const { overflowX, overflowY, display, textOverflow } = getComputedStyle(around);
        if (display === "contents") continue;
        if (textOverflow === "ellipsis") return "";
        const own = boxOf(around);
        const scrolls = (overflow: string) => overflow === "auto" || overflow === "scroll";
        const [across, upright] = [
          { left: own.left, right: own.right },
          { top: own.top, bottom: own.bottom },
        ];
        if (scrolls(overflowX)) Object.assign(box, across);
        if (scrolls(overflowY)) Object.assign(box, upright);
        const cut = { left: -Infinity, top: -Infinity, right: Infinity, bottom: Infinity };
        if (overflowX !== "visible") Object.assign(cut, across);
        if (overflowY !== "visible") Object.assign(cut, upright);
        if (around === document.body) Object.assign(cut, { left: 0, top: 0, right: innerWidth, bottom: innerHeight });
        if (around === document.body && scrolls(overflowY)) Object.assign(cut, { top: -Infinity, bottom: Infinity });
        if (!inside(box, cut)) return `cut off by ${kindOf(around)}`;
      }
      return "";
    };
    const isSeen = (el: Element): boolean => {
      if (!el.checkVisibility({ visibilityProperty: true }) || el.closest("[hidden], .sr-only")) return false;
      const { width, height } = el.getBoundingClientRect();
      return width >= 1 && height >= 1;
    };
    const found: string[] = [];
    if (of === "texts") {
      const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
      for (let text = texts.nextNode(); text; text = texts.nextNode()) {
        if (!text.textContent.trim() || !isSeen(text.parentElement) || text.parentElement.closest("option")) continue;
        const range = document.createRange();
        range.selectNodeContents(text);
        const button = text.parentElement.closest("button");
        const cut =
          button && !inside(boxOf(range), boxOf(button))
            ? `beyond ${kindOf(button)}`
            : cutBy(boxOf(range), text.parentElement);
        if (cut) found.push(`"${text.textContent.trim()}" in ${kindOf(text.parentElement)}: ${cut}`);
      }
      return found;
    }
    const controls =
      "button, input, select, textarea, summary, a[href], [role=slider], [role=switch], [role=button], [role=tab]";
    for (const el of document.querySelectorAll(controls)) {
      if (!isSeen(el)) continue;
      if (of === "targets") {
        const { width, height } = el.getBoundingClientRect();
        if (Math.min(width, height) < kFinger - 0.5)
          found.push(`${name(el)}: ${width.toFixed(0)} x ${height.toFixed(0)}`);
        continue;
      }
      const cut = cutBy(boxOf(el), el.parentElement);
      if (cut) {
        found.push(`${name(el)}: ${cut}`);
        continue;
      }
      el.scrollIntoView({ block: "nearest", inline: "nearest" });
      const box = boxOf(el);
      const hit = document.elementFromPoint((box.left + box.right) / 2, (box.top + box.bottom) / 2);
      const same = hit && (el.contains(hit) || hit.contains(el) || hit.closest("label")?.control === el);
      if (!same) found.push(`${name(el)}: under ${hit ? kindOf(hit) : "nothing"}`);
    }
    return found;
  }, what);
