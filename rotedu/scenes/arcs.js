/* Model of page 5 I. */
import {
  columns,
  DEGREES,
  IDENTITY,
  joined,
  ORIGIN,
  scaled,
  spread,
  turning,
  V,
  W,
} from "./parts.js";
import {
  angleBetween,
  arcAxis,
  combine,
  cross,
  DegenerateError,
  dot,
  length,
  nlerp,
  product,
  quaternionMatrix,
  rotate,
  slerp,
  transpose,
  unit,
} from "./rotations.js";

// Below this angle the sines are their angles to the last digit, but never 0/0.
const TINY = 1e-9;
// Angles in radians, and sines, that look like zero.
const SAME = 1e-6;
const SAMPLES = 61;
// Spoons closer than this, in radians, share one name.
const CLOSE = 25 / DEGREES;
// From the middle of the sphere to that of the spoons, to the right of the picture.
const BESIDE = [2.3, 0, 0];

/** A path from the pole that keeps to its meridian, or bulges to a side of it. */
export function theDetour({ aside }, { down }) {
  // At a share of the way down, so many degrees from the meridian.
  const at = (t, east) => rotate(rotate(W, V, (t * down) / DEGREES), W, east / DEGREES);
  const times = spread(SAMPLES);
  const path = times.map((t) => at(t, aside * Math.sin(Math.PI * t)));
  const steps = path.slice(1).map((point, i) => angleBetween(path[i], point));
  return {
    parts: {
      path: { paths: [path] },
      meridian: { paths: [times.map((t) => at(t, 0))] },
      middle: { at: at(0.5, aside) },
    },
    labels: {},
    grips: { aside: { path: times.map((x) => at(0.5, 180 * x - 90)), holds: ["path", "middle"] } },
    outputs: { length: DEGREES * steps.reduce((sum, step) => sum + step, 0) },
  };
}

/** Slerp and nlerp between two points, and what both do to a spoon. */
export function slerpByHand({ p, q, t, flip }, { antipodal }) {
  [p, q] = [p, q].map(unit);
  const end = flip ? scaled(-1, q) : q;
  const theta = angleBetween(p, end);
  if (theta > Math.PI - SAME) throw new DegenerateError(antipodal);
  const axis = axisAcross(p, q);
  const times = spread(SAMPLES);
  const arc = times.map((x) => slerp(p, end, x));
  const [here, there] = [slerp(p, end, t), nlerp(p, end, t)];
  const tenths = spread(11)
    .slice(1, -1)
    .map((x) => [ORIGIN, nlerp(p, end, x)]);
  const beside = (point, reach, across) => combine(reach, point, across, axis);
  // On the great circle where the arc is not.
  const beyond = (point, distance) =>
    combine(1.06, point, flip ? -distance : distance, cross(axis, point));
  const [startWeight, endWeight] = weights(theta, t);
  const curves = transpose(times.map((x) => weights(theta, x)));
  const onSphere = {
    parts: {
      arc: { paths: [arc] },
      tenths: { paths: tenths },
      chord: { paths: [[p, end]] },
      p: { at: p },
      q: { at: q },
      end: { at: end },
      slerp: { at: here },
      nlerp: { at: there },
    },
    labels: {
      p: beyond(p, -0.17),
      q: beyond(q, 0.17),
      "-q": flip ? beyond(end, 0.17) : null,
      slerp: beside(here, 0.8, 0.1),
      nlerp: beside(there, 1.15, -0.15),
    },
    grips: { t: { path: arc, holds: ["slerp"] }, p: { holds: ["p"] }, q: { holds: ["q"] } },
    outputs: {
      angle: DEGREES * theta,
      way: 2 * DEGREES * theta,
      speed: speedOfNlerp(theta, t),
      start_weight: startWeight,
      end_weight: endWeight,
      weights_sum: startWeight + endWeight,
    },
    charts: {
      weights: { start: curves[0], end: curves[1] },
      speeds: { slerp: times.map(() => 1), nlerp: times.map((x) => speedOfNlerp(theta, x)) },
    },
  };
  return joined(onSphere, spoons(p, axis, arc, here, there));
}

/** Beside the sphere, spoons that the quaternions of an arc turn. */
function spoons(p, axis, arc, here, there) {
  const held = transpose([p, cross(axis, p), axis]);
  /** Where the quaternion of a point v, which is v p*, takes the spoon: tip, side and bowl. */
  const turned = (point) =>
    transpose(product(quaternionMatrix([dot(point, p), ...cross(p, point)]), held));
  const spoon = (point) => ({ matrix: columns(turned(point), BESIDE) });
  const aside = (point, reach = 1) => combine(1, BESIDE, reach, point);
  const tips = arc.map((point) => turned(point)[0]);
  const last = tips.at(-1);
  return {
    parts: {
      circle: { paths: [turning(p, axis, 2 * Math.PI, 96).map((point) => aside(point))] },
      sweep: { paths: [tips.map((tip) => aside(tip))] },
      axis: { from: BESIDE, to: aside(axis, 0.5) },
      "spoon at the start": spoon(p),
      "spoon at the end": spoon(arc.at(-1)),
      "spoon by slerp": spoon(here),
      "spoon by nlerp": spoon(there),
    },
    labels: {
      start: aside(p, 1.2),
      "end of turn": angleBetween(p, last) > CLOSE ? aside(last, 1.2) : null,
    },
  };
}

/** The axis of the arc or, for points on one line, some axis across it. */
function axisAcross(p, q) {
  if (length(cross(p, q)) > SAME) return arcAxis(p, q);
  const sizes = p.map(Math.abs);
  return arcAxis(p, IDENTITY[sizes.indexOf(Math.min(...sizes))]);
}

/** The factors of both ends in (5-2); where the ends coincide, their limits. */
function weights(theta, t) {
  const size = Math.max(theta, TINY);
  return [1 - t, t].map((share) => Math.sin(share * size) / Math.sin(size));
}

/** How fast nlerp moves, as a multiple of slerp's constant speed. */
function speedOfNlerp(theta, t) {
  const size = Math.max(theta, TINY);
  return Math.sin(size) / (size * (1 - 2 * t * (1 - t) * (1 - Math.cos(size))));
}
