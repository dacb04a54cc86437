/* Surfaces of parts that move: round lines and arrows, as `rotedu.scenes.parts` draws them. */
import { along, cross, dot, unit } from "./vectors.js";

const SIDES = 8;
const AROUND = 20;
const NOWHERE = [0, 0, 0];

/**
 * Round lines through points.
 * @param {number[][][]} paths
 * @param {number} radius
 * @param {import("./types.js").Skin} [old] a surface to overwrite if it has as many points
 */
export function tubes(paths, radius, old) {
  const size = paths.map((path) => path.length).join();
  const surface = old?.size === size ? old : emptyTubes(paths, size);
  let at = 0;
  for (const path of paths) at = tube(surface, path, radius, at);
  return surface;
}

function emptyTubes(paths, size) {
  const corners = [];
  let first = 0;
  for (const { length } of paths) {
    for (let i = 0; i + 1 < length; i++) corners.push(...band(first + i * SIDES, SIDES));
    first += length * SIDES;
  }
  return { ...empty(first, corners), size };
}

/** A surface whose points have no place yet. */
function empty(count, corners) {
  return {
    positions: new Float32Array(3 * count),
    normals: new Float32Array(3 * count),
    corners: new Uint32Array(corners),
  };
}

/** The faces between a ring of points and the next. */
function band(first, count) {
  return Array.from({ length: count }, (_, k) => {
    const [a, b] = [first + k, first + ((k + 1) % count)];
    return [a, b, a + count, b, b + count, a + count];
  }).flat();
}

/** Some directions around a circle, as cosine and sine. */
const circle = (count) =>
  Array.from({ length: count }, (_, k) => {
    const angle = (2 * Math.PI * k) / count;
    return [Math.cos(angle), Math.sin(angle)];
  });
const [ROUND_TUBE, ROUND_ARROW] = [circle(SIDES), circle(AROUND)];

/** Write one line; the ring of each point is turned as little as possible from the one before. */
function tube({ positions, normals }, path, radius, at) {
  const steps = path.slice(1).map((point, i) => unit(along(point, -1, path[i])));
  let n = NOWHERE;
  let last = n;
  for (const [i, point] of path.entries()) {
    // At a corner a ring halves the angle.
    const t = unit(along(steps[i - 1] ?? NOWHERE, 1, steps[i] ?? NOWHERE));
    n = i ? carried(n, last, t) : beside(path, t);
    n = unit(along(n, -dot(n, t), t));
    last = t;
    const b = cross(t, n);
    for (const [cosine, sine] of ROUND_TUBE) {
      for (let k = 0; k < 3; k++, at++) {
        normals[at] = cosine * n[k] + sine * b[k];
        positions[at] = point[k] + radius * normals[at];
      }
    }
  }
  return at;
}

/** Across a path at its start, as VTK has it: at right angles to its first bend, if it has one. */
function beside(path, t) {
  for (let i = 1; i + 1 < path.length; i++) {
    const bend = cross(along(path[i], -1, path[i - 1]), along(path[i + 1], -1, path[i]));
    if (dot(bend, bend)) return unit(bend);
  }
  const k = t.findIndex((x) => x !== 0);
  const n = [0, 0, 0];
  n[(k + 1) % 3] = 1;
  n[k] = -t[(k + 1) % 3] / t[k];
  return n;
}

/** Turn a vector as little as turns one direction into another; back, there is no such turn. */
function carried(vector, from, to) {
  const axis = cross(from, to);
  const cosine = dot(from, to);
  const turned = along(vector, 1, cross(axis, vector));
  return cosine > -1 + 1e-9
    ? along(turned, 1 / (1 + cosine), cross(axis, cross(axis, vector)))
    : vector;
}

/** The faces of the shaft, of the back of the head and of the head, each between two rings. */
const ARROW_FACES = [0, 2, 4].flatMap((ring) => band(ring * AROUND, AROUND));

/** An axis that is not along a direction. */
const aside = (t) => (Math.abs(t[0]) < 0.6 ? [1, 0, 0] : [0, 1, 0]);

/**
 * An arrow whose head has the same size at any length, but takes no more than a share of it.
 * @param {number[]} from
 * @param {number[]} to
 * @param {number} radius of the shaft
 * @param {number} share
 * @param {import("./types.js").Skin} [old] the surface of an arrow, to overwrite
 */
export function arrow(from, to, radius, share, old) {
  const axis = along(to, -1, from);
  const length = Math.hypot(...axis);
  const t = unit(axis);
  const n = unit(cross(t, aside(t)));
  const b = cross(t, n);
  const tip = Math.min(9 * radius, share * length);
  const [shaft, head] = [Math.min(radius, tip / 4), tip / 3];
  const slope = Math.hypot(tip, head);
  // Rings: distance along the arrow, radius, and the normal's share along and across.
  const rings = [
    [0, shaft, 0, 1],
    [length - tip, shaft, 0, 1],
    [length - tip, 0, -1, 0],
    [length - tip, head, -1, 0],
    [length - tip, head, head / slope, tip / slope],
    // As VTK does at rest, the faces of a tip are averaged: what is left points along the arrow.
    [length, 0, 1, 0],
  ];
  const surface = old ?? empty(rings.length * AROUND, ARROW_FACES);
  const { positions, normals } = surface;
  let at = 0;
  for (const [distance, across, up, out] of rings) {
    const middle = along(from, distance, t);
    for (const [cosine, sine] of ROUND_ARROW) {
      for (let k = 0; k < 3; k++, at++) {
        const outwards = cosine * n[k] + sine * b[k];
        positions[at] = middle[k] + across * outwards;
        normals[at] = out * outwards + up * t[k];
      }
    }
  }
  return surface;
}
