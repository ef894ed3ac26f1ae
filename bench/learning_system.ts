// A lesson that a learning system starts, its statements taken by a record store that others have made: Learning
// Locker's service for xAPI statements (npm, @learninglocker/xapi-statements), in memory. Launch, launch data and tokens
// are given here as cmi5 wants them. A browser enters by the launch's address, a shipped script plays the lesson at ten
// times real time, and the page leads back. Writes on stdout what the store then has; fails where it refused a statement.
//
// usage: npm install --ignore-scripts --prefix STORE @learninglocker/xapi-statements     (once; 190 MB)
//        build/release/bin/own_domain node station/web/tools/ts.mjs bench/learning_system.ts STORE [SCRIPT]
//        SCRIPT: of config/scripts, L01_good unless given; a lesson that it fails is told as failed

import assert from "node:assert/strict";
import { type ChildProcess, spawn } from "node:child_process";
import { mkdtemp, rm } from "node:fs/promises";
import { type IncomingMessage, type ServerResponse, createServer } from "node:http";
import type { AddressInfo } from "node:net";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";

import { closeBrowser, openPage } from "../tests/browser/browser";
import { firstOwner } from "../tests/browser/pages";
import { Rig, eventually, sleep } from "../tests/browser/rig";

const [store, script = "L01_good"] = process.argv.slice(2);
assert.ok(store, "usage: learning_system.ts STORE [SCRIPT]");
const lesson = "L01_let_go_25m";
const kVersion = "1.0.3";
const registration = "2f9fb0a2-5c4f-4a6b-9a0e-52f4b8e6f3c1";
const activity = "https://lms.example/activities/let-go";
const actor = { objectType: "Agent", account: { homePage: "https://lms.example", name: "1625378" }, name: "Anna Lind" };
const launchData = {
  contextTemplate: {
    contextActivities: { grouping: [{ id: "https://door.example/cmi5/L01" }] },
    extensions: { "https://w3id.org/xapi/cmi5/context/extensions/sessionid": "session-1" },
  },
  launchMode: "Normal",
  moveOn: "Passed",
  masteryScore: 0.7,
  returnURL: "", // once the port is known
};

/** The store's own program, at a free port of this machine. */
async function recordStore(): Promise<{ url: string; process: ChildProcess }> {
  const port = await new Promise<number>((told) => {
    const probe = createServer().listen(0, "127.0.0.1", () => {
      const { port: free } = probe.address() as AddressInfo;
      probe.close(() => told(free));
    });
  });
  const child = spawn(
    process.execPath,
    [resolve(store, "node_modules/@learninglocker/xapi-statements/dist/server.js")],
    {
      cwd: store,
      stdio: "ignore",
      env: {
        ...process.env,
        EXPRESS_PORT: `${port}`,
        AUTH_REPO: "test",
        MODELS_REPO: "memory",
        STORAGE_REPO: "local",
        EVENTS_REPO: "redis", // tells others of a statement; without them it goes on
      },
    },
  );
  const url = `http://127.0.0.1:${port}/xAPI/`;
  await eventually("the record store answers", async () => {
    assert.equal(child.exitCode, null, "the record store has ended: is STORE as the usage says?");
    return (await fetch(`${url}about`).catch((): undefined => undefined))?.ok;
  });
  return { url, process: child };
}

const said: string[] = []; // what the store answered to each statement
let fetched = 0;

