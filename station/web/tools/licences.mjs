// The licences of the npm packages whose code or fonts are in the bundle, as one text that is served beside it.

import { readFile, readdir } from "node:fs/promises";
import { join } from "node:path";
import { root } from "./web.mjs";

/**
 * Folders of the packages that a bundle took sources from ("node_modules/three"), by esbuild's list of inputs.
 * @param {string[]} inputs
 */
function packagesOf(inputs) {
  /** @type {Set<string>} */
  const folders = new Set();
  for (const file of inputs) {
    const match = /^(.*node_modules\/(?:@[^/]+\/)?[^/]+)\//.exec(file);
    if (match?.[1]) folders.add(match[1]);
  }
  return [...folders].sort((a, b) => (a < b ? -1 : 1));
}

/**
 * The text of a package's licence; a package without one must say that it stands under the Apache License.
 * @param {string} folder of the package
 * @param {{ name: string, license: string }} about its package.json
 * @param {string} apache text of the Apache License
 */
async function textOf(folder, about, apache) {
  const file = (await readdir(folder)).find((f) => /^(licen[cs]e|copying)/i.test(f));
  if (file) return readFile(join(folder, file), "utf8");
  if (about.license === "Apache-2.0") return apache;
  throw new Error(`${about.name} is in the bundle and brings no licence (package.json says ${about.license})`);
}

/**
 * One text: for each package its name, version and licence. Throws where NOTICE does not name a package.
 * @param {string} from the folder that inputs are relative to
 * @param {string[]} inputs esbuild's list of what a bundle is made of
 */
export async function licences(from, inputs) {
  const apache = await readFile(join(root, "LICENSE"), "utf8");
  const notice = await readFile(join(root, "NOTICE"), "utf8");
  const parts = ["What these pages contain beside Windlass itself (Apache License 2.0), with the licences.\n"];
  for (const name of packagesOf(inputs)) {
    const folder = join(from, name);
    const about = /** @type {{ name: string, version: string, license: string }} */ (
      JSON.parse(await readFile(join(folder, "package.json"), "utf8"))
    );
    if (!notice.includes(`${about.name} (${about.license})`))
      throw new Error(`NOTICE must name what the pages contain: ${about.name} (${about.license})`);
    parts.push(
      `== ${about.name} ${about.version} (${about.license})\n\n${(await textOf(folder, about, apache)).trim()}\n`,
    );
  }
  return parts.join("\n");
}
