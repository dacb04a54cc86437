/**
 * What the models share.
 * @import { State } from "../../viewer/src/types.js"
 * @import { Point } from "./rotations.js"
 */
import { combine, cross, length, rotate, slerp, transform, transpose, unit } from "./rotations.js";

export const DEGREES = 180 / Math.PI;
export const ORIGIN = [0, 0, 0];
export const U = [1, 0, 0];
export const V = [0, 1, 0];
export const W = [0, 0, 1];
export const IDENTITY = [U, V, W];
/** The edges of a cube, from corner to corner. */
const CUBE = cube();

function cube() {
  const corners = Array.from({ length: 8 }, (_, i) =>
    [4, 2, 1].map((bit) => (i & bit ? 0.5 : -0.5)),
  );
  // From each corner forwards along each axis on which it is behind.
  return corners.flatMap((p) =>
    [2, 1, 0].filter((k) => p[k] < 0).map((k) => [p, combine(1, p, 1, IDENTITY[k])]),
  );
}

export const scaled = (factor, v) => v.map((x) => factor * x);

/** A part in a place, or hidden where there is none. */
export const shown = (place) => (place ? { ...place, hidden: false } : { hidden: true });

/**
 * One state made of several, each with some of the parts, labels and so on.
 * @returns {State}
 */
export function joined(...states) {
  const all = { parts: {}, labels: {}, outputs: {} };
  for (const state of states)
    for (const [kind, own] of Object.entries(state)) all[kind] = { ...all[kind], ...own };
  return all;
}

/** What an output says that is true or false. */
export const lamp = (value) => (value ? "yes" : "no");

/** Numbers evenly spread from 0 to 1, both included. */
export function spread(count) {
  return Array.from({ length: count }, (_, i) => i / (count - 1));
}

/**
 * The sixteen numbers, by columns, of a matrix that takes U, V, W and O to three vectors and a point.
 * @param {Point[]} vectors
 */
export function columns([u, v, w], origin = ORIGIN) {
  return [...u, 0, ...v, 0, ...w, 0, ...origin, 1];
}

/** The upright pose of a thing that stands in a direction and faces the origin. */
export function facing(direction) {
  const level = cross(W, direction);
  const left = length(level) > 1e-9 ? unit(level) : V;
  return columns([direction, left, cross(direction, left)], direction);
}

/** The angle between two rotations: the chord between their matrices is sqrt(8) sin(angle / 2). */
export function degreesBetween(a, b) {
  const chord = length(a.flatMap((row, i) => combine(1, row, -1, b[i])));
  return 2 * DEGREES * Math.asin(Math.min(chord / Math.sqrt(8), 1));
}

/** Arcs from each point to another. */
export function arcs(starts, ends) {
  const t = spread(13);
  return starts.map((p, i) => t.map((x) => slerp(p, ends[i], x)));
}

/** The edges of a cube in a place, after a matrix. */
export function box(matrix, place, size = 1) {
  const moved = (point) => combine(1, place, 1, transform(matrix, scaled(size, point)));
  return { paths: CUBE.map((edge) => edge.map(moved)) };
}

/** The path of a turned point. */
export function turning(point, axis, angle, steps) {
  return spread(steps + 1).map((x) => rotate(point, axis, x * angle));
}

/** Of how many sides a round skin is made, and two of which make a stripe. */
export const SIDES = 16;

/** Every second stripe along a skin of rings, for `shapes.stripes`. */
export function stripes(rings, first) {
  return [0, 1, 2, 3].flatMap((k) =>
    [0, 1, 2].flatMap((side) => rings.map((ring) => ring[(4 * k + first + side) % SIDES])),
  );
}

/** The sixteen numbers, by columns, that turn a part by a 3x3 matrix, enlarge it and put it in a place. */
export function placing(matrix, place, size = 1) {
  const scaledColumns = transpose(matrix).map((column) => scaled(size, column));
  return columns(scaledColumns, place);
}
