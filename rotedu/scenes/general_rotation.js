/* Models of `rotedu.scenes.general_rotation`. */
import { DEGREES, spread } from "./parts.js";
import {
  DegenerateError,
  axisAngle,
  combine,
  cross,
  dot,
  eulerAngles as anglesOf,
  length,
  matrixFromEulerAngles,
  product,
  quaternionFromMatrix,
  quaternionMatrix,
  rotationMatrix,
  slerpRotations,
  transpose,
  unit,
} from "./sphere.js";

const SPOON = 0.8;
const STEP = 1e-4;
const IDENTITY = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
const NAMES = ["angles", "slerp", "nlerp"];
const PIECES = spread(33);
const BACK = [0.48, -0.74, 0.47];
const RIGHT = unit(cross([0, 0, 1], BACK));
const UP = cross(BACK, RIGHT);
const SHORT = 0.05;
const PLACES = [
  combine(-0.05, UP, 1.3, RIGHT),
  combine(1.13, UP, -1.75, RIGHT),
  combine(-0.87, UP, -1.75, RIGHT),
];

const pose = (angles) => matrixFromEulerAngles(...angles.map((angle) => angle / DEGREES));
const column = (matrix, k) => matrix.map((row) => row[k]);
const scaled = (factor, v) => combine(factor, v, 0, v);

/** The ways to a pose, as functions of t: `three_ways`, only the first if the pose is half a turn away. */
function threeWays(angles) {
  const end = pose(angles);
  const byAngles = (t) => pose(scaled(t, angles));
  try {
    slerpRotations(IDENTITY, end, 0);
  } catch (error) {
    if (error instanceof DegenerateError) return [byAngles];
    throw error;
  }
  const { axis, angle } = axisAngle(end);
  const q = quaternionFromMatrix(end);
  return [
    byAngles,
    (t) => rotationMatrix(axis, t * angle),
    (t) => quaternionMatrix(combine(1 - t, [1, 0, 0, 0], t, q)),
  ];
}

/** The angle between orientations that are close together. */
function degreesBetween(before, after) {
  const change = before.flatMap((row, i) => combine(1, row, -1, after[i]));
  return 2 * DEGREES * Math.asin(length(change) / Math.sqrt(8));
}

/** The Euler angles of a matrix that are nearest to given ones, in degrees. */
function nearestAngles(matrix, angles) {
  const [u, v, w] = anglesOf(matrix).map((angle) => DEGREES * angle);
  const [one, other] = [[u, v, w], [u + 180, 180 - v, w + 180]].map((triple) =>
    triple.map((angle, i) => remainder(angle - angles[i])),
  );
  const nearest = largest(one) <= largest(other) ? one : other;
  return combine(1, angles, 1, nearest);
}

const largest = (changes) => Math.max(...changes.map(Math.abs));

/** The same angle between -180 and 180 degrees. */
const remainder = (angle) => angle - 360 * Math.round(angle / 360);

/** A matrix of 4x4 by columns, from a 3x3 matrix and a place. */
function placed(matrix, place) {
  const columns = transpose(matrix).map((v) => [...v, 0]);
  return [...columns.flat(), ...place, 1];
}

/** `rotedu.scenes.general_rotation.add_gimbals` */
function gimbals(angles, place) {
  const axes = { W: [0, 0, 1], V: column(pose([0, 0, angles[2]]), 1), U: column(pose(angles), 0) };
  const { W, V, U } = axes;
  const ring = (side) => ({ matrix: placed(transpose([V, side, cross(V, side)]), place) });
  const parts = { "outer ring": ring(W), "inner ring": ring(U) };
  const labels = {};
  const seen = combine(1, U, -dot(U, BACK), BACK);
  const beside = scaled(1 / Math.max(length(seen), SHORT), seen);
  for (const [name, first, last, direction, aside] of [
    ["W", 1.1, 1.36, W, 0.1],
    ["V", 0.92, 1.31, V, 0],
    ["U", 0.8, 0.92, beside, -0.2],
  ]) {
    const axis = axes[name];
    const paths = [1, -1].map((sign) =>
      [first, last].map((far) => combine(1, place, sign * far, axis)),
    );
    parts[`axis ${name}`] = { paths };
    labels[name] = combine(1, combine(1, place, 1.48, direction), aside, RIGHT);
  }
  return { parts, labels };
}

/** `euler_angles_by_hand` */
export function eulerAngles({ u, v, w, tilt, t }, { noWay }) {
  const set = [u, v, w];
  const level = pose(set);
  const sideways = column(pose([0, 0, w]), 0);
  const tilted = product(rotationMatrix(sideways, tilt / DEGREES), level);
  // What was not tilted keeps its angles, also where others lead to the same pose.
  const angles = tilt ? nearestAngles(tilted, set) : set;
  const now = scaled(t, angles);
  const ways = threeWays(angles);
  const here = ways.map((way) => way(t));
  const { parts, labels } = gimbals(now, PLACES[0]);
  NAMES.forEach((name, k) => {
    const three = [`${name} spoon`, `${name} path`, `${name} tip`];
    for (const part of three) parts[part] = { hidden: !ways[k] };
    if (!ways[k]) return;
    const tip = (turn) => combine(1, PLACES[k], SPOON, column(turn, 0));
    const [spoon, path, point] = three.map((part) => parts[part]);
    spoon.matrix = placed(here[k].map((row) => scaled(SPOON, row)), PLACES[k]);
    path.paths = [PIECES.map((x) => tip(ways[k](x)))];
    point.at = tip(here[k]);
  });

  const [moreU, lessU, moreW] = [[1, 0, 0], [-1, 0, 0], [0, 0, 1]].map((change) =>
    pose(combine(1, now, 1, change)),
  );
  const path = PIECES.map((x) => ways[0](t * x));
  const turned = path.slice(1).map((turn, i) => degreesBetween(path[i], turn));
  const [byAngles, slerp = null, nlerp = null] = ways.map((way) =>
    PIECES.map((x) => degreesBetween(way(x - STEP), way(x + STEP)) / (2 * STEP)),
  );
  return {
    parts,
    labels,
    outputs: {
      apart: Math.min(degreesBetween(moreU, moreW), degreesBetween(lessU, moreW)),
      rings: angles,
      ring_change: largest(combine(1, angles, -1, set)),
      entry_change: largest(tilted.flatMap((row, i) => combine(1, row, -1, level[i]))),
      by_angles: turned.reduce((sum, x) => sum + x),
      by_slerp: here[1] ? DEGREES * axisAngle(here[1]).angle : noWay,
      matrix: here[0],
    },
    charts: {
      speeds: { "three angles": byAngles, "one turn": slerp, "one turn, uneven": nlerp },
    },
  };
}
