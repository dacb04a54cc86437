import assert from "node:assert/strict";
import { test } from "node:test";
import { rowOf, stacked, toBox, toPicture, WHOLE } from "../src/stack.js";

// Left a ball, right a spoon, which is half as wide in a stack that is as high as twice its width.
const ROWS = [
  { from: [-0.1, 0.2, 0.6, 0.6], to: [0, 0, 1, 0.6] },
  { from: [0.4, 0.1, 0.5, 0.8], to: [0.25, 0.6, 0.5, 0.4] },
];
const PHONE = { width: 300, height: 600 };
const close = (found, wanted) =>
  found.forEach((x, i) => assert.ok(Math.abs(x - wanted[i]) < 1e-12));

test("only a box that is higher than wide has a stack", () => {
  assert.equal(stacked(ROWS, 0.5, { width: 600, height: 400 }), WHOLE);
  assert.equal(stacked(undefined, undefined, PHONE), WHOLE);
  assert.deepEqual(stacked(ROWS, 0.5, PHONE)[0], ROWS[0]);
});

test("a stack stands in the middle of a box of another shape, as a whole", () => {
  // 300 x 600 of 300 x 800, and of 400 x 600; the narrower row shows what is beside its part, too.
  const [high, broad] = [
    { width: 300, height: 800 },
    { width: 400, height: 600 },
  ].map((box) => stacked(ROWS, 0.5, box)[1]);
  close(high.to, [0, 1 / 8 + 0.45, 1, 0.3]);
  close(high.from, [0.15, 0.1, 1, 0.8]);
  close(broad.to, [0, 0.6, 1, 0.4]);
  close(toPicture(broad, 1 / 8 + 0.1875, 0.6), [0.4, 0.1]);
  close(toPicture(broad, 1 / 8 + 0.1875 + 0.375, 1), [0.9, 0.9]);
});

test("a place goes with the row in whose part it lies deeper", () => {
  assert.equal(rowOf(ROWS, { left: 0.44 }), 0);
  assert.equal(rowOf(ROWS, { left: 0.46 }), 1);
  assert.equal(rowOf(ROWS, { left: 2 }), 1);
  assert.equal(rowOf(WHOLE, { left: 2 }), 0);
});

test("a place of the picture is found in the box, and back", () => {
  const place = { left: 0.65, top: 0.5, inside: true };
  assert.deepEqual(toBox(ROWS[1], place), { left: 0.5, top: 0.8, inside: true });
  close(toPicture(ROWS[1], 0.5, 0.8), [0.65, 0.5]);
  assert.deepEqual(toBox(WHOLE[0], place), place);
  // Outside of its row, though within another, and outside of the picture.
  assert.equal(toBox(ROWS[1], { ...place, left: 0.35 }).inside, false);
  assert.equal(toBox(ROWS[1], { ...place, top: 0.05 }).inside, false);
  assert.equal(toBox(ROWS[1], { ...place, inside: false }).inside, false);
});
