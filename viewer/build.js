/*
 * node build.js <folder> bundles the viewer into <folder>/scene/:
 *   loader.js        a classic script on every page with scenes, which also runs from files
 *   viewer-HASH.js   a module that is fetched when the first scene goes live
 *   explorables-HASH.js   another one, for pages with figures that answer the hand
 *   scene.css        the styles of both
 */
import { copyFile, mkdir } from "node:fs/promises";
import { basename, dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const folder = join(process.argv[2], "scene");
const common = { bundle: true, minify: true, target: "es2022", legalComments: "eof" };

await mkdir(folder, { recursive: true });
const { metafile } = await build({
  ...common,
  entryPoints: [join(here, "src/viewer.js"), join(here, "src/explorables.js")],
  entryNames: "[name]-[hash]",
  outdir: folder,
  format: "esm",
  metafile: true,
});
const [explorables, viewer] = Object.keys(metafile.outputs).map((file) => basename(file)).sort();
await build({
  ...common,
  entryPoints: [join(here, "src/loader.js")],
  outdir: folder,
  format: "iife",
  define: { VIEWER: JSON.stringify(viewer), EXPLORABLES: JSON.stringify(explorables) },
});
await copyFile(join(here, "scene.css"), join(folder, "scene.css"));
