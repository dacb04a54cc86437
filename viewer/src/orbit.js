/* Lets the reader turn and zoom a scene, by mouse, fingers and keys. */
import { TOUCH } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";

const STEP = Math.PI / 24;
const ZOOM = 0.9;

/**
 * Let the reader move the camera around a point.
 * @param camera
 * @param {HTMLElement} scene
 * @param {HTMLCanvasElement} canvas
 * @param {number[]} target the point that the camera turns about
 * @param {number} [swing] degrees by which it may turn to each side; by default it turns all round
 */
export function orbit(camera, scene, canvas, target, swing) {
  const controls = new OrbitControls(camera, canvas);
  controls.target.set(...target);
  controls.minDistance = 0.2 * controls.getDistance();
  controls.maxDistance = 4 * controls.getDistance();
  controls.update();
  if (swing) {
    const [around, down] = [controls.getAzimuthalAngle(), controls.getPolarAngle()];
    const limit = (swing * Math.PI) / 180;
    controls.minAzimuthAngle = around - limit;
    controls.maxAzimuthAngle = around + limit;
    controls.minPolarAngle = Math.max(0, down - limit);
    controls.maxPolarAngle = Math.min(Math.PI, down + limit);
  }
  controls.saveState();

  // A figure that answers the hand takes its controls along.
  const whole = scene.closest(".explorable") ?? scene;
  const isFull = () => document.fullscreenElement === whole;
  const full = () => (isFull() ? document.exitFullscreen() : whole.requestFullscreen());

  // Within the page, the wheel and a finger that moves up or down scroll the page.
  const grip = () => {
    canvas.style.touchAction = isFull() ? "none" : "pan-y";
    controls.touches.TWO = isFull() ? TOUCH.DOLLY_PAN : TOUCH.DOLLY_ROTATE;
  };
  grip();
  whole.addEventListener("fullscreenchange", grip);
  scene.addEventListener(
    "wheel",
    (event) => {
      if (!event.ctrlKey && !event.metaKey && !isFull()) event.stopPropagation();
    },
    { capture: true },
  );
  // A finger that turns out to scroll the page has already moved the figure a little.
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
  for (const kind of ["touchstart", "touchmove"]) {
    canvas.addEventListener(
      kind,
      (event) => {
        if (event.touches.length > 1 && event.cancelable) event.preventDefault();
      },
      { passive: false },
    );
  }

  const keys = {
    ArrowLeft: () => controls.rotateLeft(-STEP),
    ArrowRight: () => controls.rotateLeft(STEP),
    ArrowUp: () => controls.rotateUp(-STEP),
    ArrowDown: () => controls.rotateUp(STEP),
    "+": () => controls.dollyIn(ZOOM),
    "=": () => controls.dollyIn(ZOOM),
    "-": () => controls.dollyOut(ZOOM),
    0: () => controls.reset(),
    Home: () => controls.reset(),
    f: full,
    Escape: () => canvas.blur(),
  };
  canvas.addEventListener("keydown", (event) => {
    const action = keys[event.key] ?? keys[event.key.toLowerCase()];
    if (!action || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    action();
  });
  return { controls, full };
}
