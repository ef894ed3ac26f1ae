// The men on deck, set to work from the page or the desk: they wait and say why, and stand clear again.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";

import { type TestPage, closeBrowser, openPage } from "./browser";
import { hadNoProblems, holdDown, passesAxe } from "./pages";
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

const men = (on = page) =>
  on.locator(".stand .head, .lever-card[data-what='0'] header").getByRole("button", { name: /^Men/ });
async function setTo(work: RegExp, on = page): Promise<void> {
  await men(on).click();
  await on.getByRole("dialog", { name: "Set the men to" }).getByRole("button", { name: work }).click();
}
const are = (short: string, atLength: RegExp, on = page) =>
  eventually(
    `the men are ${short}`,
    async () => (await men(on).textContent()) === short && atLength.test((await men(on).getAttribute("title")) ?? ""),
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

test("on a tablet all that they may be set to is in sight at once, and so is the picture in which they stand", async () => {
  await page.setViewportSize({ width: 1024, height: 768 });
  await setTo(/^Buoy the cable/);
  await are("Men: wait", /the weight is not on the stopper/); // the longest that is said of them
  await men().click();
  const choice = page.getByRole("dialog", { name: "Set the men to" });
  const [hidden, box, picture] = [
    await choice.evaluate((el) => el.scrollHeight - el.clientHeight),
    await choice.boundingBox(),
    await page.locator(".scene").boundingBox(),
  ];
  assert.equal(hidden, 0, "nothing is scrolled to");
  assert.equal(await choice.locator(".men button").count(), 5);
  assert.ok(box.y >= picture.y + picture.height, `${box.y} is below the picture, ${picture.y} + ${picture.height}`);
  await men().click();
  await setTo(/^Men stand clear/);
  await are("Men", /^Men stand clear$/);
  await page.setViewportSize({ width: 1440, height: 900 });
});

test("an instructor sets them to work at the desk and calls them back, and the forecastle sees it", async () => {
  const desk = await openPage((await rig.desk()).url, {
    viewport: { width: 1600, height: 900 },
    init: () => localStorage.setItem("windlass.views", "plan"),
  });
  await eventually("the windlass is heard of", () => men(desk).isEnabled());
  await setTo(/^Buoy the cable/, desk);
  await are("Men: wait", /the weight is not on the stopper/, desk);
  await are("Men: wait", /the weight is not on the stopper/);
  await men(desk).click();
  await passesAxe(desk);
  if (process.env.WINDLASS_MEN_PICTURES)
    await desk.screenshot({ path: `${process.env.WINDLASS_MEN_PICTURES}.desk.png` });
  await men(desk).click();
  await setTo(/^Men stand clear/, desk);
  await are("Men", /^Men stand clear$/, desk);
  await are("Men", /^Men stand clear$/);
  hadNoProblems(desk);
});

test("a bar that bears does not lift: it says so, its button offers it as it stands, and to hold it anew is to try anew", async () => {
  const stopper = page.getByRole("switch", { name: "chain stopper" });
  const control = page.locator(".control.stopper");
  const refusals = page.locator(".log li", { hasText: "stopper bar is loaded and does not lift" });
  await page.keyboard.press("0"); // the weight comes onto the bar
  await rig.truly("the brake is open", ({ port }) => port.windlass.brake_position < 0.01);
  for (const tries of [1, 2]) {
    await holdDown(page, stopper);
    await eventually("it is refused", async () => (await refusals.count()) === tries);
    await eventually("it says why", async () =>
      /^under load: does not lift$/.test((await control.locator(".reason").textContent()) ?? ""),
    );
    assert.equal(await control.locator(".row strong").textContent(), "ON");
    assert.equal(await stopper.textContent(), "Hold: lift");
    assert.equal(await stopper.getAttribute("aria-checked"), "true");
  }
  await page.keyboard.press("b");
  await rig.truly("the brake is hard on", ({ port }) => port.windlass.brake_position > 0.99);
  hadNoProblems(page);
});
