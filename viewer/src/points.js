/* A point more among those that the hand has set. */

// Points whose sum is a smaller share of their length lie opposite each other.
const OPPOSITE = 1e-6;

/** A new point in the middle of the widest gap of a closed sequence. */
export function added(points) {
  const after = (i) => points[(i + 1) % points.length];
  const gaps = points.map((point, i) => Math.hypot(...point.map((x, k) => x - after(i)[k])));
  const widest = gaps.indexOf(Math.max(...gaps));
  const size = Math.hypot(...points[widest]);
  const sum = points[widest].map((x, k) => x + after(widest)[k]);
  const between = Math.hypot(...sum) > OPPOSITE * size ? sum : away(points, widest);
  const scale = size / Math.hypot(...between);
  return points.toSpliced(
    widest + 1,
    0,
    between.map((x) => x * scale),
  );
}

/** A direction at right angles to a point: away from all points or, where these balance, any. */
function away(points, from) {
  const point = points[from];
  const dot = (p, q) => p.reduce((sum, x, k) => sum + x * q[k], 0);
  const outwards = point.map((_, k) => points.reduce((sum, other) => sum - other[k], 0));
  const axes = point.map((_, i) => point.map((_, k) => Number(i === k)));
  return [outwards, ...axes]
    .map((way) => way.map((x, k) => x - (dot(way, point) / dot(point, point)) * point[k]))
    .find((way) => Math.hypot(...way) > OPPOSITE * Math.hypot(...point));
}
