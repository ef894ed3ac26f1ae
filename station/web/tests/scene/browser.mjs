// Opens the scene's test page in Chromium: bundled, served on loopback.

import { build } from "esbuild";
import { createServer } from "node:http";
import { readFile } from "node:fs/promises";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";

const here = fileURLToPath(new URL(".", import.meta.url));
const kTypes = { html: "text/html", js: "text/javascript", json: "application/json" };

/** A page with window.show and window.run; close() ends browser and server. errors: what its console said. */
export async function openScene(width = 1280, height = 720) {
  const bundle = await build({
    absWorkingDir: here,
    entryPoints: ["page.ts"],
    bundle: true,
    format: "esm",
    target: "es2022",
    write: false,
  });
  const server = createServer(async (request, response) => {
    const name = request.url === "/" ? "page.html" : request.url.slice(1);
    try {
      const body = name === "page.js" ? bundle.outputFiles[0].contents : await readFile(here + name);
      response.writeHead(200, { "Content-Type": kTypes[name.split(".").at(-1)] }).end(body);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((done) => server.listen(0, "127.0.0.1", done));
  const browser = await chromium.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: ["--no-sandbox", "--use-gl=angle", "--use-angle=gl-egl", "--ignore-gpu-blocklist"],
  });
  const page = await browser.newPage({ viewport: { width, height } });
  const errors = [];
  page.on("console", (m) => ["error", "warning"].includes(m.type()) && errors.push(m.text()));
  page.on("pageerror", (e) => errors.push(`${e}`));
  await page.goto(`http://127.0.0.1:${server.address().port}/`);
  await page.waitForFunction("window.show !== undefined");
  return {
    page,
    errors,
    show: (what) => page.evaluate((w) => window.show(w), what),
    run: (seconds) => page.evaluate((s) => window.run(s), seconds),
    close: async () => {
      await browser.close();
      server.close();
    },
  };
}
