// Small pictures of the forecastles of a class, by their cameras: real exercises, drawn here by the processor.

import assert from "node:assert/strict";
import { join } from "node:path";
import { after, afterEach, before, test } from "node:test";

import { type GatewayMessage, type TestPage, closeBrowser, closePage, openPage, root } from "./browser";
import { hadNoProblems, passesAxe } from "./pages";
import { type Station, Rig, eventually, sleep } from "./rig";

const kExercises = 12;
const rig = new Rig();
const ids = Array.from({ length: kExercises - 1 }, (_, i) => `${rig.partition}-${i + 2}`);
let desk: Station;
let page: TestPage;
const asked: string[] = []; // of which exercise the page asked for what the camera sees
const subscribed = new Set<string>();

const picture = (id: string) => page.locator(`.tile[data-id='${id}'] .cctv`);
const on = () => page.getByRole("button", { name: /^CCTV/ });
/** A number that is another where the picture is: 0 as long as there is none. */
const drawn = (id: string) =>
  picture(id)
    .locator("canvas")
    .evaluate((canvas: HTMLCanvasElement) => {
      const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
      let sum = 0;
      for (let i = 0; i < data.length; i += 4) sum = (sum * 31 + data[i] + 2 * data[i + 1] + 4 * data[i + 2]) % 2 ** 40;
      return sum;
    });
const classroom = () => {
  const url = new URL(desk.url);
  return `${url.origin}/classroom${url.hash}`;
};

before(
  async () => {
    const file = (name: string) => join(root, `config/exercises/${name}.json`);
    // One of them is another ship's.
    const others = ids.flatMap((id, i) => [
      "--exercise",
      file(i === 0 ? "at_anchor_25m" : "L01_let_go_25m"),
      "--partition",
      id,
    ]);
    rig.server("L01_let_go_25m", ...others);
    desk = await rig.desk();
    page = await openPage(classroom(), {
      viewport: { width: 1440, height: 600 },
      watch: (opened) =>
        opened.on("websocket", (socket) =>
          socket.on("framesent", ({ payload }) => {
            const said = JSON.parse(payload.toString()) as GatewayMessage & { exercise?: string };
            if (said.op === "camera") asked.push(said.exercise);
            for (const { channelId } of said.subscriptions ?? []) subscribed.add(`${channelId}`);
          }),
        ),
      init: () => {
        window.contexts = 0;
        const { getContext } = HTMLCanvasElement.prototype;
        HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, ...given: [string]) {
          const made = getContext.apply(this, given);
          if (given[0] === "webgl2" && made) window.contexts += 1;
          return made;
        } as typeof getContext;
      },
    });
  },
  { timeout: 180000 },
);
after(async () => {
  await closeBrowser();
  await rig.end();
});
afterEach(() => hadNoProblems(page));

test("each tile on the screen has a picture, all by one WebGL context, and no exercise is subscribed", async () => {
  await eventually("twelve tiles", async () => (await page.locator(".tile").count()) === kExercises);
  await eventually("the first is drawn", async () => (await drawn(rig.partition)) !== 0);
  await eventually("another ship, too", async () => (await drawn(ids[0])) !== 0);
  assert.notEqual(await drawn(ids[0]), await drawn(rig.partition));
  assert.equal(await page.evaluate(() => window.contexts), 2, "the one that draws, and one that asked what draws");
  assert.equal(subscribed.size, 2, `the classroom's status and events, not ${[...subscribed].join()}`);
  await passesAxe(page);
});

test("what is not on the screen is not asked for, until it is scrolled there", async () => {
  const last = [rig.partition, ...ids].sort().at(-1);
  const seen = await picture(last).evaluate((it) => it.getBoundingClientRect().top < innerHeight);
  assert.ok(!seen, "the last tile is below the page's end");
  assert.ok(!asked.includes(last));
  await picture(last).scrollIntoViewIfNeeded();
  await eventually("it is drawn", async () => (await drawn(last)) !== 0);
});

test("pictures follow what happens, by turns", async () => {
  await page.locator(".servers").evaluate((it) => it.scrollTo(0, 0));
  const before = await drawn(rig.partition);
  await eventually("another picture", async () => (await drawn(rig.partition)) !== before);
  asked.length = 0;
  await sleep(10000);
  const often = asked.filter((id) => id === rig.partition).length;
  assert.ok(often >= 1 && often <= 3, `${often} pictures of one exercise in 10 s`);
});

test("a camera that has failed gives no picture", async () => {
  await rig.say("fault", "cctv-lost", "--timeout", "20");
  await eventually("it is said", () => picture(rig.partition).getByText("No picture").isVisible());
  await rig.say("fault", "cctv-lost", "--clear", "--timeout", "20");
  await eventually("it is back", async () => !(await picture(rig.partition).getByText("No picture").isVisible()));
});

test("turned off, none is shown or asked for, and this browser remembers it", async () => {
  await on().click();
  await eventually("none is shown", async () => !(await picture(rig.partition).isVisible()));
  await sleep(500);
  asked.length = 0;
  await page.reload();
  await eventually("it is off", async () => (await on().textContent()) === "CCTV off");
  await sleep(3000);
  assert.deepEqual(asked, []);
  assert.equal(await page.evaluate(() => window.contexts), 0);
  await on().click();
  await eventually("it is drawn again", async () => (await drawn(rig.partition)) !== 0);
});

test("a page that may not look has neither pictures nor their switch", async () => {
  // No role that opens this page is refused today; the page is told what a station that refuses it would tell.
  const other = await openPage("about:blank");
  await other.routeWebSocket(/\/ws/, (socket) => {
    const server = socket.connectToServer();
    socket.onMessage((message) => {
      const { op, id } = JSON.parse(message.toString()) as GatewayMessage & { id: number };
      const refused = { op: "refused", id, topic: "", field: "", text: "the cameras of other exercises" };
      if (op === "camera") socket.send(JSON.stringify(refused));
      else server.send(message);
    });
  });
  await other.goto(classroom());
  await eventually("tiles", async () => (await other.locator(".tile").count()) === kExercises);
  await eventually("no picture", async () => (await other.locator(".cctv:visible").count()) === 0);
  assert.equal(await other.getByRole("button", { name: /^CCTV/ }).count(), 0);
  await closePage(other);
});
