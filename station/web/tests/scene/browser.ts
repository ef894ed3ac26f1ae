// Opens the scene's test page in Chromium: bundled, served on loopback.

import { build } from "esbuild";
import { createServer } from "node:http";
import type { AddressInfo } from "node:net";
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { chromium, type Page } from "playwright-core";
import { found, root } from "../../tools/web.mjs";
import type { SceneWindow, Show } from "./page";

export const here = join(root, "station/web/tests/scene");
const kTypes: Record<string, string> = { html: "text/html", js: "text/javascript", json: "application/json" };

/** What a picture cost. */
export interface Stats {
  calls: number;
  triangles: number;
  geometries: number;
  textures: number;
}

export interface SceneBrowser {
  page: Page;
  /** What its console said. */
  errors: string[];
  show(what: Show): Promise<Stats>;
  /** Where the links of a side are drawn: x, y, z, x, y, z ... */
  places(side: number): Promise<number[]>;
  close(): Promise<void>;
}

/** A page that draws the scene; close() ends browser and server. */
export async function openScene(width = 1280, height = 720): Promise<SceneBrowser> {
  const bundle = await build({
    ...found,
    absWorkingDir: here,
    entryPoints: ["page.ts"],
    bundle: true,
    format: "esm",
    target: "es2022",
    write: false,
  });
  const script = bundle.outputFiles[0]!.contents;
  const server = createServer((request, response) => {
    const name = request.url === "/" ? "page.html" : request.url!.slice(1);
    const body = name === "page.js" ? Promise.resolve(script) : readFile(join(here, name));
    body.then(
      (bytes) => response.writeHead(200, { "Content-Type": kTypes[name.split(".").at(-1)!] }).end(bytes),
      () => response.writeHead(404).end(),
    );
  });
  await new Promise<void>((done) => server.listen(0, "127.0.0.1", done));
  const browser = await chromium.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: ["--no-sandbox", "--use-gl=angle", "--use-angle=gl-egl", "--ignore-gpu-blocklist"],
  });
  const page = await browser.newPage({ viewport: { width, height } });
  const errors: string[] = [];
  page.on("console", (m) => ["error", "warning"].includes(m.type()) && errors.push(m.text()));
  page.on("pageerror", (e) => errors.push(`${e}`));
  await page.goto(`http://127.0.0.1:${(server.address() as AddressInfo).port}/`);
  await page.waitForFunction("window.show !== undefined");
  return {
    page,
    errors,
    show: (what) => page.evaluate((w) => (window as unknown as SceneWindow).show(w), what),
    places: (side) => page.evaluate((s) => (window as unknown as SceneWindow).places(s), side),
    close: async () => {
      await browser.close();
      server.close();
    },
  };
}
