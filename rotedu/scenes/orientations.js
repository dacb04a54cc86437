/**
 * Models of page 5 IV.
 * @import { Point } from "./rotations.js"
 */
import { DEGREES, placing, scaled, spread, turning, U, V, W } from "./parts.js";
import {
  angleBetween,
  arcAxis,
  combine,
  cross,
  deCasteljau,
  dot,
  rotationMatrix,
  slerp,
  transform,
  unit,
} from "./rotations.js";

// Arrows that are left on the way.
const STATIONS = 9;
const SIZE = 0.33;
// How much larger a clock is in a picture.
const CLOSE = 2.6;
// In so many steps the arrow sweeps its ribbon.
const STEPS = 60;
const LEAST = 0.001;

/** What two cameras see that look at the same clock, the second rolled about its line of sight. */
export function twoPictures({ roll }, { pictures, cameras }) {
  const parts = {};
  const [first, second] = cameras.map((camera) => combine(1, camera, 0.52, V));
  [0, roll].forEach((degrees, i) => {
    const turned = (sign) => rotationMatrix(U, (sign * degrees) / DEGREES);
    parts[`clock ${i}`] = { matrix: placing(turned(-1), pictures[i], CLOSE) };
    parts[`camera ${i}`] = { matrix: placing(turned(1), cameras[i]) };
    const above = (height) => combine(1, cameras[i], height, transform(turned(1), W));
    parts[`up ${i}`] = { from: above(0.16), to: above(0.42) };
  });
  const around = Math.abs(roll);
  return { parts, labels: { first, second }, outputs: { between: Math.min(around, 360 - around) } };
}

/** An arrow carried around a triangle by the rotations of its sides. */
export function carriedAroundByHand({ corners, t }, { just_inside }) {
  const p = corners.map(unit);
  const after = [p[1], p[2], p[0]];
  const carried = arrowAround(p, after);
  const [start, ahead] = carried(0);
  const [, back] = carried(1);
  const twist = Math.atan2(dot(start, cross(ahead, back)), dot(ahead, back));
  const nearness = 1 + p.reduce((sum, point, i) => sum + dot(point, after[i]), 0);
  const area = 2 * Math.atan2(dot(p[0], cross(p[1], p[2])), nearness);

  const sides = p.map((point, i) => deCasteljau([point, after[i]], spread(25)));
  const roundOnce = spread(STEPS + 1);
  const soFar = roundOnce.map((x) => carried(Math.max(t, LEAST) * x));
  const tails = soFar.map(([at]) => at);
  const rim = turning(scaled(0.7 * SIZE, ahead), start, twist, 48);
  const parts = {
    inside: { points: triangle(p).map((point) => scaled(just_inside, point)) },
    sides: { paths: sides },
    way: { paths: [tails] },
    swept: { points: [...tails, ...soFar.map((here) => head(here))] },
    arrow: arrow(carried(t)),
    sector: { points: [start, ...rim.map((x) => combine(1, start, 1, x))], hidden: t !== 1 },
  };
  for (let k = 0; k < STATIONS; k++) {
    // The first is longer, so that the arrow does not hide it.
    const size = k ? SIZE : 1.4 * SIZE;
    parts[`station ${k}`] = { ...arrow(carried(k / STATIONS), size), hidden: k > t * STATIONS };
  }
  // Beyond the tips of both arrows, and outside the sphere when they are seen edge on.
  const labels = { twist: t === 1 ? combine(1.12, start, 2.6, rim[24]) : null };
  p.forEach((point, i) => {
    const others = combine(1, p[(i + 1) % 3], 1, p[(i + 2) % 3]);
    parts["ABC"[i]] = { at: point };
    labels["ABC"[i]] = combine(1, point, 0.18, unit(combine(2, point, -1, others)));
  });
  return {
    parts,
    labels,
    // The arrow is grabbed by its tip, away from the rings of the corners.
    grips: {
      t: { path: roundOnce.map((x) => head(carried(x))), holds: ["arrow"] },
      corners: { holds: ["A", "B", "C"] },
    },
    outputs: {
      // Nobody knows it before the arrow is back.
      twist: t === 1 ? DEGREES * twist : "",
      area: DEGREES * area,
      difference: t === 1 ? DEGREES * (area - twist) : "",
    },
  };
}

/** Where an arrow begins that is carried around a triangle, and its direction, at a time. */
function arrowAround(p, after) {
  const axes = p.map((point, i) => arcAxis(point, after[i]));
  const angles = p.map((point, i) => angleBetween(point, after[i]));
  const start = [p[0], cross(axes[0], p[0])];
  return (t) => {
    const turns = axes.map((axis, i) =>
      rotationMatrix(axis, angles[i] * Math.min(1, Math.max(0, 3 * t - i))),
    );
    return start.map((vector) => turns.reduce((v, turn) => transform(turn, v), vector));
  };
}

const head = (here, size = SIZE) => combine(1, here[0], size, here[1]);

const arrow = (here, size) => ({ from: here[0], to: head(here, size) });

/**
 * Points of a triangle of the sphere, on arcs from its first corner to the opposite side.
 * @param {Point[]} corners
 */
function triangle([p, q, r]) {
  const s = spread(13);
  return s.flatMap((u) => deCasteljau([p, slerp(q, r, u)], s));
}
