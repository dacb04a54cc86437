import assert from "node:assert/strict";
import { test } from "node:test";
import { arrow, tubes } from "../src/shapes.js";
import { near, points } from "./near.js";

/** Three numbers of each point. */
const triples = (array) =>
  Array.from({ length: array.length / 3 }, (_, i) => [...array.slice(3 * i, 3 * i + 3)]);
const lengths = (array) => array.map((point) => Math.hypot(...point));
const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
const cross = ([a, b, c], [d, e, f]) => [b * f - c * e, c * d - a * f, a * e - b * d];
const times = (point, factor) => point.map((x) => factor * x);

/** A volume by the divergence theorem: openings in planes through the origin take nothing away. */
function volume({ positions, normals, corners }, least = 0.9) {
  const [all, outward] = [triples(positions), triples(normals)];
  return triples(corners).reduce((sum, face) => {
    const [a, b, c] = face.map((i) => all[i]);
    const [e, f] = [b, c].map((end) => end.map((x, i) => x - a[i]));
    const across = cross(e, f);
    for (const i of Math.hypot(...across) > 1e-9 ? face : []) {
      assert.ok(dot(across, outward[i]) > least * Math.hypot(...across), `${face} faces inwards`);
    }
    return sum + dot(a, across) / 6;
  }, 0);
}

const WAYS = points("1,0,0 0,1,0 0,0,-1 0.6,0,0.8 0.48,-0.6,0.64 0.8,-0.36,0.48");
/** The area of a regular polygon. */
const area = (radius, sides) => (sides * radius ** 2 * Math.sin((2 * Math.PI) / sides)) / 2;

test("a tube is as thick as it is told, whichever way it goes, and does not twist", () => {
  for (const way of WAYS) {
    const path = [0, 1, 1, 4].map((length) => times(way, length));
    const longer = path.map((point) => times(point, 2));
    near([volume(tubes([path, longer], 0.1))], [(2 / 3) * area(0.1, 8) * (4 + 8)], 1e-6);
    const bent = [...path, way.map((x, i) => 5 * x + way[(i + 1) % 3])];
    const rings = triples(tubes([bent], 0.1).normals);
    for (const [i, normal] of rings.slice(0, 32).entries()) {
      if (i < 24) near([dot(normal, way)], [0], 1e-6);
      assert.ok(dot(normal, rings[i + 8]) > 0.3, `${way}: ${i}`);
    }
  }
});

test("a tube keeps its distance from its line, and its normals point outwards", () => {
  const line = Array.from({ length: 9 }, (_, i) => [Math.cos(i / 3), Math.sin(i / 3), i / 10]);
  const { positions, normals, corners } = tubes([line, line.slice(0, 2)], 0.1);
  assert.equal(corners.length, 3 * 2 * 8 * (8 + 1));
  const [all, outward] = [triples(positions), triples(normals)];
  const centers = [...line, ...line.slice(0, 2)].flatMap((point) => Array(8).fill(point));
  const wanted = centers.map((center, i) => center.map((x, k) => x + 0.1 * outward[i][k]));
  near(all, wanted, 1e-6);
  near(lengths(outward), Array(88).fill(1), 1e-6);
});

test("a tube with as many points is written over the old one", () => {
  const made = (text, old) => tubes([points(text)], 0.1, old);
  const old = made("0,0,0 1,0,0");
  const same = made("0,0,0 0,2,0", old);
  assert.equal(same.positions, old.positions);
  assert.equal(same.corners, old.corners);
  near([Math.max(...same.positions.filter((_, i) => i % 3 === 1))], [2], 1e-6);
  assert.notEqual(made("0,0,0 1,0,0 2,0,0", old).positions, old.positions);
});

test("an arrow is written over the old one", () => {
  const made = (to, old) => arrow([0, 0, 1], to, 0.02, 0.8, old);
  const old = made([0, 0, 2]);
  assert.equal(made([2, 0, 1], old), old);
  assert.deepEqual(old, made([2, 0, 1]));
});

test("an arrow is closed, whichever way it goes, and keeps its shape if it is short", () => {
  for (const way of WAYS) {
    for (const [length, tip] of points("1,0.18 0.2,0.1")) {
      const made = arrow([0, 0, 0], times(way, length), 0.02, 1 / 2);
      const [shaft, head] = [area(Math.min(0.02, tip / 4), 20), area(tip / 3, 20)];
      near([volume(made, 0.3)], [(2 / 3) * shaft * (length - tip) + (head * tip) / 3], 1e-9);
      const normals = triples(made.normals);
      near(lengths(normals), Array(normals.length).fill(1), 1e-6);
      // VTK, too, shades a tip by the mean of its faces.
      near(normals.slice(-20), Array(20).fill(way), 1e-6);
    }
  }
});

test("an arrow reaches from one point to the other with a head of one size, but if it is short", () => {
  for (const [length, width] of points("1,0.06 2,0.06 0.15,0.04")) {
    const all = triples(arrow([1, 0, 0], [1, 0, length], 0.02, 0.8).positions);
    const heights = all.map(([, , z]) => z);
    near([Math.min(...heights), Math.max(...heights)], [0, length], 1e-6);
    const widths = all.map(([x, y]) => Math.hypot(x - 1, y));
    near([Math.max(...widths)], [width], 1e-6);
    const widest = heights.filter((_, i) => widths[i] > width - 1e-6);
    near(widest, Array(40).fill(length - Math.min(0.18, 0.8 * length)), 1e-6);
  }
});

test("the sides of a frame are not pinched, however it lies", () => {
  for (const way of WAYS) {
    const up = cross(way, [0.3, 0.5, 0.7]);
    const size = Math.hypot(...up);
    const [e, f] = [times(up, 1 / size), cross(way, times(up, 1 / size))];
    const corner = (x, y) => e.map((_, i) => x * e[i] + y * f[i]);
    const frame = [corner(1, 0.6), corner(-1, 0.6), corner(-1, -0.6), corner(1, -0.6)];
    const normals = triples(tubes([[...frame, ...frame.slice(0, 2)]], 0.1).normals);
    // Halfway along a side, a point lies between one of a ring and the same one of the next.
    for (let i = 8; i < 32; i++) {
      const halfway = normals[i].map((x, k) => (x + normals[i + 8][k]) / 2);
      assert.ok(Math.hypot(...halfway) > 0.68, `${way}: ${i}`);
    }
  }
});
