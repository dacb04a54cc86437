/* Vectors of three numbers, as lists. */

export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

export const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/** The point that lies so far from another in a direction. */
export const along = (point, distance, direction) => [
  point[0] + distance * direction[0],
  point[1] + distance * direction[1],
  point[2] + distance * direction[2],
];

/** A vector of length 1; one of length 0 stays. */
export function unit(vector) {
  const length = Math.sqrt(vector.reduce((sum, x) => sum + x * x, 0)) || 1;
  return vector.map((x) => x / length);
}
