/* Models of Chapter 4. */
import {
  DEGREES,
  degreesBetween,
  IDENTITY,
  ORIGIN,
  placing,
  scaled,
  shown,
  spread,
  turning,
  U,
  W,
} from "./parts.js";
import {
  axisAngle,
  combine,
  cross,
  DegenerateError,
  dot,
  eulerAngles,
  length,
  matrixFromEulerAngles,
  product,
  quaternionFromMatrix,
  quaternionMatrix,
  rotate,
  rotationMatrix,
  slerpRotations,
  transform,
  turnBetween,
  unit,
} from "./rotations.js";

// A shorter direction has no length of 1.
const SHORT = 0.05;

const column = (matrix, k) => matrix.map((row) => row[k]);

const ROW_BACK = [0.49, -0.77, 0.42];
const ROW_RIGHT = unit(cross(W, ROW_BACK));
const ROW_UP = cross(ROW_BACK, ROW_RIGHT);
const ACROSS = [-3.4, -1.35, 0.7, 2.6];
const DIAL = 0.45;
// A shorter bent arrow has no room for its head.
const SMALLEST_ARC = 12;

/** The three principal rotations twice: U, V, W as in (4-1), and in any order. */
export function threeTurnsByHand({ u, v, w, order, axes }, { factors, carried }) {
  const angles = { U: u, V: v, W: w };
  const parts = {};
  const labels = {};
  const grips = {};
  const rows = [
    ["upper", 1.3, ["U", "V", "W"], false],
    ["lower", -1.4, order.split(" "), axes === carried],
  ].map(([row, height, letters, along]) => {
    let soFar = IDENTITY;
    const place = (k) => combine(ACROSS[k], ROW_RIGHT, height, ROW_UP);
    parts[`${row} 0`] = { matrix: placing(soFar, place(0)) };
    letters.forEach((letter, i) => {
      const k = i + 1;
      const own = IDENTITY["UVW".indexOf(letter)];
      const n = along ? transform(soFar, own) : own;
      soFar = product(rotationMatrix(n, angles[letter] / DEGREES), soFar);
      const at = (far) => combine(1, place(k), far, n);
      parts[`${row} ${k}`] = { matrix: placing(soFar, place(k)) };
      parts[`${row} axis ${k}`] = { from: at(-1.05), to: at(1.15) };
      const { arc, head, path } = dial(at(-0.7), n, angles[letter]);
      parts[`${row} turn ${k}`] = arc;
      parts[`${row} turn ${k}, head`] = head;
      if (row === "upper") {
        labels[letter] = at(1.4);
        // The dial or the spoon, from end to end.
        const spoon = [-1, 1].map((end) => combine(1, place(k), end, column(soFar, 0)));
        grips[letter.toLowerCase()] = { path, body: [...path, ...spoon], holds: [`upper ${k}`] };
      } else {
        // Of the names of an axis, one for each number of turns that carried it, one shows.
        for (const primes of [0, 1, 2]) {
          labels[`${letter} ${primes}`] = primes === (along ? i : 0) ? at(1.4) : null;
        }
      }
    });
    const written = along ? letters : letters.toReversed();
    return { end: soFar, written: written.map((letter) => factors[letter]).join(" ") };
  });
  const [upper, lower] = rows;
  const apart = DEGREES * turnBetween(upper.end, lower.end).angle;
  return { parts, labels, grips, outputs: { apart, upper: upper.written, lower: lower.written } };
}

/**
 * A bent arrow on the side of the eye that shows an angle about an axis, and the whole dial from
 * -180 to 180 degrees.
 */
