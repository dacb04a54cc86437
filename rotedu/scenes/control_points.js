/* Models of page 5 II. */
import { arcs, DEGREES, joined, lamp, ORIGIN, scaled, shown, spread, turning, W } from "./parts.js";
import {
  angleBetween,
  arcAxis,
  combine,
  controlPoints,
  cross,
  deCasteljau,
  dot,
  double,
  rotate,
  slerp,
  unit,
} from "./rotations.js";

// Lengths of vectors and angles in radians that look equal.
const SAME = 1e-6;
// From a point to its label.
const NEAR = 0.17;
const FAR = 0.36;
// What lies behind the sphere, as it is seen at first, is named within the glass.
const INWARD = -0.2;
const EYE = [4.86, -0.2, 3];
// Clear of the name of a point beside it.
const BELOW = -0.3;
const SAMPLES = spread(25);

/** A curve from door to window that passes the clock in a direction to choose. */
export function arrowAtTheClock({ aim }, { targets, corner }) {
  const p = targets.map(unit);
  const [door, clock, window] = p;
  const { a, b } = controlPoints(p);
  // From the clock straight on, as far as the finished curve's control point is, then turned.
  const far = angleBetween(clock, a[1]);
  const ahead = rotate(clock, arcAxis(door, clock), far);
  const towards = (degrees) => rotate(ahead, clock, degrees / DEGREES);
  const tip = towards(aim);
  const dial = spread(13).map((t) => towards(corner * t));
  const curves = [
    [door, a[0], double(tip, clock), clock],
    [clock, tip, b[2], window],
  ];
  return {
    parts: {
      arcs: { paths: arcs([door, clock], [clock, window]) },
      curve: { paths: curves.map((four) => deCasteljau(four, spread(21))) },
      arrow: { from: scaled(1.01, clock), to: scaled(1.01, tip) },
      dial: { paths: [dial] },
      door: { at: door },
      clock: { at: clock },
      window: { at: window },
    },
    labels: {
      door: scaled(1.28, door),
      clock: combine(1.06, clock, -0.17, W),
      window: scaled(1.25, window),
    },
    grips: { aim: { path: dial, holds: ["arrow"] } },
    outputs: { bends: curves.map((four) => DEGREES * bendOf(four)) },
  };
}

/** How far a curve turns in all, to the left and to the right: at the corners of a polygon on it. */
function bendOf(control) {
  const points = deCasteljau(control, spread(401));
  const normals = points.slice(1).map((after, k) => cross(points[k], after));
  const turns = normals.slice(1).map((after, k) => angleBetween(normals[k], after));
  return turns.reduce((sum, turn) => sum + turn);
}

