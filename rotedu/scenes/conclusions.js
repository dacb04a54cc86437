/**
 * Model of Chapter 6.
 * @import { Matrix, Quaternion } from "./rotations.js"
 */
import { box, DEGREES, IDENTITY, placing, scaled, spread, W } from "./parts.js";
import {
  axisAngle,
  combine,
  conjugate,
  length,
  nearestRotation,
  product,
  quaternionMatrix,
  quaternionProduct,
  rotate,
  rotationMatrix,
  transpose,
  unit,
} from "./rotations.js";

// A chart shows every tenth number of turns, and nothing below 1e-8 degrees.
const EVERY = 10;
const FLOOR = 1e-8;
const ACROSS = scaled(0.96, [0.93, 0.36, 0]);
const BELOW = [0, 0, -0.95];
// Towards the viewer.
const AXLE = [0.36, -0.93, 0];
// What is left of a number after every turn.
const ROUNDED = {
  // Ties, which could go either way, do not occur.
  "2 decimals": (x) => Math.round(100 * x) / 100,
  "3 decimals": (x) => Math.round(1000 * x) / 1000,
  "16 bits": to16Bits,
  "32 bits": Math.fround,
};
const known = new Map();

/** A number with the eleven significant bits of 16-bit numbers, fewer near zero. */
function to16Bits(x) {
  const [, high] = new Uint32Array(new Float64Array([x]).buffer);
  const exponent = ((high >>> 20) & 2047) - 1023;
  const step = 2 ** (Math.max(exponent, -14) - 10);
  return Math.round(x / step) * step;
}

/** Unit quaternions whose directions are evenly spread. */
function* randomTurns(count) {
  let seed = 3;
  const thrown = () => {
    seed = (Math.imul(1664525, seed) + 1013904223) >>> 0;
    return seed / 2 ** 31 - 1;
  };
  for (let found = 0; found < count; ) {
    const q = [0, 0, 0, 0].map(thrown);
    const square = length(q) ** 2;
    if (square <= 0.01 || square > 1) continue;
    found++;
    yield unit(q);
  }
}

/**
 * Turns multiplied as matrices and as quaternions, every number rounded after every turn: what
 * there is after 0, 1, ... turns and one turn more, which leads back to the start.
 */
function chains(precision, most) {
  if (!known.has(precision)) {
    const round = ROUNDED[precision];
    const rounded = (rows) => rows.map((row) => row.map(round));
    let exact = [1, 0, 0, 0];
    let matrix = IDENTITY;
    let kept = exact;
    /** @type {{matrix: Matrix[], quaternion: Quaternion[]}} */
    const worn = { matrix: [], quaternion: [] };
    for (const turn of [...randomTurns(most), exact]) {
      const back = conjugate(exact);
      worn.matrix.push(rounded(product(quaternionMatrix(back), matrix)));
      worn.quaternion.push(quaternionProduct(back, kept).map(round));
      exact = quaternionProduct(turn, exact);
      matrix = rounded(product(quaternionMatrix(turn), matrix));
      kept = quaternionProduct(turn, kept).map(round);
    }
    const near = (k) => [nearestRotation(worn.matrix[k]), quaternionMatrix(worn.quaternion[k])];
    const off = (k) => near(k).map((rotation) => DEGREES * axisAngle(rotation).angle);
    // Only repaired products have curves.
    let sampled;
    const curves = () =>
      (sampled ??= transpose(worn.matrix.flatMap((_, k) => (k % EVERY ? [] : [off(k)]))));
    known.set(precision, { ...worn, near, off, curves });
  }
  return known.get(precision);
}

/** A number with two digits, however small it is. A tie goes up, whatever its last bits are. */
function twoDigits(value) {
  const digits = value > FLOOR ? Math.max(0, 1 - Math.floor(Math.log10(value))) : 0;
  return (value + 10 ** -(digits + 6)).toFixed(digits);
}

/** What becomes of a matrix if it differs so many times as much from the identity. */
function underMagnifier(matrix, times, repaired) {
  if (times === 1) return matrix;
  if (!repaired) return matrix.map((row, i) => combine(1 - times, IDENTITY[i], times, row));
  const { axis, angle } = axisAngle(matrix);
  return rotationMatrix(axis, times * angle);
}

/** What rounding does to a product of matrices and to a product of quaternions. */
export function wornSpoonsByHand({ turns, precision, repair, magnified }, constants) {
  const { most, crank, magnifiers, degree, in_length } = constants;
  const worn = chains(precision, most);
  const times = magnified ? magnifiers[precision] : 1;
  const k = Math.round(turns);
  const q = worn.quaternion[k];
  const square = length(q) ** 2;
  const unrepaired = [worn.matrix[k], quaternionMatrix(q).map((row) => scaled(square, row))];
  const rotations = repair ? worn.near(k) : unrepaired;
  const off = worn.off(k);
  const wheel = rotationMatrix(AXLE, (-2 * Math.PI * crank.laps * turns) / most);
  const state = {
    parts: { crank: { matrix: placing(wheel, crank.place) } },
    labels: {},
    outputs: { times },
    charts: { off: {} },
    grips: { turns: { path: roundAndRound(crank), laps: crank.laps, holds: ["crank"] } },
  };
  ["matrix", "quaternion"].forEach((name, i) => {
    const rotation = rotations[i];
    const place = scaled(i ? 1 : -1, ACROSS);
    for (const [part, matrix] of [
      [`${name} at the start`, IDENTITY],
      [name, underMagnifier(rotation, times, repair)],
    ]) {
      state.parts[`box, ${part}`] = box(matrix, place);
      state.parts[part] = { matrix: placing(matrix, place) };
    }
    state.labels[name] = combine(1, place, 1, BELOW);
    const edges = transpose(rotation).map(length);
    const bent = twoDigits(100 * Math.max(...edges.map((x) => Math.abs(x - 1))));
    state.outputs[`${name}_off`] = repair ? twoDigits(off[i]) + degree : bent + in_length;
    state.outputs[`${name}_edges`] = edges;
    const heights = (angles) => angles.map((angle) => Math.log10(Math.max(angle, FLOOR)));
    state.charts.off[name] = repair ? heights(worn.curves()[i]) : null;
  });
  return state;
}

/** The way of the crank's knob, clockwise as seen from the front: each lap a little wider. */
const roundAndRound = ({ place, radius, laps }) =>
  spread(24 * laps + 1).map((t) =>
    combine(1, place, radius * (1 + 0.01 * t), rotate(W, AXLE, -2 * Math.PI * laps * t)),
  );
