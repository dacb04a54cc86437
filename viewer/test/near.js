/* What the tests share: points, written as in addresses, and comparing numbers. */
import assert from "node:assert/strict";

/** The points of a text, by blanks; their coordinates are separated by commas. */
export const points = (text) => text.split(" ").map((point) => point.split(",").map(Number));
export const unit = (point) => point.map((x) => x / Math.hypot(...point));
export const [X, Y, Z] = points("1,0,0 0,1,0 0,0,1");

/** Numbers, in lists of one form, differ by little. */
export function near(mine, wanted, within = 1e-9) {
  const [a, b] = [[...mine].flat(9), [...wanted].flat(9)];
  assert.equal(a.length, b.length);
  for (const [i, x] of a.entries()) assert.ok(Math.abs(x - b[i]) < within, `${a} is not ${b}`);
}
