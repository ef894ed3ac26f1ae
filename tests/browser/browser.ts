// Debian's Chromium, or its Firefox, with what each page must not do: no error on the console, no request to another
// origin.

import { type Browser, type BrowserContextOptions, type Page, chromium, firefox } from "playwright-core";

export { root } from "../../station/web/tools/web.mjs";

const kChromium = process.env.WINDLASS_CHROMIUM ?? "/usr/bin/chromium";
const kFirefox = process.env.WINDLASS_FIREFOX ?? "/usr/bin/firefox-esr";
// Without OpenGL, which by software costs a third more of the machine than all that a page does itself.
const kPlainPages = "--disable-gpu-compositing";
// Software rendering, so that a picture does not depend on the machine; timers as if the page were looked at.
const kArguments = [
  "--no-sandbox",
  "--headless=new",
  "--use-gl=angle",
  "--use-angle=gl-egl",
  "--ignore-gpu-blocklist",
  kPlainPages,
  // the address bar's own pages, which it loads for every window; then what Playwright turns off, which this replaces
  "--disable-features=WebUIOmniboxPopup,WebUIOmniboxAimPopup,HttpsUpgrades,MediaRouter,OptimizationHints,Translate",
  "--disable-background-timer-throttling",
  "--disable-renderer-backgrounding",
  "--autoplay-policy=no-user-gesture-required",
];
// OpenBridge's gauges log one of these when they are first drawn, and a busy machine's sound device the other; nothing
// else may be on the console.
const kKnown = /<path> attribute d: Expected (number|arc flag)|AudioContext encountered an error from the audio device/;

/** A page of ours. */
export interface TestPage extends Page {
  /** The console's errors and requests to other origins so far. */
  problems: string[];
  /** Its station or server is ended on purpose: the console may say so. */
  lostOnPurpose?: boolean;
}

/** What is read of the gateway's messages (docs/gateway.md). */
export interface GatewayMessage {
  op: string;
  allowed?: string;
  channels?: { id: number; topic: string }[];
  subscriptions?: { channelId: number }[];
}

let browser: Browser | undefined;
let isFirefox = process.env.WINDLASS_BROWSER === "firefox"; // else Chromium
/** Makes Firefox the browser of a test file, before it opens a page: as Debian has it, driven by WebDriver BiDi. */
export function inFirefox(): void {
  isFirefox = true;
}
/** The one browser of a test file. asUsers: its pages are put together as a user's are, whatever that costs. */
export async function theBrowser({ asUsers = false } = {}): Promise<Browser> {
  const args = asUsers ? kArguments.filter((each) => each !== kPlainPages) : kArguments;
  browser ??= isFirefox
    ? await firefox.launch({ channel: "moz-firefox", executablePath: kFirefox })
    : await chromium.launch({ executablePath: kChromium, args });
  return browser;
}
export async function closeBrowser(): Promise<void> {
  await browser?.close();
  browser = undefined;
}

export interface PageOptions extends BrowserContextOptions {
  /** Of somebody who was never here: the pages explain themselves. */
  firstVisit?: boolean;
  /** A script run before the page's. */
  init?: () => void;
  /** Gets the page before it goes anywhere. */
  watch?: (page: TestPage) => void;
}

/** Opens an address in a context of its own. */
export async function openPage(
  url: string,
  { init, watch, firstVisit, ...options }: PageOptions = {},
): Promise<TestPage> {
  const context = await (await theBrowser()).newContext({ viewport: { width: 1280, height: 800 }, ...options });
  if (!firstVisit)
    await context.addInitScript(
      () => location.protocol.startsWith("http") && localStorage.setItem("windlass.first_visit", "seen"),
    );
  if (init) await context.addInitScript(init);
  context.setDefaultTimeout(60000); // a loaded machine is no fault of the page
  const problems: string[] = [];
  const page: TestPage = Object.assign(await context.newPage(), { problems });
  const origin = url === "about:blank" ? "about:blank" : new URL(url).origin;
  page.on("pageerror", (error) => problems.push(`uncaught: ${error.message}`));
  page.on("console", (message) => {
    if (message.type() === "error" && !kKnown.test(message.text()) && !page.lostOnPurpose)
      problems.push(message.text());
  });
  page.on("request", (request) => {
    const to = request.url();
    if (!/^(data|blob|about):/.test(to) && new URL(to).origin.replace(/^ws/, "http") !== origin)
      problems.push(`request to ${to}`);
  });
  watch?.(page);
  await page.goto(url);
  return page;
}
export const closePage = (page: Page): Promise<void> => page.context().close();
