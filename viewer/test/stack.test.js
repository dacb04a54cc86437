import assert from "node:assert/strict";
import { test } from "node:test";
import { Sphere, Vector3 } from "three";
import { Aim, lens } from "../src/aim.js";
import { project } from "../src/labels.js";
import { Rows, rowOf, stacked, toBox, toPicture, WHOLE } from "../src/stack.js";
import { near, points, unit, X, Y, Z } from "./near.js";

// Left a ball, right a spoon, which is half as wide in a stack that is as high as twice its width.
const ROWS = [
  { from: [-0.1, 0.2, 0.6, 0.6], to: [0, 0, 1, 0.6] },
  { from: [0.4, 0.1, 0.5, 0.8], to: [0.25, 0.6, 0.5, 0.4] },
];
const PHONE = { width: 300, height: 600 };
const POSE = { position: [4, -2, 2], target: [0, 0, 0.1], up: Z, viewAngle: 30, aspect: 1.5 };

/** A camera, and how it turns about what it looks at. */
function aimed() {
  const aim = new Aim(POSE, new Sphere(new Vector3(), 1.2), [[...X, -1, 0, 0, ...Y, ...Z]]);
  const turn = (x, y, z) => {
    aim.camera.position.set(x, y, z);
    aim.camera.lookAt(new Vector3(...POSE.target));
    aim.fit(POSE.aspect);
  };
  return { aim, turn };
}

test("only a box that is higher than wide has a stack", () => {
  assert.equal(stacked(ROWS, 0.5, { width: 600, height: 400 }), WHOLE);
  assert.equal(stacked(undefined, undefined, PHONE), WHOLE);
  assert.deepEqual(stacked(ROWS, 0.5, PHONE)[0], ROWS[0]);
});

test("a stack stands in the middle of a box of another shape, as a whole", () => {
  // 300 x 600 of 300 x 800, and of 400 x 600; the narrower row shows what is beside its part, too.
  const high = stacked(ROWS, 0.5, { width: 300, height: 800 })[1];
  const broad = stacked(ROWS, 0.5, { width: 400, height: 600 })[1];
  near(high.to, [0, 1 / 8 + 0.45, 1, 0.3]);
  near(high.from, [0.15, 0.1, 1, 0.8]);
  near(broad.to, [0, 0.6, 1, 0.4]);
  near(toPicture(broad, 1 / 8 + 0.1875, 0.6), [0.4, 0.1]);
  near(toPicture(broad, 1 / 8 + 0.1875 + 0.375, 1), [0.9, 0.9]);
});

test("a place goes with the row in whose part it lies deeper", () => {
  const rows = [0.44, 0.46, 2].map((left) => rowOf(ROWS, { left }));
  assert.deepEqual(rows, [0, 1, 1]);
  assert.equal(rowOf(WHOLE, { left: 2 }), 0);
});

test("a place of the picture is found in the box, and back", () => {
  const place = { left: 0.65, top: 0.5, inside: true };
  assert.deepEqual(toBox(ROWS[1], place), { left: 0.5, top: 0.8, inside: true });
  near(toPicture(ROWS[1], 0.5, 0.8), [0.65, 0.5]);
  assert.deepEqual(toBox(WHOLE[0], place), place);
  // Outside of its row, though within another, and outside of the picture.
  for (const other of [{ left: 0.35 }, { top: 0.05 }, { inside: false }]) {
    assert.equal(toBox(ROWS[1], { ...place, ...other }).inside, false);
  }
});

test("through a place of the picture one sees what is there, wherever the camera has gone", () => {
  const { aim, turn } = aimed();
  near([aim.distance], [Math.hypot(4, -2, 1.9)]);
  for (const eye of points("4,-2,2 -3,1,-3")) {
    turn(...eye);
    const point = aim.eye().map((x, k) => x + 3 * aim.through(0.3, 0.8)[k]);
    const { left, top } = project(lens(aim.camera), point);
    near([left, top], [0.3, 0.8]);
  }
  assert.ok(aim.widen(1.5) && !aim.widen(1.5));
  near([aim.around.radius], [1.8]);
});

test("a row shows what it showed at rest, in its middle and as large; without a stack there is one", () => {
  const { aim, turn } = aimed();
  const rows = new Rows({ rows: ROWS, aspect: 0.5 }, aim);
  rows.fit(PHONE);
  const middles = ROWS.map(({ from }) => aim.middleOf(from));
  const sizes = [];
  for (const eye of points("4,-2,2 3,3,-1")) {
    turn(...eye);
    rows.follow();
    for (const [i, { to }] of ROWS.entries()) {
      assert.equal(rows.at(middles[i]), i);
      const { left, top } = rows.project(middles[i]);
      near([left, top], [0.5, to[1] + to[3] / 2]);
      const [right] = aim.axes();
      const beside = middles[i].map((x, k) => x + 0.1 * right[k]);
      sizes.push(rows.project(beside, middles[i]).left - left);
      const { direction } = rows.sight(left, top, middles[i]);
      const way = middles[i].map((x, k) => x - aim.eye()[k]);
      near(direction, unit(way));
    }
  }
  near([sizes[0] / sizes[1]], [sizes[2] / sizes[3]]);
  rows.fit({ width: 600, height: 400 });
  rows.follow();
  assert.equal(rows.now, WHOLE);
  assert.equal(rows.at(middles[1]), 0);
});
