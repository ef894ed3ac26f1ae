// Debian's Chromium, with what each page must not do: no error on the console, no request to another origin.

import { join } from "node:path";
import { need, root } from "../../station/web/tools/web.mjs";

export { found, need, root } from "../../station/web/tools/web.mjs";
export const web = join(root, "station/web");

const kChromium = process.env.WINDLASS_CHROMIUM ?? "/usr/bin/chromium";
// Software rendering, so that a picture does not depend on the machine; timers as if the page were looked at.
const kArguments = [
  "--no-sandbox",
  "--headless=new",
  "--use-gl=angle",
  "--use-angle=gl-egl",
  "--ignore-gpu-blocklist",
  "--disable-background-timer-throttling",
  "--disable-renderer-backgrounding",
  "--autoplay-policy=no-user-gesture-required",
];
// OpenBridge's gauges log one of these when they are first drawn; nothing else may be on the console.
const kKnown = /<path> attribute d: Expected (number|arc flag)/;

let browser;
/** The one browser of a test file. */
export async function theBrowser() {
  browser ??= await need("playwright-core").chromium.launch({ executablePath: kChromium, args: kArguments });
  return browser;
}
export async function closeBrowser() {
  await browser?.close();
  browser = undefined;
}

/**
 * Opens an address in a context of its own. options: as playwright's newContext; init: a script run before the page's;
 * watch: gets the page before it goes anywhere.
 * The page's `problems` are the console's errors and requests to other origins so far.
 */
export async function openPage(url, { init, watch, ...options } = {}) {
  const context = await (await theBrowser()).newContext({ viewport: { width: 1280, height: 800 }, ...options });
  if (init) await context.addInitScript(init);
  context.setDefaultTimeout(60000); // a loaded machine is no fault of the page
  const page = await context.newPage();
  const origin = url === "about:blank" ? "about:blank" : new URL(url).origin;
  page.problems = [];
  page.on("pageerror", (error) => page.problems.push(`uncaught: ${error.message}`));
  page.on("console", (message) => {
    if (message.type() === "error" && !kKnown.test(message.text()) && !page.lostOnPurpose)
      page.problems.push(message.text());
  });
  page.on("request", (request) => {
    const to = request.url();
    if (!/^(data|blob|about):/.test(to) && new URL(to).origin.replace(/^ws/, "http") !== origin)
      page.problems.push(`request to ${to}`);
  });
  watch?.(page);
  await page.goto(url);
  return page;
}
export const closePage = (page) => page.context().close();
