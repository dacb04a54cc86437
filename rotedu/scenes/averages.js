/* Model of `rotedu.scenes.averages`. */
import { DEGREES, ORIGIN, placing } from "./parts.js";
import {
  axisAngle,
  combine,
  length,
  nearestRotation,
  product,
  quaternionMatrix,
  singularValues,
  transpose,
  unit,
} from "./rotations.js";

const BESIDE = [[-2.13, 0, 0.36], [-1.42, 0, 0.36], [-1.77, 0, -0.28]];
const NAME = combine(1, BESIDE[2], 1, [0, 0, -0.43]);
const SIZE = 0.36;
const SMALLEST = 1e-9;
const UNCLEAR = 1e-3;

/** `mean_by_hand` */
export function mean({ poses, flip }, { no_mean }) {
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
  const labels = { q_3: flip ? null : NAME, "-q_3": flip ? NAME : null };
  given.forEach((turn, i) => {
    parts[`R_${i + 1}`] = { matrix: spoon(turn, BESIDE[i], SIZE) };
    parts[`R_${i + 1} in the ball`] = { matrix: spoon(turn, ORIGIN, 1) };
    parts[`tip ${i + 1}`] = { at: tip(turn) };
  });
  const outputs = { singular };
  for (const [name, turn] of Object.entries(means)) {
    const hidden = !turn;
    parts[name] = hidden ? { hidden } : { matrix: spoon(turn, ORIGIN, 1), hidden };
    parts[`tip by ${name}`] = hidden ? { hidden } : { at: tip(turn), hidden };
    outputs[`by_${name}`] = hidden ? no_mean : given.map((one) => between(one, turn));
  }
  const { matrices, quaternions } = means;
  outputs.apart = matrices && quaternions ? between(matrices, quaternions) : no_mean;
  return { parts, labels, outputs };
}

const tip = (turn) => turn.map(([x]) => x);

/** The sixteen numbers, by columns, that turn and shrink a spoon about its place. */
const spoon = (turn, place, size) => placing(turn.map((row) => row.map((x) => size * x)), place);

/** The mean of matrices, entry by entry. */
function entrywise(given) {
  const entries = sum(given.map((matrix) => matrix.flat())).map((x) => x / given.length);
  return [entries.slice(0, 3), entries.slice(3, 6), entries.slice(6)];
}

/** `mean_of_quaternions` */
function meanOfQuaternions(q) {
  const total = sum(q);
  return length(total) < SMALLEST ? null : quaternionMatrix(total);
}

const sum = (rows) => transpose(rows).map((column) => column.reduce((a, b) => a + b));

/** `rotedu.averages.angular_distance`, in degrees. */
const between = (a, b) => DEGREES * axisAngle(product(transpose(a), b)).angle;
