/* Models of `rotedu.scenes.closed_curve`. */
import { DEGREES, ORIGIN, arcs, columns, spread } from "./parts.js";
import {
  angleBetween,
  arcAxis,
  bisect,
  closedCurve as curveThrough,
  combine,
  controlPoints,
  cross,
  deCasteljau,
  deCasteljauLevels,
  dot,
  double,
  length,
  unit,
} from "./rotations.js";

const STEP = 3e-4;
// Of `arcs_of_arcs`.
const CROWDED = 0.19;
// Of `closed_curve_by_hand`.
const MOST = 8;
const NAMED = 5;
const SAMPLES = 25;
// Of `camera_by_hand`.
const LEG = 24;
const TIMES = Array.from({ length: LEG }, (_, i) => i / LEG);
const [WIDTH, HEIGHT] = [0.21, 0.14];
const ANGLE = 56;

/** Velocity and geodesic curvature: `motion`. */
function motion(control, u) {
  const [before, here, after] = [-STEP, 0, STEP].map((x) => deCasteljau(control, u + x));
  const velocity = combine(1 / (2 * STEP), after, -1 / (2 * STEP), before);
  const acceleration = here.map((x, i) => (after[i] - 2 * x + before[i]) / STEP ** 2);
  const speed = Math.max(length(velocity), STEP);
  return { velocity, curvature: dot(cross(here, velocity), acceleration) / speed ** 3 };
}

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
  const speeds = motions.map((row) => row.map(({ velocity }) => DEGREES * length(velocity)));
  const bends = ends.map(([v, w]) => Math.abs(w.curvature - v.curvature));
  return {
    parts,
    labels,
    grips: { u: { path: [...curve, curve[0]] } },
    outputs: {
      speed: DEGREES * length(now.velocity),
      curvature: now.curvature,
      velocity_jump: DEGREES * Math.max(...jumps),
      curvature_jump: bends[Math.floor(n * u + 1 / 2) % n],
      speed_range: [Math.min, Math.max].map((pick) => pick(...speeds.flat())),
      curvature_jumps: bends,
    },
    charts: {
      speeds: { curve: speeds },
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

/** `arcs_of_arcs` */
export function arcsOfArcs({ control, u }) {
  const levels = deCasteljauLevels(control, u);
  const curve = spread(61).map((x) => deCasteljau(control, x));
  const parts = { curve: { paths: [curve] } };
  levels.forEach((level, j) => {
    if (level.length > 1) parts[`level ${j}`] = { paths: arcs(level.slice(0, -1), level.slice(1)) };
    level.forEach((point, k) => (parts[`Q ${j} ${j + k}`] = { at: point }));
  });
  const way = (j) => DEGREES * angleBetween(levels[0][0], levels[j][0]);
  return {
    parts,
    labels: namesOfLevels(levels),
    grips: { u: { path: curve } },
    outputs: { way_1: way(1), way_2: way(2), way_3: way(3) },
  };
}

/** Places for the names of points, none where there is no room: `names_of_levels`. */
function namesOfLevels(levels) {
  const middle = levels[0].reduce((sum, q) => combine(1, sum, 1 / 4, q), ORIGIN);
  const labels = {};
  for (const j of [0, 3, 2, 1]) {
    levels[j].forEach((point, k) => {
      const away = combine(1, point, -1, middle);
      const place = combine(1, point, (j === 3 ? -0.13 : 0.13) / Math.max(length(away), STEP), away);
      const taken = Object.values(labels).filter(Boolean);
      const free = taken.every((other) => length(combine(1, place, -1, other)) > CROWDED);
      labels[`Q_{${j},${j + k}}`] = free ? place : null;
    });
  }
  return labels;
}

/** `camera_by_hand` */
export function camera({ targets, path, roll, u }, { seen }) {
  const p = targets.map(unit);
  const legs = legsBetween(p);
  const ways = {
    arcs: legs.arcs.flatMap((arc) => TIMES.map((t) => deCasteljau(arc, t))),
    curve: curveThrough(p, LEG),
  };
  const leg = Math.min(Math.floor(p.length * u), p.length - 1);
  const [taken, within] = [legs[path][leg], p.length * u - leg];
  const ahead = deCasteljau(taken, within);
  const vertical = upright(ahead);
  let up = vertical;
  if (roll === "carried along") {
    up = carried(upright(p[0]), [...ways[path].slice(0, samplesUntil(u)), ahead]);
  }
  const top = combine(1, ahead, HEIGHT, up);
  const middle = p.reduce((sum, q) => combine(1, sum, 1 / p.length, q), ORIGIN);
  const named = (place, after = "") =>
    Object.fromEntries(seen.map((name, i) => [name + after, place(p[i])]));
  const { velocity } = motion(taken, within);
  const { bends, charts } = motions(legs, path);
  return {
    parts: {
      ...paths(ways, path),
      ...named((at) => ({ at })),
      ...cameraAndFrames(ahead, up, vertical),
    },
    labels: {
      ...named((point) => outside(point, middle)),
      ...named((point) => combine(1, point, 0.08, away(point, middle)), " seen"),
      up: combine(1, top, 0.36, up),
    },
    grips: { u: { path: [...ways[path], ways[path][0]] } },
    views: { ride: { eye: ORIGIN, target: ahead, up, angle: ANGLE } },
    outputs: {
      rolled: DEGREES * Math.atan2(dot(cross(vertical, up), ahead), dot(vertical, up)),
      spin: roll === "kept upright" ? DEGREES * spinOfUpright(ahead, velocity) : 0,
      speed: DEGREES * length(velocity),
      bends: seen.map((name, i) => `${name} ${(DEGREES * bends[i]).toFixed(0)}°`).join(", "),
    },
    charts,
  };
}

/** Control points from target to target, for both paths: `legs_between`. */
function legsBetween(p) {
  const after = p.map((_, i) => p[(i + 1) % p.length]);
  const { a, b } = controlPoints(p);
  return {
    arcs: p.map((point, i) => [point, after[i]]),
    curve: p.map((point, i) => [point, a[i], b[(i + 1) % p.length], after[i]]),
  };
}

/** How many samples of the way round lie before a place on it: `samples_until`. */
const samplesUntil = (u) => Math.min(Math.floor(4 * LEG * u), 4 * LEG - 1) + 1;

/** Both paths, each thick and thin: `add_paths`. */
function paths(ways, path) {
  const parts = {};
  for (const [name, way] of Object.entries(ways)) {
    const paths = [[...way, way[0]]];
    parts[name] = { paths, hidden: name !== path };
    parts[`other ${name}`] = { paths, hidden: name === path };
  }
  return parts;
}

/** A camera and the middle of its picture, upright and as it is: `add_camera`. */
function cameraAndFrames(ahead, up, vertical) {
  const [level, corners] = [vertical, up].map((side) => picture(ahead, side));
  const [levelTop, top] = [vertical, up].map((side) => combine(1, ahead, HEIGHT, side));
  return {
    camera: { matrix: columns([ahead, cross(up, ahead), up]) },
    upright: { paths: [[...level, level[0]]] },
    "upright up": { from: levelTop, to: combine(1, levelTop, 0.16, vertical) },
    picture: { paths: [[...corners, corners[0]]] },
    edges: { paths: corners.map((corner) => [ORIGIN, corner]) },
    up: { from: top, to: combine(1, top, 0.28, up) },
  };
}

/** The bends of a path, the speed on both, and the spin of an upright camera: `show_motion`. */
function motions(legs, path) {
  const t = spread(LEG / 2 + 1);
  const velocities = (way) => way.map((leg) => t.map((x) => motion(leg, x).velocity));
  const speeds = (rows) => rows.map((row) => row.map((v) => DEGREES * length(v)));
  const driven = { arcs: velocities(legs.arcs), curve: velocities(legs.curve) };
  const spin = driven[path].map((row, i) =>
    row.map((v, k) => DEGREES * spinOfUpright(deCasteljau(legs[path][i], t[k]), v)),
  );
  return {
    bends: driven[path].map((row, i) => angle(driven[path].at(i - 1).at(-1), row[0])),
    charts: {
      speeds: { arcs: speeds(driven.arcs), curve: speeds(driven.curve) },
      spins: { spin },
    },
  };
}

/** The upward direction of the picture of an upright camera. */
const upright = (ahead) => cross(ahead, arcAxis([0, 0, 1], ahead));

/** How fast an upright camera turns about its line of sight. */
function spinOfUpright([x, y, z], [dx, dy]) {
  return (z * (x * dy - y * dx)) / Math.max(x ** 2 + y ** 2, STEP ** 2);
}

/** Carry a direction along a path on the sphere: two half turns make up the rotation of an arc. */
function carried(up, way) {
  return way.slice(1).reduce((v, q, i) => double(double(v, way[i]), bisect(way[i], q)), up);
}

/** The corners of what a camera sees, where it meets the unit sphere. */
function picture(ahead, up) {
  const left = cross(up, ahead);
  const signs = [[1, 1], [1, -1], [-1, -1], [-1, 1]];
  return signs.map(([x, y]) =>
    combine(1, ahead, 1, combine(x * WIDTH, left, y * HEIGHT, up)),
  );
}

/** The angle between two velocities; one that is zero makes none. */
const angle = (v, w) => Math.atan2(length(cross(v, w)), dot(v, w));

/** The direction away from the middle of the targets, along the sphere. */
function away(point, middle) {
  const chord = combine(1, point, -1, middle);
  const tangent = combine(1, chord, -dot(chord, point), point);
  return tangent.map((x) => x / Math.max(length(tangent), STEP));
}

/** The place of a label: away from the middle, and from the path. */
function outside(point, middle) {
  const aside = away(point, middle);
  return combine(1.1, point, 0.15, combine(1, aside, 1, cross(point, aside)));
}