/** The four steps to the control points, with either misprint, and four tests of the result. */
export function controlPointsByHand(
  { points, step, printed_axis, printed_double, one_circle },
  { inks, notYet, steps, verdicts },
) {
  const [before, here, held] = points.map(unit);
  const axis = one_circle && arcAxis(before, here);
  const after = one_circle ? cross(arcAxis(axis, held), axis) : held;
  const reflected = slerp(before, here, 2);
  // About the reversed axis, half of the angle turns away from the next point.
  const half = printed_axis ? -0.5 : 0.5;
  const middle = slerp(reflected, after, half);
  const a = slerp(middle, here, 0.5);
  const doubled = printed_double ? [here, a] : [a, here];
  const b = slerp(...doubled, 2);
  const errors = errorsOf(here, after, reflected, middle, a, b);
  /** @param {number[]} test */
  const tested = ([made, error]) => (step < made ? notYet : lamp(error < SAME));
  const failed = Object.values(errors).filter(([, error]) => error >= SAME).length;
  const told = {
    // The ring stays on the point that it holds.
    inputs: one_circle ? { points: [before, here, after] } : {},
    grips: { points: { holds: ["$P_{i-1}$", "$P_i$", "$P_{i+1}$"] } },
    trails: step < 3 ? undefined : { "way of a": above(a), "way of P": above(after) },
    outputs: {
      now: steps[Math.ceil(step)],
      tests: step < 4 ? "" : verdicts[failed],
      to_jump: one_circle && step >= 1 ? 180 - DEGREES * angleBetween(reflected, after) : "",
      ...Object.fromEntries(Object.entries(errors).map(([name, test]) => [name, tested(test)])),
    },
  };
  const path = (k, ends, from, to) => {
    // What is not yet taken is whole, and hidden: a tube needs a length.
    const share = step > k ? Math.min(1, step - k) : 1;
    return SAMPLES.map((x) => slerp(...ends, from + share * x * (to - from)));
  };
  const wrong = [false, printed_axis, printed_axis, printed_axis || printed_double];
  const taken = (k, name, path, ink, others, distance) =>
    stepTaken(k, name, path, wrong[k] ? inks.wrong : ink, wrong[k], step <= k, others, distance);
  // With (5-13) as printed, b_i comes to the second auxiliary point and its name.
  const nameOfB = printed_double ? FAR : NEAR;
  return joined(
    given(before, here, after, axis, reflected, step),
    taken(0, "\\bar P_{i-1}", path(0, [before, here], 1, 2), inks.cross, []),
    taken(1, "\\bar P_i", path(1, [reflected, after], 0, half), inks.cross, [here, reflected]),
    taken(2, "a_i", path(2, [middle, here], 0, 0.5), inks.result, [here, after]),
    taken(3, "b_i", path(3, doubled, 0, 2), inks.result, [here, reflected], nameOfB),
    told,
  );
}

/** The three points, and where a_i jumps. */
function given(before, here, after, axis, reflected, step) {
  const opposite = scaled(-1, reflected);
  const jumps = axis && step >= 1;
  return {
    parts: {
      circle: shown(axis && { paths: [turning(before, axis, 2 * Math.PI, 96)] }),
      given: { paths: arcs([before, here], [here, after]) },
      "$P_{i-1}$": { at: before },
      $P_i$: { at: here },
      "$P_{i+1}$": { at: after },
      halved: { paths: arcs([reflected], [after]), hidden: step <= 1 },
      opposite: { at: opposite, hidden: !jumps },
    },
    labels: {
      "P_{i-1}": beside(before, [here]),
      P_i: beside(here, [before, after]),
      "P_{i+1}": beside(after, [here, reflected]),
      opposite: jumps ? combine(1, opposite, BELOW, W) : null,
    },
  };
}

/** The k-th step: its path, and the point to which it leads, with one name or another. */
function stepTaken(k, name, path, color, wrong, hidden, others, distance) {
  const at = path.at(-1);
  const place = hidden ? null : beside(at, others, distance);
  return {
    parts: {
      [`path ${k}`]: { paths: [path], color, hidden },
      [`$${name}$`]: { at, color, hidden },
    },
    labels: { [name]: wrong ? null : place, [`${name} spoiled`]: wrong ? place : null },
  };
}

/** By how much each test fails, after the step that makes it possible. */
function errorsOf(here, after, reflected, middle, a, b) {
  const [near, far] = [a, b].map((q) => angleBetween(here, q));
  const span = angleBetween(reflected, after);
  const halves = [angleBetween(reflected, middle), angleBetween(middle, after)];
  const turnsIn = cross(b, here);
  return {
    midway: [2, Math.max(...halves.map((x) => Math.abs(x - span / 2)))],
    on_circle: [4, Math.abs(dot(turnsIn, a))],
    equally_far: [4, Math.abs(near - far)],
    no_corner: [4, -dot(turnsIn, cross(here, a))],
  };
}

/** Where a way is seen over the arcs. */
const above = (point) => scaled(1.05, point);

/** The place of a label: next to a point of the sphere, away from others; on its far side, within. */
function beside(point, others, distance = NEAR) {
  const sum = others.reduce((away, q) => combine(1, away, -1, q), ORIGIN);
  const reach = dot(point, EYE) < 0 ? INWARD : distance;
  return combine(1, point, reach, unit(combine(0.3 + others.length, point, 1, sum)));
}
