/* Model of page 5 II. */
import { arcs, DEGREES, lamp, ORIGIN, spread, turning } from "./parts.js";
import { angleBetween, arcAxis, combine, cross, dot, slerp, unit } from "./rotations.js";

// Lengths of vectors and angles in radians that look equal.
const SAME = 1e-6;
// From a point to its label.
const NEAR = 0.17;
const FAR = 0.36;
// What lies behind the sphere is named within the glass.
const INWARD = -0.2;
const SAMPLES = spread(25);

/** The four steps to the control points, with either misprint, and four tests of the result. */
export function controlPointsByHand(
  { points, step, printed_axis, printed_double, one_circle },
  { inks, notYet, steps, verdicts },
) {
  const [before, here, held] = points.map(unit);
  const axis = one_circle && arcAxis(before, here);
  const after = one_circle ? cross(arcAxis(axis, held), axis) : held;
  const path = (k, [p, q], from, to) => {
    // What is not yet taken is hidden, and whole: a tube needs a length.
    const share = step > k ? Math.min(1, step - k) : 1;
    return SAMPLES.map((t) => slerp(p, q, from + share * t * (to - from)));
  };
  const reflected = slerp(before, here, 2);
  // About the reversed axis, half of the angle turns away from the next point.
  const half = printed_axis ? -0.5 : 0.5;
  const middle = slerp(reflected, after, half);
  const a = slerp(middle, here, 0.5);
  const doubled = printed_double ? [here, a] : [a, here];
  const b = slerp(...doubled, 2);
  const opposite = combine(-1, reflected, 0, ORIGIN);

  const parts = {
    circle: one_circle
      ? { paths: [turning(before, axis, 2 * Math.PI, 96)], hidden: false }
      : { hidden: true },
    given: { paths: arcs([before, here], [here, after]) },
    "$P_{i-1}$": { at: before },
    $P_i$: { at: here },
    "$P_{i+1}$": { at: after },
    halved: { paths: arcs([reflected], [after]), hidden: step <= 1 },
    opposite: { at: opposite, hidden: step < 1 },
  };
  const labels = {
    "P_{i-1}": beside(before, [here]),
    P_i: beside(here, [before, after]),
    "P_{i+1}": beside(after, [here, reflected]),
    opposite: step < 1 ? null : beside(opposite, [], INWARD),
  };
  // With (5-13) as printed, b_i comes to the second auxiliary point and its name.
  const last = printed_double ? FAR : NEAR;
  const bWrong = printed_axis || printed_double;
  const ways = [
    ["\\bar P_{i-1}", [[before, here], 1, 2], inks.cross, false, [], INWARD],
    ["\\bar P_i", [[reflected, after], 0, half], inks.cross, printed_axis, [here, reflected], NEAR],
    ["a_i", [[middle, here], 0, 0.5], inks.result, printed_axis, [here, after], NEAR],
    ["b_i", [doubled, 0, 2], inks.result, bWrong, [here, reflected], last],
  ];
  ways.forEach(([name, ends, ink, wrong, others, distance], k) => {
    const way = path(k, ...ends);
    const [at, color, hidden] = [way.at(-1), wrong ? inks.wrong : ink, step <= k];
    parts[`path ${k}`] = { paths: [way], color, hidden };
    parts[`$${name}$`] = { at, color, hidden };
    const place = hidden ? null : beside(at, others, distance);
    labels[name] = wrong ? null : place;
    labels[`${name} spoiled`] = wrong ? place : null;
  });

  const [near, far] = [a, b].map((q) => angleBetween(here, q));
  const span = angleBetween(reflected, after);
  const halves = [angleBetween(reflected, middle), angleBetween(middle, after)];
  const turnsIn = cross(b, here);
  const errors = {
    midway: [2, Math.max(...halves.map((x) => Math.abs(x - span / 2)))],
    on_circle: [4, Math.abs(dot(turnsIn, a))],
    equally_far: [4, Math.abs(near - far)],
    no_corner: [4, -dot(turnsIn, cross(here, a))],
  };
  const tested = ([made, error]) => (step < made ? notYet : lamp(error < SAME));
  const failed = Object.values(errors).filter(([, error]) => error >= SAME).length;
  return {
    // The ring stays on the point that it holds.
    inputs: one_circle ? { points: [before, here, after] } : {},
    parts,
    labels,
    trails: { "way of a": step < 3 ? null : above(a), "way of P": above(after) },
    outputs: {
      now: steps[Math.ceil(step)],
      tests: step < 4 ? "" : verdicts[failed],
      to_jump: one_circle && step >= 1 ? 180 - DEGREES * span : "",
      ...Object.fromEntries(Object.entries(errors).map(([name, test]) => [name, tested(test)])),
    },
  };
}

/** Where a way is seen over the arcs. */
const above = (point) => combine(1.05, point, 0, ORIGIN);

/** The place of a label: next to a point of the sphere, away from others. */
function beside(point, others, distance = NEAR) {
  const sum = others.reduce((away, q) => combine(1, away, -1, q), ORIGIN);
  return combine(1, point, distance, unit(combine(0.3 + others.length, point, 1, sum)));
}
