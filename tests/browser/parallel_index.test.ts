// Lines parallel to a course on the bridge's plan: where they are drawn, against the ring of a bearing line.

import assert from "node:assert/strict";
import { after, afterEach, before, test } from "node:test";

import { type TestPage, closeBrowser, openPage } from "./browser";
import { hadNoProblems, passesAxe } from "./pages";
import { Rig, eventually } from "./rig";

const kMile = 1852; // m
const kDegree = Math.PI / 180;
const near = (a: number, b: number, tolerance: number, what: string): void =>
  assert.ok(Math.abs(a - b) <= tolerance, `${what}: ${a}, not ${b}`);

const rig = new Rig();
let page: TestPage;

/** window.laid: of the plan's last picture the ends of the index lines and the ring of the first bearing line, px. */
const look = () => {
  const { setLineDash, moveTo, lineTo, arc } = CanvasRenderingContext2D.prototype;
  let path: [number, number][] = [];
  let radius = 0;
  window.laid = { lines: [], ring: 0 };
  Object.assign(CanvasRenderingContext2D.prototype, {
    moveTo(this: CanvasRenderingContext2D, x: number, y: number) {
      path = [[x, y]];
      moveTo.call(this, x, y);
    },
    lineTo(this: CanvasRenderingContext2D, x: number, y: number) {
      path.push([x, y]);
      lineTo.call(this, x, y);
    },
    arc(this: CanvasRenderingContext2D, ...given: Parameters<typeof arc>) {
      path = [];
      radius = given[2];
      arc.apply(this, given);
    },
    setLineDash(this: CanvasRenderingContext2D, dash: number[]) {
      if (dash.join() === "18,4,3,4") window.laid.lines[0] = path;
      if (dash.join() === "18,4,3,4,3,4") window.laid.lines[1] = path;
      if (dash.join() === "10,4" && path.length === 0) window.laid.ring = radius;
      setLineDash.call(this, dash);
    },
  });
};

const tools = () => page.getByRole("toolbar", { name: "plan" });
const button = () => tools().getByRole("button", { name: /^PI/ });
const form = () => page.getByRole("dialog", { name: "Parallel index" });
const sheet = () => page.getByRole("application", { name: /^plan/ });
const course = (which: number) => form().getByRole("spinbutton", { name: `course of line ${which}, degrees` });
const far = (which: number) => form().getByRole("spinbutton", { name: `distance of line ${which}` });
const side = (which: number) => form().getByRole("combobox", { name: `side of line ${which}` });

/** Of a line as it is drawn: rad clockwise from up, and m to starboard of own ship, who is in the middle. */
async function drawn(which: 1 | 2) {
  const { width, height } = await sheet().boundingBox();
  const metres = await scale();
  const ends = await page.evaluate((k) => window.laid.lines[k], which - 1);
  const [[ax, ay], [bx, by]] = ends.toSorted((a, b) => b[0] - a[0]); // from right to left
  const way = Math.atan2(ax - bx, by - ay); // to the right one
  const [dx, dy] = [bx - width / 2, by - height / 2];
  return { way, off: (dx * Math.cos(way) + dy * Math.sin(way)) * metres };
}
/** m to a pixel, by what the first bearing line reads and its ring. */
async function scale() {
  const [, range] = /, (\d+) m$/.exec(
    await tools()
      .getByRole("button", { name: /^EBL 1/ })
      .textContent(),
  );
  return Number(range) / (await page.evaluate(() => window.laid.ring));
}
async function is(which: 1 | 2, degrees: number, off: number) {
  await eventually(`line ${which} on ${degrees} degrees, ${off} NM`, async () => {
    const now = await drawn(which);
    return Math.abs(now.off - off * kMile) < 4 && Math.abs(now.way / kDegree - degrees) < 0.5;
  });
}
/** A place of the sheet: m from own ship to the right and up. */
async function at(right: number, up: number): Promise<[number, number]> {
  const box = await sheet().boundingBox();
  const metres = await scale();
  return [box.x + box.width / 2 + right / metres, box.y + box.height / 2 - up / metres];
}

