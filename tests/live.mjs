/*
 * node tests/live.mjs RUNTIME CASES ANSWERS runs cells in the Python of the pages.
 *
 * CASES is JSON: a list of pages, each with the names of its `figures` and its `cells`, which run in
 * order in one namespace. ANSWERS gets for each page the results that a page of the book would get.
 */
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { loadPyodide } from "pyodide";

// Node would print the whole source of Pyodide with an error that nobody catches.
process.on("uncaughtException", (error) => {
  console.error(String(error.message).slice(-2000));
  process.exit(1);
});

const [runtime, cases, answers] = process.argv.slice(2);
const python = await loadPyodide({
  indexURL: new URL("../node_modules/pyodide/", import.meta.url).pathname,
  stdLibURL: join(runtime, "python_stdlib.zip"),
});
const site = python.runPython("import site; site.getsitepackages()[0]");
for (const name of ["numpy.zip", "rotedu.zip"]) {
  python.unpackArchive(new Uint8Array(readFileSync(join(runtime, name))), "zip", { extractDir: site });
}
const page = python.pyimport("page");

const results = JSON.parse(readFileSync(cases, "utf-8")).map(({ figures, cells }) => {
  page.start();
  const shown = JSON.stringify(Object.fromEntries(figures.map((name) => [name, {}])));
  return cells.map((code, i) => JSON.parse(page.run(code, `Cell ${i + 1}`, shown, () => {})));
});
writeFileSync(answers, JSON.stringify(results));
