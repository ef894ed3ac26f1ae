// Bundles the tests of the pages' pure parts and runs them.
//
// usage: node tests/run.mjs [NAME...]

import { build } from "esbuild";
import { spawnSync } from "node:child_process";
import { mkdtemp, readdir, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { basename, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = fileURLToPath(new URL(".", import.meta.url));
const wanted = process.argv.slice(2);
const found = (await readdir(here, { recursive: true })).filter(
  (f) => f.endsWith(".test.ts") && (wanted.length === 0 || wanted.some((w) => f.includes(w))),
);
const output = await mkdtemp(join(tmpdir(), "windlass-pages-"));
try {
  await build({
    absWorkingDir: here,
    entryPoints: found,
    outdir: output,
    outExtension: { ".js": ".mjs" },
    bundle: true,
    platform: "node",
    format: "esm",
    target: "node20",
    logLevel: "warning",
  });
  const bundled = (await readdir(output, { recursive: true })).filter((f) => f.endsWith(".mjs"));
  const { status } = spawnSync(process.execPath, ["--test", ...bundled.map((f) => join(output, f))], {
    stdio: "inherit",
    env: { ...process.env, SCENE_INSTANTS: join(here, "scene/instants.json") },
  });
  process.exitCode = status ?? 1;
  if (found.length === 0) throw new Error(`no tests named ${wanted.map((w) => basename(w))}`);
} finally {
  await rm(output, { recursive: true });
}
