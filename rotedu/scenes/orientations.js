/* Models of `rotedu.scenes.orientations`. */
import { DEGREES, spread, turning } from "./parts.js";
import {
  angleBetween,
  arcAxis,
  combine,
  cross,
  dot,
  rotationMatrix,
  slerp,
  transform,
  unit,
} from "./sphere.js";

const STATIONS = 9;
const SIZE = 0.33;
const STEPS = 60;
const LEAST = 0.001;
const JUST_INSIDE = 0.99;

/** `carried_around_by_hand` */
export function carriedAround({ corners, t }) {
  const p = corners.map(unit);
  const after = [p[1], p[2], p[0]];
  const axes = p.map((point, i) => arcAxis(point, after[i]));
  const angles = p.map((point, i) => angleBetween(point, after[i]));
  const [start] = p;
  const ahead = cross(axes[0], start);

  /** Where the arrow begins, and its direction. */
  const carried = (t) => {
    const turns = axes.map((axis, i) => {
      return rotationMatrix(axis, angles[i] * Math.min(1, Math.max(0, 3 * t - i)));
    });
    return [start, ahead].map((vector) => turns.reduce((v, turn) => transform(turn, v), vector));
  };
  const head = ([at, way], size = SIZE) => combine(1, at, size, way);
  const arrow = (here, size) => ({ from: here[0], to: head(here, size) });

  const [, back] = carried(1);
  const twist = Math.atan2(dot(start, cross(ahead, back)), dot(ahead, back));
  const nearness = 1 + p.reduce((sum, point, i) => sum + dot(point, after[i]), 0);
  const area = 2 * Math.atan2(dot(p[0], cross(p[1], p[2])), nearness);

  const side = spread(25);
  const roundOnce = spread(STEPS + 1);
  const soFar = roundOnce.map((x) => carried(Math.max(t, LEAST) * x));
  const tails = soFar.map(([at]) => at);
  const rim = turning(ahead.map((x) => 0.7 * SIZE * x), start, twist, 48);
  const parts = {
    inside: { points: triangle(p) },
    sides: { paths: p.map((point, i) => side.map((s) => slerp(point, after[i], s))) },
    way: { paths: [tails] },
    swept: { points: [...tails, ...soFar.map((here) => head(here))] },
    arrow: arrow(carried(t)),
    sector: { points: [start, ...rim.map((x) => combine(1, start, 1, x))], hidden: t !== 1 },
  };
  for (let k = 0; k < STATIONS; k++) {
    const size = k ? SIZE : 1.4 * SIZE;
    parts[`station ${k}`] = { ...arrow(carried(k / STATIONS), size), hidden: k > t * STATIONS };
  }
  const labels = { twist: t === 1 ? combine(1.12, start, 2.6, rim[24]) : null };
  p.forEach((point, i) => {
    const others = combine(1, p[(i + 1) % 3], 1, p[(i + 2) % 3]);
    parts["ABC"[i]] = { at: point };
    labels["ABC"[i]] = combine(1, point, 0.18, unit(combine(2, point, -1, others)));
  });
  return {
    parts,
    labels,
    grips: { t: { path: roundOnce.map((x) => head(carried(x))) } },
    outputs: {
      twist: DEGREES * twist,
      area: DEGREES * area,
      difference: DEGREES * (area - twist),
    },
  };
}

/** Points of a triangle: `spherical_triangle`. */
function triangle([p, q, r]) {
  const s = spread(13);
  return s.flatMap((u) => {
    const opposite = slerp(q, r, u);
    return s.map((v) => slerp(p, opposite, v).map((x) => JUST_INSIDE * x));
  });
}
