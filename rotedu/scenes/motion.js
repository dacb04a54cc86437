/* Model of page A. */
import {
  box,
  DEGREES,
  degreesBetween,
  IDENTITY,
  ORIGIN,
  placing,
  scaled,
  shown,
  spread,
  U,
  W,
} from "./parts.js";
import {
  combine,
  cross,
  dot,
  length,
  nearestRotation,
  product,
  quaternionMatrix,
  quaternionProduct,
  rotationMatrix,
  transform,
  transpose,
  turnBetween,
  unit,
} from "./rotations.js";

const SPEED = Math.PI / 2;
// Of the yaw and of the roll, in degrees.
const QUARTER = 90;
const ARROW = 0.85;
const EYE = [0.3, -0.88, 0.36];
const ACROSS = unit(cross(W, EYE));
const UPWARDS = unit(cross(EYE, ACROSS));
const ASLANT = 0.6;
const PLACES = [0, 2.72, 5.07].map((x) => scaled(x, ACROSS));
const BELOW = [0, 0, -1.5];
const PIECE = 0.025;
const ROUNDING = 1e-6;

/** A spoon that turns by two velocities, as three integrators see it: `spinning_by_hand`. */
export function spinningByHand(
  { space, body, h, t, repair },
  { seconds, edge: size, longest: edges, aside },
) {
  const times = scaled(seconds, spread(61));
  const tip = [size / 2, 0, 0];
  const [first, second] = [unit(space), unit(body)];
  const exact = (t) => product(rotationMatrix(first, SPEED * t), rotationMatrix(second, SPEED * t));
  const right = exact(t);
  const truth = times.map(exact);
  const turn = rotationMatrix(first, SPEED * t);

  const parts = {};
  const labels = {};
  for (const [name, axis, side] of [
    ["space", first, 1],
    ["body", transform(turn, second), -1],
  ]) {
    const end = scaled(ARROW, axis);
    parts[name] = { from: ORIGIN, to: end };
    labels[name] = beside(end, side);
  }
  const outputs = {};
  const charts = { longest: {}, off: {} };
  const ways = integrators(scaled(SPEED, first), scaled(SPEED, second), h, repair, seconds);
  Object.entries(ways).forEach(([name, way], i) => {
    const now = way(t);
    const tipAt = (moment) => combine(1, PLACES[i], 1, transform(way(moment), tip));
    labels[name] = combine(1, PLACES[i], 1, BELOW);
    parts[`exact, ${name}`] = box(right, PLACES[i], size);
    parts[`box, ${name}`] = box(now, PLACES[i], size);
    parts[name] = { matrix: placing(now, PLACES[i]) };
    parts[`way, ${name}`] = { paths: [moments(h, t).map(tipAt)] };
    // All but one matrix are a rotation times a number.
    const turnOf = (matrix) =>
      name === "Euler, matrix" && !repair
        ? nearestRotation(matrix)
        : matrix.map((row) => scaled(1 / longest(matrix), row));
    const off = (matrix, rotation) => degreesBetween(turnOf(matrix), rotation);
    const drawn = times.map(way);
    charts.longest[name] = drawn.map(longest);
    charts.off[name] = drawn.map((matrix, k) => off(matrix, truth[k]));
    outputs[name] = `${edges}${longest(now).toFixed(2)}, ${off(now, right).toFixed(0)}${aside}`;
  });
  const grips = { space: { holds: ["space"] }, body: { turn, holds: ["body"] } };
  return { parts, labels, grips, outputs, charts };
}

/** Where the name of an arrow is, clear of the ring around its tip. */
function beside(tip, side) {
  const angle = Math.atan2(dot(tip, UPWARDS), dot(tip, ACROSS)) + side * ASLANT;
  const aside = combine(0.42 * Math.cos(angle), ACROSS, 0.3 * Math.sin(angle), UPWARDS);
  return combine(1, tip, 1, aside);
}

const longest = (matrix) => Math.max(...transpose(matrix).map(length));

/**
 * What each method makes of the body at a time, as the matrix that draws it; what is left of a step at
 * the end is a shorter step.
 */
function integrators(omega, own, h, repair, seconds) {
  const steps = (step, start, drawn) => stepped(step, start, h, seconds, drawn);
  const turned = (vector, t) => rotationMatrix(vector, length(vector) * t);
  const exponential = (r, h) => product(product(turned(omega, h), r), turned(own, h));
  const matrix = (m, h) => {
    const left = transpose(transpose(m).map((column) => cross(omega, column)));
    const moved = m.map((row, i) => combine(1, row, h, combine(1, left[i], 1, cross(row, own))));
    return repair ? nearestRotation(moved) : moved;
  };
  const quaternion = (q, h) => {
    const left = quaternionProduct([0, ...omega], q);
    const right = quaternionProduct(q, [0, ...own]);
    const moved = combine(1, q, h / 2, combine(1, left, 1, right));
    return repair ? unit(moved) : moved;
  };
  return {
    exponential: steps(exponential, IDENTITY, (r) => r),
    "Euler, matrix": steps(matrix, IDENTITY, (m) => m),
    "Euler, quaternion": steps(quaternion, [1, 0, 0, 0], (q) =>
      quaternionMatrix(q).map((row) => scaled(dot(q, q), row)),
    ),
  };
}

/** The matrix that draws a body at a time, after whole steps and the rest of one. */
function stepped(step, start, h, seconds, drawn) {
  const states = [start];
  while (states.length <= seconds / h) states.push(step(states.at(-1), h));
  return (t) => {
    const whole = Math.min(Math.floor(t / h), states.length - 1);
    const rest = t - whole * h;
    return drawn(rest ? step(states[whole], rest) : states[whole]);
  };
}

/** A time divided into steps, and these into pieces that are short enough for a path. */
function moments(h, t) {
  const pieces = Math.ceil(h / PIECE);
  const whole = Math.max(1, Math.ceil((t * pieces) / h - ROUNDING));
  return [...Array.from({ length: whole }, (_, k) => (k * h) / pieces), Math.max(t, ROUNDING)];
}

/** A drone after a yaw and a roll, as it flies and as a log read in the wrong frame has it. */
export function theDrone({ time }) {
  const yaw = rotationMatrix(W, (QUARTER * Math.min(time, 1)) / DEGREES);
  const roll = rotationMatrix(U, (QUARTER * Math.max(time - 1, 0)) / DEGREES);
  const [flies, logged] = [product(yaw, roll), product(roll, yaw)];
  const nose = (turn) => scaled(1.1, transform(turn, U));
  const { angle } = turnBetween(flies, logged);
  const off = (place) => shown(time > 1 && place);
  return {
    parts: {
      drone: { matrix: placing(flies, ORIGIN) },
      nose: { from: ORIGIN, to: nose(flies) },
      logged: off({ matrix: placing(logged, ORIGIN) }),
      "logged nose": off({ from: ORIGIN, to: nose(logged) }),
    },
    labels: {},
    grips: {},
    outputs: { apart: DEGREES * angle },
  };
}
