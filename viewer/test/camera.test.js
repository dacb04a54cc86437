import assert from "node:assert/strict";
import { test } from "node:test";
import { clipping, fieldOfView, outermost, reach, turned, widened } from "../src/camera.js";

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

const AXES = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

test("the outermost points are those at the corners, as seen from the center", () => {
  const corners = [-1, 1].flatMap((x) => [-1, 1].flatMap((y) => [-1, 1].map((z) => [x, y, z])));
  const inner = corners.map((corner) => corner.map((x) => x / 2));
  const found = outermost([inner.flat(), corners.flat()], [1, 1, 1]);
  const names = new Set(found.map(String));
  assert.deepEqual(names, new Set(corners.map((corner) => String(corner.map((x) => x - 1)))));
});

test("a ball reaches as far whichever way it is turned", () => {
  const ball = Array.from({ length: 30000 }, (_, i) => Math.sin(i * i));
  for (let i = 0; i < ball.length; i += 3) {
    const length = Math.hypot(ball[i], ball[i + 1], ball[i + 2]);
    for (let k = 0; k < 3; k += 1) ball[i + k] /= length;
  }
  for (const end of outermost([ball], [0, 0, 0])) assert.ok(Math.hypot(...end) > 0.999);
  const ends = outermost([ball], [0, 0, 0]);
  const [x, y, z] = AXES;
  const ways = [AXES, [y, z, x], [z, x, y]].map((axes) => reach(ends, axes, 10, [1, 1]));
  assert.ok(Math.max(...ways) / Math.min(...ways) < 1.05, `${ways}`);
});

test("what is at the border of the picture reaches 1", () => {
  // Five in front of a camera whose picture is 4 wide and 2 high at distance 1.
  close(reach([[10, 0, 0]], AXES, 5, [2, 1]), 1);
  close(reach([[0, -5, 0]], AXES, 5, [2, 1]), 1);
  close(reach([[0, 2, 3]], AXES, 5, [2, 1]), 1);
  close(
    reach(
      [
        [0, 2, 3],
        [1, 1, 0],
      ],
      AXES,
      5,
      [2, 1],
    ),
    1,
  );
});

test("the view stays as it is while the scene fits, and widens by as much as it would be cut", () => {
  close(widened(30, 0.5, 0.9), 30);
  close(widened(30, 0.92, 0.5), 30);
  close(widened(30, 1.2, 1.2), 30);
  const tan = (angle) => Math.tan((angle * Math.PI) / 360);
  close(tan(widened(30, 2.4, 1.2)), 2 * tan(30));
});

test("an arrow key moves a point to where it says", () => {
  const axes = [
    [0, 1, 0],
    [0, 0, 1],
    [1, 0, 0],
  ];
  const near = (mine, wanted) => mine.forEach((x, i) => close(x, wanted[i]));
  near(turned([1, 0, 0], axes, [1, 0], 0.1), [Math.cos(0.1), Math.sin(0.1), 0]);
  near(turned([1, 0, 0], axes, [0, 1], 0.1), [Math.cos(0.1), 0, Math.sin(0.1)]);
  near(turned([0, 2, 0], axes, [0, -1], 0.1), [0, 2, 0]);
});
