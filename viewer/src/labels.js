/* Where labels are on the screen, which of them are hidden, and how they give way to each other. */
import { Ray, Vector3 } from "three";

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

const ray = new Ray();
const face = [new Vector3(), new Vector3(), new Vector3()];
const place = new Vector3();

/**
 * Count how often the segment from one point to another crosses a surface, up to a limit. Most miss the
 * sphere around it, and none of its faces is looked at.
 * @param {import("./types.js").Surface} surface
 * @param {number[]} from
 * @param {number[]} to
 */
export function crossings({ positions, corners, around }, from, to, limit = Infinity) {
  ray.origin.fromArray(from);
  const length = ray.direction.fromArray(to).sub(ray.origin).length();
  ray.direction.divideScalar(length);
  if (!ray.intersectsSphere(around)) return 0;
  const [a, b, c] = face;
  const found = [];
  for (let i = 0; i < corners.length && found.length < limit; i += 3) {
    a.fromArray(positions, 3 * corners[i]);
    b.fromArray(positions, 3 * corners[i + 1]);
    c.fromArray(positions, 3 * corners[i + 2]);
    if (!ray.intersectTriangle(a, b, c, false, place)) continue;
    const share = place.distanceTo(ray.origin) / length;
    if (share < 1 && !found.some((other) => Math.abs(other - share) < SAME)) found.push(share);
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
