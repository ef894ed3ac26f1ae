// Two hands on the same levers: two instructors at desks of their own, and two trainees at the same seat. Whoever takes
// over last has them, every page says who, and who lost them is told.

import assert from "node:assert/strict";
import { after, afterEach, before, describe, test } from "node:test";

import { type TestPage, closeBrowser, openPage } from "./browser";
import { hadNoProblems } from "./pages";
import { Rig, eventually } from "./rig";

const rig = new Rig();
const desks: TestPage[] = [];
const decks: TestPage[] = [];

const card = (page: TestPage) => page.locator(".lever-card[data-what='0']");
const who = (page: TestPage) => card(page).locator(".who").textContent();
const brake = (page: TestPage) => card(page).getByRole("slider", { name: "brake on, %" });
const set = async (page: TestPage) => Number(await card(page).locator(".lever .set").first().textContent());
const says = (page: TestPage, words: string, patience?: number) =>
  eventually(words, async () => (await who(page)) === words, patience);
const isAt = (share: number) =>
  rig.truly(`the brake is at ${share}`, ({ port }) => Math.abs(port.windlass.brake_position - share) < 0.011);
/** Holds the button until the levers are this desk's; again where a stalled page has lost them meanwhile. */
async function takesOver(page: TestPage) {
  const button = card(page).getByRole("button", { name: /^take over/ });
  await eventually("it takes over", async () => {
    if ((await button.isVisible()) && (await who(page)) !== "in your hand") {
      await button.hover({ timeout: 30000 });
      await page.mouse.down();
      try {
        await says(page, "in your hand", 20000);
      } finally {
        await page.mouse.up();
      }
    }
    return (await who(page)) === "in your hand";
  });
}
/** A page that a busy machine stalls for five seconds has let go, as the dead man's rule has it: it takes them anew. */
async function keeps(page: TestPage) {
  if ((await who(page)) !== "in your hand") await takesOver(page);
}

before(
  async () => {
    rig.server("L05_standing_moor");
    for (const name of ["desk-1", "desk-2"])
      desks.push(
        await openPage((await rig.desk({ name })).url, { init: () => localStorage.setItem("windlass.views", "plan") }),
      );
    for (const name of ["forecastle-1", "forecastle-2"])
      decks.push(await openPage((await rig.station("forecastle", { name })).url.replace("#", "?picture=off#")));
    for (const page of desks)
      await eventually("the brake is known", async () =>
        /\d/.test(await card(page).locator(".lever .now").first().textContent()),
      );
  },
  { timeout: 120000 },
);
after(async () => {
  await closeBrowser();
  await rig.end();
});
afterEach(() => [...desks, ...decks].forEach(hadNoProblems));

describe("two instructors", () => {
  test("the first takes over, and the second's desk says so", async () => {
    const [one, two] = desks;
    await takesOver(one);
    const whole = (el: Element) => el.scrollWidth <= el.clientWidth;
    assert.ok(await card(one).locator(".who").evaluate(whole), "whose they are is not cut off");
    await brake(one).fill("70"); // the anchor hangs on it
    await isAt(0.7);
    await says(two, "desk-1, instructor");
    await eventually("with what it has set", async () => (await set(two)) === 70);
  });

  for (const [loses, takes, percent] of [
    [0, 1, 90],
    [1, 0, 65],
    [0, 1, 100],
  ])
    test(`desk-${takes + 1} takes over from desk-${loses + 1}, which is told and sees what is set`, async () => {
      const [loser, taker] = [desks[loses], desks[takes]];
      const notice = () => loser.locator(".notice").textContent();
      const taken = new RegExp(`^desk-${takes + 1} has the port windlass, at \\d+:\\d\\d: your hand is off it`);
      await eventually("the loser is told", async () => {
        await keeps(loser);
        const earlier = await notice(); // of the time before, with its time
        await takesOver(taker);
        await says(loser, `desk-${takes + 1}, instructor`);
        // A page that was held up meanwhile had let go, and is told that instead: once more.
        return eventually("told", async () => (await notice()) !== earlier && taken.test(await notice()), 20000);
      });
      await eventually("what is in another's hand cannot be moved", () => brake(loser).isDisabled());
      await eventually("no frame any longer", async () => (await loser.locator("body.in-command").count()) === 0);
      await brake(taker).fill(`${percent}`);
      await isAt(percent / 100);
      for (const page of desks) await eventually("both show what is set", async () => (await set(page)) === percent);
      const log = await taker.locator(".log").textContent();
      assert.match(log, new RegExp(`desk-${takes + 1} has the port windlass, taken from desk-${loses + 1}`));
    });

  test("handed back, nobody has them on either desk", async () => {
    await keeps(desks[1]);
    await card(desks[1])
      .getByRole("button", { name: /^hand back/ })
      .click();
    for (const page of desks) await says(page, "nobody");
  });
});

describe("two trainees at one seat", () => {
  const owner = (page: TestPage) => page.locator(".owner").textContent();
  const told = (page: TestPage) => page.locator(".stand .notice").textContent();

  test("each sees whose the levers are; of two who hold them one has them, and the other is told", async () => {
    const [one, two] = decks;
    await one.keyboard.press("b");
    await eventually("the first has them", async () => (await owner(one)) === "mine");
    await eventually("the second sees it", async () => (await owner(two)) === "forecastle-1");
    await two.keyboard.press("b");
    let has: number | undefined;
    await eventually("one is told that the other has them", async () => {
      has = /^forecastle-2 has the port windlass/.test(await told(one))
        ? 1
        : /^forecastle-1 has the port windlass/.test(await told(two))
          ? 0
          : undefined;
      return has !== undefined;
    });
    await eventually("it has them", async () => (await owner(decks[has])) === "mine");
    await eventually("the other names it", async () => (await owner(decks[1 - has])) === `forecastle-${has + 1}`);
    for (const page of desks) await says(page, `forecastle-${has + 1}`);
  });
});
