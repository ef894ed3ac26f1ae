// WebKit: a trainee joins by code through the door, sees the deck drawn, lets go by the hand-wheel, reports, and is back
// in the seat after a reload; at the desk's, the tablet's and the phone's size.

import assert from "node:assert/strict";
import { mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { By } from "selenium-webdriver";

import { root } from "../../station/web/tools/web.mjs";
import { type TestPage, closeBrowser } from "./browser";
import { firstOwner, hadNoProblems, openClass } from "./pages";
import { Rig, eventually } from "./rig";
import { WebKit } from "./webkit";

const rig = new Rig();
const pictures = process.env.WINDLASS_WEBKIT_PICTURES; // a folder, to look at the pages
let folder: string, code: string;
let door: Awaited<ReturnType<Rig["door"]>>;
let owner: TestPage; // in Chromium
let deck: WebKit;
let exercise: Rig; // that of the class

const look = async (name: string) => {
  if (pictures) await writeFile(join(pictures, `${name}.png`), await deck.driver.takeScreenshot(), "base64");
};
/** What the instructor's page says of the class's one exercise. */
const row = () => owner.locator("[data-exercise]").first().textContent();
const setBrake = async () =>
  Number(await (await deck.find('[aria-label="brake hand-wheel"]')).getAttribute("aria-valuenow")) / 100;
/** The order comes, and is repeated back by its button. */
async function repeats(order: string) {
  await eventually(`${order} is repeated`, async () => {
    try {
      const given = await deck.driver.findElement(
        By.xpath(`//*[contains(@class,"orders")]//li[contains(.,"${order}")]`),
      );
      if ((await given.getAttribute("data-state")) === "ORDER_REPEATED") return true;
      await given.findElement(By.css('button[aria-label^="repeat back"]')).click();
    } catch {
      // not there yet
    }
    return false;
  });
}

before(
  async () => {
    folder = await mkdtemp(join(tmpdir(), "windlass-webkit-"));
    rig.server("L01_let_go_25m", "--wait");
    door = await rig.door(join(folder, "door"));
    owner = await firstOwner(door.setup);
    code = await openClass(owner, 1, 2);
    await eventually("its exercise is there", async () => /ready/.test(await row()));
    exercise = new Rig(await owner.locator("[data-exercise]").first().getAttribute("data-exercise"));
    deck = await WebKit.start();
    await deck.size(1280, 800);
  },
  { timeout: 180000 },
);
after(async () => {
  await deck?.end();
  await closeBrowser();
  await exercise?.end();
  await rig.end();
  await rm(folder, { recursive: true, force: true });
});

test("a trainee joins by the code of a class, and sees the deck drawn", async () => {
  await deck.driver.get(door.url);
  await deck.driver.executeScript("localStorage.setItem('windlass.first_visit', 'seen')");
  await deck.driver.get(`${door.url}?code=${code}`);
  await (await deck.find("input[name=name]")).sendKeys("ben");
  await deck.press("Take a seat");
  await eventually("the forecastle", async () => (await deck.driver.getCurrentUrl()).endsWith("/forecastle"));
  await eventually("the instructor sees it", async () => /ben.*at the page/s.test(await row()));
  await look("briefing");
  for (const each of await deck.driver.findElements(By.css("dialog[open] button"))) {
    if (await each.isDisplayed()) await each.click().catch((): void => undefined);
  }
  await eventually("links, deck and sea are drawn", () =>
    deck.driver.executeScript<boolean>("return window.windlass?.stats()?.triangles > 10000"),
  );
  await look("forecastle_1280");
  await deck.driver.executeScript(await readFile(join(root, "build/web/node_modules/axe-core/axe.min.js"), "utf8"));
  const serious = await deck.driver.executeAsyncScript<string[]>(
    "const done = arguments[0]; window.axe.run(document, { resultTypes: ['violations'] }).then((found) => done(" +
      "found.violations.filter((v) => v.impact === 'serious' || v.impact === 'critical')" +
      ".map((v) => v.id + ': ' + v.nodes.map((n) => n.target + ' ' + n.failureSummary).join('; '))))",
  );
  assert.deepEqual(serious, []);
});

test("orders are repeated back, the anchor is let go with the hand-wheel, and reports are heard", async () => {
  await owner.getByRole("button", { name: "Start all", exact: true }).click();
  await repeats("stand by");
  await deck.press("Standing by");
  await repeats("let go");
  const { x, y, width, height } = await (await deck.find('[aria-label="brake hand-wheel"]')).getRect();
  const at = (turns: number) => ({
    x: x + width / 2 + 0.4 * width * Math.sin(2 * Math.PI * turns),
    y: y + height / 2 - 0.4 * width * Math.cos(2 * Math.PI * turns),
  });
  const before = await setBrake();
  await deck.drag(
    Array.from({ length: 61 }, (_, step) => at(-step / 24)),
    60, // slower than the wheel may be turned
  );
  // A busy page still turns it when the driver holds the drag to be over.
  await eventually("the wheel is turned off, and the brake follows", async () => {
    const set = await setBrake();
    return set < before - 0.2 && Math.abs((await exercise.truth()).port.windlass.brake_position - set) < 0.02;
  });
  await exercise.truly("the anchor falls", ({ port }) => port.chain.cable_out > 20);
  await deck.press("Let go");
  await deck.press("Hard on");
  await exercise.truly("she is checked", ({ port }) => port.windlass.brake_position > 0.99);
  await look("forecastle_let_go");
  await eventually("the report was heard", async () => /reported: port anchor is let go/.test(await deck.text(".log")));
});

test("the speed lever follows the hand, and springs back", async () => {
  // The slider itself: the control around it bears the same name, and how much it is higher is the layout's.
  const slider = await deck.find('[role="slider"][aria-label="speed lever"]');
  const { x, y, width, height } = await slider.getRect();
  const middle = { x: x + width / 2, y: y + height / 2 };
  const knob = await deck.driver.executeScript<number>(
    "return arguments[0].querySelector('.knob').offsetHeight",
    slider,
  );
  const half = { x: middle.x, y: middle.y - 0.5 * ((height - knob) / 2) };
  await eventually("half speed while it is held", async () => {
    const hand = deck.drag([middle, half], 200, 4000);
    const seen = exercise.truly("half speed", ({ port }) => Math.abs(port.windlass.speed_lever - 0.5) < 0.02);
    const held = await Promise.race([
      seen.then(
        (): boolean => true,
        (): boolean => false,
      ),
      hand.then((): boolean => false),
    ]);
    await hand;
    return held;
  });
  await exercise.truly("zero", ({ port }) => port.windlass.speed_lever === 0);
});

test("loaded anew it is in its seat again, with what it had set", async () => {
  await deck.driver.navigate().refresh();
  await eventually("the exercise is heard", async () => /running/.test(await deck.text(".top-bar")));
  assert.match(await deck.driver.getCurrentUrl(), /\/forecastle$/);
  await eventually("the rim is hard on", async () => (await setBrake()) > 0.99);
});

test("nothing lies beside the screen of a tablet or a phone", async () => {
  for (const [width, height] of [
    [1024, 768],
    [768, 1024],
    [390, 844],
  ]) {
    await deck.size(width, height);
    await look(`forecastle_${width}`);
    const beside = await deck.driver.executeScript<number>("return document.documentElement.scrollWidth - innerWidth");
    assert.equal(beside, 0, `${width}x${height}`);
  }
  hadNoProblems(owner);
});
