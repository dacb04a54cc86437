import assert from "node:assert/strict";
import { test } from "node:test";
import { alongPlane, alongSphere } from "../src/drag.js";

const near = (mine, wanted, within = 1e-12) =>
  mine.forEach((x, i) => assert.ok(Math.abs(x - wanted[i]) < within, `${mine} is not ${wanted}`));
const EYE = [5, 0, 0];

test("a line of sight meets the near side of the sphere", () => {
  near(alongSphere(EYE, [-1, 0, 0], 2), [2, 0, 0]);
  const towards = [-4, 0, 1].map((x) => x / Math.hypot(4, 1));
  const hit = alongSphere(EYE, towards, 1.5);
  assert.ok(Math.abs(Math.hypot(...hit) - 1.5) < 1e-12);
  const [x, , z] = hit;
  assert.ok(Math.abs(z / (5 - x) - 1 / 4) < 1e-12);
  assert.ok(x > 0);
});

test("beside the sphere a point slides along the rim", () => {
  for (const angle of [0.1, 2, 4]) {
    const direction = [-1, 2 * Math.cos(angle), 2 * Math.sin(angle)].map((x) => x / Math.sqrt(5));
    const [x, y, z] = alongSphere(EYE, direction, 1);
    near([x], [1 / 5]);
    near([Math.hypot(x, y, z)], [1]);
    near([Math.atan2(z, y)], [angle > Math.PI ? angle - 2 * Math.PI : angle]);
  }
});

test("a line of sight meets a level plane, and above the horizon it points the way", () => {
  near(alongPlane([0, 0, 2], [0.6, 0, -0.8]), [1.5, 0, 0]);
  near(alongPlane([0, 0, -2], [0, 0.6, 0.8]), [0, 1.5, 0]);
  near(alongPlane([0, 0, 2], [0.6, 0, 0.8]), [0.6, 0, 0.8]);
});
