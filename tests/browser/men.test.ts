// The men on deck, set to work from the page: they wait and say why, and stand clear again.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";

import { type TestPage, closeBrowser, openPage } from "./browser";
import { hadNoProblems, passesAxe } from "./pages";
import { Rig, eventually } from "./rig";

const rig = new Rig();
let page: TestPage;

before(
  async () => {
    rig.server("at_anchor_25m"); // on the brake, stopper on behind it
    const station = await rig.station("forecastle");
    const url = await eventually("the page is told", () => station.urls()[0]);
    page = await openPage(url.replace("#", "?picture=off#"), { viewport: { width: 1440, height: 900 } });
    await eventually("its windlass is heard of", async () =>
      /\d/.test((await page.locator(".counter").textContent()) ?? ""),
    );
  },
  { timeout: 180000 },
);
after(async () => {
  await closeBrowser();
  await rig.end();
});

const men = () => page.locator(".stand .head").getByRole("button", { name: /^Men/ });
async function setTo(work: RegExp): Promise<void> {
  await men().click();
  await page.getByRole("dialog", { name: "Set the men to" }).getByRole("button", { name: work }).click();
}
const are = (short: string, atLength: RegExp) =>
  eventually(
    `the men are ${short}`,
    async () => (await men().textContent()) === short && atLength.test((await men().getAttribute("title")) ?? ""),
  );

test("men who are set to break the cable wait until the weight is on the stopper, and stand clear at a word", async () => {
  assert.equal(await men().textContent(), "Men");
  await setTo(/^Buoy the cable/);
  await are("Men: wait", /the weight is not on the stopper/);
  if (process.env.WINDLASS_MEN_PICTURES) {
    await men().click();
    await page.screenshot({ path: process.env.WINDLASS_MEN_PICTURES });
  } else {
    await men().click();
  }
  assert.match((await page.locator(".popover").textContent()) ?? "", /the weight is not on the stopper/);
  await passesAxe(page);
  await men().click();
  await setTo(/^Feed the windlass/);
  await are("Men: wait", /the windlass is not hydraulic$/);
  await setTo(/^Men stand clear/);
  await are("Men", /^Men stand clear$/);
  hadNoProblems(page);
});