before(
  async () => {
    rig.server("L31_mediterranean_moor"); // with way on her, heading 330
    const station = await rig.station("bridge");
    page = await openPage(station.url, { init: look, hasTouch: true, viewport: { width: 1440, height: 900 } });
    await eventually("the instruments show", async () =>
      /^\d/.test(await page.getByRole("meter", { name: "HDG" }).getAttribute("aria-valuetext")),
    );
    await tools()
      .getByRole("button", { name: /^EBL 1/ })
      .click();
  },
  { timeout: 180000 },
);
after(async () => {
  await closeBrowser();
  await rig.end();
});
afterEach(() => hadNoProblems(page));

test("lines are typed: course, distance in miles or cables, and side", async () => {
  await button().click();
  await course(1).fill("90");
  await far(1).fill("0.1");
  await side(1).selectOption("starboard");
  await is(1, 90, 0.1); // across the screen, below own ship
  await form().getByRole("combobox", { name: "unit of the distance" }).selectOption("cable");
  assert.equal(await far(1).inputValue(), "1");
  await course(2).fill("45.5");
  await far(2).fill("0.8");
  await side(2).selectOption("port");
  await is(2, 45.5, -0.08);
  await is(1, 90, 0.1);
  await course(2).fill("400");
  await eventually("it is said", () => form().getByText("Course 400: 0 to 360 degrees").isVisible());
  await is(2, 45.5, -0.08);
  await passesAxe(page);
  await form().getByRole("button", { name: "close" }).click();
});

test("a mouse drags a line to its distance and over to the other side", async () => {
  await page.mouse.move(...(await at(-150, -0.1 * kMile)));
  await page.mouse.down();
  await page.mouse.move(...(await at(-140, -60)), { steps: 3 });
  await page.mouse.move(...(await at(-130, 0.05 * kMile)), { steps: 3 });
  await page.mouse.up();
  await is(1, 90, -0.05);
});

test("a finger turns a line by its square, and it keeps its distance", async () => {
  const { width, height } = await sheet().boundingBox();
  const ahead = 0.3 * Math.min(width, height) * (await scale());
  const finger = await page.context().newCDPSession(page);
  const touch = async (type: "touchStart" | "touchMove" | "touchEnd", ...place: [] | [number, number]) =>
    finger.send("Input.dispatchTouchEvent", {
      type,
      touchPoints: place.length ? [{ id: 1, x: place[0], y: place[1] }] : [],
    });
  await touch("touchStart", ...(await at(ahead, 0.05 * kMile)));
  await touch("touchMove", ...(await at(ahead, 0)));
  // On 120 degrees the line leads 0.05 miles to port of her.
  const [u, n] = [
    [Math.sin(120 * kDegree), Math.cos(120 * kDegree)],
    [Math.sin(30 * kDegree), Math.cos(30 * kDegree)],
  ];
  const port = 0.05 * kMile;
  await touch("touchMove", ...(await at(ahead * u[0] + port * n[0], ahead * u[1] + port * n[1])));
  await touch("touchEnd");
  await is(1, 120, -0.05);
});

test("heading up turns the plan and its lines with it; they keep course and distance", async () => {
  const heading = Number(/^[\d.]+/.exec(await page.getByRole("meter", { name: "HDG" }).getAttribute("aria-valuetext")));
  const turned = tools().getByRole("button", { name: /^Head up/ });
  await turned.click();
  assert.ok(heading > 20 && heading < 340, `she heads ${heading}`);
  const askew = (way: number) => ((way / kDegree - (45.5 - heading) + 810) % 180) - 90; // a line has two directions
  await eventually("it is turned by her heading", async () => Math.abs(askew((await drawn(2)).way)) < 0.5);
  near(Math.abs((await drawn(2)).off), 0.08 * kMile, 4, "off her");
  await turned.click();
  await is(2, 45.5, -0.08);
});

test("this computer keeps them over a reload", async () => {
  await page.reload();
  await tools()
    .getByRole("button", { name: /^EBL 1/ })
    .click();
  await eventually("they are drawn", () => page.evaluate(() => window.laid.lines.length === 2));
  await is(1, 120, -0.05);
  await is(2, 45.5, -0.08);
  await button().click();
  near(Number(await course(1).inputValue()), 120, 0.3, "course"); // as near as a finger has put it
  assert.deepEqual([await far(1).inputValue(), await side(1).inputValue()], ["0.5", "-1"]);
  await form().getByRole("checkbox", { name: "line 1" }).uncheck();
  await form().getByRole("checkbox", { name: "line 2" }).uncheck();
  await eventually("it is off", async () => (await button().getAttribute("aria-pressed")) === "false");
});
