import assert from "node:assert/strict";
import { test } from "node:test";
import { alongSphere, carried, isClosed, nearest, pointOf, rolling } from "../src/drag-geometry.js";

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

test("a line of sight leaves the sphere on its far side, whose rim is the same", () => {
  near(alongSphere(EYE, [-1, 0, 0], 2, true), [-2, 0, 0]);
  const aside = [-1, 1, 0].map((x) => x / Math.sqrt(2));
  near(alongSphere(EYE, aside, 1, true), alongSphere(EYE, aside, 1));
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

const SQUARE = [
  [0, 0],
  [4, 0],
  [4, 4],
  [0, 4],
  [0, 0],
];

test("a path gives the point of a share, and the share of what is nearest to a place", () => {
  near(pointOf(SQUARE, 0.375), [4, 2]);
  near(pointOf(SQUARE, 1), [0, 0]);
  near([nearest(SQUARE, [5, 2]).share], [0.375]);
  near([nearest(SQUARE, [1, 5]).share], [0.6875]);
  near(
    [
      nearest(
        [
          [0, 0],
          [0, 0],
          [2, 0],
        ],
        [1, 3],
      ).share,
    ],
    [0.75],
  );
});

test("an open path ends; a closed one goes on", () => {
  assert.ok(isClosed(SQUARE) && !isClosed(SQUARE.slice(1)));
  near([nearest(SQUARE, [-1, 3.9], 0.02, 0.2).share], [0]);
  near([nearest(SQUARE, [-1, 1], 0.02, 0.2, true).share], [-0.0625]);
  near([nearest(SQUARE, [1, -1], 0.98, 0.2, true).share], [1.0625]);
});

test("where a path runs twice along one way, the finger stays on its own", () => {
  const there_and_back = [
    [0, 0],
    [4, 0],
    [0, 0],
  ];
  near([nearest(there_and_back, [1, 1], 0.2, 0.2).share], [0.125]);
  near([nearest(there_and_back, [1, 1], 0.8, 0.2).share], [0.875]);
});

test("a ball rolls under a finger: what is under it stays there, and the rim turns it in the picture", () => {
  near(rolling([0, 0], [0.6, 0]), [0, Math.asin(0.6), 0]);
  near(rolling([0, 0], [0, 0.6]), [-Math.asin(0.6), 0, 0]);
  near(rolling([0.3, 0.2], [0.3, 0.2]), [0, 0, 0]);
  // Far out the slope is almost level, so a quarter round turns by almost a quarter about the line of sight.
  const [x, y, z] = rolling([1e3, 0], [0, 1e3]);
  near([x, y, z], [0, 0, Math.PI / 2], 1e-2);
});

test("a point of a body goes on a circle about the axis of the body's path", () => {
  const round = Array.from({ length: 25 }, (_, k) => {
    const angle = (k * Math.PI) / 12;
    return [1 + 2 * Math.cos(angle), 3, 5 - 2 * Math.sin(angle)];
  });
  // At a quarter of the path the body points down; the point sticks out from it.
  const way = carried(round, [1, 3.5, 3.8], 0.25);
  assert.equal(way.length, 25);
  near(way[6], [1, 3.5, 3.8]);
  near(way[0], [2.2, 3.5, 5]);
  near(way[12], [-0.2, 3.5, 5]);
  near(pointOf(way, 0.75), [1, 3.5, 6.2]);
  assert.equal(carried(round, [1.1, 9, 5], 0.25), round);
});
