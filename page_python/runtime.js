/*
 * The page's Python: a worker that the first run starts. What it has fetched is kept for the next
 * one, and spare workers have their scripts: after Stop, Python starts again without a network.
 */
import { home } from "./elements.js";

export const STOPPED = "Stopped. What has run is forgotten; the next Run starts Python anew.";
const SPARES = 2;
const root = document.documentElement;
let worker;
let spares = [];
const kept = {};
let serial = 0;
let waiting;
root.dataset.python = "absent";

/**
 * Run code, one piece at a time; promise what the worker says then, or words for the reader.
 * `loading` is told how many bytes are fetched, of how many, and of what, and nothing when Python is
 * ready; `printing` all that has been printed so far.
 */
export function run(cell, loading, printing) {
  worker ??= start();
  return new Promise((resolve, reject) => {
    waiting = { id: ++serial, resolve, reject, loading, printing };
    worker.postMessage({ id: serial, ...cell });
  });
}

/** End Python, also in the middle of a cell. */
export const stop = () => end("absent", STOPPED);

function start() {
  root.dataset.python = "loading";
  const made = spares.pop() ?? load();
  made.onmessage = hear;
  made.onerror = ({ message = "its script did not load" }) => fail(message);
  if (kept.files) made.postMessage(kept);
  return made;
}

const load = () => new Worker(new URL(globalThis.WORKER, home));

function addSpares() {
  while (spares.length < SPARES) {
    const spare = load();
    spares.push(spare);
    // Without a network none loads.
    spare.onerror = () => (spares = spares.filter((each) => each !== spare));
  }
}

function hear({ data }) {
  if (data.total) waiting?.loading?.(data.fetched, data.total, data.what);
  if (data.failed) {
    delete kept.files;
    fail(data.failed);
  }
  if (data.ready) {
    root.dataset.python = "ready";
    waiting?.loading?.();
    kept.compiled = data.compiled;
    addSpares();
  }
  if (data.files) kept.files = { ...kept.files, ...data.files };
  if (data.id !== waiting?.id) return;
  if (data.text) waiting.printing?.(data.text);
  if (data.dead) end("absent", `Python has ended: ${data.dead}. The next Run starts it anew.`);
  if (data.done) settle("resolve", data.done);
}

function fail(why) {
  const offline = navigator.onLine ? "" : " You seem to be offline.";
  end("failed", `Python could not be fetched (${why}).${offline} Run tries again.`);
}

function end(state, text) {
  worker?.terminate();
  worker = undefined;
  root.dataset.python = state;
  settle("reject", new Error(text));
}

function settle(how, what) {
  const one = waiting;
  waiting = undefined;
  one?.[how](what);
}
