/*
 * The Python of a page, in a classic worker. Everything comes from the folder of this script.
 *
 * From the page:  {compiled, files}                  first, if an earlier worker has sent them
 *                 {id, code, name, figures}          run a cell; figures: name -> values, {} if not live
 * To the page:    {fetched, total}                   bytes, while loading
 *                 {ready, versions, compiled, files} keep both for the next worker
 *                 {failed}                           why Python did not load
 *                 {id, text}                         all that the cell has printed so far
 *                 {id, done, heap}                   done: see `run` in python/page.py
 *                 {id, dead}                         Python has ended; a new worker is needed
 */
"use strict";

const HERE = new URL(".", self.location);
// All scripts at once: a worker in reserve needs no network later. SIZES are of all else, in bytes.
importScripts(...["sizes.js", "pyodide.js", "pyodide.asm.js"].map((name) => new URL(name, HERE)));
// Pyodide asks for a list of packages that it could load: none.
const LOCK = { info: { arch: "wasm32", platform: "emscripten_3_1_45", version: "0.24.1", python: "3.11.3" }, packages: {} };
const PAGE = 65536;
const MOST_MEMORY = 2 ** 30;

const browserFetch = self.fetch.bind(self);

/** Fetch a file and say how far it is. */
async function fetched(name, tell) {
  const answer = await browserFetch(new URL(name, HERE));
  if (!answer.ok) throw new Error(`${name}: ${answer.status} ${answer.statusText}`);
  const chunks = [];
  for (const reader = answer.body.getReader(); ; ) {
    const { done, value } = await reader.read();
    if (done) break;
    chunks.push(value);
    tell(value.length);
  }
  return new Uint8Array(await new Blob(chunks).arrayBuffer());
}

async function fetchAll() {
  const total = Object.values(SIZES).reduce((sum, size) => sum + size);
  let sum = 0;
  const tell = (more) => postMessage({ fetched: (sum += more), total });
  const names = Object.keys(SIZES);
  const contents = await Promise.all(names.map((name) => fetched(name, tell)));
  return Object.fromEntries(names.map((name, i) => [name, contents[i]]));
}

/** Some servers send what is packed as packed, and the browser unpacks it. */
function unpacked(bytes) {
  const plain = new Blob([bytes]).stream();
  const stream = bytes[0] === 0x1f ? plain.pipeThrough(new DecompressionStream("gzip")) : plain;
  return new Response(stream, { headers: { "Content-Type": "application/wasm" } });
}

/** Let Python grow so far only: then it gets a MemoryError, and not the reader's machine. */
function boundMemory() {
  const { Memory } = WebAssembly;
  WebAssembly.Memory = function (limits) {
    return new Memory({ ...limits, maximum: MOST_MEMORY / PAGE });
  };
}

async function load({ compiled, files }) {
  files ??= await fetchAll();
  compiled ??= await WebAssembly.compileStreaming(unpacked(files["pyodide.asm.wasm.gz"]));
  boundMemory();
  // What Pyodide fetches is here already.
  WebAssembly.instantiateStreaming = async (_, imports) => ({
    module: compiled,
    instance: await WebAssembly.instantiate(compiled, imports),
  });
  const local = { "pyodide-lock.json": JSON.stringify(LOCK), "python_stdlib.zip": files["python_stdlib.zip"] };
  self.fetch = async (address) => new Response(local[String(address).split("/").at(-1)]);
  const python = await loadPyodide({ indexURL: HERE.href });
  const site = python.runPython("import site; site.getsitepackages()[0]");
  for (const name of ["numpy.zip", "rotedu.zip"]) {
    python.unpackArchive(files[name], "zip", { extractDir: site });
  }
  const page = python.pyimport("page");
  // From here on, what a reader pastes into a cell talks to no other host.
  for (const name of ["fetch", "XMLHttpRequest", "WebSocket", "EventSource", "importScripts"]) {
    self[name] = () => {
      throw new Error(`${name}: Python in a page talks to no host`);
    };
  }
  postMessage({ ready: true, versions: page.versions(), compiled, files });
  return { python, page };
}

let loading;
async function answer({ data }) {
  loading ??= load(data);
  const { python, page } = await loading;
  const { id, code, name, figures } = data;
  if (id === undefined) return;
  const tell = (text) => postMessage({ id, text });
  try {
    const done = JSON.parse(page.run(code, name, JSON.stringify(figures), tell));
    postMessage({ id, done, heap: python._module.HEAP8.length });
  } catch (error) {
    // The runtime is gone: os._exit, or a stack that ran over.
    postMessage({ id, dead: String(error).slice(0, 200) });
  }
}
onmessage = (event) => answer(event).catch((error) => postMessage({ failed: String(error) }));
