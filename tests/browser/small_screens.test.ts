// Every control of every page can be reached on the screens that training rooms have, and on smaller ones by scrolling.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";

import { closeBrowser, closePage, openPage } from "./browser";
import { hadNoProblems, heard, unreachable } from "./pages";
import { Rig, eventually } from "./rig";

const kSizes: [number, number][] = [
  [1600, 900], // the widest arrangement at its narrowest
  [1280, 720],
  [1180, 820],
  [1024, 768],
  [820, 600], // scrolls
];

const rig = new Rig();
const urls: Record<string, string> = {};

before(
  async () => {
    rig.server("L05_standing_moor", "--wait"); // both windlasses
    Object.assign(urls, await rig.everyPage());
  },
  { timeout: 180000 },
);
after(async () => {
  await closeBrowser();
  await rig.end();
});

for (const [name, sign] of Object.entries(heard))
  test(`every control of the page ${name} can be reached at every size`, async () => {
    assert.ok(urls[name], `${Object.keys(urls)}`);
    const page = await openPage(urls[name].replace("#", "?picture=off#"), {
      viewport: { width: 1280, height: 720 },
      init: () => localStorage.setItem("windlass.views", "plan"),
    });
    await eventually("it has heard of the exercise", () => page.locator(sign).first().textContent());
    const missing: string[] = [];
    const briefing = page.getByRole("dialog", { name: "briefing" });
    if (await page.locator("dialog.briefing").count()) {
      await eventually("its briefing has opened by itself", () => briefing.isVisible());
      await briefing.getByRole("button", { name: "Close" }).click();
    }
    const look = async (where: string) => missing.push(...(await unreachable(page)).map((what) => `${where}: ${what}`));
    for (const [width, height] of kSizes) {
      await page.setViewportSize({ width, height });
      await look(`${width}x${height}`);
      const tabs = await page.getByRole("tab", { selected: false }).all();
      const names = await Promise.all(tabs.map((tab) => tab.textContent()));
      for (const tab of names) {
        await page.getByRole("tab", { name: tab, exact: true }).evaluate((el: HTMLElement) => el.click());
        await look(`${width}x${height}, ${tab}`);
      }
    }
    assert.deepEqual([...new Set(missing)], []);
    hadNoProblems(page);
    await closePage(page);
  });
