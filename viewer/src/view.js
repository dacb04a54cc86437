/* A second picture of a scene, from elsewhere, beside it and with labels of its own. */
import { PerspectiveCamera } from "three";
import { createPicture } from "./elements.js";
import { draw } from "./screen.js";
import { pixels } from "./startup.js";

// What a camera that may be within the scene sees.
const [NEAR, FAR] = [0.01, 100];

/**
 * @param {HTMLElement} box a poster, or nothing yet, and labels
 * @param {Map<string, {objects: object[]}>} parts of the scene, by name
 * @returns {{camera: PerspectiveCamera, look: function, draw: function}} look takes a view of a state, and
 *   draw a scene; before the first look there is nothing to draw
 */
export function secondPicture(box, parts) {
  const camera = new PerspectiveCamera();
  const unseen = JSON.parse(box.dataset.without).flatMap((name) => parts.get(name).objects);
  const poster = box.querySelector(".scene-poster");
  const canvas = createPicture(poster?.alt ?? box.dataset.alt);
  let seen = null;
  const show = (scene) => {
    Object.assign(canvas, pixels(box));
    if (!seen || canvas.width === 0) return;
    camera.position.set(...seen.eye);
    camera.up.set(...seen.up);
    camera.lookAt(...seen.target);
    Object.assign(camera, {
      near: NEAR,
      far: FAR,
      fov: seen.angle,
      aspect: canvas.width / canvas.height,
    });
    camera.updateMatrixWorld();
    camera.updateProjectionMatrix();
    const hidden = unseen.filter(({ visible }) => visible);
    for (const object of hidden) object.visible = false;
    draw(scene, camera, canvas);
    for (const object of hidden) object.visible = true;
    if (!canvas.isConnected) box.prepend(canvas);
    box.dataset.state = "live";
  };
  return { camera, look: (view) => (seen = view), draw: show };
}