async function answer(asked: IncomingMessage, given: ServerResponse, statements: string): Promise<void> {
  const { pathname, search, searchParams } = new URL(asked.url, "http://x");
  const tell = (status: number, body = ""): void => {
    given.writeHead(status, { "Content-Type": "application/json" }).end(body);
  };
  if (pathname === "/fetch")
    return tell(
      200,
      JSON.stringify(
        fetched++ ? { "error-code": "1", "error-text": "given already" } : { "auth-token": "dGVzdDp0ZXN0" },
      ),
    );
  if (pathname === "/back") return tell(200, `"the course"`);
  if (pathname === "/lrs/activities/state" && searchParams.get("stateId") === "LMS.LaunchData")
    return tell(200, JSON.stringify(launchData));
  if (pathname !== "/lrs/statements") return tell(404);
  const parts: Buffer[] = [];
  for await (const part of asked) parts.push(part as Buffer);
  const body = Buffer.concat(parts).toString();
  const headers = {
    "X-Experience-API-Version": kVersion,
    "Content-Type": "application/json",
    Authorization: asked.headers.authorization ?? "",
  };
  const took = await fetch(`${statements}${search}`, { method: asked.method, headers, body: body || undefined });
  const text = await took.text();
  if (asked.method === "POST") {
    const { verb } = JSON.parse(body) as { verb: { id: string } };
    said.push(`${verb.id.replace(/.*\//, "")}: ${took.status} ${took.ok ? "" : text}`);
  }
  tell(took.status, text);
}

const folder = await mkdtemp(join(tmpdir(), "windlass-course-"));
const rig = new Rig();
let deck: Rig | undefined; // that of the learner's exercise
const { url, process: storeProcess } = await recordStore();
const system = createServer((asked, given) => {
  answer(asked, given, `${url}statements`).catch((why: unknown) => {
    console.error(why);
    given.writeHead(500).end();
  });
});
try {
  await new Promise<void>((ready) => system.listen(0, "127.0.0.1", ready));
  const origin = `http://127.0.0.1:${(system.address() as AddressInfo).port}`;
  launchData.returnURL = `${origin}/back`;
  rig.server(lesson, "--wait", "--time-scale", "10");
  const door = await rig.door(join(folder, "door"), "--learning-system", origin);
  const owner = await firstOwner(door.setup);
  const launch = new URLSearchParams({
    endpoint: `${origin}/lrs/`,
    fetch: `${origin}/fetch`,
    actor: JSON.stringify(actor),
    registration,
    activityId: activity,
  });
  const learner = await openPage(`${door.url}cmi5/${lesson}?${launch}`, { ignoreHTTPSErrors: true });
  await learner.getByRole("link", { name: "Enter the ship" }).click();
  await learner.waitForURL(/\/forecastle/);
  const name = await eventually("its exercise is listed", async () => {
    const all = await owner.evaluate(async () => (await fetch("/door/classes")).text());
    return /"(cmi5-[\w]+)"/.exec(all)?.[1] ?? "";
  });
  deck = new Rig(`${name}-1`);
  await deck.script(script).ended; // that of an error may wait in vain for what the bridge then does not order
  await learner.getByRole("link", { name: "Finish, back to the course" }).click();
  await learner.getByRole("heading", { name: /assed, with/ }).waitFor();
  console.log(await learner.getByRole("heading", { name: /assed, with/ }).textContent());
  await learner.waitForURL(/\/back/, { timeout: 120_000 });
  await eventually("the session is closed", () => said.some((each) => each.startsWith("terminated")));
  await sleep(1000);
  console.log(said.join("\n"));
  const headers = { "X-Experience-API-Version": kVersion, Authorization: "Basic dGVzdDp0ZXN0" };
  const kept = (await (await fetch(`${url}statements?registration=${registration}`, { headers })).json()) as {
    statements: { verb: { id: string }; result?: object }[];
  };
  for (const { verb, result } of kept.statements.reverse())
    console.log(`${verb.id.replace(/.*\//, "")} ${JSON.stringify(result ?? {})}`);
  assert.equal(kept.statements.length, said.length);
  assert.deepEqual(
    said.filter((each) => !each.endsWith(": 200 ")),
    [],
  );
} catch (why) {
  console.error(why);
  console.error(said.join("\n"));
  process.exitCode = 1;
} finally {
  await closeBrowser();
  await deck?.end();
  await rig.end();
  storeProcess.kill();
  system.close();
  if (process.env.KEEP) console.log(`kept: ${folder}`);
  else await rm(folder, { recursive: true, force: true });
}
