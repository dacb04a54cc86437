import assert from "node:assert/strict";
import { test } from "node:test";
import { alongPlane, alongSphere } from "../src/drag.js";
import { fromText, toText } from "../src/link.js";
import { arrow, tubes } from "../src/shapes.js";

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

const FIGURE = {
  name: "some-figure",
  start: { u: 0.5, points: [[1, 0, 0], [0, 1, 0]], one: [0, 0, 1], on: false, way: "short" },
  inputs: {
    u: { kind: "number", low: 0, high: 1 },
    points: { kind: "points", names: ["P", "Q", "R"], least: 2, most: 3 },
    one: { kind: "points", names: "N" },
    on: { kind: "switch" },
    way: { kind: "choice", options: ["short", "long"] },
  },
};

test("the address holds what differs from the start, and gives it back", () => {
  const state = {
    u: 0.25,
    points: [[1, 0, 0], [0, 0.6, -0.8], [0, 0, 1]],
    one: [0, 0, 1],
    on: true,
    way: "long",
  };
  const text = toText(state, FIGURE.start);
  assert.ok(!text.includes("one="));
  const found = fromText(`#explore-some-figure?${text}`, FIGURE);
  assert.deepEqual({ ...FIGURE.start, ...found }, state);
  assert.equal(toText(FIGURE.start, FIGURE.start), "");
});

test("an address that makes no sense changes nothing", () => {
  for (const text of [
    "u=2",
    "u=x",
    "way=round",
    "other=1",
    "one=0,0,0",
    "one=1,2",
    "points=1,0,0",
    "points=1,0,0 0,1,0 0,0,1 1,1,0",
    "points=1,0,0 0,x,0",
  ]) {
    assert.equal(fromText(`#explore-some-figure?${text}`, FIGURE), null, text);
  }
  assert.equal(fromText("#explore-another?u=0.1", FIGURE), null);
  assert.equal(fromText("#some-figure", FIGURE), null);
});

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