function dial(center, n, angle) {
  const view = combine(1, ROW_BACK, -dot(ROW_BACK, n), n);
  // A quarter turn lies in the middle of what the eye sees.
  const zero = rotate(scaled(DIAL / Math.max(length(view), SHORT), view), n, -Math.PI / 4);
  const moved = (points) => points.map((point) => combine(1, center, 1, point));
  const path = moved(turning(rotate(zero, n, -Math.PI), n, 2 * Math.PI, 72));
  const drawn = Math.abs(angle) >= SMALLEST_ARC;
  const arc = moved(turning(zero, n, angle / DEGREES, 24));
  const to = arc.at(-1);
  const ahead = cross(n, combine(1, to, -1, center));
  const from = combine(1, to, (-0.15 * Math.sign(angle)) / DIAL, ahead);
  return { arc: shown(drawn && { paths: [arc] }), head: shown(drawn && { from, to }), path };
}

// Each ring turns with its angle within the next.
const RINGS = { u: 0.67, v: 0.885, w: 1.1 };
// Each ring in its own pose, and the place on it that can be seen to be grabbed.
const FLAT = [(c, s) => [c, s, 0], (c, s) => [c, s, 0], (c, s) => [0, c, s]];
// Far from each other in most poses.
const GRABBED = [
  [1, 1, 0],
  [-1, 1, 0],
  [0, -1, -1],
];
const ROUND = spread(49).map((x) => [Math.cos(2 * Math.PI * x), Math.sin(2 * Math.PI * x)]);
const WHOLE = spread(73).map((x) => 360 * x - 180);
const BACK = [0.48, -0.74, 0.47];
const RIGHT = unit(cross(W, BACK));
const UP = cross(BACK, RIGHT);
const PLACE = scaled(2.6, RIGHT);
const SPOON = 0.58;
// The spoons on their way have two sizes: where they lie alike, one is seen.
const WAYS = [
  { name: "angles", text: "three angles", size: 0.9, aside: -0.5 },
  { name: "slerp", text: "one turn", size: 0.97, aside: 0.6 },
];
const PIECES = spread(33);
// With the middle ring at 90°, the axes of the others are one line.
const LOCKED = [0, 90, 0];
const STEP = 1e-4;
const SAME = 1e-9;

const pose = (angles) => matrixFromEulerAngles(...angles.map((angle) => angle / DEGREES));
/**
 * A spoon in the rings of its Euler angles, and two ways to its pose: who turns the spoon takes the
 * rings along, who sets them, the spoon.
 */
export function eulerAnglesByHand({ u, v, w, spoon, t }, { noWay }, changed) {
  const turned = changed.some((name) => name in RINGS);
  const led = changed.includes("spoon") && !turned;
  const angles = led ? nearestAngles(quaternionMatrix(spoon), [u, v, w]) : [u, v, w];
  const end = pose(angles);
  const found = quaternionFromMatrix(end);
  const q = dot(found, spoon) < 0 ? scaled(-1, found) : found;
  const ways = twoWays(angles);
  const { parts, labels, grips } = gimbals(angles);
  WAYS.forEach(({ name, text, size, aside }, k) => {
    const way = ways[k];
    labels[text] = combine(aside, RIGHT, -1.14, UP);
    parts[`${name} spoon`] = shown(way && { matrix: placing(way(t), ORIGIN, size) });
    parts[`${name} path`] = shown(way && { paths: [PIECES.map((x) => column(way(x), 0))] });
    parts[`${name} tip`] = shown(way && { at: column(way(t), 0) });
  });

  const [moreU, lessU, moreW] = [U, scaled(-1, U), W].map((x) => pose(combine(1, angles, 1, x)));
  const path = PIECES.map(ways[0]);
  const steps = path.slice(1).map((turn, i) => degreesBetween(path[i], turn));
  const [byAngles, slerp = null] = ways.map((way) =>
    PIECES.map((x) => degreesBetween(way(x - STEP), way(x + STEP)) / (2 * STEP)),
  );
  return {
    parts,
    labels,
    grips,
    inputs: led ? { u: angles[0], v: angles[1], w: angles[2] } : turned ? { spoon: q } : {},
    outputs: {
      rings: angles,
      by_angles: steps.reduce((sum, x) => sum + x),
      by_slerp: ways[1] ? DEGREES * axisAngle(end).angle : noWay,
      apart: Math.min(degreesBetween(moreU, moreW), degreesBetween(lessU, moreW)),
      matrix: end,
      q,
    },
    charts: { speeds: { "three angles": byAngles, "one turn": slerp } },
  };
}

