/* Models of page 5 III. */
import {
  arcs,
  columns,
  DEGREES,
  facing,
  joined,
  ORIGIN,
  scaled,
  shown,
  spread,
  W,
} from "./parts.js";
import {
  angleBetween,
  arcAxis,
  bisect,
  closedCurve,
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
// Names this close together would cover each other.
const CROWDED = 0.19;
// How long a hair is for a curvature of 1, and at most, as an arc.
const [HAIR, LONGEST] = [0.09, 0.5];
// Of the whole curve.
const SAMPLES = 96;
// Samples from one target of the camera to the next.
const LEG = 24;
const TIMES = Array.from({ length: LEG }, (_, i) => i / LEG);
// Half the width and height of the camera's picture on the sphere.
const [WIDTH, HEIGHT] = [0.21, 0.14];
// Of the view of who rides on the camera, in degrees.
const ANGLE = 56;

/** Figure 8 with its curvature, on the curve and at one place, and its speed. */
export function closedCurveByHand({ points, u, fraction }, { most }) {
  const p = points.map(unit);
  const n = p.length;
  const { a, b } = controlPoints(p, fraction);
  const control = p.map((point, i) => [point, a[i], b[(i + 1) % n], p[(i + 1) % n]]);
  const segment = Math.min(Math.floor(u * n), n - 1);
  const within = u * n - segment;
  const times = spread(Math.round(SAMPLES / n) + 1);
  // Refuses a curve that could go two ways.
  closedCurve(p, 1, fraction);
  const [now] = motion(control[segment], [within]);
  const motions = control.map((four) => motion(four, times));
  const curve = [p[0], ...motions.flatMap(([, ...later]) => later.map(({ here }) => here))];
  const shape = {
    parts: {
      curve: { paths: [curve] },
      polygon: { paths: arcs([...b, ...p, ...a], [...p, ...a, ...control.map((four) => four[2])]) },
      ...comb(motions, now, segment, times.filter((x) => x < within).length),
      C: { at: now.here },
    },
    grips: { u: { path: curve, holds: ["C"] }, points: { holds: p.map((_, i) => `P_${i}`) } },
  };
  const polygon = p.flatMap((point, i) => [b[i], point, a[i]]);
  return joined(shape, corners(polygon, segment, most), motionOf(motions, now, segment + within));
}

/** Hairs on the outer side of the curve up to a place on it, as long as it is curved there. */
function comb(motions, now, segment, before) {
  const pieces = [...motions.slice(0, segment), [...motions[segment].slice(0, before), now]];
  const tips = pieces.map((piece) => piece.map(hairTip));
  const hairs = pieces.flatMap((piece, i) => piece.map(({ here }, k) => [here, tips[i][k]]));
  const lines = tips.filter(({ length }) => length > 1);
  return { comb: { paths: hairs }, tips: shown(lines.length > 0 && { paths: lines }) };
}

/** Where a hair ends, which lies on the sphere as well. */
function hairTip({ here, velocity, curvature }) {
  const angle = Math.min(Math.max(HAIR * curvature, -LONGEST), LONGEST);
  return combine(Math.cos(angle), here, -Math.sin(angle), unit(cross(here, velocity)));
}

/** The points of a closed curve, each between its control points; those of one piece have names. */
function corners(polygon, segment, most) {
  const middle = polygon.reduce((sum, q) => combine(1, sum, 1 / polygon.length, q), ORIGIN);
  const parts = {};
  const labels = {};
  for (let i = 0; i < 3 * most; i++) {
    const name = `${"bPa"[i % 3]}_${Math.floor(i / 3)}`;
    const point = polygon[i];
    const named = i % 3 === 1 || i === 3 * segment + 2 || i === (3 * segment + 3) % polygon.length;
    parts[name] = shown(point && { at: point });
    labels[name] = point && named ? beside(polygon, i, middle) : null;
  }
  return { parts, labels };
}

/** Speed and curvature along a closed curve and at one place, and how they jump. */
function motionOf(motions, now, place) {
  const ends = motions.map((leaving, i) => [motions.at(i - 1).at(-1), leaving[0]]);
  const jumps = ends.map(([v, w]) => length(combine(1, w.velocity, -1, v.velocity)));
  const speeds = motions.map((row) => row.map(({ velocity }) => DEGREES * length(velocity)));
  const bends = ends.map(([v, w]) => Math.abs(w.curvature - v.curvature));
  return {
    outputs: {
      speed: DEGREES * length(now.velocity),
      curvature: now.curvature,
      velocity_jump: DEGREES * Math.max(...jumps),
      curvature_jump: bends[Math.floor(place + 1 / 2) % motions.length],
      speed_range: [Math.min, Math.max].map((pick) => pick(...speeds.flat())),
      curvature_jumps: bends,
    },
    charts: {
      speeds: { curve: speeds },
      curvatures: { curve: motions.map((row) => row.map(({ curvature }) => curvature)) },
    },
  };
}

/**
 * The place of a label beside a corner of a closed polygon on the sphere.
 *
 * It is on the outer side of the corner. Where the polygon has no corner, as at P_i, it is on the
 * side away from the middle of all.
 */
function beside(polygon, i, middle) {
  const count = polygon.length;
  const [before, after] = [polygon.at(i - 1), polygon[(i + 1) % count]];
  const outwards = polygon[i].map(
    (x, k) => 0.35 * (x - middle[k]) + x - (before[k] + after[k]) / 2,
  );
  const sideways = unit(cross(polygon[i], combine(1, after, -1, before)));
  return combine(1.1, polygon[i], dot(sideways, outwards) < 0 ? -0.16 : 0.16, sideways);
}

/** De Casteljau's construction on the sphere: the arcs of all levels for one u. */
export function arcsOfArcs({ control, u }) {
  const levels = deCasteljauLevels(control, u);
  const curve = deCasteljau(control, spread(61));
  const parts = { curve: { paths: [curve] } };
  levels.forEach((level, j) => {
    if (level.length > 1) parts[`level ${j}`] = { paths: arcs(level.slice(0, -1), level.slice(1)) };
    level.forEach((point, k) => {
      parts[`Q ${j} ${j + k}`] = { at: point };
    });
  });
  const way = (j) => DEGREES * angleBetween(levels[0][0], levels[j][0]);
  return {
    parts,
    labels: namesOfLevels(levels),
    grips: {
      u: { path: curve, holds: ["Q 3 3"] },
      control: { holds: control.map((_, k) => `Q 0 ${k}`) },
    },
    outputs: { way_1: way(1), way_2: way(2), way_3: way(3) },
  };
}

/** Places for the names of the points of all levels, none where there is no room. */
function namesOfLevels(levels) {
  const middle = levels[0].reduce((sum, q) => combine(1, sum, 1 / 4, q), ORIGIN);
  const labels = {};
  // Given points and the result come first.
  for (const j of [0, 3, 2, 1]) {
    levels[j].forEach((point, k) => {
      const away = combine(1, point, -1, middle);
      const reach = (j === 3 ? -0.13 : 0.13) / Math.max(length(away), STEP);
      const place = combine(1, point, reach, away);
      const taken = Object.values(labels).filter(Boolean);
      const free = taken.every((other) => length(combine(1, place, -1, other)) > CROWDED);
      labels[`Q_{${j},${j + k}}`] = free ? place : null;
    });
  }
  return labels;
}

/** A camera that looks from target to target and back to the first, and what it sees. */
export function cameraByHand({ u, targets, path, roll }, { seen }) {
  const p = targets.map(unit);
  const legs = legsBetween(p);
  const ways = {
    arcs: legs.arcs.flatMap((arc) => deCasteljau(arc, TIMES)),
    curve: closedCurve(p, LEG),
  };
  const leg = Math.min(Math.floor(p.length * u), p.length - 1);
  const [taken, within] = [legs[path][leg], p.length * u - leg];
  const [now] = motion(taken, [within]);
  const ahead = now.here;
  const vertical = upright(ahead);
  const gone = [...ways[path].slice(0, samplesUntil(u)), ahead];
  const up = roll === "carried along" ? carried(upright(p[0]), gone) : vertical;
  const top = combine(1, ahead, HEIGHT, up);
  const middle = p.reduce((sum, q) => combine(1, sum, 1 / p.length, q), ORIGIN);
  const named = (place, after = "") =>
    Object.fromEntries(seen.map((name, i) => [name + after, place(p[i])]));
  const { bends, charts } = motions(legs, path);
  return {
    parts: {
      ...paths(ways, path),
      ...named((point) => ({ matrix: facing(point) })),
      ...cameraAndFrames(ahead, up, vertical),
    },
    labels: {
      ...named((point) => outside(point, middle)),
      // Seen from the centre, names stand beside what they name.
      ...named((point) => combine(1, point, 0.3, away(point, middle)), " seen"),
      up: combine(1, top, 0.36, up),
    },
    grips: {
      u: { path: [...ways[path], ways[path][0]], holds: ["camera"] },
      targets: { holds: seen },
    },
    views: { ride: { eye: ORIGIN, target: ahead, up, angle: ANGLE } },
    outputs: {
      rolled: DEGREES * Math.atan2(dot(cross(vertical, up), ahead), dot(vertical, up)),
      spin: roll === "kept upright" ? DEGREES * spinOfUpright(now) : 0,
      speed: DEGREES * length(now.velocity),
      bends: seen.map((name, i) => `${name} ${(DEGREES * bends[i]).toFixed(0)}°`).join(", "),
    },
    charts,
  };
}

/** Control points from target to target, for both paths. */
function legsBetween(p) {
  const after = p.map((_, i) => p[(i + 1) % p.length]);
  const { a, b } = controlPoints(p);
  return {
    arcs: p.map((point, i) => [point, after[i]]),
    curve: p.map((point, i) => [point, a[i], b[(i + 1) % p.length], after[i]]),
  };
}

/** How many samples of the way round lie before a place on it. */
const samplesUntil = (u) => Math.min(Math.floor(4 * LEG * u), 4 * LEG - 1) + 1;

/** Both paths, each thick and thin; thick is the one that the camera takes. */
function paths(ways, path) {
  const parts = {};
  for (const [name, way] of Object.entries(ways)) {
    const paths = [[...way, way[0]]];
    parts[name] = { paths, hidden: name !== path };
    parts[`other ${name}`] = { paths, hidden: name === path };
  }
  return parts;
}

/** A camera and the middle of its picture, upright and as it is. */
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

/** The bends of a path, the speed on both, and the spin of an upright camera. */
function motions(legs, path) {
  const t = spread(LEG / 2 + 1);
  const drive = (way) => way.map((leg) => motion(leg, t));
  const speeds = (rows) => rows.map((row) => row.map((now) => DEGREES * length(now.velocity)));
  const driven = { arcs: drive(legs.arcs), curve: drive(legs.curve) };
  const taken = driven[path];
  const spin = taken.map((row) => row.map((now) => DEGREES * spinOfUpright(now)));
  return {
    bends: taken.map((row, i) => angle(taken.at(i - 1).at(-1).velocity, row[0].velocity)),
    charts: { speeds: { arcs: speeds(driven.arcs), curve: speeds(driven.curve) }, spins: { spin } },
  };
}

/** The upward direction of the picture of an upright camera. */
const upright = (ahead) => cross(ahead, arcAxis(W, ahead));

/** How fast an upright camera turns about its line of sight: by its turn about W. */
function spinOfUpright({ here: [x, y, z], velocity: [dx, dy] }) {
  return (z * (x * dy - y * dx)) / Math.max(x ** 2 + y ** 2, STEP ** 2);
}

/**
 * Carry a direction along a path on the sphere, by the rotation of each short arc.
 *
 * Two half turns, about the start and about the middle of an arc, make up its rotation. Unlike an
 * axis, they also exist where the path stands still.
 */
function carried(up, way) {
  return way.slice(1).reduce((v, q, i) => double(double(v, way[i]), bisect(way[i], q)), up);
}

/** The corners of what a camera at the origin sees, where it meets the unit sphere. */
function picture(ahead, up) {
  const left = cross(up, ahead);
  const corner = (x, y) => combine(1, ahead, 1, combine(x * WIDTH, left, y * HEIGHT, up));
  return [corner(1, 1), corner(1, -1), corner(-1, -1), corner(-1, 1)];
}

/** The angle between two velocities; one that is zero makes none. */
const angle = (v, w) => Math.atan2(length(cross(v, w)), dot(v, w));

/** The direction away from the middle of the targets, along the sphere. */
function away(point, middle) {
  const chord = combine(1, point, -1, middle);
  const tangent = combine(1, chord, -dot(chord, point), point);
  return scaled(1 / Math.max(length(tangent), STEP), tangent);
}

/** The place of a label, clear of the path and of the upper side of the picture. */
function outside(point, middle) {
  const aside = away(point, middle);
  return combine(1.12, point, 0.19, combine(1, aside, 1, cross(point, aside)));
}

/**
 * Places, velocities and geodesic curvatures along a Bezier curve on the sphere, by differences.
 *
 * They are in radians for a step of 1 in u, and in radians turned for each radian travelled:
 * positive to the left, 0 on a great circle and where the curve stands still.
 */
function motion(control, places) {
  const [before, middle, after] = [-STEP, 0, STEP].map((step) => {
    const shifted = places.map((u) => u + step);
    return deCasteljau(control, shifted);
  });
  return middle.map((here, k) => {
    const velocity = combine(1 / (2 * STEP), after[k], -1 / (2 * STEP), before[k]);
    const acceleration = here.map((x, i) => (after[k][i] - 2 * x + before[k][i]) / STEP ** 2);
    const speed = Math.max(length(velocity), STEP);
    return { here, velocity, curvature: dot(cross(here, velocity), acceleration) / speed ** 3 };
  });
}
