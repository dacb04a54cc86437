/* Numbers for the camera. */

const DEGREES = 180 / Math.PI;

/**
 * The height of the field of view, in degrees, that shows all of the poster in a box of another
 * shape.
 * @param {number} viewAngle of the poster, in degrees
 * @param {number} posterAspect width over height of the poster
 * @param {number} aspect width over height of the box
 */
export function fieldOfView(viewAngle, posterAspect, aspect) {
  const half = Math.tan(viewAngle / 2 / DEGREES);
  return 2 * DEGREES * Math.atan(half * Math.max(1, posterAspect / aspect));
}

/**
 * The nearest and the farthest distance that has something to show.
 * @param {number} distance from the camera to the middle of the scene
 * @param {number} radius of the scene
 */
export function clipping(distance, radius) {
  const far = distance + radius;
  return { near: Math.max(distance - radius, far / 1000) * 0.99, far: far * 1.01 };
}
