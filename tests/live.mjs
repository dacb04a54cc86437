/*
 * node tests/live.mjs CASES ANSWERS runs cells in the Python of the pages.
 *
 * CASES is JSON: a list of pages, each with the names of its `figures` and its `cells`, which run in
 * order in one namespace. ANSWERS gets for each page the results that a page of the book would get.
 */
import { readFileSync, writeFileSync } from "node:fs";
import { loadPyodide } from "pyodide";

// Node would print the whole source of Pyodide with an error that nobody catches.
process.on("uncaughtException", (error) => {
  console.error(String(error.message).slice(-2000));
  process.exit(1);
});

const [cases, answers] = process.argv.slice(2);
const runtime = new URL("../_build/live/live/", import.meta.url).pathname;
const python = await loadPyodide({
  indexURL: new URL("../node_modules/pyodide/", import.meta.url).pathname,
  stdLibURL: `${runtime}python_stdlib.zip`,
});
const site = python.runPython("import site; site.getsitepackages()[0]");
for (const name of ["numpy.zip", "rotedu.zip"]) {
  python.unpackArchive(new Uint8Array(readFileSync(runtime + name)), "zip", { extractDir: site });
}
const page = python.pyimport("page");

const results = JSON.parse(readFileSync(cases, "utf-8")).map(({ figures, cells }) => {
  page.NAMESPACE.clear();
  const shown = JSON.stringify(Object.fromEntries(figures.map((name) => [name, {}])));
  return cells.map((code, i) => JSON.parse(page.run(code, `Cell ${i + 1}`, shown, () => {})));
});
writeFileSync(answers, JSON.stringify(results));
