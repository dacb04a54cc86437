/**
 * Models of page 5 V.
 * @import { Point } from "./rotations.js"
 */
import { columns, DEGREES, placing, scaled, shown, spread, W } from "./parts.js";
import {
  angleBetween,
  closedRotationCurve,
  combine,
  deCasteljau,
  dot,
  double,
  length,
  nearestRotation,
  periodicSpline,
  quaternionFromAxisAngle,
  quaternionFromMatrix,
  quaternionMatrix,
  rotate,
  rotationMatrix,
  slerp,
  squad,
  transpose,
  turnBetween,
  unit,
} from "./rotations.js";

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
  return {
    parts: {
      ...mapped({ ...points, ...middles }, (at) => ({ at })),
      ...mapped(ways, (path) => ({ paths: [path] })),
      "shorter way": { paths: [arc(NEXT, flips ? on - 2 * HALF : on, 0.72)] },
    },
    labels: {
      ...mapped(points, ([x, y, z]) => [1.36 * x, 1.16 * y, z]),
      // Beside the ring that holds it.
      gate: combine(1, points.gate, 1, [0.45 * Math.tanh(8 * points.gate[0]), 0.12, 0]),
      remembered: scaled(0.48, middles.remembered),
      shorter: scaled(0.27, middles.shorter),
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
    const copy = (k, size) => ({
      ...mounted(way[k], size),
      hidden: name !== "route" && !(apart[k] > DEGREES * SAME),
    });
    for (let k = 0; k < count; k += 5) if (k % SAMPLES) parts[`${name} ${k}`] = copy(k, 0.5);
    parts[`${name} now`] = copy(here, 1.2);
    angles[name] = legs(turned[name].map((turn) => between(q[0], turn)));
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

/** A gate on two curves through the same places, along its route and by the shorter ways. */
export function theSwing({ t }, { places }) {
  const q = places.map((degrees) => quaternionFromAxisAngle(W, degrees / DEGREES));
  const turned = {
    route: closedRotationCurve(q.map(quaternionMatrix), SAMPLES).map(quaternionFromMatrix),
    shortest: shortestWay(q),
  };
  const angles = mapped(turned, (way) => unwrapped(way.map(([w, , , z]) => 2 * Math.atan2(z, w))));
  const count = SAMPLES * places.length;
  const here = Math.round(count * t) % count;
  const at = (angle, radius) => rotate([radius, 0, 0], W, angle);
  const far = { route: 1.25, shortest: 1.4 };
  const parts = {};
  const outputs = {};
  for (const [name, own] of Object.entries(angles)) {
    parts[`${name}, gate`] = { matrix: columns(transpose(rotationMatrix(W, own[here]))) };
    parts[`${name}, way`] = { paths: [[...own, own[0]].map((angle) => at(angle, far[name]))] };
    outputs[name] = DEGREES * own[here];
  }
  const labels = {};
  places.forEach((degrees, k) => {
    const [near, end] = [0.2, 1.25].map((radius) => at(degrees / DEGREES, radius));
    parts[`place ${k}`] = { paths: [[near, end]] };
    labels[`place ${k}`] = at(degrees / DEGREES, 1.62);
  });
  return {
    parts,
    labels,
    grips: { t: { path: parts["route, way"].paths[0], holds: ["route, gate", "shortest, gate"] } },
    outputs,
    charts: { angles: mapped(angles, (own) => legs(scaled(DEGREES, own))) },
  };
}

/** Values along a closed curve in pieces from place to place, both ends included. */
const legs = (values) =>
  Array.from({ length: values.length / SAMPLES }, (_, i) =>
    [...values, values[0]].slice(SAMPLES * i, SAMPLES * (i + 1) + 1),
  );

/** Angles one after the other without jumps of a whole turn. */
function unwrapped(angles) {
  const all = [angles[0]];
  for (const angle of angles.slice(1)) {
    const turns = Math.round((all.at(-1) - angle) / (2 * Math.PI));
    all.push(angle + 2 * Math.PI * turns);
  }
  return all;
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
// Heights of the given poses and of the line of time, and the middle of the ball below.
const [ROW, RAIL, MIDDLE] = [2.05, 1.45, [0, 0, -0.3]];
const TICK = 0.07;

/** Films of a spoon that go through the same poses at the same times, of which some are shown. */
export function animate({ poses, t, films: wanted, fraction }, { choices, jumpy, most, radius }) {
  const q = poses.map(unit);
  const [all, chosen] = [choices["all five"], choices[wanted]];
  const films = filmsThrough(q, fraction, new Set([...chosen, "slerp", ...jumpy]));
  const count = PICTURES * q.length;
  const picture = Math.floor(count * t + 1 / 2) % count;
  const { parts, labels, grip } = timeline(q, most);
  for (const [i, name] of all.entries()) {
    const film = chosen.includes(name) && films[name];
    parts[`${name}, tip`] = shown(film && { paths: [tipsOf(film, radius)] });
    // Of spoons in one pose the first is seen.
    const size = (1 - 0.01 * i) * radius;
    parts[name] = shown(film && { matrix: placing(film[picture], MIDDLE, size) });
  }
  const steps = mapped(films, filmSteps);
  const motions = mapped(steps, filmMotion);
  const sizes = (kind) => {
    const curve = (name) => motions[name][kind].map((own) => own.map(length));
    return Object.fromEntries(
      all.map((name) => [name, chosen.includes(name) ? curve(name) : null]),
    );
  };
  const [speeds, accelerations] = [sizes("velocity"), sizes("acceleration")];
  const [segment, within] = [Math.floor(picture / PICTURES), picture % PICTURES];
  return {
    parts,
    labels,
    grips: { t: { path: parts.rail.paths[0], holds: chosen }, poses: grip },
    charts: { speeds, accelerations },
    outputs: {
      fastest: chosen.map((name) => Math.max(...steps[name].flat().map(length))),
      corner: jump(motions.slerp.velocity),
      speed: chosen.map((name) => speeds[name][segment][within]),
      jumps: jumpy.map((name) => jump(motions[name].acceleration)),
    },
  };
}

/** The path of a spoon's tip, once round. */
function tipsOf(film, radius) {
  const tips = film.map((rotation) => rotation.map(([x]) => radius * x));
  return [...tips, tips[0]].map((tip) => combine(1, MIDDLE, 1, tip));
}

/** A function of each value of an object, by its name. */
const mapped = (object, value) =>
  Object.fromEntries(Object.entries(object).map(([name, own]) => [name, value(own)]));

/** A line of time, and above it a spoon for each pose and, at its end, the first again. */
function timeline(q, most) {
  const n = q.length;
  const size = 1.7 / n;
  const stop = (k, height) => [-1.9 + (3.8 * k) / n, 0, height];
  const given = q.map(quaternionMatrix);
  const every = Array.from({ length: n + 1 }, (_, k) => k);
  const parts = {
    rail: { paths: [[stop(0, RAIL), stop(n, RAIL)]] },
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
  return { parts, labels, grip: { at: given.map((_, k) => stop(k, ROW)), size, holds } };
}

/** Films of rotation matrices, from quaternions: those that are wanted, by their names. */
function filmsThrough(q, fraction, wanted) {
  const given = q.map(quaternionMatrix);
  const times = Array.from({ length: PICTURES }, (_, k) => k / PICTURES);
  const arcs = () => q.flatMap((p, i) => deCasteljau([p, q[(i + 1) % q.length]], times));
  const entries = given.map((matrix) => matrix.flat());
  const rows = (m) => [m.slice(0, 3), m.slice(3, 6), m.slice(6)];
  const films = {
    slerp: () => arcs().map(quaternionMatrix),
    squad: () => squad(q, PICTURES).map(quaternionMatrix),
    "spline of q": () => periodicSpline(q, PICTURES).map(quaternionMatrix),
    "the paper's": () => closedRotationCurve(given, PICTURES, fraction),
    "spline of M": () => periodicSpline(entries, PICTURES).map((m) => nearestRotation(rows(m))),
  };
  return Object.fromEntries([...wanted].map((name) => [name, films[name]()]));
}

/** The turns from picture to picture, in degrees a second, in pieces from pose to pose. */
function filmSteps(film) {
  const turns = film.map((rotation, k) => {
    const { axis, angle } = turnBetween(rotation, film[(k + 1) % film.length]);
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
