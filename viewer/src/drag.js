/* The geometry of dragging a point over a sphere about the origin, or over the plane of x and y. */

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** The point that lies so far from another in a direction. */
const along = (point, distance, direction) => point.map((x, i) => x + distance * direction[i]);

/**
 * Where a line of sight meets the sphere first; beside it, the nearest point of the rim.
 * @param {number[]} eye
 * @param {number[]} direction of length 1
 * @param {number} radius
 */
export function alongSphere(eye, direction, radius) {
  const middle = -dot(eye, direction);
  const foot = along(eye, middle, direction);
  const beside = dot(foot, foot) - radius * radius;
  if (beside <= 0) return along(eye, middle - Math.sqrt(-beside), direction);
  // The rim seen from the eye is the circle of the points p with p . eye = radius^2.
  const distance = Math.hypot(...eye);
  const towards = eye.map((x) => x / distance);
  const across = along(foot, -dot(foot, towards), towards);
  const cosine = radius / distance;
  const out = (radius * Math.sqrt(1 - cosine * cosine)) / Math.hypot(...across);
  return along(towards.map((x) => radius * cosine * x), out, across);
}

/**
 * Where a line of sight meets the plane of x and y; above its horizon, the direction of sight.
 * @param {number[]} eye
 * @param {number[]} direction
 */
export function alongPlane(eye, direction) {
  const way = -eye[2] / direction[2];
  return way > 0 ? along(eye, way, direction) : direction;
}
