import assert from "node:assert/strict";
import { test } from "node:test";
import { extent, rowOf, stacked, toBox, toPicture, WHOLE } from "../src/stack.js";

// Left a ball, right a spoon, which is half as wide in a stack that is as high as twice its width.
const ROWS = [
  { from: [-0.1, 0.2, 0.6, 0.6], to: [0, 0, 1, 0.6] },
  { from: [0.4, 0.1, 0.5, 0.8], to: [0.25, 0.6, 0.5, 0.4] },
];
const PHONE = { width: 300, height: 600 };
const close = (found, wanted) => found.forEach((x, i) => assert.ok(Math.abs(x - wanted[i]) < 1e-12));

test("only a box that is higher than wide has a stack", () => {
  assert.equal(stacked(ROWS, 0.5, { width: 600, height: 400 }), WHOLE);
  assert.equal(stacked(undefined, undefined, PHONE), WHOLE);
  assert.deepEqual(stacked(ROWS, 0.5, PHONE), ROWS);
});

test("a stack stands in the middle of a box of another shape, as a whole", () => {
  // 300 x 600 of 300 x 800, and of 400 x 600.
  close(stacked(ROWS, 0.5, { width: 300, height: 800 })[1].to, [0.25, 1 / 8 + 0.45, 0.5, 0.3]);
  close(stacked(ROWS, 0.5, { width: 400, height: 600 })[1].to, [1 / 8 + 0.1875, 0.6, 0.375, 0.4]);
});

test("a place goes with the row in whose part it lies deeper", () => {
  assert.equal(rowOf(ROWS, { left: 0.44 }), ROWS[0]);
  assert.equal(rowOf(ROWS, { left: 0.46 }), ROWS[1]);
  assert.equal(rowOf(ROWS, { left: 2 }), ROWS[1]);
  close(extent(ROWS, ROWS[0]), [0, 0.55 / 0.6]);
  close(extent(ROWS, ROWS[1]), [0.1, 1]);
  close(extent(WHOLE, WHOLE[0]), [0, 1]);
});

test("a place of the picture is found in the box, and back", () => {
  const place = { left: 0.65, top: 0.5, inside: true };
  assert.deepEqual(toBox(ROWS, place), { left: 0.5, top: 0.8, inside: true });
  close(toPicture(ROWS[1], 0.5, 0.8), [0.65, 0.5]);
  assert.deepEqual(toBox(WHOLE, place), place);
  // Outside of its row, and of the picture.
  assert.equal(toBox(ROWS, { ...place, top: 0.05 }).inside, false);
  assert.equal(toBox(ROWS, { ...place, inside: false }).inside, false);
});
