/*
 * node build.js <folder> bundles the viewer for pages into <folder>/scene/:
 *   loader.js            a classic script on every page with scenes, which also runs from files
 *   viewer-HASH.js       a module that is fetched when the first scene goes live
 *   explorables-HASH.js  another one, for pages with explorables: what changes them, and their models
 *   scene.css            the styles of both
 *
 * node build.js --notebook <folder> bundles it for notebooks into <folder>/:
 *   figure-loader.js   a module that travels with every figure
 *   figure.js          a module that the loader fetches once, with styles, fonts and models in it
 */
import { createHash } from "node:crypto";
import { copyFile, mkdir, readFile } from "node:fs/promises";
import { basename, dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
// Python gives VTK the same texts.
const texts = ["light", "ball"].map((name) =>
  readFile(join(here, `../rotedu/figures/${name}.glsl`), "utf8"),
);
const shaders = (await Promise.all(texts)).join("");
const SHADERS = JSON.stringify(shaders.replace(/ *\/\/.*/g, "").replace(/\n\s*/g, "\n"));
/** @type {import("esbuild").BuildOptions} */
const common = {
  bundle: true,
  define: { SHADERS },
  minify: true,
  target: "es2022",
  legalComments: "eof",
};

async function forPages(folder) {
  await mkdir(folder, { recursive: true });
  const { metafile } = await build({
    ...common,
    entryPoints: [join(here, "src/viewer.js"), join(here, "explorables.js")],
    entryNames: "[name]-[hash]",
    outdir: folder,
    format: "esm",
    metafile: true,
  });
  const files = Object.keys(metafile.outputs).map((file) => basename(file));
  const [explorables, viewer] = files.sort();
  await build({
    ...common,
    entryPoints: [join(here, "src/loader.js")],
    outdir: folder,
    format: "iife",
    define: { VIEWER: JSON.stringify(viewer), EXPLORABLES: JSON.stringify(explorables) },
  });
  await copyFile(join(here, "scene.css"), join(folder, "scene.css"));
}

async function forNotebooks(folder) {
  const styles = await build({
    ...common,
    entryPoints: [join(here, "widget.css")],
    write: false,
    // Every browser that runs the viewer reads woff2.
    loader: { ".woff2": "dataurl", ".woff": "empty", ".ttf": "empty" },
  });
  const module = (entry, outfile, define) =>
    build({
      ...common,
      entryPoints: [join(here, entry)],
      outfile,
      format: "esm",
      define: { SHADERS, ...define },
    });
  const figure = join(folder, "figure.js");
  await module("notebook.js", figure, { STYLES: JSON.stringify(styles.outputFiles[0].text) });
  const digest = createHash("sha256")
    .update(await readFile(figure))
    .digest("hex");
  await module("src/widget-loader.js", join(folder, "figure-loader.js"), {
    DIGEST: JSON.stringify(digest.slice(0, 16)),
  });
}

const [first, second] = process.argv.slice(2);
await (first === "--notebook" ? forNotebooks(second) : forPages(join(first, "scene")));
