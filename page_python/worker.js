/*
 * The Python of a page, in a classic worker. Everything comes from the folder of this script.
 *
 * From the page:  {compiled, files}                  first, if an earlier worker has sent them
 *                 {id, code, name, figures}          run a cell; figures: name -> values, {} if not live
 * To the page:    {fetched, total, what}             bytes, while loading Python, or Matplotlib
 *                 {ready, compiled, files}           keep both for the next worker
 *                 {files}                            keep these for it, too
 *                 {failed}                           why Python did not load
 *                 {id, text}                         all that the cell has printed so far
 *                 {id, done}                         done: see `run` in python/page.py
 *                 {id, dead}                         Python has ended; a new worker is needed
 */
"use strict";

const scope = /** @type {any} */ (self);
const wasm = /** @type {any} */ (WebAssembly);
const HERE = new URL(".", location.href);
// Before Python takes the word from it. FILES are fetched later, CHARTS when a
// cell first draws.
scope.importScripts(`files.js${location.search}`, "pyodide.js", "pyodide.asm.js");
// Pyodide asks for a list of packages that it could load: none.
const NO_PACKAGES = JSON.stringify({ info: { version: "0.27.7" }, packages: {} });
const WASM = "pyodide.asm.wasm.gz";
const MOST_MEMORY = 2 ** 14; // pages of 64 KiB

/** Fetch all files, and say how far that is. */
async function fetchAll() {
  const total = scope.FILES.reduce((sum, { size }) => sum + size, 0);
  let fetched = 0;
  const one = async ({ name, version }) => {
    const { ok, status, body } = await fetch(new URL(`${name}?v=${version}`, HERE));
    if (!ok) throw new Error(`${name}: ${status}`);
    const tell = new TransformStream({
      transform(bytes, next) {
        postMessage({ fetched: (fetched += bytes.length), total, what: "Python" });
        next.enqueue(bytes);
      },
    });
    return [name, new Uint8Array(await new Response(body?.pipeThrough(tell)).arrayBuffer())];
  };
  return Object.fromEntries(await Promise.all(scope.FILES.map(one)));
}

function compile(bytes) {
  const { body } = new Response(bytes);
  // Some servers send what is packed as packed, and the browser has unpacked it.
  const stream = bytes[0] === 0x1f ? body?.pipeThrough(new DecompressionStream("gzip")) : body;
  const headers = { "Content-Type": "application/wasm" };
  return WebAssembly.compileStreaming(new Response(stream, { headers }));
}

/** Give Pyodide what is here already, and bound its memory: beyond, Python raises a MemoryError. */
function prepare(compiled, files) {
  wasm.Memory = class extends WebAssembly.Memory {
    constructor(limits) {
      super({ ...limits, maximum: MOST_MEMORY });
    }
  };
  wasm.instantiateStreaming = async (_, imports) => ({
    module: compiled,
    instance: await wasm.instantiate(compiled, imports),
  });
  const local = { ...files, "pyodide-lock.json": NO_PACKAGES };
  scope.fetch = async (address) => new Response(local[String(address).replace(/.*\//, "")]);
}

/**
 * Return what unpacks Matplotlib for Python, and fetches it first if it is not kept; it returns why it
 * could not. Python waits meanwhile, since a cell may come to its first chart anywhere.
 */
function charts(kept, unpack) {
  const { name, size, version } = scope.CHARTS;
  const request = new XMLHttpRequest();
  const far = (fetched) => postMessage({ fetched, total: size, what: "Matplotlib" });
  return () => {
    if (!kept) {
      far(0);
      request.open("GET", new URL(`${name}?v=${version}`, HERE), false);
      request.responseType = "arraybuffer";
      try {
        request.send();
      } catch {
        return navigator.onLine ? "the server does not answer" : "you seem to be offline";
      }
      if (request.status !== 200) return `${name}: ${request.status}`;
      if (request.response.byteLength !== size) return `${name} came incomplete`;
      const bytes = new Uint8Array(request.response);
      try {
        unpack(bytes);
      } catch {
        return `${name} came damaged`;
      }
      kept = bytes;
      postMessage({ files: { [name]: kept } });
    } else unpack(kept);
    far(size);
    return "";
  };
}

async function load({ compiled, files }) {
  files ??= await fetchAll();
  compiled ??= await compile(files[WASM]);
  delete files[WASM];
  prepare(compiled, files);
  const python = await scope.loadPyodide({ indexURL: HERE.href });
  // Python then looks up from its loops; WebKit ends a worker only there.
  python.setInterruptBuffer(new Int32Array(1));
  const extractDir = python.runPython("import site; site.getsitepackages()[0]");
  const unpack = (bytes) => python.unpackArchive(bytes, "zip", { extractDir });
  [files["numpy.zip"], files["rotedu.zip"]].forEach(unpack);
  python.registerJsModule("shelf", { unpack_charts: charts(files[scope.CHARTS.name], unpack) });
  const page = python.pyimport("page");
  for (const name of ["fetch", "XMLHttpRequest", "WebSocket", "EventSource", "importScripts"]) {
    scope[name] = () => {
      throw new Error(`${name}: Python in a page talks to no host`);
    };
  }
  postMessage({ ready: true, compiled, files });
  return { python, page };
}

let loading;
async function answer({ id, code, name, figures, compiled, files }) {
  loading ??= load({ compiled, files });
  const { page } = await loading;
  if (id === undefined) return;
  try {
    const done = page.run(code, name, JSON.stringify(figures), (text) => postMessage({ id, text }));
    postMessage({ id, done: JSON.parse(done) });
  } catch (error) {
    // The runtime is gone: os._exit, or a stack that ran over.
    postMessage({ id, dead: String(error).trim().replace(/.*\n/gs, "").slice(0, 200) });
  }
}
self.onmessage = ({ data }) =>
  answer(data).catch((error) => postMessage({ failed: String(error) }));
