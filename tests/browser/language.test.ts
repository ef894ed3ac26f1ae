// The pages in German: nothing is cut off or out of reach where it is not in English, nothing of the catalogue is left
// in English, and the choice of the language is the person's, which takes no levers out of a hand.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";

import german from "../../words/pages_de.json";
import { type TestPage, closeBrowser, closePage, openPage } from "./browser";
import { cutOff, hadNoProblems, heard, passesAxe, unreachable } from "./pages";
import { Rig, eventually } from "./rig";

const kSizes: [number, number][] = [
  [1440, 900],
  [1024, 768],
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

const open = (name: string) =>
  openPage(urls[name].replace("#", "?picture=off#"), {
    viewport: { width: 1440, height: 900 },
    locale: "de-DE",
    init: () => localStorage.setItem("windlass.views", "plan"),
  });

for (const [name, sign] of Object.entries(heard))
  test(`the page ${name} is read in German`, async () => {
    const page = await open(name);
    await eventually("it has heard of the exercise", () => page.locator(sign).first().textContent());
    assert.equal(await page.locator("html").getAttribute("lang"), "de");
    if (await page.locator("dialog.briefing").count()) {
      const close = page.getByRole("button", { name: "Schließen" });
      await eventually("its briefing has opened by itself", () => close.isVisible());
      await close.click();
    }
    const wrong: string[] = [];
    for (const [width, height] of kSizes) {
      await page.setViewportSize({ width, height });
      const tabs = await page.getByRole("tab", { selected: false }).all();
      const names = await Promise.all(tabs.map((tab) => tab.textContent()));
      for (const tab of ["", ...names]) {
        if (tab) await page.getByRole("tab", { name: tab, exact: true }).evaluate((el: HTMLElement) => el.click());
        const found = [...(await unreachable(page)), ...(await cutOff(page))];
        wrong.push(...found.map((what) => `${width}x${height}, ${tab}: ${what}`));
      }
    }
    assert.deepEqual([...new Set(wrong)], []);
    // Criteria of a lesson have the names of its file; "Back" is where the windlass stands.
    const left = await page.evaluate(
      (english) =>
        [...document.querySelectorAll("body :not(.marks *, option)")]
          .flatMap((element) => [
            element.firstElementChild ? "" : element.textContent.trim(),
            element.getAttribute("aria-label"),
            element.getAttribute("title"),
          ])
          .filter((text) => text && english.includes(text)),
      Object.keys(german).filter((english) => !Object.values(german).includes(english)),
    );
    assert.deepEqual([...new Set(left)], []);
    await passesAxe(page);
    hadNoProblems(page);
    await closePage(page);
  });

test("the desk's plots have a height to be read by, however many lines their bar takes", async () => {
  const page = await open("instructor");
  await eventually("it has heard of the exercise", () => page.locator(heard.instructor).first().textContent());
  for (const [width, height] of kSizes) {
    await page.setViewportSize({ width, height });
    await eventually(`${width}x${height}`, async () => {
      const plots = page.locator(".pane .u-over");
      const heights = await plots.evaluateAll((all) => all.map((plot) => plot.getBoundingClientRect().height));
      return heights.length > 0 && Math.min(...heights) >= 50;
    });
  }
  await page.setViewportSize({ width: 1280, height: 800 });
  const beyond = () =>
    page.locator(".panes, .desk > .middle").evaluateAll((all) => all.map((el) => el.scrollHeight - el.clientHeight));
  await eventually("on a common screen all of them are in sight", async () => Math.max(...(await beyond())) <= 1);
  hadNoProblems(page);
  await closePage(page);
});

test("an order that waits on the forecastle is in sight with its state and its button, a last call too, at every size", async () => {
  const page = await open("forecastle");
  const close = page.getByRole("button", { name: "Schließen" });
  await eventually("its briefing has opened by itself", () => close.isVisible());
  await close.click();
  const order = page.locator(".orders li").first();
  const isWhole = async () => {
    for (const [width, height] of [...kSizes, [1280, 800], [1280, 720], [820, 1180]]) {
      await page.setViewportSize({ width, height });
      const hidden = await order.evaluate((row: HTMLElement) => {
        const kSlack = 3; // px
        const around = row.closest(".orders").getBoundingClientRect();
        return [...row.children]
          .filter((part) => {
            const { left, right, bottom } = part.getBoundingClientRect();
            const cut = part.scrollWidth > part.clientWidth + kSlack || part.scrollHeight > part.clientHeight + kSlack;
            return cut || left < around.left || right > around.right || bottom > around.bottom + kSlack;
          })
          .map((part) => part.textContent);
      });
      assert.deepEqual(hidden, [], `${width}x${height}`);
    }
  };
  const lastCall = "I say again; this is my last call, then I send another man forward";
  await rig.say("order", "pay-out", "3", "--side", "port", "--text", lastCall);
  await eventually("it waits", () => order.getByText("noch nicht wiederholt").isVisible());
  await eventually("it is called for the last time", () => order.getByText(lastCall).isVisible());
  assert.ok(await order.getByRole("button").isVisible());
  await isWhole();
  hadNoProblems(page);
  await closePage(page);
});

test("a gauge that has not measured yet says so without touching its scale or its name, at every size", async () => {
  const page = await open("forecastle");
  const close = page.getByRole("button", { name: "Schließen" });
  await eventually("its briefing has opened by itself", () => close.isVisible());
  await close.click();
  const dial = page.getByRole("meter", { name: "Kettenlast" });
  await eventually("it has not measured", () => dial.getByText("noch nicht gemessen").isVisible());
  for (const [width, height] of [...kSizes, [1280, 800], [1280, 720], [820, 1180], [412, 915]]) {
    await page.setViewportSize({ width, height });
    const touched = await dial.evaluate((dial) => {
      const linesOf = (part: Element) => {
        const text = document.createRange();
        text.selectNodeContents(part);
        return [...text.getClientRects()];
      };
      const words = linesOf(dial.querySelector(".unit"));
      return [...dial.querySelectorAll("svg text, .label")]
        .filter((part) =>
          linesOf(part).some(({ left, right, top, bottom }) =>
            words.some((line) => left < line.right && right > line.left && top < line.bottom && bottom > line.top),
          ),
        )
        .map((part) => part.textContent);
    });
    assert.deepEqual(touched, [], `${width}x${height}`);
  }
  hadNoProblems(page);
  await closePage(page);
});

/**
 * Parts of the stand that lie beyond its edges, and words of its head that have no room. men: what their button says,
 * put there at once: between two pictures nobody writes over it.
 */
const beyondTheStand = (page: TestPage, men: string) =>
  page.locator(".stand").evaluate((stand, men) => {
    const kSlack = 3; // px
    const button = stand.querySelector(".head > button:last-child");
    const before = button.textContent;
    button.textContent = men;
    const { left, right } = stand.getBoundingClientRect();
    const isCut = (part: Element) =>
      part.scrollWidth > part.clientWidth + kSlack || part.scrollHeight > part.clientHeight + kSlack;
    const beyond = [...stand.querySelectorAll("*")]
      .filter((part) => {
        const box = part.getBoundingClientRect();
        if (!part.checkVisibility() || box.width === 0) return false;
        return box.left < left || box.right > right || (part.matches(".head button, .levers-of") && isCut(part));
      })
      .map((part) => `${part.tagName} ${part.getAttribute("class")} ${part.textContent}`);
    button.textContent = before;
    return beyond;
  }, men);

test("whoever has the levers, and whatever the men do, all of the stand lies within its panel", async () => {
  for (const [mine, instructors, men, options] of [
    ["bei mir", "Ausbilder hat übernommen", ["Leute: warten", "Leute: 20:00"], { locale: "de-DE" }],
    [
      "mine",
      "instructor has taken over",
      ["Men: done", "Men: 20:00"],
      { locale: "en-GB", hasTouch: true, isMobile: true },
    ],
  ] as const) {
    const page = await openPage(urls.forecastle.replace("#", "?picture=off#"), options);
    const close = page.getByRole("button", { name: /^(Schließen|Close)$/ });
    await eventually("its briefing has opened by itself", () => close.isVisible());
    await close.click();
    const isWhole = async (whose: string) => {
      await eventually(whose, async () => (await page.locator(".owner").textContent()) === whose);
      for (const [width, height] of [...kSizes, [1280, 800]]) {
        await page.setViewportSize({ width, height });
        for (const words of men)
          assert.deepEqual(await beyondTheStand(page, words), [], `${whose}, ${words}, ${width}x${height}`);
      }
    };
    const leave = page.getByRole("button", { name: /^(Abgeben|Leave them)$/ });
    await page.keyboard.press("b");
    await isWhole(mine);
    assert.ok(await leave.isVisible());
    const instructor = rig.console("levers", "--side", "port", "--brake", "1");
    await isWhole(instructors);
    assert.equal(await leave.isVisible(), false, "there is nothing to leave");
    await instructor.stop("SIGINT");
    await isWhole(mine);
    await leave.click();
    hadNoProblems(page);
    await closePage(page);
  }
});

test("the brake's wheel keeps size and place whatever is said of it", async () => {
  const page = await open("forecastle");
  const close = page.getByRole("button", { name: "Schließen" });
  await eventually("its briefing has opened by itself", () => close.isVisible());
  await close.click();
  await page.setViewportSize({ width: 1024, height: 768 });
  // The longest that either says, put there at once: between two pictures nobody writes over it.
  const boxes = (wheel: string, speed: string) =>
    page.evaluate(
      ([turns, lever]) => {
        const line = document.querySelector(".brake .figures span");
        const words = document.querySelector(".speed .figures");
        const before = [line.textContent, words.textContent];
        [line.textContent, words.textContent] = [turns, lever];
        document.querySelector(".speed").toggleAttribute("data-latched"); // bold
        const found = [".brake .wheel", ".speed .slot"].map((part) => {
          const { x, y, width, height } = document.querySelector(part).getBoundingClientRect();
          return { x, y, width, height };
        });
        const wide = line.scrollWidth > line.clientWidth;
        [line.textContent, words.textContent] = before;
        document.querySelector(".speed").toggleAttribute("data-latched");
        return { found, wide };
      },
      [wheel, speed],
    );
  const short = await boxes("fest", "0 %");
  for (const turns of ["von 5 Umdrehungen", "Soll 4 Umdr. 359°"])
    assert.deepEqual(await boxes(turns, "fieren 100 %, eingerastet"), short, turns);
  assert.equal(short.wide, false);
  hadNoProblems(page);
  await closePage(page);
});

test("another language is chosen among the units, and not out of a hand that is on levers", async () => {
  const page = await open("forecastle");
  const language = () => page.locator("html").getAttribute("lang");
  const close = page.getByRole("button", { name: "Schließen" });
  await eventually("its briefing has opened by itself", () => close.isVisible());
  await close.click();
  await page.keyboard.press("b");
  await eventually("the levers are in hand", () => page.getByRole("button", { name: "Abgeben" }).isVisible());
  const early = page.getByText("Noch nicht gestartet: Was Sie jetzt verstellen, wirkt mit dem Start.");
  await eventually("it is told that nothing moves before the start", () => early.isVisible());
  await page.getByRole("button", { name: /^Einheiten/ }).click();
  await page.getByRole("radio", { name: "English" }).click();
  await eventually("it is refused", () => page.getByText("erst abgeben").isVisible());
  assert.equal(await language(), "de");
  await close.click();
  await page.getByRole("button", { name: "Abgeben" }).click();
  await eventually("who has let go need not be told", () => early.isHidden());
  await page.getByRole("button", { name: /^Einheiten/ }).click();
  await page.getByRole("radio", { name: "English" }).click();
  await eventually("the page is loaded anew in English", async () => (await language()) === "en");
  await eventually("its words are English", () => page.getByText("Orders from the bridge").isVisible());
  assert.equal(await page.evaluate(() => localStorage.getItem("windlass.language")), "en");
  hadNoProblems(page);
  await closePage(page);
});
