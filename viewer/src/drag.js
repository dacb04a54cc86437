/* The geometry of dragging a point over a sphere about the origin, or over the plane of U and V. */
import { combine, dot, rotate } from "./sphere.js";

/**
 * Where a line of sight meets the sphere first; beside it, the nearest point of the rim.
 * @param {number[]} eye
 * @param {number[]} direction of length 1
 * @param {number} radius
 */
export function alongSphere(eye, direction, radius) {
  const middle = -dot(eye, direction);
  const foot = combine(1, eye, middle, direction);
  const beside = dot(foot, foot) - radius * radius;
  if (beside <= 0) return combine(1, eye, middle - Math.sqrt(-beside), direction);
  // The rim seen from the eye is the circle of the points p with p . eye = radius^2.
  const distance = Math.hypot(...eye);
  const towards = eye.map((x) => x / distance);
  const across = combine(1, foot, -dot(foot, towards), towards);
  const cosine = radius / distance;
  const out = (radius * Math.sqrt(1 - cosine * cosine)) / Math.hypot(...across);
  return combine(radius * cosine, towards, out, across);
}

/**
 * Where a line of sight meets the plane of U and V; above its horizon, the direction of sight.
 * @param {number[]} eye
 * @param {number[]} direction
 */
export function alongFloor(eye, direction) {
  const way = -eye[2] / direction[2];
  return way > 0 ? combine(1, eye, way, direction) : direction;
}

/**
 * Turn a point a step to the right or up, as the eye sees it.
 * @param {number[]} point
 * @param {number[][]} axes of the camera: right, up, back
 * @param {number[]} arrow steps to the right and up
 * @param {number} angle of a step
 */
export function turned(point, [right, up], [x, y], angle) {
  return rotate(point, combine(x, up, -y, right), angle);
}
