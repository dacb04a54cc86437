/* A second picture of a scene, from elsewhere, beside it and with labels of its own. */
import { PerspectiveCamera, Vector3 } from "three";
import { createPicture } from "./elements.js";
import { sortSeeThrough } from "./materials.js";
import { Labels } from "./placed-labels.js";
import { draw, without } from "./screen.js";
import { pixels } from "./startup.js";

// What a camera that may be within the scene sees.
const [NEAR, FAR] = [0.01, 100];

export class SecondPicture {
  /**
   * @param {HTMLElement} box a poster, or nothing yet, and labels
   * @param {Map<string, import("./types.js").Part>} parts of the scene, by name
   */
  constructor(box, parts) {
    /** @type {HTMLImageElement | null} */
    const poster = box.querySelector(".scene-poster");
    this.box = box;
    this.camera = new PerspectiveCamera();
    this.canvas = createPicture(poster?.alt ?? box.dataset.alt);
    this.labels = new Labels(box);
    const names = JSON.parse(box.dataset.without ?? "[]");
    this.unseen = names.flatMap((name) => parts.get(name)?.objects);
    /** @type {import("./types.js").Sight | null} before the first look there is nothing to draw */
    this.seen = null;
  }

  draw({ scene, objects, surfaces }) {
    const { box, camera, canvas, seen } = this;
    Object.assign(canvas, pixels(box));
    if (!seen || canvas.width === 0) return;
    camera.position.fromArray(seen.eye);
    camera.up.fromArray(seen.up);
    camera.lookAt(new Vector3().fromArray(seen.target));
    const aspect = canvas.width / canvas.height;
    Object.assign(camera, { near: NEAR, far: FAR, fov: seen.angle, aspect });
    camera.updateMatrixWorld();
    camera.updateProjectionMatrix();
    sortSeeThrough(objects, camera);
    without(this.unseen, () => draw(scene, camera, canvas));
    if (!canvas.isConnected) box.prepend(canvas);
    box.dataset.state = "live";
    this.labels.place(camera, surfaces);
  }
}
