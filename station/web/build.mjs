// Bundles the pages into a folder that the station programs serve as it is: scripts, styles, fonts, the licences of
// what is in them, and a gzip twin of each that gains by it. No network, no clock: the same sources give the same
// files.
//
// usage: node build.mjs OUTPUT

import { cp, mkdir, readFile, readdir, rm, writeFile } from "node:fs/promises";
import { join, resolve } from "node:path";
import { constants, gzipSync } from "node:zlib";
import { licences } from "./tools/licences.mjs";
import { makeWire } from "./tools/make_wire.mjs";
import { found, need, root } from "./tools/web.mjs";

const here = join(root, "station/web");
const [to] = process.argv.slice(2);
if (!to) throw new Error("usage: node build.mjs OUTPUT");
const output = resolve(to);

await makeWire();

await rm(output, { recursive: true, force: true });
await mkdir(output, { recursive: true });

const pages = (await readdir(join(here, "src/pages"))).filter((f) => f.endsWith(".html"));
const names = pages.map((f) => f.replace(/\.html$/, ""));
const { build } = /** @type {typeof import("esbuild")} */ (need("esbuild"));
const { metafile } = await build({
  ...found,
  absWorkingDir: here,
  // The last is a module of the audio's own thread, which a page loads by its address (sound/strikes.ts).
  entryPoints: [...names.map((n) => `src/pages/${n}.ts`), "src/kit/kit.css", "src/sound/strikes_processor.ts"],
  outdir: join(output, "assets"),
  entryNames: "[name]",
  bundle: true,
  splitting: true,
  format: "esm",
  target: "es2022",
  minify: true,
  sourcemap: false,
  legalComments: "linked",
  metafile: true,
  chunkNames: "[name]-[hash]",
  assetNames: "[name]-[hash]",
  loader: { ".woff2": "file", ".svg": "file" },
  logLevel: "warning",
});
for (const page of pages) await cp(join(here, "src/pages", page), join(output, page));
await cp(join(here, "src/pages/favicon.svg"), join(output, "favicon.svg"));
await writeFile(join(output, "licences.txt"), await licences(here, Object.keys(metafile.inputs)));

/** @param {string} folder */
async function filesIn(folder) {
  const entries = await readdir(folder, { recursive: true, withFileTypes: true });
  return entries.filter((f) => f.isFile()).map((f) => join(f.parentPath, f.name));
}
let total = 0,
  zipped = 0;
for (const file of await filesIn(output)) {
  if (!/\.(js|css|html|svg|txt)$/.test(file)) continue;
  const bytes = await readFile(file);
  const gz = gzipSync(bytes, { level: constants.Z_BEST_COMPRESSION });
  await writeFile(`${file}.gz`, gz);
  total += bytes.length;
  zipped += gz.length;
}
console.log(
  `${names.length} pages, ${Object.keys(metafile.inputs).length} sources, ` +
    `${Math.round(total / 1024)} kB, ${Math.round(zipped / 1024)} kB gzipped`,
);
