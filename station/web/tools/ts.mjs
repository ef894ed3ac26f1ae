// Runs TypeScript in node: bundles it by esbuild into a folder of its own in build/web, where it finds npm's packages.
//
// usage: node ts.mjs FILE.ts [ARGUMENT...]       runs it; import.meta.url is the bundle's, so it is told in
//                                                WINDLASS_ROOT where the repository is
//        node ts.mjs --test FOLDER [NAME...]     runs the tests of FOLDER (*.test.ts), or those whose path has a NAME
//        node ts.mjs --test FILE.ts              runs the tests of a file
// Stops with what it ran: a signal goes on to it.

import { spawn } from "node:child_process";
import { mkdir, mkdtemp, readdir, rm } from "node:fs/promises";
import { join, relative, resolve } from "node:path";
import { found, need, root, web } from "./web.mjs";

/** @param {string} folder */
const filesIn = async (folder) => (await readdir(folder, { recursive: true })).map((name) => join(folder, name));

/**
 * Bundles sources into a folder that did not exist before.
 * @param {string[]} sources
 */
async function bundle(sources) {
  const { build } = /** @type {typeof import("esbuild")} */ (need("esbuild"));
  await mkdir(join(web, "run"), { recursive: true });
  const output = await mkdtemp(join(web, "run/"));
  await build({
    ...found,
    entryPoints: sources,
    outdir: output,
    outbase: root,
    outExtension: { ".js": ".mjs" },
    bundle: true,
    external: ["esbuild", "playwright-core", "ws"], // these look for files of their own
    platform: "node",
    format: "esm",
    target: "node18",
    sourcemap: "inline",
    banner: {
      // what CommonJS in a bundle asks for
      js: "import { createRequire as __of } from 'node:module'; const require = __of(import.meta.url);",
    },
    loader: { ".css": "empty" },
    logLevel: "warning",
  });
  return { output, files: (await filesIn(output)).filter((file) => file.endsWith(".mjs")) };
}

const [first, ...rest] = process.argv.slice(2);
if (!first) throw new Error("usage: node ts.mjs FILE.ts [ARGUMENT...] | --test FOLDER [NAME...]");
const testing = first === "--test";
let sources = [resolve(first)];
if (testing) {
  const [place, ...names] = rest;
  if (!place) throw new Error("usage: node ts.mjs --test FILE.ts | FOLDER [NAME...]");
  const wanted = (/** @type {string} */ file) =>
    file.endsWith(".test.ts") && (names.length === 0 || names.some((name) => relative(place, file).includes(name)));
  sources = place.endsWith(".ts") ? [resolve(place)] : (await filesIn(resolve(place))).filter(wanted);
  if (sources.length === 0) throw new Error(`${place} has no tests ${names.join(", ")}`);
}
const { output, files } = await bundle(sources);
try {
  const child = spawn(
    process.execPath,
    ["--enable-source-maps", ...(testing ? ["--test", ...files] : [...files, ...rest])],
    { stdio: "inherit", env: { ...process.env, WINDLASS_ROOT: root } },
  );
  for (const signal of /** @type {const} */ (["SIGINT", "SIGTERM"])) process.on(signal, () => child.kill(signal));
  process.exitCode = await new Promise((done) => child.on("close", (code) => done(code ?? 1)));
} finally {
  await rm(output, { recursive: true, force: true });
}
