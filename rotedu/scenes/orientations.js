/**
 * Models of page 5 IV.
 * @import { Point } from "./rotations.js"
 */
import { DEGREES, placing, scaled, spread, turning, W } from "./parts.js";
import {
  angleBetween,
  arcAxis,
  axisAngle,
  closedRotationCurve,
  combine,
  cross,
  dot,
  double,
  length,
  nearestRotation,
  periodicSpline,
  product,
  quaternionFromMatrix,
  quaternionMatrix,
  rotate,
  rotationMatrix,
  slerp,
  squad,
  transform,
  transpose,
  unit,
} from "./rotations.js";

// Arrows that are left on the way.
const STATIONS = 9;
const SIZE = 0.33;
// In so many steps the arrow sweeps its ribbon.
const STEPS = 60;
const LEAST = 0.001;

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

  const sides = p.map((point, i) => spread(25).map((s) => slerp(point, after[i], s)));
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
  return s.flatMap((u) => s.map((v) => slerp(p, slerp(q, r, u), v)));
}

// On the circle of a gate: where it goes after its swing, in degrees, and half a turn.
const [NEXT, HALF] = [10, 180];

/** Of a gate that swings on by as far again, the middles on both ways from there to its next place. */
export function twoMiddles({ swing }, { low, high }) {
  const on = 2 * swing;
  const flips = on - NEXT > HALF;
  const middle = (on + NEXT) / 2;
  const at = (degrees, radius = 1) => rotate([radius, 0, 0], W, degrees / DEGREES);
  const arc = (from, to, radius) => spread(25).map((t) => at(from + t * (to - from), radius));
  const points = { gate: at(swing), on: at(on), next: at(NEXT) };
  const middles = { remembered: at(middle, 0.86), shorter: at(middle + (flips ? HALF : 0), 0.72) };
  const ways = { swung: arc(0, on), "whole way": arc(NEXT, on, 0.86) };
  const placed = (places, place) =>
    Object.fromEntries(Object.entries(places).map(([name, at]) => [name, place(at)]));
  return {
    parts: {
      ...placed({ ...points, ...middles }, (at) => ({ at })),
      ...placed(ways, (path) => ({ paths: [path] })),
      "shorter way": { paths: [arc(NEXT, flips ? on - 2 * HALF : on, 0.72)] },
    },
    labels: {
      ...placed(points, ([x, y, z]) => [1.36 * x, 1.16 * y, z]),
      remembered: scaled(0.72, middles.remembered),
      shorter: scaled(0.6, middles.shorter),
    },
    grips: { swing: { path: arc(low, high), holds: ["gate"] } },
    outputs: { apart: flips ? HALF : 0 },
  };
}

const SAMPLES = 20;
// Where the given poses are turned, round the ball.
const PLACES = [
  [-0.8, 0, 1.42],
  [0.8, 0, 1.42],
  [0.8, 0, -1.42],
  [-0.8, 0, -1.42],
];
const MOUNTED = 0.28;
const SAME = 1e-6;

