/* The camera of a scene: where the poster was seen from, and where the reader has turned it. */
import { PerspectiveCamera, Vector3 } from "three";
import { clipping, fieldOfView, outermost, reach, widened } from "./camera.js";

/** @import { Axes, Frame, Point, PosterCamera } from "./types.js" */

export class Aim {
  /**
   * @param {PosterCamera} pose
   * @param {import("three").Sphere} around everything, also what has yet to move there
   * @param {ArrayLike<number>[]} clouds coordinates of what a turned scene must not lose
   */
  constructor(pose, around, clouds) {
    this.pose = pose;
    this.around = around;
    this.radius = around.radius;
    this.camera = new PerspectiveCamera(pose.viewAngle, pose.aspect);
    this.camera.up.fromArray(pose.up);
    this.camera.position.fromArray(pose.position);
    this.camera.lookAt(new Vector3().fromArray(pose.target));
    this.camera.updateMatrixWorld();
    this.distance = this.depth(pose.target);
    this.ends = outermost(clouds, pose.target);
    this.atRest = this.axes();
    this.lensAtRest = lens(this.camera);
  }

  /** Fit the lens to where the camera has gone and to a picture of some shape. */
  fit(aspect) {
    const { around, camera, distance, ends, pose } = this;
    camera.updateMatrixWorld();
    const angle = fieldOfView(pose.viewAngle, pose.aspect, aspect);
    const half = Math.tan((angle * Math.PI) / 360);
    const [now, before] = [this.axes(), this.atRest].map((axes) =>
      reach(ends, axes, distance, [half * aspect, half]),
    );
    const depths = clipping(camera.position.distanceTo(around.center), around.radius);
    Object.assign(camera, { ...depths, aspect, fov: widened(angle, now, before) });
    camera.updateProjectionMatrix();
  }

  /**
   * Leave room for what moves, which may come nearer to the camera than anything did at the start.
   * @returns whether there has been less
   */
  widen(factor) {
    if (this.around.radius >= factor * this.radius) return false;
    this.around.radius = factor * this.radius;
    return true;
  }

  /** @returns {Point} where the camera is */
  eye() {
    return this.camera.position.toArray();
  }

  /** @returns {Axes} */
  axes() {
    const [right, up, back] = [new Vector3(), new Vector3(), new Vector3()];
    this.camera.matrixWorld.extractBasis(right, up, back);
    return [right.toArray(), up.toArray(), back.toArray()];
  }

  /** How far before the camera a point lies. */
  depth(point) {
    return -new Vector3().fromArray(point).applyMatrix4(this.camera.matrixWorldInverse).z;
  }

  /** The direction of the line of sight through a place of the picture. */
  through(left, top) {
    const { camera } = this;
    const seen = new Vector3(2 * left - 1, 1 - 2 * top, 0.5).unproject(camera);
    return seen.sub(camera.position).normalize().toArray();
  }

  /**
   * The point in the middle of a part of the poster, as far away as what the camera looks at.
   * @param {Frame} part
   */
  middleOf([left, top, width, height]) {
    const { viewAngle, aspect, target } = this.pose;
    const half = this.distance * Math.tan((viewAngle * Math.PI) / 360);
    const [x, y] = [(2 * left + width - 1) * half * aspect, (1 - 2 * top - height) * half];
    const [right, up] = this.atRest;
    return target.map((value, i) => value + x * right[i] + y * up[i]);
  }
}

/** The matrix from the scene to the picture of a camera, by columns. */
export function lens(camera) {
  return camera.projectionMatrix.clone().multiply(camera.matrixWorldInverse).elements;
}
