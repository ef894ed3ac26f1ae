// Every pad that opens for a figure, a lead or an answer, and for an order's figure on the bridge, lies within the window,
// on a tablet, a small screen and a phone, in both languages, and each of its buttons gets the touch.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";

import type { Locator } from "playwright-core";

import { type TestPage, closeBrowser, closePage, openPage } from "./browser";
import { hadNoProblems } from "./pages";
import { Rig, eventually } from "./rig";

const kSizes: [number, number][] = [
  [1024, 768],
  [1280, 800],
  [390, 844],
];
const kLanguages = ["en-GB", "de-DE"];

const rig = new Rig();
const pages: TestPage[] = [];

before(
  async () => {
    rig.server("anchor_and_weigh_25m");
    const station = await rig.station("forecastle");
    for (const locale of kLanguages) {
      const page = await openPage(station.url.replace("#", "?picture=off#"), {
        hasTouch: true,
        isMobile: true,
        locale,
      });
      await eventually("it has heard of the windlass", () => page.locator(".counter strong").first().textContent());
      pages.push(page);
    }
  },
  { timeout: 180000 },
);
after(async () => {
  await closeBrowser();
  await rig.end();
});

/** Buttons and fields of the pad that lies open which lie beyond the window, or under something else. */
const outOfTouch = (page: TestPage, pad = ".popover"): Promise<string[]> =>
  page.locator(pad).evaluate((pad) =>
    [...pad.querySelectorAll("button, [role=button], input")].flatMap((control) => {
      const { left, top, right, bottom } = control.getBoundingClientRect();
      const within = left >= 0 && top >= 0 && right <= innerWidth && bottom <= innerHeight;
      const hit = document.elementFromPoint((left + right) / 2, (top + bottom) / 2);
      const name = control.textContent || control.getAttribute("aria-label");
      return within && control.contains(hit) ? [] : [`${name} at ${Math.round(left)}, ${Math.round(top)}`];
    }),
  );

const touch = (button: Locator) => button.evaluate((el: HTMLElement) => el.click());
const sized = async (page: TestPage, [width, height]: [number, number]) => {
  await page.setViewportSize({ width, height });
  return `${await page.locator("html").getAttribute("lang")}, ${width}x${height}`;
};

/** What is wrong with the pad that a button opens, and with those that are opened from it. */
async function look(page: TestPage, opener: Locator, where: string): Promise<string[]> {
  const close = () => touch(page.locator(".popover > .row button"));
  const wrong: string[] = [];
  const see = async () => {
    const title = await page.locator(".popover h2").textContent();
    assert.ok((await page.locator(".popover :is(button, input)").count()) > 1, `${title}: there is what is touched`);
    wrong.push(...(await outOfTouch(page)).map((what) => `${where}, ${title}: ${what}`));
  };
  await touch(opener);
  const more = page.locator(".popover button[aria-haspopup]");
  const count = await more.count();
  await see();
  for (let k = 0; k < count; ++k) {
    if ((await more.count()) === 0) {
      await close();
      await touch(opener);
    }
    await touch(more.nth(k));
    await see();
  }
  await close();
  assert.equal(await page.locator(".popover").count(), 0);
  return wrong;
}

test("every report that asks for more is to be had", { timeout: 300000 }, async () => {
  const wrong: string[] = [];
  for (const page of pages)
    for (const size of kSizes) {
      const where = await sized(page, size);
      const seen = new Set<string>();
      for (const leaf of await page.locator(".leaves button[data-leaf]").all()) {
        await touch(leaf);
        for (const opener of await page.locator(".report-pad button[aria-haspopup]").all()) {
          const name = await opener.textContent();
          if (!seen.has(name)) wrong.push(...(await look(page, opener, where)));
          seen.add(name);
        }
      }
      for (const name of ["Unsafe", "Lead", "Growing, weight", "n on deck", "n in water", "n in pipe"])
        assert.ok(seen.has(name), name);
      wrong.push(...(await look(page, page.locator(".leaves button[aria-haspopup]"), where))); // in own words
    }
  assert.deepEqual(wrong, []);
});