/** A closed curve of orientations along its route, and by shortest ways of matrices. */
export function routesByHand({ poses, u }, { signs }) {
  const q = poses.map(unit);
  const given = q.map(quaternionMatrix);
  const route = closedRotationCurve(given, SAMPLES);
  const shortest = shortestWay(q);
  const ways = { route, shortest: shortest.map(quaternionMatrix) };
  const turned = { route: route.map(quaternionFromMatrix), shortest };
  const count = given.length * SAMPLES;
  const here = Math.round(count * u) % count;
  const between = (p, q) => 2 * DEGREES * angleBetween(p, nearer(p, q));
  const apart = turned.route.map((turn, k) => between(turn, shortest[k]));

  const middle = (turn) => turn.map((row) => row[2]);
  const mounted = (turn, size) => ({ matrix: placing(turn, middle(turn), size * MOUNTED) });
  const parts = {};
  const angles = {};
  for (const [name, way] of Object.entries(ways)) {
    parts[name] = { paths: [[...way, way[0]].map(middle)] };
    const shown = (k, size) => ({
      ...mounted(way[k], size),
      hidden: name !== "route" && !(apart[k] > DEGREES * SAME),
    });
    for (let k = 0; k < count; k += 5) if (k % SAMPLES) parts[`${name} ${k}`] = shown(k, 0.5);
    parts[`${name} now`] = shown(here, 1.2);
    const fromStart = turned[name].map((turn) => between(q[0], turn));
    angles[name] = given.map((_, i) => {
      return [...fromStart, fromStart[0]].slice(SAMPLES * i, SAMPLES * (i + 1) + 1);
    });
  }
  const labels = {};
  given.forEach((turn, k) => {
    const [x, y, z] = PLACES[k];
    parts[`mounted ${k}`] = mounted(turn, 1);
    parts[`R_${k}`] = { matrix: placing(turn, PLACES[k], 0.5) };
    labels[`R_${k}`] = [1.46 * x, y, 0.7 * z];
  });
  const agree = q.reduce((sign, one, i) => sign * dot(q.at(i - 1), one), 1) > 0;
  return {
    parts,
    labels,
    grips: {
      u: { path: parts.route.paths[0], holds: ["route now", "shortest now"] },
      poses: { at: PLACES, size: 0.5, holds: given.map((_, k) => `R_${k}`) },
    },
    outputs: {
      turn: DEGREES * Math.max(...turnsFromDouble(q)),
      apart: Math.max(...apart),
      signs: signs[Number(agree)],
    },
    charts: { angles },
  };
}

/** Of a quaternion and its opposite, the one nearer to another. */
const nearer = (p, q) => (dot(p, q) < 0 ? scaled(-1, q) : q);

/**
 * The curve of Section 5 with the shortest way between two matrices as its arc, computed by
 * quaternions, which are faster: the sign of each is chosen anew for every arc.
 */
function shortestWay(q) {
  const shortest = (p, q, t) => slerp(p, nearer(p, q), t);
  const next = (i) => (i + 1) % q.length;
  const a = q.map((here, i) => {
    return shortest(here, shortest(double(q.at(i - 1), here), q[next(i)], 1 / 2), 1 / 2);
  });
  return q.flatMap((here, i) =>
    Array.from({ length: SAMPLES }, (_, k) => {
      let level = [here, a[i], double(a[next(i)], q[next(i)]), q[next(i)]];
      while (level.length > 1) {
        level = level.slice(1).map((end, j) => shortest(level[j], end, k / SAMPLES));
      }
      return level[0];
    }),
  );
}

/** How far it is, along the route, from Double of two poses to the next, in radians. */
function turnsFromDouble(q) {
  return q.map((here, i) => {
    const after = nearer(here, q[(i + 1) % q.length]);
    return 2 * angleBetween(double(nearer(here, q.at(i - 1)), here), after);
  });
}

// Pictures of a film a second. Each second leads from one pose to the next.
const PICTURES = 24;
// Heights of the given poses and of the line of time.
const [ROW, RAIL] = [1.12, 0.42];
const TICK = 0.07;

/** Five films of a spoon that go through the same poses at the same times. */
export function animate({ poses, t, fraction }, { most, jumpy, middles, radius }) {
  const q = poses.map(unit);
  const films = filmsThrough(q, fraction);
  const count = PICTURES * q.length;
  const picture = Math.floor(count * t + 1 / 2) % count;
  const { parts, labels, grips } = timeline(q, most);
  Object.entries(films).forEach(([name, film], i) => {
    const tips = film.map((rotation) => rotation.map(([x]) => radius * x));
    const round = [...tips, tips[0]].map((tip) => combine(1, middles[i], 1, tip));
    parts[`${name}, tip`] = { paths: [round] };
    parts[name] = { matrix: placing(film[picture], middles[i], radius) };
    labels[name] = combine(1, middles[i], 1, [0, 0, -0.84]);
  });
  const steps = mapped(films, filmSteps);
  const motions = mapped(steps, filmMotion);
  const sizes = (kind) => mapped(motions, (motion) => motion[kind].map((own) => own.map(length)));
  const [speeds, accelerations] = [sizes("velocity"), sizes("acceleration")];
  const [segment, within] = [Math.floor(picture / PICTURES), picture % PICTURES];
  return {
    parts,
    labels,
    grips: { ...grips, t: { ...grips.t, holds: Object.keys(films) } },
    charts: { speeds, accelerations },
    outputs: {
      fastest: Object.values(steps).map((pieces) => Math.max(...pieces.flat().map(length))),
      corner: jump(motions.slerp.velocity),
      speed: Object.values(speeds).map((speed) => speed[segment][within]),
      jumps: jumpy.map((name) => jump(motions[name].acceleration)),
    },
  };
}

