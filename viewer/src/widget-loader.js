/*
 * Travels with every figure of a notebook, so it is small. It makes sure that the viewer itself comes
 * only once for all figures of the page, which share it on the global object.
 *
 * The first figure of a kernel has the viewer with it. If that figure is not on this page, the others
 * ask for the viewer; but a kernel that runs cells answers only after the last of them.
 */
/* global DIGEST */

// How long the viewer may be under way before another figure asks for it, in milliseconds.
const PATIENCE = 10_000;
const shared = (globalThis[`rotedu viewer ${DIGEST}`] ??= share());

function share() {
  let resolve;
  const viewer = new Promise((done) => (resolve = done));
  return { viewer, resolve, askedAt: -Infinity, arrived: false };
}

/** Take the viewer out of its buffer, which is empty if it is elsewhere. */
function receive(buffer) {
  if (shared.arrived || buffer.byteLength === 0) return;
  shared.arrived = true;
  shared.resolve(load(buffer));
}

async function load(buffer) {
  const text = new Blob([buffer]).stream().pipeThrough(new DecompressionStream("gzip"));
  const module = await new Response(text, {
    headers: { "Content-Type": "text/javascript" },
  }).blob();
  return import(URL.createObjectURL(module));
}

/** Ask for a sign of life, because some kernels never answer, and then, once, for the viewer. */
function ask(model) {
  const fetch = () => {
    if (shared.arrived) return;
    const wait = shared.askedAt + PATIENCE - Date.now();
    if (wait > 0) {
      setTimeout(fetch, wait);
    } else {
      shared.askedAt = Date.now();
      model.send({ get: "viewer" });
    }
  };
  model.on("msg:custom", ({ got }, [buffer]) => {
    if (got === "sign of life") fetch();
    if (got === "viewer") receive(buffer);
  });
  model.send({ get: "sign of life" });
}

export default {
  initialize({ model }) {
    receive(model.get("viewer"));
  },
  async render(view) {
    if (!shared.arrived) ask(view.model);
    const viewer = await shared.viewer;
    if (!view.signal?.aborted) return viewer.render(view);
  },
};
