/* Lets the reader turn and zoom a scene, by mouse, fingers and keys. */
import { TOUCH } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { glide, isCalm, SHORT, slerp } from "./travel.js";

const STEP = Math.PI / 24;
const ZOOM = 0.9;

/**
 * Let the reader move the camera around what it looks at.
 * @param {import("./aim.js").Aim} aim
 * @param {HTMLElement} scene
 * @param {HTMLCanvasElement} canvas
 * @param {() => void} nextColor lights what the next colour of the caption means
 */
export function orbit({ camera, pose }, scene, canvas, nextColor) {
  const controls = new OrbitControls(camera, canvas);
  controls.target.fromArray(pose.target);
  controls.minDistance = 0.2 * controls.getDistance();
  controls.maxDistance = 4 * controls.getDistance();
  controls.update();
  if (pose.swing) swing(controls, (pose.swing * Math.PI) / 180);
  controls.saveState();

  // A figure that answers the hand takes its controls along.
  const whole = /** @type {HTMLElement} */ (scene.closest(".explorable") ?? scene);
  const isFull = () => document.fullscreenElement === whole;
  const full = () => (isFull() ? document.exitFullscreen() : whole.requestFullscreen());
  // Within the page, a finger that moves up or down scrolls the page.
  const grip = () => {
    canvas.style.touchAction = isFull() ? "none" : "pan-y";
    controls.touches.TWO = isFull() ? TOUCH.DOLLY_PAN : TOUCH.DOLLY_ROTATE;
  };
  grip();
  whole.addEventListener("fullscreenchange", grip);
  leaveTheWheel(scene, isFull);
  leaveScrolling(controls, camera, canvas);
  const reset = () => (isCalm() ? controls.reset() : goHome(controls, camera));
  bindKeys(controls, canvas, { full, reset, nextColor });
  return { controls, full, reset };
}

/** Lead the camera back to where it was at first, unless the reader takes it on the way. */
function goHome(controls, camera) {
  const from = camera.position.clone().sub(controls.target).toArray();
  const to = controls.position0.clone().sub(controls.target0).toArray();
  const target = controls.target.clone();
  const stop = glide(SHORT, (t) => {
    if (t === 1) return controls.reset();
    controls.target.lerpVectors(target, controls.target0, t);
    camera.position.fromArray(slerp(from, to, t)).add(controls.target);
    controls.update();
  });
  controls.addEventListener("start", stop);
}

/** Let the camera turn by no more than an angle to each side; by default it turns all round. */
function swing(controls, limit) {
  const [around, down] = [controls.getAzimuthalAngle(), controls.getPolarAngle()];
  controls.minAzimuthAngle = around - limit;
  controls.maxAzimuthAngle = around + limit;
  controls.minPolarAngle = Math.max(0, down - limit);
  controls.maxPolarAngle = Math.min(Math.PI, down + limit);
}

/** Within the page, the wheel scrolls the page. */
function leaveTheWheel(scene, isFull) {
  const pass = (event) => {
    if (!event.ctrlKey && !event.metaKey && !isFull()) event.stopPropagation();
  };
  scene.addEventListener("wheel", pass, { capture: true });
}

/** A finger that turns out to scroll the page has already moved the figure a little: undo that. */
function leaveScrolling(controls, camera, canvas) {
  const before = { position: camera.position.clone(), target: controls.target.clone() };
  canvas.addEventListener("pointerdown", () => {
    before.position.copy(camera.position);
    before.target.copy(controls.target);
  });
  canvas.addEventListener("pointercancel", () => {
    camera.position.copy(before.position);
    controls.target.copy(before.target);
    controls.update();
  });
  const keepTwo = (event) => {
    if (event.touches.length > 1 && event.cancelable) event.preventDefault();
  };
  for (const kind of ["touchstart", "touchmove"]) {
    canvas.addEventListener(kind, keepTwo, { passive: false });
  }
}

function bindKeys(controls, canvas, { full, reset, nextColor }) {
  const keys = {
    ArrowLeft: () => controls.rotateLeft(-STEP),
    ArrowRight: () => controls.rotateLeft(STEP),
    ArrowUp: () => controls.rotateUp(-STEP),
    ArrowDown: () => controls.rotateUp(STEP),
    "+": () => controls.dollyIn(ZOOM),
    "=": () => controls.dollyIn(ZOOM),
    "-": () => controls.dollyOut(ZOOM),
    0: reset,
    Home: reset,
    f: full,
    c: nextColor,
    Escape: () => canvas.blur(),
  };
  canvas.addEventListener("keydown", (event) => {
    const action = keys[event.key] ?? keys[event.key.toLowerCase()];
    if (!action || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    action();
  });
}
