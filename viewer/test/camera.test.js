import assert from "node:assert/strict";
import { test } from "node:test";
import { clipping, fieldOfView, outermost, reach, widened } from "../src/camera.js";
import { near, points, unit, X, Y, Z } from "./near.js";

const close = (a, b) => near([a], [b]);
const tan = (angle) => Math.tan((angle * Math.PI) / 360);

test("a box of another shape shows the whole poster, and more at the sides or above and below", () => {
  close(fieldOfView(30, 1.5, 1.5), 30);
  close(fieldOfView(30, 1.5, 3), 30);
  close(0.5 * tan(fieldOfView(30, 1.5, 0.5)), 1.5 * tan(30));
});

test("clipping leaves everything in, from outside and from inside", () => {
  const outside = clipping(5, 1);
  assert.ok(outside.near < 4 && outside.near > 3.9 && outside.far > 6);
  const inside = clipping(0.5, 1);
  assert.ok(inside.near > 0 && inside.near < 0.01 && inside.far > 1.5);
});

test("the outermost points are those at the corners, as seen from the center", () => {
  const corners = points("-1,-1,-1 -1,-1,1 -1,1,-1 -1,1,1 1,-1,-1 1,-1,1 1,1,-1 1,1,1");
  const inner = corners.map((corner) => corner.map((x) => x / 2));
  const found = outermost([inner.flat(), corners.flat()], [1, 1, 1]);
  const wanted = corners.map((corner) => String(corner.map((x) => x - 1)));
  assert.deepEqual(new Set(found.map(String)), new Set(wanted));
});

test("a ball reaches as far whichever way it is turned", () => {
  const ball = Array.from({ length: 10_000 }, (_, i) =>
    unit([0, 1, 2].map((k) => Math.sin((3 * i + k) ** 2))),
  );
  const ends = outermost([ball.flat()], [0, 0, 0]);
  for (const end of ends) assert.ok(Math.hypot(...end) > 0.999);
  const turned = [
    [X, Y, Z],
    [Y, Z, X],
    [Z, X, Y],
  ];
  const ways = turned.map((axes) => reach(ends, axes, 10, [1, 1]));
  assert.ok(Math.max(...ways) / Math.min(...ways) < 1.05, `${ways}`);
});

test("what is at the border of the picture reaches 1", () => {
  // Five in front of a camera whose picture is 4 wide and 2 high at distance 1.
  for (const ends of ["10,0,0", "0,-5,0", "0,2,3", "0,2,3 1,1,0"]) {
    close(reach(points(ends), [X, Y, Z], 5, [2, 1]), 1);
  }
});

test("the view stays as it is while the scene fits, and widens by as much as it would be cut", () => {
  close(widened(30, 0.5, 0.9), 30);
  close(widened(30, 0.92, 0.5), 30);
  close(widened(30, 1.2, 1.2), 30);
  close(tan(widened(30, 2.4, 1.2)), 2 * tan(30));
});
