// A lesson that a learning system starts, as the learner sees it: from its link to the way back.

import assert from "node:assert/strict";
import { mkdtemp, rm } from "node:fs/promises";
import { type Server, createServer } from "node:http";
import type { AddressInfo } from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";

import { type TestPage, closeBrowser, closePage, openPage } from "./browser";
import { hadNoProblems, passesAxe } from "./pages";
import { Rig, eventually } from "./rig";

const rig = new Rig();
const picture = process.env.WINDLASS_DOOR_PICTURES; // a folder, to look at the pages
const tls = { ignoreHTTPSErrors: true };
const activity = "https://lms.example/activities/let-go";
const registration = "760e3480-ba55-4991-94b0-01820dbd23a2";
const actor = { account: { homePage: "https://lms.example", name: "1625378" }, name: "ben" };
const verbs: string[] = [];
let folder: string, origin: string;
let door: Awaited<ReturnType<Rig["door"]>>;
let system: Server;
let launches = 0;

/** What a learning system has: tokens, a launch's data, preferences, statements, and a page to come back to. */
function answer(path: string, body: string): [number, string] {
  if (path.startsWith("/fetch")) return [200, JSON.stringify({ "auth-token": "c2VjcmV0" })];
  if (path.startsWith("/back")) return [200, "<!doctype html><title>The course</title>"];
  if (path.startsWith("/lrs/activities/state"))
    return [
      200,
      JSON.stringify({
        contextTemplate: { extensions: { "https://w3id.org/xapi/cmi5/context/extensions/sessionid": `${launches}` } },
        launchMode: "Normal",
        moveOn: "Passed",
        masteryScore: 0.7,
        returnURL: `${origin}/back`,
      }),
    ];
  if (path.startsWith("/lrs/agents/profile")) return [200, JSON.stringify({ languagePreference: "de-DE,en" })];
  if (!path.startsWith("/lrs/statements") || !body) return [200, JSON.stringify({ statements: [] })];
  const { verb } = JSON.parse(body) as { verb: { id: string } };
  verbs.push(verb.id.split("/").at(-1));
  return [200, "[]"];
}

const link = (lesson: string, more: Record<string, string> = {}) =>
  `${door.url}cmi5/${lesson}?${new URLSearchParams({
    endpoint: `${origin}/lrs/`,
    fetch: `${origin}/fetch?k=${++launches}`,
    actor: JSON.stringify(actor),
    registration,
    activityId: activity,
    ...more,
  }).toString()}`;

const look = async (page: TestPage, name: string) => {
  if (picture) await page.screenshot({ path: join(picture, `${name}.png`) });
};

before(async () => {
  folder = await mkdtemp(join(tmpdir(), "windlass-launch-"));
  system = createServer((request, response) => {
    let body = "";
    request.on("data", (part: Buffer) => (body += part.toString()));
    request.on("end", () => {
      const [status, text] = answer(request.url, body);
      const type = request.url.startsWith("/back") ? "text/html" : "application/json";
      response.writeHead(status, { "Content-Type": type }).end(text);
    });
  }).listen(0, "127.0.0.1");
  await new Promise((listens) => system.once("listening", listens));
  origin = `http://127.0.0.1:${(system.address() as AddressInfo).port}`;
  rig.server("L01_let_go_25m", "--wait");
  door = await rig.door(join(folder, "door"), "--learning-system", origin);
});
after(async () => {
  await closeBrowser();
  await rig.end();
  system.close();
  await rm(folder, { recursive: true, force: true });
});

test("a launch that is none says which field, its value and what is allowed", async () => {
  const page: TestPage = await openPage(link("L01", { endpoint: "https://elsewhere.example/" }), {
    ...tls,
    viewport: { width: 390, height: 844 },
  });
  page.lostOnPurpose = true; // the browser says of each refusal that it was one
  await page
    .getByText(`endpoint: https://elsewhere.example/: of this door's learning systems only: ${origin}`)
    .waitFor();
  assert.ok(!page.url().includes("actor"), "who it is of is not left in the address");
  await passesAxe(page);
  await closePage(page);
});

test("a learner is led in, reads the language that he prefers, and is led back", { timeout: 120000 }, async () => {
  const page: TestPage = await openPage(link("L01"), { ...tls, viewport: { width: 390, height: 844 } });
  await page.getByText("Die Lektion L01 ist bereit für ben").waitFor();
  await passesAxe(page);
  await look(page, "launch_ready_390");
  await page.getByRole("link", { name: "An Bord gehen" }).click();
  await page.waitForURL(/\/forecastle$/);
  await eventually("it runs: nobody else starts it", async () => {
    const state = await page.locator(".top-bar").textContent();
    return /läuft/.test(state);
  });
  await page.goto(`${door.url}cmi5`);
  await page.getByRole("button", { name: "Beenden" }).click();
  await page.getByText("Sie gilt weder als bestanden noch als nicht bestanden").waitFor({ timeout: 60000 });
  await page.getByText("Ihr Kurs weiß davon. Sie können gehen.").waitFor();
  await passesAxe(page);
  await look(page, "launch_over_390");
  assert.equal(await page.getByRole("link", { name: "Zurück zum Kurs" }).getAttribute("href"), `${origin}/back`);
  hadNoProblems(page); // until it leaves: no page asks another site for anything
  await page.waitForURL(`${origin}/back`, { timeout: 40000 });
  assert.deepEqual(verbs, ["initialized", "terminated"]);
  await closePage(page);
});
