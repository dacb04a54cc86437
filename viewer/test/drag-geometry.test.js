import assert from "node:assert/strict";
import { test } from "node:test";
import { Quaternion, Vector3 } from "three";
import {
  alongSphere,
  carried,
  isClosed,
  nearest,
  pointOf,
  rolling,
  spun,
  turned,
} from "../src/drag-geometry.js";
import { stepped } from "../src/pointer.js";
import { near, points, unit, X, Y, Z } from "./near.js";

const EYE = [5, 0, 0];

test("a line of sight meets the near side of the sphere, or leaves it on the far side", () => {
  near(alongSphere(EYE, [-1, 0, 0], 2), [2, 0, 0]);
  near(alongSphere(EYE, [-1, 0, 0], 2, true), [-2, 0, 0]);
  const [x, y, z] = alongSphere(EYE, unit([-4, 0, 1]), 1.5);
  near([Math.hypot(x, y, z), z / (5 - x)], [1.5, 1 / 4]);
  assert.ok(x > 0);
});

test("beside the sphere a point slides along the rim, which both sides share", () => {
  for (const angle of [0.1, 2, 3]) {
    const direction = unit([-1, 2 * Math.cos(angle), 2 * Math.sin(angle)]);
    for (const far of [false, true]) {
      const [x, y, z] = alongSphere(EYE, direction, 1, far);
      near([x, Math.hypot(x, y, z), Math.atan2(z, y)], [1 / 5, 1, angle]);
    }
  }
});

const SQUARE = points("0,0 4,0 4,4 0,4 0,0");

test("a path gives the point of a share, and the share of what is nearest to a place", () => {
  near(pointOf(SQUARE, 0.375), [4, 2]);
  near(pointOf(SQUARE, 1), [0, 0]);
  const share = (path, ...where) => nearest(path, ...where).share;
  near([share(SQUARE, [5, 2]), share(SQUARE, [1, 5])], [0.375, 0.6875]);
  near([share(points("0,0 0,0 2,0"), [1, 3])], [0.75]);
  // An open path ends; a closed one goes on.
  assert.ok(isClosed(SQUARE) && !isClosed(SQUARE.slice(1)));
  near([share(SQUARE, [-1, 3.9], 0.02, 0.2)], [0]);
  near([share(SQUARE, [-1, 1], 0.02, 0.2, true)], [-0.0625]);
  near([share(SQUARE, [1, -1], 0.98, 0.2, true)], [1.0625]);
  // Where it runs twice along one way, the finger stays on its own.
  const there_and_back = points("0,0 4,0 0,0");
  for (const [about, wanted] of points("0.2,0.125 0.8,0.875")) {
    near([share(there_and_back, [1, 1], about, 0.2)], [wanted]);
  }
});

test("a ball rolls under a finger: what is under it stays there, and the rim turns it in the picture", () => {
  near(rolling([0, 0], [0.6, 0]), [0, Math.asin(0.6), 0]);
  near(rolling([0, 0], [0, 0.6]), [-Math.asin(0.6), 0, 0]);
  near(rolling([0.3, 0.2], [0.3, 0.2]), [0, 0, 0]);
  // Far out the slope is almost level, so a quarter round turns by almost a quarter about the line of sight.
  near(rolling([1e3, 0], [0, 1e3]), [0, 0, Math.PI / 2], 1e-2);
});

test("a point of a body goes on a circle about the axis of the body's path", () => {
  const round = Array.from({ length: 25 }, (_, k) => {
    const angle = (k * Math.PI) / 12;
    return [1 + 2 * Math.cos(angle), 3, 5 - 2 * Math.sin(angle)];
  });
  // At a quarter of the path the body points down; the point sticks out from it.
  const way = carried(round, [1, 3.5, 3.8], 0.25);
  assert.equal(way.length, 25);
  near([way[6], way[0], way[12]], points("1,3.5,3.8 2.2,3.5,5 -0.2,3.5,5"));
  near(pointOf(way, 0.75), [1, 3.5, 6.2]);
  assert.equal(carried(round, [1.1, 9, 5], 0.25), round);
});

test("an arrow key moves a point to where it says", () => {
  near(turned([1, 0, 0], [Y, Z, X], [1, 0], 0.1), [Math.cos(0.1), Math.sin(0.1), 0]);
  near(turned([1, 0, 0], [Y, Z, X], [0, 1], 0.1), [Math.cos(0.1), 0, Math.sin(0.1)]);
  near(turned([0, 2, 0], [Y, Z, X], [0, -1], 0.1), [0, 2, 0]);
  const [right, up] = [unit([1, 2, 2]), unit([-2, -1, 2])];
  const wanted = new Vector3(3, 1, 2).applyAxisAngle(new Vector3(...up), 0.7);
  near(turned([3, 1, 2], [right, up, []], [1, 0], 0.7), wanted.toArray());
});

test("a body turns as the camera sees it", () => {
  const [x, y, z, w] = new Quaternion().setFromAxisAngle(new Vector3(...unit([1, -2, 3])), 2);
  const turn = [0.1, 0.3, -0.2];
  const by = new Quaternion().setFromAxisAngle(new Vector3(...unit(turn)), Math.hypot(...turn));
  const wanted = by.multiply(new Quaternion(x, y, z, w));
  near(spun([w, x, y, z], [Y, Z, X], [0.3, -0.2, 0.1]), [wanted.w, wanted.x, wanted.y, wanted.z]);
  near(spun([w, x, y, z], [Y, Z, X], [0, 0, 0]), [w, x, y, z]);
});

test("a number goes to the nearest step of its slider, and not beyond its ends", () => {
  const spec = { low: 1, high: 3, step: 0.5 };
  const found = [1.8, 2.2, 9, -9].map((number) => stepped(spec, number));
  near(found, [2, 2, 3, 1]);
});
