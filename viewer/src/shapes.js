/* Surfaces of parts that move: round lines and arrows, as `rotedu.scenes.parts` draws them. */

const SIDES = 8;
const AROUND = 20;

/**
 * Round lines through points.
 * @param {number[][][]} paths
 * @param {number} radius
 * @param {import("./types.js").Tubes} [old] a surface to overwrite if it has as many points
 */
export function tubes(paths, radius, old) {
  const size = paths.map((path) => path.length).join();
  const count = paths.reduce((sum, path) => sum + path.length, 0);
  const surface = old?.size === size ? old : emptyTubes(paths, count, size);
  let at = 0;
  for (const path of paths) at = tube(surface, path, radius, at);
  return surface;
}

function emptyTubes(paths, count, size) {
  const corners = [];
  let first = 0;
  for (const { length } of paths) {
    for (let i = 0; i + 1 < length; i++) {
      for (let k = 0; k < SIDES; k++) {
        const [a, b] = [first + i * SIDES + k, first + i * SIDES + ((k + 1) % SIDES)];
        corners.push(a, b, a + SIDES, b, b + SIDES, a + SIDES);
      }
    }
    first += length * SIDES;
  }
  const numbers = 3 * SIDES * count;
  return {
    positions: new Float32Array(numbers),
    normals: new Float32Array(numbers),
    corners: new Uint32Array(corners),
    size,
  };
}

const COSINES = Array.from({ length: SIDES }, (_, k) => Math.cos((2 * Math.PI * k) / SIDES));
const SINES = Array.from({ length: SIDES }, (_, k) => Math.sin((2 * Math.PI * k) / SIDES));

/** Write one line; the ring of each point is turned as little as possible from the one before. */
function tube({ positions, normals }, path, radius, at) {
  const last = path.length - 1;
  let nx = 0;
  let ny = 0;
  let nz = 0;
  for (let i = 0; i <= last; i++) {
    const p = path[i];
    const before = path[Math.max(0, i - 1)];
    const after = path[Math.min(last, i + 1)];
    let tx = after[0] - before[0];
    let ty = after[1] - before[1];
    let tz = after[2] - before[2];
    const length = Math.hypot(tx, ty, tz) || 1;
    tx /= length;
    ty /= length;
    tz /= length;
    if (i === 0) [nx, ny, nz] = Math.abs(tx) < 0.6 ? [1, 0, 0] : [0, 1, 0];
    const along = nx * tx + ny * ty + nz * tz;
    nx -= along * tx;
    ny -= along * ty;
    nz -= along * tz;
    const size = Math.hypot(nx, ny, nz) || 1;
    nx /= size;
    ny /= size;
    nz /= size;
    const [bx, by, bz] = [ty * nz - tz * ny, tz * nx - tx * nz, tx * ny - ty * nx];
    for (let k = 0; k < SIDES; k++, at += 3) {
      const [c, s] = [COSINES[k], SINES[k]];
      normals[at] = c * nx + s * bx;
      normals[at + 1] = c * ny + s * by;
      normals[at + 2] = c * nz + s * bz;
      positions[at] = p[0] + radius * normals[at];
      positions[at + 1] = p[1] + radius * normals[at + 1];
      positions[at + 2] = p[2] + radius * normals[at + 2];
    }
  }
  return at;
}

/**
 * An arrow whose head has the same size at any length, but where VTK makes that of a tiny one smaller.
 * @param {number[]} from
 * @param {number[]} to
 * @param {number} radius of the shaft
 */
export function arrow(from, to, radius) {
  const axis = to.map((value, i) => value - from[i]);
  const length = Math.hypot(...axis);
  const t = axis.map((value) => value / length);
  const n = perpendicular(t);
  const b = [t[1] * n[2] - t[2] * n[1], t[2] * n[0] - t[0] * n[2], t[0] * n[1] - t[1] * n[0]];
  const tip = Math.min(9 * radius, 0.8 * length);
  const [shaft, head] = [Math.min(radius, 5 * length), Math.min(3 * radius, 10 * length)];
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
  const positions = new Float32Array(3 * AROUND * rings.length);
  const normals = new Float32Array(positions.length);
  const corners = [];
  let at = 0;
  rings.forEach(([along, across, up, out], ring) => {
    for (let k = 0; k < AROUND; k++, at += 3) {
      const [c, s] = [Math.cos((2 * Math.PI * k) / AROUND), Math.sin((2 * Math.PI * k) / AROUND)];
      for (let i = 0; i < 3; i++) {
        const outwards = c * n[i] + s * b[i];
        positions[at + i] = from[i] + along * t[i] + across * outwards;
        normals[at + i] = up * t[i] + out * outwards;
      }
      const [here, next] = [ring * AROUND + k, ring * AROUND + ((k + 1) % AROUND)];
      if (ring % 2 === 0)
        corners.push(here, next, here + AROUND, next, next + AROUND, here + AROUND);
    }
  });
  return { positions, normals, corners: new Uint32Array(corners) };
}

function perpendicular(t) {
  const other = Math.abs(t[0]) < 0.6 ? [1, 0, 0] : [0, 1, 0];
  const n = [
    t[1] * other[2] - t[2] * other[1],
    t[2] * other[0] - t[0] * other[2],
    t[0] * other[1] - t[1] * other[0],
  ];
  const length = Math.hypot(...n);
  return n.map((value) => value / length);
}
