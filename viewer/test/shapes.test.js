import assert from "node:assert/strict";
import { test } from "node:test";
import { arrow, tubes } from "../src/shapes.js";

const near = (mine, wanted, within = 1e-12) =>
  mine.forEach((x, i) => assert.ok(Math.abs(x - wanted[i]) < within, `${mine} is not ${wanted}`));
/** Three numbers of each point. */
function points(array) {
  return Array.from({ length: array.length / 3 }, (_, i) => [...array.slice(3 * i, 3 * i + 3)]);
}

test("a tube keeps its distance from its line, and its normals point outwards", () => {
  const line = Array.from({ length: 9 }, (_, i) => [Math.cos(i / 3), Math.sin(i / 3), i / 10]);
  const { positions, normals, corners } = tubes([line, line.slice(0, 2)], 0.1);
  assert.equal(positions.length, 3 * 8 * 11);
  assert.equal(corners.length, 3 * 2 * 8 * (8 + 1));
  const normal = points(normals);
  points(positions).forEach((point, i) => {
    const center = [...line, ...line.slice(0, 2)][Math.floor(i / 8)];
    near(point.map((x, k) => (x - center[k]) / 0.1), normal[i], 1e-5);
    near([Math.hypot(...normal[i])], [1], 1e-6);
  });
});

test("a tube with as many points is written over the old one", () => {
  const old = tubes([[[0, 0, 0], [1, 0, 0]]], 0.1);
  const same = tubes([[[0, 0, 0], [0, 2, 0]]], 0.1, old);
  assert.equal(same.positions, old.positions);
  assert.equal(same.corners, old.corners);
  near([Math.max(...same.positions.filter((_, i) => i % 3 === 1))], [2], 1e-6);
  const longer = tubes([[[0, 0, 0], [1, 0, 0], [2, 0, 0]]], 0.1, old);
  assert.notEqual(longer.positions, old.positions);
});

test("an arrow reaches from one point to the other with a head of one size", () => {
  for (const length of [1, 2]) {
    const { positions } = arrow([1, 0, 0], [1, 0, length], 0.02);
    const all = points(positions);
    near([Math.min(...all.map(([, , z]) => z)), Math.max(...all.map(([, , z]) => z))], [0, length], 1e-6);
    const widest = all.filter(([x, y]) => Math.abs(Math.hypot(x - 1, y) - 0.06) < 1e-6);
    near(widest.map(([, , z]) => z), Array(widest.length).fill(length - 0.18), 1e-6);
    assert.equal(widest.length, 40);
  }
});
