// WebKit, which Safari and every browser of an iPad are made of: Debian's WebKitGTK, driven by WebDriver, on a display
// that nobody sees.

import { type ChildProcess, spawn } from "node:child_process";
import { createServer } from "node:net";
import { Builder, By, type WebDriver, type WebElement } from "selenium-webdriver";

import { eventually } from "./rig";

const kDriver = process.env.WINDLASS_WEBKIT_DRIVER ?? "/usr/bin/WebKitWebDriver";

async function freePort(): Promise<number> {
  const server = createServer().listen(0, "127.0.0.1");
  await new Promise((listening) => server.once("listening", listening));
  const address = server.address();
  await new Promise((closed) => server.close(closed));
  if (address === null || typeof address === "string") throw new Error("no port");
  return address.port;
}

/** A display without a screen, for a window of a desk's size; its name. */
async function display(started: ChildProcess[]): Promise<string> {
  const server = spawn("Xvfb", ["-displayfd", "1", "-screen", "0", "1400x1000x24", "-nolisten", "tcp"], {
    stdio: ["ignore", "pipe", "ignore"],
  });
  started.push(server);
  let told = "";
  server.stdout.on("data", (text: Buffer) => (told += text.toString()));
  await eventually("a display", () => Promise.resolve(told.includes("\n")));
  return `:${told.trim()}`;
}

/** A window of it, with what a hand does there. */
export class WebKit {
  private constructor(
    readonly driver: WebDriver,
    private readonly started: ChildProcess[],
  ) {}

  /** It takes a certificate that no authority vouches for, as that of a door's own. */
  static async start(): Promise<WebKit> {
    const started: ChildProcess[] = [];
    const port = await freePort();
    const env = { ...process.env, DISPLAY: await display(started) };
    started.push(spawn(kDriver, [`--port=${port}`], { stdio: "ignore", env }));
    const url = `http://127.0.0.1:${port}`;
    await eventually("WebKit's driver", () =>
      fetch(`${url}/status`).then(
        (answer): boolean => answer.ok,
        (): boolean => false,
      ),
    );
    const driver = await new Builder()
      .usingServer(url)
      .withCapabilities({ browserName: "MiniBrowser", acceptInsecureCerts: true })
      .build();
    await driver.manage().setTimeouts({ implicit: 10000 }); // what is looked for may still be drawn
    return new WebKit(driver, started);
  }

  async end(): Promise<void> {
    await this.driver.quit().catch((): void => undefined); // it may have ended by itself
    for (const each of this.started.reverse()) each.kill();
  }

  /** Makes the page so large, as far as a window goes. */
  async size(width: number, height: number): Promise<void> {
    const window = this.driver.manage().window();
    await window.setRect({ x: 0, y: 0, width, height });
    const inner = await this.driver.executeScript<[number, number]>("return [innerWidth, innerHeight]");
    await window.setRect({ x: 0, y: 0, width: 2 * width - inner[0], height: 2 * height - inner[1] });
  }

  find(css: string): Promise<WebElement> {
    return this.driver.findElement(By.css(css));
  }
  /** The button that is called so. */
  button(name: string): Promise<WebElement> {
    return this.driver.findElement(By.xpath(`//button[normalize-space(.)="${name}"]`));
  }
  /** Pressed once it is there and may be. */
  async press(name: string): Promise<void> {
    await eventually(`"${name}" is pressed`, async () => {
      try {
        await (await this.button(name)).click();
        return true;
      } catch {
        return false;
      }
    });
  }
  async text(css: string): Promise<string> {
    return (await this.find(css)).getText();
  }

  /** Drags by mouse from the first of these places on the page through the others, so many ms to each, and lets go when
   * the last has been held so long. In one go: between two the driver lets go by itself. */
  async drag(path: { x: number; y: number }[], duration: number, held = 0): Promise<void> {
    const whole = path.map(({ x, y }) => ({ x: Math.round(x), y: Math.round(y) }));
    let hand = this.driver
      .actions()
      .move({ ...whole[0], duration: 0 })
      .press();
    for (const to of whole.slice(1)) hand = hand.move({ ...to, duration });
    // It moves where it is: at a pause WebKit's driver stays for good.
    for (let ms = 0; ms < held; ms += 500) hand = hand.move({ ...whole.at(-1), duration: 500 });
    await hand.release().perform();
  }
}
