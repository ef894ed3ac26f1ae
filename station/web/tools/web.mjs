// build/web: what the build makes for pages, tests and tools. All presets share it: npm's packages, and the wire's
// types and decoders (wire/generated.ts), which sources import as if they stood in station/web/src.

import { createRequire } from "node:module";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

/** The repository's folder, without a slash at its end; ts.mjs says it to what it has bundled elsewhere. */
export const root = process.env.WINDLASS_ROOT ?? fileURLToPath(new URL("../../..", import.meta.url)).replace(/\/$/, "");
export const web = join(root, "build/web");
const from = createRequire(join(web, "package.json"));

/**
 * A package of station/web/package.json.
 * @param {string} name
 * @returns {unknown} to be given its type: typeof import(name)
 */
export function need(name) {
  try {
    return /** @type {unknown} */ (from(name));
  } catch (why) {
    throw new Error(`${name} is not in ${web}: build the pages first, or run cmake -P cmake/NpmPackages.cmake`, {
      cause: why,
    });
  }
}

/**
 * How esbuild finds what is in build/web.
 * @type {Pick<import("esbuild").BuildOptions, "nodePaths" | "plugins">}
 */
export const found = {
  nodePaths: [join(web, "node_modules")],
  plugins: [
    {
      name: "generated",
      setup: (build) => build.onResolve({ filter: /\/generated$/ }, () => ({ path: join(web, "wire/generated.ts") })),
    },
  ],
};
