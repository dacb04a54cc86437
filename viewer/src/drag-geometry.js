/*
 * The geometry of dragging: a point over a sphere about the origin, a number along a path, a body
 * about its middle. Axes are those of the camera: to the right, up and back.
 */
import { along, cross, dot, unit } from "./vectors.js";

// A point of a body this close to its axis, in radii of its path, does not say how far the body turns.
const CLOSE = 0.2;

/**
 * Where a line of sight meets the sphere first, or last; beside it, the nearest point of the rim.
 * @param {number[]} eye
 * @param {number[]} direction of length 1
 * @param {number} radius
 * @param {boolean} [far] whether the far side is meant
 */
export function alongSphere(eye, direction, radius, far) {
  const middle = -dot(eye, direction);
  const foot = along(eye, middle, direction);
  const beside = dot(foot, foot) - radius * radius;
  if (beside <= 0) return along(eye, middle + (far ? 1 : -1) * Math.sqrt(-beside), direction);
  // The rim seen from the eye is the circle of the points p with p . eye = radius^2.
  const distance = Math.hypot(...eye);
  const towards = unit(eye);
  const across = along(foot, -dot(foot, towards), towards);
  const cosine = radius / distance;
  const out = (radius * Math.sqrt(1 - cosine * cosine)) / Math.hypot(...across);
  return along(
    towards.map((x) => radius * cosine * x),
    out,
    across,
  );
}

/** Whether a path ends where it begins. */
export function isClosed(path) {
  const last = path.at(-1);
  return Math.hypot(...path[0].map((x, i) => x - last[i])) < 1e-4;
}

/** The point of a path at a share of its steps. */
export function pointOf(path, share) {
  const at = Math.min(1, Math.max(0, share)) * (path.length - 1);
  const i = Math.min(path.length - 2, Math.floor(at));
  return path[i].map((x, k) => x + (at - i) * (path[i + 1][k] - x));
}

/**
 * The circle on which a point of a body goes while the body turns with a number along a closed circle.
 * @param {number[][]} path the circle along which the number goes, once or several times
 * @param {number[]} point of the body
 * @param {number} share where the body is now, as a share of the path
 * @returns {number[][]} as many points; the path itself if the point is too close to the axis to be led
 */
export function carried(path, point, share) {
  const steps = path.length - 1;
  const middle = [0, 1, 2].map((i) => path.slice(1).reduce((sum, p) => sum + p[i], 0) / steps);
  const [first, second] = path.map((p) => along(p, -1, middle));
  const normal = cross(first, second);
  const axis = unit(normal);
  const step = Math.atan2(Math.hypot(...normal), dot(first, second));
  const offset = along(point, -1, middle);
  const height = dot(offset, axis);
  const spoke = along(offset, -height, axis);
  if (Math.hypot(...spoke) < CLOSE * Math.hypot(...first)) return path;
  const ahead = cross(axis, spoke);
  const centre = along(middle, height, axis);
  return path.map((_, k) => {
    const angle = (k - share * steps) * step;
    return along(along(centre, Math.cos(angle), spoke), Math.sin(angle), ahead);
  });
}

/**
 * Where a path in the picture comes nearest to a place, as a share of its steps.
 * @param {number[][]} path of pixels
 * @param {number[]} place
 * @param {number} [about] a share from which the path is searched for `reach` to both sides; round and
 *   round if it is closed, so that the answer may lie beyond 0 and 1
 */
export function nearest(path, [x, y], about = 0.5, reach = 0.5, closed = false) {
  const steps = path.length - 1;
  const first = Math.floor((about - reach) * steps);
  const last = Math.ceil((about + reach) * steps);
  let best = { distance: Infinity };
  for (let i = first; i < last; i++) {
    if (!closed && (i < 0 || i >= steps)) continue;
    const from = ((i % steps) + steps) % steps;
    const [ax, ay] = path[from];
    const [dx, dy] = path[from + 1].map((value, k) => value - path[from][k]);
    const square = dx * dx + dy * dy;
    const t = square && Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / square));
    const distance = Math.hypot(ax + t * dx - x, ay + t * dy - y);
    if (distance < best.distance) best = { distance, share: (i + t) / steps };
  }
  return best;
}

/**
 * The turn of a ball under a finger, as axis times angle: to the right, up, and towards the eye.
 * @param {number[]} from a place of the finger, in radii from the middle of the ball, right and up
 * @param {number[]} to the next place
 */
export function rolling(from, to) {
  const [a, b] = [onBall(from), onBall(to)];
  const axis = cross(a, b);
  const sine = Math.hypot(...axis);
  const angle = Math.atan2(sine, dot(a, b));
  return axis.map((x) => (sine ? (x * angle) / sine : 0));
}

/** A point of the ball of radius 1 or, farther out, of the slope around it. */
function onBall(place) {
  const [x, y] = place;
  const square = x * x + y * y;
  const z = square < 0.5 ? Math.sqrt(1 - square) : 0.5 / Math.sqrt(square);
  return unit([x, y, z]);
}

/**
 * Turn a point about the origin.
 * @param {number[]} point
 * @param {number[][]} axes
 * @param {number[]} arrow steps to the right and up, one of them 0
 * @param {number} angle of a step
 */
export function turned(point, axes, arrow, angle) {
  const [right, up] = axes;
  const [x, y] = arrow;
  const axis = along(
    right.map((value) => -y * value),
    x,
    up,
  );
  const ahead = cross(axis, point);
  const still = (1 - Math.cos(angle)) * dot(axis, point);
  return along(
    along(
      point.map((value) => Math.cos(angle) * value),
      Math.sin(angle),
      ahead,
    ),
    still,
    axis,
  );
}

/**
 * Turn a body.
 * @param {number[]} pose a unit quaternion, scalar first
 * @param {number[]} turn axis times angle along the axes
 */
export function spun([w, ...v], axes, turn) {
  const axis = [0, 1, 2].map((i) => axes.reduce((sum, way, k) => sum + turn[k] * way[i], 0));
  const angle = Math.hypot(...axis);
  const cosine = Math.cos(angle / 2);
  const by = axis.map((x) => angle && (x * Math.sin(angle / 2)) / angle);
  const across = cross(by, v);
  const now = [cosine * w - dot(by, v), ...v.map((x, i) => cosine * x + w * by[i] + across[i])];
  return unit(now);
}
