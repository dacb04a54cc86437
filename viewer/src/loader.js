/*
 * Makes the scenes of a page live when they come near the screen, after the first sign of a reader.
 * For a reader who saves data, a click does so. Until then, and where it fails, the posters stay.
 * The data-state of a scene is poster, loading, live or failed.
 */
/* global VIEWER, BY_HAND */
import { SERVE, onClickOnly, openWebGL, reason, status } from "./startup.js";

const home = document.currentScript.src;
const scenes = [...document.querySelectorAll(".scene[data-scene]")];
const SIGNS_OF_A_READER = ["pointermove", "pointerdown", "touchstart", "scroll", "keydown"];
const NEAR = "50% 0%";
let context;

/** Fetch the viewer and the scene at the same time, and put the first frame over the poster. */
async function goLive(scene) {
  if (scene.dataset.state !== "poster") return;
  scene.dataset.state = "loading";
  try {
    const figure = scene.closest(".explorable");
    const needed = [loadModule(VIEWER), load(scene.dataset.scene)];
    if (figure) needed.push(loadModule(BY_HAND), load(figure.dataset.explore));
    context ??= openWebGL(scene);
    const [viewer, file, byHand, data] = await Promise.all(needed);
    const { attributes } = scene.querySelector(".scene-poster");
    // The size of the scene as it was made, not of the poster as it is shown.
    const [width, height] = [attributes.width, attributes.height].map(({ value }) => Number(value));
    const alt = attributes.alt.value;
    const live = await viewer.show(scene, file, context, { width, height, alt });
    scene.dataset.state = "live";
    if (figure) byHand.answer(figure, live, JSON.parse(new TextDecoder().decode(data)));
  } catch (error) {
    fail(scene, reason(error));
  }
}

function loadModule(name) {
  return import(new URL(name, home)).catch(() => {
    throw new Error("the viewer did not load");
  });
}

async function load(url) {
  const answer = await fetch(url).catch(() => {
    throw new Error("its scene did not load");
  });
  if (!answer.ok) throw new Error(`its scene did not load (${answer.status})`);
  return answer.arrayBuffer();
}

function fail(scene, text) {
  scene.dataset.state = "failed";
  const line = status();
  scene.after(line);
  line.textContent = text;
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

/** Go at once to the figure that the address speaks of. */
function followLink() {
  const [whose, state] = location.hash.slice(1).split("?");
  const figure = state === undefined ? null : document.getElementById(whose);
  if (!figure?.matches(".explorable")) return;
  figure.scrollIntoView();
  begin();
}

function begin() {
  SIGNS_OF_A_READER.forEach((sign) => removeEventListener(sign, begin));
  watch(goLive);
}

for (const scene of scenes) {
  scene.dataset.state = "poster";
  // Python in the page sets a figure that nobody has seen yet.
  scene.addEventListener("rotedu:live", () => goLive(scene));
}
if (location.protocol === "file:") {
  // Browsers fetch nothing for a page opened from a file.
  watch((scene) => fail(scene, SERVE));
} else if (navigator.connection?.saveData) {
  scenes.forEach((scene) => onClickOnly(scene, goLive));
} else {
  SIGNS_OF_A_READER.forEach((sign) => addEventListener(sign, begin, { passive: true }));
  followLink();
}
