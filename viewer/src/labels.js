/* Where labels are on the screen, which of them are hidden, and how they give way to each other. */

// A label often lies on a surface itself, so its line of sight ends just short of it.
const SHORT = 1 - 1e-3;
// Two crossings this close together lie on the edge that two faces share.
const SAME = 1e-6;
// How often labels that lie on each other are moved apart, before they have to stay.
const ROUNDS = 20;

/**
 * Project a point.
 * @param {ArrayLike<number>} matrix projection times view, by columns
 * @param {number[]} point
 * @returns {{left: number, top: number, inside: boolean}} fractions of the picture's size, and
 *   whether the picture shows the point
 */
export function project(matrix, [x, y, z]) {
  const row = (i) => matrix[i] * x + matrix[i + 4] * y + matrix[i + 8] * z + matrix[i + 12];
  const w = row(3);
  const [left, top] = [(1 + row(0) / w) / 2, (1 - row(1) / w) / 2];
  const inside = w > 0 && Math.max(Math.abs(left - 0.5), Math.abs(top - 0.5)) <= 0.5;
  return { left, top, inside };
}

/**
 * Count how often the segment from one point to another crosses a surface, up to a limit.
 * @param {{positions: ArrayLike<number>, corners: ArrayLike<number>}} surface three corners a face
 * @param {number[]} from
 * @param {number[]} to
 * @param {number} limit
 */
export function crossings({ positions, corners }, from, to, limit = Infinity) {
  const [ox, oy, oz] = from;
  const [dx, dy, dz] = to.map((value, i) => value - from[i]);
  const found = [];
  for (let i = 0; i < corners.length && found.length < limit; i += 3) {
    const a = 3 * corners[i];
    const b = 3 * corners[i + 1];
    const c = 3 * corners[i + 2];
    // Möller and Trumbore: the edges e and f, and the vector s from their corner.
    const ex = positions[b] - positions[a];
    const ey = positions[b + 1] - positions[a + 1];
    const ez = positions[b + 2] - positions[a + 2];
    const fx = positions[c] - positions[a];
    const fy = positions[c + 1] - positions[a + 1];
    const fz = positions[c + 2] - positions[a + 2];
    const px = dy * fz - dz * fy;
    const py = dz * fx - dx * fz;
    const pz = dx * fy - dy * fx;
    const volume = ex * px + ey * py + ez * pz;
    if (volume === 0) continue;
    const sx = ox - positions[a];
    const sy = oy - positions[a + 1];
    const sz = oz - positions[a + 2];
    const u = (sx * px + sy * py + sz * pz) / volume;
    if (u < 0 || u > 1) continue;
    const qx = sy * ez - sz * ey;
    const qy = sz * ex - sx * ez;
    const qz = sx * ey - sy * ex;
    const v = (dx * qx + dy * qy + dz * qz) / volume;
    if (v < 0 || u + v > 1) continue;
    const t = (fx * qx + fy * qy + fz * qz) / volume;
    if (t > 0 && t < 1 && !found.some((other) => Math.abs(other - t) < SAME)) found.push(t);
  }
  return found.length;
}

/**
 * Tell whether surfaces come between the eye and a point. One opaque surface hides all that lies
 * behind it. A see-through surface does so only where the line of sight goes in and out again, so the
 * inside of a glass ball keeps its labels.
 */
export function isHidden(surfaces, eye, point) {
  const end = point.map((value, i) => eye[i] + (value - eye[i]) * SHORT);
  return surfaces.some((surface) => {
    const enough = surface.seeThrough ? 2 : 1;
    return crossings(surface, eye, end, enough) >= enough;
  });
}

/**
 * Move labels apart that lie on each other, each by half of the shorter way. The push grows from nothing
 * with the overlap, so that labels do not leap while a point is dragged.
 * @param {{x: number, y: number, width: number, height: number}[]} boxes by their middles
 * @returns {{x: number, y: number}[]} how far each label moves
 */
export function apart(boxes) {
  const moved = boxes.map(({ x, y }) => ({ x, y }));
  const push = (i, j) => {
    const [dx, dy] = [moved[j].x - moved[i].x, moved[j].y - moved[i].y];
    const across = (boxes[i].width + boxes[j].width) / 2 - Math.abs(dx);
    const down = (boxes[i].height + boxes[j].height) / 2 - Math.abs(dy);
    if (across <= 0 || down <= 0) return false;
    const [axis, overlap, way] = across < down ? ["x", across, dx] : ["y", down, dy];
    const step = (way < 0 ? -overlap : overlap) / 2;
    moved[i][axis] -= step;
    moved[j][axis] += step;
    return true;
  };
  const pairs = boxes.flatMap((_, j) => boxes.slice(0, j).map((_, i) => [i, j]));
  for (let round = 0; round < ROUNDS; round++) {
    if (!pairs.map(([i, j]) => push(i, j)).includes(true)) break;
  }
  return moved.map(({ x, y }, i) => ({ x: x - boxes[i].x, y: y - boxes[i].y }));
}
