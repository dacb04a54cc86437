/* Model of page B. */
import { DEGREES, ORIGIN, placing, scaled, shown } from "./parts.js";
import {
  combine,
  length,
  nearestRotation,
  quaternionMatrix,
  singularValues,
  transpose,
  turnBetween,
  unit,
} from "./rotations.js";

// Where the given orientations are turned, quite beside the ball, and where their names are.
const BESIDE = [
  [-2.13, 0, 0.36],
  [-1.42, 0, 0.36],
  [-1.77, 0, -0.28],
];
const NAMES = BESIDE.map((place, i) => combine(1, place, 1, [0, 0, i === 2 ? -0.43 : 0.43]));
const SIZE = 0.36;
// The mean by quaternions is a little smaller, so that both are seen where they are the same.
const NESTED = 0.95;
// A sum of quaternions that is shorter has no direction.
const SMALLEST = 1e-9;
// A mean that is no clearer is none: links keep five digits, and a hand keeps fewer.
const UNCLEAR = 1e-3;

/** The mean of three orientations by their matrices and by their quaternions. */
export function meanByHand({ poses, flip }, { no_mean }) {
  const q = poses.map(unit);
  if (flip) q[2] = q[2].map((x) => -x);
  const given = q.map(quaternionMatrix);
  const singular = singularValues(entrywise(given));
  const [, second, third] = singular;
  const means = {
    matrices: second + third > UNCLEAR ? nearestRotation(entrywise(given)) : null,
    quaternions: meanOfQuaternions(q),
  };

  const parts = {};
  const [first, another, last] = NAMES;
  const labels = {
    "+q_1": first,
    "+q_2": another,
    "+q_3": flip ? null : last,
    "-q_3": flip ? last : null,
  };
  given.forEach((turn, i) => {
    parts[`R_${i + 1}`] = { matrix: placing(turn, BESIDE[i], SIZE) };
    parts[`R_${i + 1} in the ball`] = { matrix: placing(turn, ORIGIN) };
    parts[`tip ${i + 1}`] = { at: tip(turn) };
  });
  const outputs = { singular };
  Object.entries(means).forEach(([name, turn], i) => {
    labels[name] = turn && [i ? 0.72 : -0.72, 0, -0.97];
    const size = i ? NESTED : 1;
    parts[name] = shown(turn && { matrix: placing(turn, ORIGIN, size) });
    parts[`tip by ${name}`] = shown(turn && { at: scaled(size, tip(turn)) });
    outputs[`by_${name}`] = turn ? given.map((one) => between(one, turn)) : no_mean;
  });
  const { matrices, quaternions } = means;
  outputs.apart = matrices && quaternions ? between(matrices, quaternions) : no_mean;
  const holds = ["R_1", "R_2", "R_3"];
  return { parts, labels, grips: { poses: { at: BESIDE, size: SIZE, holds } }, outputs };
}

const tip = (turn) => turn.map(([x]) => x);

/** The mean of matrices, entry by entry. */
const entrywise = (given) =>
  [0, 1, 2].map((i) => sum(given.map((matrix) => matrix[i])).map((x) => x / given.length));

/** The rotation of the sum of quaternions, whatever their signs, or null if it is zero. */
function meanOfQuaternions(q) {
  const total = sum(q);
  return length(total) < SMALLEST ? null : quaternionMatrix(total);
}

const sum = (rows) => transpose(rows).map((column) => column.reduce((a, b) => a + b));

/** The angle of the turn from one orientation to another, in degrees. */
const between = (a, b) => DEGREES * turnBetween(a, b).angle;
