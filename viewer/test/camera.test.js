import assert from "node:assert/strict";
import { test } from "node:test";
import { clipping, fieldOfView } from "../src/camera.js";

const close = (a, b) => assert.ok(Math.abs(a - b) < 1e-9, `${a} is not ${b}`);

test("a box of the poster's shape has the poster's field of view", () => {
  close(fieldOfView(30, 1.5, 1.5), 30);
});

test("a wider box shows the same height, and more at the sides", () => {
  close(fieldOfView(30, 1.5, 3), 30);
});

test("a narrower box shows the same width, and more above and below", () => {
  const width = (angle, aspect) => Math.tan((angle * Math.PI) / 360) * aspect;
  close(width(fieldOfView(30, 1.5, 0.5), 0.5), width(30, 1.5));
});

test("clipping leaves everything in, from outside and from inside", () => {
  const outside = clipping(5, 1);
  assert.ok(outside.near < 4 && outside.near > 3.9 && outside.far > 6);
  const inside = clipping(0.5, 1);
  assert.ok(inside.near > 0 && inside.near < 0.01 && inside.far > 1.5);
});