/** A function of each value of an object, by its name. */
const mapped = (object, value) =>
  Object.fromEntries(Object.entries(object).map(([name, own]) => [name, value(own)]));

/** A line of time, and above it a spoon for each pose and, at its end, the first again. */
function timeline(q, most) {
  const n = q.length;
  const size = 2.2 / n;
  const stop = (k, height) => [-2.75 + (5.5 * k) / n, 0, height];
  const given = q.map(quaternionMatrix);
  const every = Array.from({ length: n + 1 }, (_, k) => k);
  const rail = [stop(0, RAIL), stop(n, RAIL)];
  const parts = {
    rail: { paths: [rail] },
    ticks: { paths: every.map((k) => [stop(k, RAIL - TICK), stop(k, RAIL + TICK)]) },
    again: { matrix: placing(given[0], stop(n, ROW), size) },
  };
  const labels = { again: stop(n, RAIL - 4 * TICK) };
  for (let k = 0; k < most; k++) {
    const used = k < n;
    const i = Math.min(k, n - 1);
    parts[`R_${k}`] = { matrix: placing(given[i], stop(i, ROW), size), hidden: !used };
    labels[`R_${k}`] = used ? stop(k, RAIL - 4 * TICK) : null;
  }
  const holds = given.map((_, k) => `R_${k}`);
  const grips = {
    t: { path: rail },
    poses: { at: given.map((_, k) => stop(k, ROW)), size, holds },
  };
  return { parts, labels, grips };
}

/** Films of rotation matrices, from quaternions. */
function filmsThrough(q, fraction) {
  const given = q.map(quaternionMatrix);
  const arcs = q.flatMap((p, i) => {
    const next = q[(i + 1) % q.length];
    return Array.from({ length: PICTURES }, (_, k) => slerp(p, next, k / PICTURES));
  });
  const entries = periodicSpline(
    given.map((matrix) => matrix.flat()),
    PICTURES,
  );
  return {
    slerp: arcs.map(quaternionMatrix),
    squad: squad(q, PICTURES).map(quaternionMatrix),
    "spline of q": periodicSpline(q, PICTURES).map(quaternionMatrix),
    "the paper's": closedRotationCurve(given, PICTURES, fraction),
    "spline of M": entries.map((m) => nearestRotation([m.slice(0, 3), m.slice(3, 6), m.slice(6)])),
  };
}

/** The turns from picture to picture, in degrees a second, in pieces from pose to pose. */
function filmSteps(film) {
  const turns = film.map((rotation, k) => {
    const { axis, angle } = axisAngle(product(transpose(rotation), film[(k + 1) % film.length]));
    return scaled(PICTURES * DEGREES * angle, axis);
  });
  const starts = turns.map((_, k) => k).filter((k) => k % PICTURES === 0);
  return starts.map((start) => turns.slice(start, start + PICTURES));
}

/**
 * Velocity and acceleration, as the body sees them, at the pictures from pose to pose, both ends
 * included: at a pose, the pieces before and after it have their own.
 */
function filmMotion(steps) {
  const extended = steps.map((own) => [beyond(own), ...own, beyond(own.toReversed())]);
  const between = (combined) =>
    extended.map((all) => all.slice(1).map((after, k) => combined(after, all[k])));
  return {
    velocity: between((after, before) => combine(1 / 2, after, 1 / 2, before)),
    acceleration: between((after, before) => combine(PICTURES, after, -PICTURES, before)),
  };
}

/**
 * The value before four others on the cubic through them.
 * @param {Point[]} values
 */
function beyond([first, second, third, fourth]) {
  return combine(1, combine(4, first, -6, second), 1, combine(4, third, -1, fourth));
}

/** The largest jump of a motion from one segment to the next. */
function jump(motion) {
  const changes = motion.map((piece, i) => combine(1, piece[0], -1, motion.at(i - 1).at(-1)));
  return Math.max(...changes.map(length));
}
