/* Models of `rotedu.scenes.closed_curve`. */
import {
  closedCurve as curveThrough,
  combine,
  controlPoints,
  cross,
  deCasteljauLevels,
  dot,
  length,
  unit,
} from "../src/sphere.js";
import { DEGREES, ORIGIN, arcs, motion, spread } from "./common.js";

const MOST = 8;
const NAMED = 5;
const SAMPLES = 25;

/** `closed_curve_by_hand` */
export function closedCurve({ points, u, fraction }) {
  const p = points.map(unit);
  const n = p.length;
  const { a, b } = controlPoints(p, fraction);
  const control = p.map((point, i) => [point, a[i], b[(i + 1) % n], p[(i + 1) % n]]);
  const segment = Math.min(Math.floor(u * n), n - 1);
  const within = u * n - segment;
  const levels = deCasteljauLevels(control[segment], within);
  const curve = curveThrough(p, 40, fraction);

  const polygon = p.flatMap((point, i) => [b[i], point, a[i]]);
  const [, first, second, [here]] = levels;
  const parts = {
    curve: { paths: [[...curve, curve[0]]] },
    handles: { paths: arcs([...b, ...p], [...p, ...a]) },
    polygon: { paths: arcs(a, control.map((four) => four[2])) },
    levels: { paths: arcs([first[0], first[1], second[0]], [first[1], first[2], second[1]]) },
    "Q 1 1": { at: first[0] },
    "Q 1 2": { at: first[1] },
    "Q 1 3": { at: first[2] },
    "Q 2 2": { at: second[0] },
    "Q 2 3": { at: second[1] },
    C: { at: here },
  };
  const labels = {};
  const middle = polygon.reduce((sum, q) => combine(1, sum, 1 / polygon.length, q), ORIGIN);
  for (let i = 0; i < 3 * MOST; i++) {
    const name = `${"bPa"[i % 3]}_${Math.floor(i / 3)}`;
    const point = polygon[i];
    parts[name] = point ? { at: point, hidden: false } : { hidden: true };
    labels[name] = point && (i % 3 === 1 || n <= NAMED) ? beside(polygon, i, middle) : null;
  }

  const t = spread(SAMPLES);
  const motions = control.map((four) => t.map((x) => motion(four, x)));
  const ends = motions.map((leaving, i) => [motions.at(i - 1).at(-1), leaving[0]]);
  const now = motion(control[segment], within);
  const jumps = ends.map(([v, w]) => length(combine(1, w.velocity, -1, v.velocity)));
  const bends = ends.map(([v, w]) => Math.abs(w.curvature - v.curvature));
  return {
    parts,
    labels,
    outputs: {
      speed: DEGREES * length(now.velocity),
      curvature: now.curvature,
      velocity_jump: DEGREES * Math.max(...jumps),
      curvature_jump: Math.max(...bends),
      curvature_jumps: bends,
    },
    charts: {
      speeds: { curve: motions.map((row) => row.map(({ velocity }) => DEGREES * length(velocity))) },
      curvatures: { curve: motions.map((row) => row.map(({ curvature }) => curvature)) },
    },
  };
}

/** The place of a label, beside a corner of the polygon. */
function beside(polygon, i, middle) {
  const count = polygon.length;
  const [before, after] = [polygon.at(i - 1), polygon[(i + 1) % count]];
  const outwards = polygon[i].map(
    (x, k) => 0.35 * (x - middle[k]) + x - (before[k] + after[k]) / 2,
  );
  const sideways = unit(cross(polygon[i], combine(1, after, -1, before)));
  return combine(1.1, polygon[i], dot(sideways, outwards) < 0 ? -0.16 : 0.16, sideways);
}