/** A spoon in locked rings, tipped about the direction in which none of them turns. */
export function oneDegree({ tilt }) {
  const tipped = product(rotationMatrix(U, tilt / DEGREES), pose(LOCKED));
  const [u, v, w] = tilt ? eulerAngles(tipped).map((angle) => DEGREES * angle) : LOCKED;
  const { parts, labels } = gimbals([u, v, w]);
  return { parts, labels, grips: {}, outputs: { outer: w } };
}

/**
 * From the start to a pose by its three angles and by slerp, as functions of t; only the first if
 * the pose is half a turn away, where slerp has two shortest ways.
 */
function twoWays(angles) {
  const end = pose(angles);
  const byAngles = (t) => pose(scaled(t, angles));
  try {
    slerpRotations(IDENTITY, end, 0);
  } catch (error) {
    if (error instanceof DegenerateError) return [byAngles];
    throw error;
  }
  const { axis, angle } = axisAngle(end);
  return [byAngles, (t) => rotationMatrix(axis, t * angle)];
}

/** The Euler angles of a matrix nearest to given ones, in degrees, which stay if they fit. */
function nearestAngles(matrix, angles) {
  const off = pose(angles).flatMap((row, i) => combine(1, row, -1, matrix[i]));
  if (largest(off) < SAME) return angles;
  const [u, v, w] = eulerAngles(matrix).map((angle) => DEGREES * angle);
  const one = [u, v, w].map(remainder);
  const other = [u + 180, 180 - v, w + 180].map(remainder);
  const change = (triple) => largest(triple.map((angle, i) => remainder(angle - angles[i])));
  return change(one) <= change(other) ? one : other;
}

const largest = (changes) => Math.max(...changes.map(Math.abs));

/** The same angle between -180 and 180 degrees. */
const remainder = (angle) => angle - 360 * Math.round(angle / 360);

/** A spoon in three rings, each turning within the next, for Euler angles in degrees. */
function gimbals([u, v, w]) {
  const moved = (turn, point) => combine(1, PLACE, 1, transform(turn, point));
  const poses = [pose([u, v, w]), pose([0, v, w]), pose([0, 0, w])];
  const parts = { held: { matrix: placing(poses[0], PLACE, SPOON) } };
  const grips = { spoon: { at: PLACE, size: SPOON, holds: ["held"] } };
  const labels = {};
  Object.entries(RINGS).forEach(([name, radius], k) => {
    const body = ROUND.map((place) => moved(poses[k], scaled(radius, FLAT[k](...place))));
    const corner = scaled(radius / Math.SQRT2, GRABBED[k]);
    const at = (angle) => [u, v, w].map((x, i) => (i < k ? 0 : i === k ? angle : x));
    parts[`ring ${name}`] = { paths: [body] };
    const path = WHOLE.map((angle) => moved(pose(at(angle)), corner));
    grips[name] = { path, body, holds: [`ring ${name}`] };
  });
  const [V, U] = [column(poses[2], 1), column(poses[1], 0)];
  const seen = combine(1, U, -dot(U, BACK), BACK);
  // The name of U″ lies in the plane of the picture, outside the rings.
  const beside = scaled(1 / Math.max(length(seen), SHORT), seen);
  const axis = (name, axis, first, last, aside, direction = axis) => {
    const end = (sign) => [first, last].map((far) => combine(1, PLACE, sign * far, axis));
    parts[`axis ${name}`] = { paths: [end(1), end(-1)] };
    labels[name] = combine(1, combine(1, PLACE, 1.42, direction), aside, RIGHT);
  };
  axis("W", W, RINGS.w, 1.3, 0.1);
  axis("V", V, RINGS.v, RINGS.w + 0.15, 0);
  axis("U", U, RINGS.u, RINGS.v, -0.2, beside);
  return { parts, labels, grips };
}
