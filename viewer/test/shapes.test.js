import assert from "node:assert/strict";
import { test } from "node:test";
import { arrow, tubes } from "../src/shapes.js";

const near = (mine, wanted, within = 1e-12) =>
  mine.forEach((x, i) => assert.ok(Math.abs(x - wanted[i]) < within, `${mine} is not ${wanted}`));
/** Three numbers of each point. */
function points(array) {
  return Array.from({ length: array.length / 3 }, (_, i) => [...array.slice(3 * i, 3 * i + 3)]);
}

/** A volume by the divergence theorem: openings in planes through the origin take nothing away. */
function volume({ positions, normals, corners }, least = 0.9) {
  const [all, outward] = [points(positions), points(normals)];
  const faces = points(corners).map((face) => {
    const [a, b, c] = face.map((i) => all[i]);
    const [e, f] = [b, c].map((end) => end.map((x, i) => x - a[i]));
    const across = [
      e[1] * f[2] - e[2] * f[1],
      e[2] * f[0] - e[0] * f[2],
      e[0] * f[1] - e[1] * f[0],
    ];
    for (const i of Math.hypot(...across) > 1e-9 ? face : []) {
      assert.ok(dot(across, outward[i]) > least * Math.hypot(...across), `${face} faces inwards`);
    }
    return dot(a, across) / 6;
  });
  return faces.reduce((sum, x) => sum + x);
}

const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
const WAYS = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, -1],
  [0.6, 0, 0.8],
  [0.48, -0.6, 0.64],
  [0.8, -0.36, 0.48],
];
/** The area of a regular polygon. */
const area = (radius, sides) => (sides * radius ** 2 * Math.sin((2 * Math.PI) / sides)) / 2;

test("a tube is as thick as it is told, whichever way it goes, and does not twist", () => {
  for (const way of WAYS) {
    const path = [0, 1, 1, 4].map((length) => way.map((x) => length * x));
    const longer = path.map((point) => point.map((x) => 2 * x));
    const bent = [...path, way.map((x, i) => 5 * x + way[(i + 1) % 3])];
    near([volume(tubes([path, longer], 0.1))], [(2 / 3) * area(0.1, 8) * (4 + 8)], 1e-6);
    const rings = points(tubes([bent], 0.1).normals);
    for (const [i, normal] of rings.slice(0, 32).entries()) {
      if (i < 24) near([dot(normal, way)], [0], 1e-6);
      assert.ok(dot(normal, rings[i + 8]) > 0.3, `${way}: ${i}`);
    }
  }
});

test("an arrow is closed, whichever way it goes, and all head if it is short", () => {
  for (const way of WAYS) {
    for (const [length, tip] of [
      [1, 0.18],
      [0.2, 0.16],
    ]) {
      const made = arrow(
        [0, 0, 0],
        way.map((x) => length * x),
        0.02,
      );
      const [shaft, head] = [area(0.02, 20), area(0.06, 20)];
      near([volume(made, 0.3)], [(2 / 3) * shaft * (length - tip) + (head * tip) / 3], 1e-9);
      for (const normal of points(made.normals)) near([Math.hypot(...normal)], [1], 1e-6);
      // VTK, too, shades a tip by the mean of its faces.
      for (const normal of points(made.normals).slice(-20)) near(normal, way, 1e-6);
    }
  }
});

test("a tube keeps its distance from its line, and its normals point outwards", () => {
  const line = Array.from({ length: 9 }, (_, i) => [Math.cos(i / 3), Math.sin(i / 3), i / 10]);
  const { positions, normals, corners } = tubes([line, line.slice(0, 2)], 0.1);
  assert.equal(positions.length, 3 * 8 * 11);
  assert.equal(corners.length, 3 * 2 * 8 * (8 + 1));
  const normal = points(normals);
  points(positions).forEach((point, i) => {
    const center = [...line, ...line.slice(0, 2)][Math.floor(i / 8)];
    near(
      point.map((x, k) => (x - center[k]) / 0.1),
      normal[i],
      1e-5,
    );
    near([Math.hypot(...normal[i])], [1], 1e-6);
  });
});

test("a tube with as many points is written over the old one", () => {
  const old = tubes(
    [
      [
        [0, 0, 0],
        [1, 0, 0],
      ],
    ],
    0.1,
  );
  const same = tubes(
    [
      [
        [0, 0, 0],
        [0, 2, 0],
      ],
    ],
    0.1,
    old,
  );
  assert.equal(same.positions, old.positions);
  assert.equal(same.corners, old.corners);
  near([Math.max(...same.positions.filter((_, i) => i % 3 === 1))], [2], 1e-6);
  const longer = tubes(
    [
      [
        [0, 0, 0],
        [1, 0, 0],
        [2, 0, 0],
      ],
    ],
    0.1,
    old,
  );
  assert.notEqual(longer.positions, old.positions);
});

test("an arrow reaches from one point to the other with a head of one size", () => {
  for (const length of [1, 2]) {
    const { positions } = arrow([1, 0, 0], [1, 0, length], 0.02);
    const all = points(positions);
    near(
      [Math.min(...all.map(([, , z]) => z)), Math.max(...all.map(([, , z]) => z))],
      [0, length],
      1e-6,
    );
    const widest = all.filter(([x, y]) => Math.abs(Math.hypot(x - 1, y) - 0.06) < 1e-6);
    near(
      widest.map(([, , z]) => z),
      Array(widest.length).fill(length - 0.18),
      1e-6,
    );
    assert.equal(widest.length, 40);
  }
});

test("the head of a tiny arrow is as wide as VTK makes it", () => {
  const { positions } = arrow([0, 0, 0], [0.002, 0, 0], 0.02);
  const widths = Array.from({ length: positions.length / 3 }, (_, k) =>
    Math.hypot(positions[3 * k + 1], positions[3 * k + 2]),
  );
  assert.ok(Math.abs(Math.max(...widths) - 0.02) < 1e-7);
});
