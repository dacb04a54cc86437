/*
 * The Python of the pages in Node.
 *
 * node page_python.mjs RUNTIME ANSWERS compiles the modules that a page loads when it starts, and those
 * that it has loaded when it has drawn a chart. ANSWERS gets, as JSON, both as `core` and `charts`: the
 * file of each module with its bytes in base64.
 *
 * node page_python.mjs RUNTIME ANSWERS CASES runs cells. CASES is JSON: a list of pages, each with
 * what its `figures` show, by name, and its `cells`, which run in order in one namespace. ANSWERS
 * gets the results that a page would get.
 */
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { loadPyodide } from "pyodide";

const COMPILE = `
import base64, json, sys
from importlib._bootstrap_external import _code_to_hash_pyc

compiled = {}
for module in list(sys.modules.values()):
    file = getattr(module, "__file__", None) or ""
    if file.endswith(".py") and hasattr(module.__loader__, "get_data"):
        # Nobody reads the docstrings of the standard library here; they weigh half a megabyte.
        short = 2 if ".zip/" in file else 0
        source = module.__loader__.get_data(file)
        code = compile(source, file, "exec", dont_inherit=True, optimize=short)
        compiled[file] = base64.b64encode(_code_to_hash_pyc(code, bytes(8), False)).decode()
json.dumps(compiled)
`;

const CHART = "import matplotlib.pyplot as plt\nplt.plot([1], label='$x$')\nplt.legend()";

// Node would print the whole source of Pyodide with an error that nobody catches.
process.on("uncaughtException", (error) => {
  console.error(String(error.message).slice(-2000));
  process.exit(1);
});

const [runtime, answers, cases] = process.argv.slice(2);
const python = await loadPyodide({
  indexURL: fileURLToPath(new URL("../node_modules/pyodide/", import.meta.url)),
  stdLibURL: join(runtime, "python_stdlib.zip"),
});
const site = python.runPython("import site; site.getsitepackages()[0]");
function unpack(name) {
  const bytes = new Uint8Array(readFileSync(join(runtime, name)));
  python.unpackArchive(bytes, "zip", { extractDir: site });
}
["numpy.zip", "rotedu.zip"].forEach(unpack);
python.registerJsModule("shelf", { unpack_charts: () => unpack("matplotlib.zip") ?? "" });
const page = python.pyimport("page");

function run({ figures, cells }) {
  page.start();
  const shown = JSON.stringify(figures);
  return cells.map((code, i) => JSON.parse(page.run(code, `Cell ${i + 1}`, shown, () => {})));
}

function compile() {
  const loaded = () => JSON.parse(python.runPython(COMPILE));
  const core = loaded();
  const [{ error }] = run({ figures: {}, cells: [CHART] });
  if (error) throw new Error(error);
  return { core, charts: loaded() };
}

const results = cases ? JSON.parse(readFileSync(cases, "utf-8")).map(run) : compile();
writeFileSync(answers, JSON.stringify(results));
