/*
 * Makes the scenes of a page live when they come near the screen, after the first sign of a reader.
 * For a reader who saves data, a click does so. Until then, and where it fails, the posters stay.
 * The data-state of a scene is poster, loading, live or failed.
 */
/* global VIEWER */
import { SERVE, onClickOnly, openWebGL, reason, status } from "./page.js";

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
    const needed = [loadViewer(), loadScene(scene.dataset.scene)];
    context ??= openWebGL(scene);
    const [viewer, file] = await Promise.all(needed);
    const { attributes } = scene.querySelector(".scene-poster");
    // The size of the scene as it was made, not of the poster as it is shown.
    const [width, height] = [attributes.width, attributes.height].map(({ value }) => Number(value));
    await viewer.show(scene, file, context, { width, height, alt: attributes.alt.value });
    scene.dataset.state = "live";
  } catch (error) {
    fail(scene, reason(error));
  }
}

function loadViewer() {
  return import(new URL(VIEWER, home)).catch(() => {
    throw new Error("the viewer did not load");
  });
}

async function loadScene(url) {
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

function begin() {
  SIGNS_OF_A_READER.forEach((sign) => removeEventListener(sign, begin));
  watch(goLive);
}

for (const scene of scenes) scene.dataset.state = "poster";
if (location.protocol === "file:") {
  // Browsers fetch nothing for a page opened from a file.
  watch((scene) => fail(scene, SERVE));
} else if (navigator.connection?.saveData) {
  scenes.forEach((scene) => onClickOnly(scene, goLive));
} else {
  SIGNS_OF_A_READER.forEach((sign) => addEventListener(sign, begin, { passive: true }));
}
