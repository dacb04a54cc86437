/* What a scene needs before it is live: messages, a button that starts it, WebGL. */

// Nobody sees more pixels than this per CSS pixel.
const DENSITY = 2;

export const SERVE =
  "To turn or move this figure, run “python -m http.server” in the folder of the book" +
  " and open http://localhost:8000.";

/** Say why a figure stays a picture. */
export function reason(error) {
  return `This figure stays a picture: ${error.message}.`;
}

/** Make an empty line whose text a screen reader will announce. */
export function status() {
  const line = document.createElement("p");
  line.className = "scene-message";
  line.setAttribute("role", "status");
  return line;
}

/** Let the reader decide whether to fetch a scene. */
export function onClickOnly(scene, goLive) {
  const button = document.createElement("button");
  button.type = "button";
  button.className = "scene-start";
  button.textContent = "Turn this figure";
  button.addEventListener("click", () => {
    button.remove();
    goLive(scene);
  });
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
  return opened;
}
