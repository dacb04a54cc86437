import assert from "node:assert/strict";
import { test } from "node:test";
import { added } from "../src/points.js";
import { near, points } from "./near.js";

test("a point is added in the middle of the widest gap, which may be the last", () => {
  for (const [text, at, wanted] of [
    ["1,0,0 0,1,0 0.6,0.8,0", 1, [Math.SQRT1_2, Math.SQRT1_2, 0]],
    ["1,0,0 0.8,0.6,0 0,1,0 -1,0,0", 4, [0, -1, 0]],
    ["2,0,0 1.6,1.2,0 1.2,1.6,0", 3, [4 / Math.sqrt(5), 2 / Math.sqrt(5), 0]],
  ]) {
    const made = added(points(text));
    near(made.splice(at, 1), wanted);
    assert.deepEqual(made, points(text));
  }
});

test("between opposite points a new one stands away from the others, or anywhere across", () => {
  near(added(points("0.6,0,0.8 0,1,0 -0.6,0,-0.8"))[3], [0, -1, 0]);
  const [x, y, z] = added(points("0.6,0,0.8 -0.6,0,-0.8"))[1];
  near([Math.hypot(x, y, z), 0.6 * x + 0.8 * z], [1, 0]);
});
