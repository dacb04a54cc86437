/* Models of `rotedu.scenes.arcs`. */
import { DEGREES, ORIGIN, placing, spread } from "./parts.js";
import {
  DegenerateError,
  angleBetween,
  arcAxis,
  combine,
  cross,
  length,
  nlerp,
  product,
  quaternionFromAxisAngle,
  quaternionMatrix,
  rotate,
  rotateByQuaternion,
  slerp as alongArc,
  transpose,
  unit,
} from "./sphere.js";

const TINY = 1e-9;
const SAME = 1e-6;
const SAMPLES = 61;
const AROUND = 97;
const UP = [0, 0, 1];

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

/** `slerp_by_hand` */
export function slerp({ p, q, what, turn, flip, t }, { antipodal }) {
  [p, q] = [p, q].map(unit);
  const spoons = what === "orientations";
  const axis = spoons || length(cross(p, q)) > SAME ? arcAxis(p, q) : UP;
  const first = spoons ? [1, 0, 0, 0] : p;
  const unflipped = spoons ? quaternionFromAxisAngle(axis, turn / DEGREES) : q;
  const last = flip ? unflipped.map((x) => -x) : unflipped;
  const theta = angleBetween(first, last);
  if (spoons && theta > Math.PI - SAME) {
    throw new DegenerateError(antipodal);
  }
  const times = spread(SAMPLES);

  const tip = (end) => (spoons ? rotateByQuaternion(end, p) : end);
  const now = alongArc(first, last, t);
  const [end, here, there] = [last, now, nlerp(first, last, t)].map(tip);
  const tenths = spread(11).slice(1, -1).map((x) => tip(nlerp(first, last, x)));
  const parts = {
    arc: { paths: [times.map((x) => tip(alongArc(first, last, x)))] },
    tenths: { paths: tenths.map((point) => [ORIGIN, point]) },
    chord: spoons ? { hidden: true } : { paths: [[p, end]], hidden: false },
    p: { at: p },
    q: { at: q },
    end: { at: end },
    slerp: { at: here },
    nlerp: { at: there },
  };
  if (spoons) {
    const held = transpose([p, cross(axis, p), axis]);
    const spoon = (turned) => ({
      matrix: placing(product(quaternionMatrix(turned), held)),
      hidden: false,
    });
    const circle = spread(AROUND).map((x) => rotate(p, axis, 2 * Math.PI * x));
    Object.assign(parts, {
      circle: { paths: [circle], hidden: false },
      axis: { from: ORIGIN, to: axis.map((x) => 1.1 * x), hidden: false },
      "spoon at the start": spoon(first),
      "spoon at the end": spoon(last),
      spoon: spoon(now),
    });
  } else {
    for (const name of ["circle", "axis", "spoon at the start", "spoon at the end", "spoon"]) {
      parts[name] = { hidden: true };
    }
  }

  const beside = (point, reach, across) => combine(reach, point, across, axis);
  const beyond = (point) => beside(point, 1.1, 0.14);
  const [startWeight, endWeight] = weights(theta, t);
  return {
    parts,
    labels: {
      p: spoons ? null : beyond(p),
      1: spoons ? beside(p, 1.1, 0.26) : null,
      q: spoons && flip ? null : beyond(spoons ? end : q),
      "-q": flip ? beyond(end) : null,
      axis: spoons ? axis.map((x) => 1.2 * x) : null,
      held: spoons ? beside(q, 1.1, -0.14) : null,
      slerp: beside(here, 0.8, 0.1),
      nlerp: beside(there, 1.15, -0.15),
    },
    outputs: {
      angle: DEGREES * theta,
      way: DEGREES * theta * (spoons ? 2 : 1),
      start_weight: startWeight,
      end_weight: endWeight,
      weights_sum: startWeight + endWeight,
      speed: speedOfNlerp(theta, t),
    },
    charts: {
      weights: {
        start: times.map((x) => weights(theta, x)[0]),
        end: times.map((x) => weights(theta, x)[1]),
      },
      speeds: { slerp: times.map(() => 1), nlerp: times.map((x) => speedOfNlerp(theta, x)) },
    },
  };
}
