/*
 * Makes the scenes of a page live when they come near the screen, once the page has loaded and the
 * browser has nothing better to do. For a reader who saves data, a click does so. Until then, and where
 * it fails, the posters stay. The data-state of a scene is poster, loading, live or failed.
 */
import { goTo, isInSight, isNew, keepDrags, spokenOf } from "./arrival.js";
import { all } from "./elements.js";
import { fail, loading, onClickOnly, openWebGL, reason, SERVE } from "./startup.js";

const { src: home } = /** @type {HTMLScriptElement} */ (document.currentScript);
const scenes = all(document, ".scene[data-scene]");
const NEAR = "50% 0%";
// Milliseconds after which a busy browser begins, too.
const BUSY = 2000;
const goOn = keepDrags(scenes);
// Sphinx empties it as soon as the page is there.
const past = history.state;
let context;

/** Fetch the viewer and the scene at the same time, and put the first frame over the poster. */
async function goLive(scene) {
  if (scene.dataset.state !== "poster") return;
  scene.dataset.state = "loading";
  scene.querySelector(".scene-start")?.remove();
  const loaded = loading(scene);
  try {
    const figure = scene.closest(".explorable");
    const needed = [loadModule(VIEWER), load(scene.dataset.scene, scene.dataset.shared)];
    if (figure) needed.push(loadModule(EXPLORABLES), load(figure.dataset.explore));
    context ??= openWebGL(scene);
    const [viewer, file, explorables, data] = await Promise.all(needed);
    const { attributes } = scene.querySelector(".scene-poster");
    // The size of the scene as it was made, not of the poster as it is shown.
    const [width, height] = [attributes.width, attributes.height].map(({ value }) => Number(value));
    const alt = attributes.alt.value;
    const view = await viewer.show(scene, file, context, { width, height, alt });
    scene.dataset.state = "live";
    if (figure) explorables.answer(figure, view, JSON.parse(new TextDecoder().decode(data)));
    goOn(scene);
  } catch (error) {
    fail(scene, reason(error));
  } finally {
    loaded();
  }
}

function loadModule(name) {
  return import(String(new URL(name, home))).catch(() => {
    throw new Error("the viewer did not load");
  });
}

/** Fetch a file; what other scenes have as well is an end of its own. */
async function load(url, end) {
  if (end) return new Blob(await Promise.all([load(url), load(end)])).arrayBuffer();
  const answer = await fetch(url).catch(() => {
    throw new Error("its scene did not load");
  });
  if (!answer.ok) throw new Error(`its scene did not load (${answer.status})`);
  return answer.arrayBuffer();
}

/** Call back when a scene is near the screen. */
function watch(callback) {
  const observer = new IntersectionObserver(
    (entries) => {
      for (const { isIntersecting, target } of entries) {
        if (!isIntersecting) continue;
        observer.unobserve(target);
        callback(target);
      }
    },
    { rootMargin: NEAR },
  );
  scenes.forEach((scene) => observer.observe(scene));
}

/** Wait for the page, and until the browser has nothing better to do. */
function whenIdle(callback) {
  const wait = globalThis.requestIdleCallback ?? setTimeout;
  addEventListener("load", () => wait(callback, { timeout: BUSY }));
}

function followLink() {
  const figure = spokenOf(location.hash);
  if (!figure) return;
  const scene = figure.querySelector(".scene");
  if (!isInSight(scene)) goTo(figure);
  goLive(scene);
}

addEventListener("load", () => history.replaceState({ ...past, ...history.state }, ""));
for (const scene of scenes) {
  scene.dataset.state = "poster";
  // Python in the page sets a figure that nobody has seen yet.
  scene.addEventListener("rotedu:live", () => goLive(scene));
}
if (location.protocol === "file:") {
  // Browsers fetch nothing for a page opened from a file.
  watch((scene) => fail(scene, SERVE));
} else {
  if (navigator.connection?.saveData) scenes.forEach((scene) => onClickOnly(scene, goLive));
  else whenIdle(() => watch(goLive));
  const aim = spokenOf(location.hash);
  if (aim && isNew()) goTo(aim);
  addEventListener("hashchange", followLink);
}
