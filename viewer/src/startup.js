/* What a scene needs before it is live: messages, a button that starts it, WebGL. */
import { all, element } from "./elements.js";

// Nobody sees more pixels than this per CSS pixel.
const DENSITY = 2;
// In milliseconds: when a wait needs a word, and how long the browser may keep the graphics.
const SOON = 1000;
const PATIENCE = 3000;

export const SERVE =
  "To turn or move this figure, run “python -m http.server” in the folder of the book" +
  " and open http://localhost:8000.";
const LOADING = "Loading the figure…";
const LOST =
  "The browser has taken the graphics of this page back, so this figure stays a picture until they return.";

/** Say why a figure stays a picture. */
export function reason(error) {
  return `This figure stays a picture: ${error.message}.`;
}

/** Make an empty line whose text a screen reader will announce. */
export function status(kind = "scene-message") {
  return element("p", { class: kind, role: "status" });
}

/** Put a line with a text below a scene. */
function say(scene, text, kind) {
  const line = status(kind);
  scene.after(line);
  line.textContent = text;
  return line;
}

/** Say that a scene is a picture for good. */
export function fail(scene, text) {
  scene.dataset.state = "failed";
  say(scene, text);
}

/**
 * Say that a scene is loading, unless it is there soon.
 * @returns a function that ends this
 */
export function loading(scene) {
  let line;
  const timer = setTimeout(() => (line = say(scene, LOADING, "scene-loading")), SOON);
  return () => {
    clearTimeout(timer);
    line?.remove();
  };
}

/** Let the reader decide whether to fetch a scene. */
export function onClickOnly(scene, goLive) {
  const button = element("button", { type: "button", class: "scene-start" }, "Turn this figure");
  button.addEventListener("click", () => goLive(scene));
  scene.append(button);
}

/** The size of the picture that fills a scene. */
export function pixels({ clientWidth, clientHeight }) {
  const density = Math.min(devicePixelRatio, DENSITY);
  return { width: Math.round(clientWidth * density), height: Math.round(clientHeight * density) };
}

/** Open the only WebGL context of the page, as large as its first scene. */
export function openWebGL(scene) {
  const canvas = document.createElement("canvas");
  Object.assign(canvas, pixels(scene));
  const opened = canvas.getContext("webgl2", { alpha: true, antialias: true });
  if (!opened) throw new Error("this browser cannot draw with WebGL");
  standIn(canvas);
  return opened;
}

/** Put the posters back while graphics that the browser has taken do not return. */
function standIn(canvas) {
  const lines = new Map();
  let timer;
  const rest = () => {
    for (const scene of all(document, ".scene[data-state=live]")) {
      scene.dataset.state = "failed";
      lines.set(scene, say(scene, LOST));
      switchControls(scene, false);
    }
    // Their next picture sets them right.
    for (const view of all(document, ".scene-view")) view.dataset.state = "poster";
  };
  canvas.addEventListener("webglcontextlost", (event) => {
    // Else the browser would never give it back.
    event.preventDefault();
    timer = setInterval(rest, PATIENCE);
  });
  canvas.addEventListener("webglcontextrestored", () => {
    clearInterval(timer);
    for (const [scene, line] of lines) {
      scene.dataset.state = "live";
      line.remove();
      switchControls(scene, true);
    }
    lines.clear();
  });
}

function switchControls(scene, on) {
  const controls = scene.closest(".explorable")?.querySelector("fieldset");
  if (controls) controls.disabled = !on;
}
