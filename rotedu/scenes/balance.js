/* Models of Chapters 3 and 6: a balance that weighs what a computation costs. */
import { columns, IDENTITY, shown, spread, U, V, W } from "./parts.js";
import { combine, rotate } from "./rotations.js";

const TURN_POINTS = "turn points by one turn";
// How far the beam would tilt, in radians, with all weight on one side.
const STEEPEST = 1.1;
const FULCRUM = [0, 0, 0.95];
const POINTER = [0, 0, 0.28];
// Where the strings of a pan meet its rim.
const RIM = [0.5, 2.6, 4.7].map((angle) => combine(0.53, rotate(U, W, angle), 0.06, W));

/** What it takes to turn points, in the pans of a balance. */
export const theBalance = ({ decades }, constants) => weighed(TURN_POINTS, decades, constants);

/** What one of several works takes, in the pans of a balance. */
export const theBalanceOfWorks = ({ work, decades }, constants) =>
  weighed(work, decades, constants);

function weighed(work, decades, { works, most, ruler, size }) {
  const cost = (ways, n) => Math.min(...ways.map(([once, each]) => once + each * n));
  const costs = (n) => ["matrix", "quaternion"].map((name) => cost(works[work][name], n));
  const number = Math.round(10 ** decades);
  const [left, right] = costs(number);
  // How many operations a spoon stands for.
  const spoon = 10 ** Math.max(0, Math.ceil(Math.log10(Math.max(left, right) / most)));
  const counts = [left, right].map((operations) => Math.round(operations / spoon));
  const tilt = (STEEPEST * (right - left)) / (right + left);

  const matrixIsHeavier = (n) => costs(n)[0] > costs(n)[1];
  const crossed = matrixIsHeavier(1) && !matrixIsHeavier(number);
  const [low, high, floor] = ruler;
  const onRuler = (log) => [low + (log / 4) * (high - low), 0, floor];
  const level = onRuler(Math.log10(1.5));
  const { parts, labels } = hung(tilt, counts, size);
  return {
    parts: { ...parts, level: shown(crossed && { paths: [[level, combine(1, level, 0.16, W)]] }) },
    labels: { ...labels, level: crossed ? combine(1, level, 0.26, W) : null },
    grips: { decades: { path: spread(41).map((t) => onRuler(4 * t)), holds: ["left", "right"] } },
    outputs: { number, matrix: left, quaternion: right, spoon },
  };
}

/** Hang two pans with so many spoons on a beam that tilts. */
function hung(tilt, counts, [beam, depth]) {
  const ends = [-beam, beam].map((x) => combine(1, FULCRUM, x, rotate(U, V, tilt)));
  const pans = ends.map((end) => combine(1, end, -depth, W));
  const strings = pans.flatMap((pan, k) =>
    RIM.map((point) => [ends[k], combine(1, pan, 1, point)]),
  );
  const [left, right] = pans.map((pan) => columns(IDENTITY, pan));
  const [underLeft, underRight] = pans.map((pan) => combine(1, pan, -0.2, W));
  return {
    parts: {
      beam: { paths: [ends] },
      pointer: { paths: [[FULCRUM, combine(1, FULCRUM, 1, rotate(POINTER, V, tilt))]] },
      strings: { paths: strings },
      "pan left": { matrix: left },
      "pan right": { matrix: right },
      left: { matrix: left, count: counts[0] },
      right: { matrix: right, count: counts[1] },
    },
    labels: { left: underLeft, right: underRight },
  };
}