/** Gives an order, and looks at what its button opens, everywhere. */
async function lookAtOrder(...order: string[]): Promise<string[]> {
  const wrong: string[] = [];
  const before = await pages[0].locator(".orders li").count();
  await rig.say("order", ...order, "--side", "port");
  for (const page of pages) {
    await eventually("it is heard", async () => (await page.locator(".orders li").count()) > before);
    const opener = page.locator(".orders li").first().getByRole("button");
    assert.equal(await opener.getAttribute("aria-haspopup"), "dialog", `${order}`);
    assert.notEqual(
      await opener.evaluate((el) => getComputedStyle(el).backgroundImage),
      "none",
      "its corner is marked",
    );
    for (const size of kSizes) wrong.push(...(await look(page, opener, await sized(page, size))));
  }
  return wrong;
}

test("the repeat of an order with a figure has a marked corner, and its pad is to be had", async () => {
  assert.deepEqual([...(await lookAtOrder("hold-on", "6")), ...(await lookAtOrder("walk-out", "5"))], []);
  await rig.say("order", "stand-by", "--side", "port");
  const bare = pages[0].locator(".orders li", { hasText: "stand by" }).getByRole("button");
  await bare.waitFor();
  assert.equal(await bare.getAttribute("aria-haspopup"), null, "one touch says it");
  assert.equal(await bare.evaluate((el) => getComputedStyle(el).backgroundImage), "none");
});

test("what answers a question is to be had, each answer once", { timeout: 300000 }, async () => {
  const wrong: string[] = [];
  for (const question of ["how-much", "how-leading", "how-growing", "how-much-weight", "brought-up"])
    wrong.push(...(await lookAtOrder(question)));
  assert.deepEqual(wrong, []);
  await rig.say("order", "how-leading", "--side", "port");
  const [page] = pages;
  await eventually("it is asked again", () => page.locator(".orders li").first().getByRole("button").isVisible());
  await touch(page.locator(".orders li").first().getByRole("button"));
  const answers = await page.locator(".popover .choices button").allTextContents();
  assert.deepEqual(answers, ["Up and down", "Short stay", "Medium stay", "Long stay"]);
  await touch(page.locator(".popover > .row button"));
});

test("the figure of every order is to be had on the bridge", { timeout: 300000 }, async () => {
  const station = await rig.station("bridge");
  const wrong: string[] = [];
  for (const locale of kLanguages) {
    const page = await openPage(station.url.replace("#", "?picture=off#"), { hasTouch: true, isMobile: true, locale });
    const openers = page.locator(".order-buttons button", { hasText: "\u2026" });
    await eventually("it may give orders", () => openers.first().isEnabled());
    for (const size of kSizes) {
      const where = await sized(page, size);
      for (const opener of await openers.all()) {
        await touch(opener);
        const pad = await page.locator(".figure-pad").getAttribute("aria-label");
        assert.ok((await page.locator(".figure-pad button").count()) > 10, pad);
        wrong.push(...(await outOfTouch(page, ".figure-pad")).map((what) => `${where}, ${pad}: ${what}`));
        await touch(opener);
      }
    }
    hadNoProblems(page);
    await closePage(page);
  }
  assert.deepEqual(wrong, []);
});

test("however many orders have come, the page is no higher than the window", async () => {
  for (let n = 1; n <= 6; ++n) await rig.say("order", "hold-on", `${n}`, "--side", "port");
  for (const page of pages)
    for (const size of kSizes) {
      const where = await sized(page, size);
      const beyond = () => page.evaluate(() => document.documentElement.scrollHeight - innerHeight);
      assert.equal(await beyond(), 0, where);
    }
  for (const page of pages) hadNoProblems(page);
});
