import assert from "node:assert/strict";
import { test } from "node:test";
import { PerspectiveCamera, Sphere, SphereGeometry, Vector3 } from "three";
import { lens } from "../src/aim.js";
import { apart, crossings, isHidden, project } from "../src/labels.js";
import { Labels } from "../src/placed-labels.js";
import { figure } from "./dom.js";
import { near, points } from "./near.js";

function ball(seeThrough = false) {
  const { attributes, index } = new SphereGeometry(1, 48, 32);
  const around = new Sphere(new Vector3(), 1);
  return { positions: attributes.position.array, corners: index.array, around, seeThrough };
}

const square = {
  positions: points("-1,-1,0 1,-1,0 1,1,0 -1,1,0").flat(),
  corners: [0, 1, 2, 0, 2, 3],
  around: new Sphere(new Vector3(), Math.SQRT2),
};

test("labels are where three's camera sees their points", () => {
  const camera = new PerspectiveCamera(30, 1.5, 0.1, 100);
  camera.up.set(0, 0, 1);
  camera.position.set(4, -2, 2);
  camera.lookAt(0, 0, 0.1);
  camera.updateMatrixWorld();
  for (const point of points("0,0,0.1 1,0.5,-0.3 -2,1,1")) {
    const seen = new Vector3(...point).project(camera);
    const { left, top, inside } = project(lens(camera), point);
    near([left, top], [(1 + seen.x) / 2, (1 - seen.y) / 2]);
    assert.ok(inside);
  }
  for (const outside of points("8,-4,4 0,3,0 0,0,2 0,0,-2")) {
    assert.ok(!project(lens(camera), outside).inside);
  }
});

test("crossings are counted on the way alone, up to a limit; those in an edge of two faces are one", () => {
  for (const [surface, way, wanted, limit] of [
    [square, "0.3,0.1,1 0.3,0.1,-1", 1],
    [square, "0.3,0.1,1 0.3,0.1,0.5", 0],
    [square, "0.3,0.1,-1 0.3,0.1,-2", 0],
    [square, "2,0,1 2,0,-1", 0],
    [square, "0.5,0.5,1 0.5,0.5,-1", 1],
    [{ ...square, corners: [0, 0, 2] }, "0,0,1 0,0,-1", 0],
    [ball(), "0.1,0.2,3 0.15,0.1,-3", 2],
    [ball(), "0.1,0.2,3 0.15,0.1,0", 1],
    [ball(), "0.1,0.2,3 0.15,0.1,-3", 1, 1],
  ]) {
    const [from, to] = points(way);
    assert.equal(crossings(surface, from, to, limit), wanted, way);
  }
});

test("a label is hidden in and behind an opaque ball, behind a glass ball, nowhere without", () => {
  for (const [surfaces, ...wanted] of [
    [[ball()], false, false, true, true, true],
    [[ball(true)], false, false, false, false, true],
    [[], false, false, false, false, false],
  ]) {
    const places = [1.5, 0.999, 0, -0.999, -1.5].map((z) => [0.01, 0.01, z]);
    const hidden = places.map((place) => isHidden(surfaces, [0.3, 0.2, 5], place));
    assert.deepEqual(hidden, wanted);
  }
});

const box = (x, y, width = 20, height = 10) => ({ x, y, width, height });
const pushed = (boxes) =>
  apart(boxes).map(({ x, y }, i) => ({ ...boxes[i], x: boxes[i].x + x, y: boxes[i].y + y }));
/** By how much two boxes overlap: the shorter way apart. */
const overlap = (a, b) =>
  Math.min(
    (a.width + b.width) / 2 - Math.abs(a.x - b.x),
    (a.height + b.height) / 2 - Math.abs(a.y - b.y),
  );
const worst = (boxes) =>
  Math.max(...boxes.flatMap((a, i) => boxes.slice(0, i).map((b) => overlap(a, b))));

test("labels give way by half of the shorter way each, and not at all if they only touch", () => {
  for (const [boxes, wanted] of [
    [[box(0, 0), box(20, 3), box(0, 10)], "0,0 0,0 0,0"],
    [[box(0, 0), box(3, 6)], "0,-2 0,2"],
    [[box(0, 0), box(3, -6)], "0,2 0,-2"],
    [[box(0, 0), box(-17, 1)], "1.5,0 -1.5,0"],
  ]) {
    const ways = apart(boxes).map(({ x, y }) => [x, y]);
    near(ways, points(wanted));
  }
  assert.deepEqual(apart([]), []);
});

test("labels give way also if they lie in one place, and in a crowd", () => {
  const crowd = [0, 1, 2, 3, 4, 5].map((i) =>
    box(7 * Math.sin(5 * i), 4 * Math.cos(3 * i), 14 + i),
  );
  for (const boxes of [Array(2).fill(box(5, 5)), Array(3).fill(box(5, 5)), crowd]) {
    assert.ok(worst(boxes) > 1);
    assert.ok(worst(pushed(boxes)) < 0.5, `${worst(pushed(boxes))}`);
    assert.ok(Math.max(...apart(boxes).map(({ x, y }) => Math.hypot(x, y))) < 40);
  }
});

test("labels give way without a leap", () => {
  const ways = Array.from({ length: 110 }, (_, i) => pushed([box(0, 0), box(4, 12 - i / 10)])[1].y);
  for (const [i, y] of ways.slice(1).entries()) assert.ok(Math.abs(y - ways[i]) < 0.2);
});

test("labels of a page stand where their points are seen, with the room that they need", () => {
  const box = figure("").querySelector(".scene");
  const label = (name, position) =>
    `<span class="scene-label" data-label="${name}" data-position="${position}"></span>`;
  box.innerHTML = label("P", "1 0 0") + label("Q", "1 0 0") + label("R", "") + label("S", "0 9 0");
  box.innerHTML += label("T", "-1 1.9 0");
  globalThis.getComputedStyle = () => ({ marginTop: "-15px" });
  const labels = new Labels(box);
  const size = { offsetWidth: { value: 20 }, offsetHeight: { value: 10 } };
  for (const { label } of labels.entries) Object.defineProperties(label, size);
  Object.defineProperties(box, { clientWidth: { value: 200 }, clientHeight: { value: 100 } });
  labels.measure();
  const camera = new PerspectiveCamera(90, 1);
  camera.position.set(0, 0, 2);
  camera.updateMatrixWorld();
  labels.place(camera, []);
  const said = labels.entries.map(({ label: { style } }) =>
    ["--at", "--aside"].map((name) => style.getPropertyValue(name)),
  );
  assert.deepEqual(said.slice(0, 2), [
    ["50% auto auto 75%", "0px -5px"],
    ["50% auto auto 75%", "0px 5px"],
  ]);
  // It would lie on the text above.
  near([Number.parseFloat(said.at(-1)[1].split(" ")[1])], [5.5]);
  const behind = labels.entries.map(({ label }) => label.hasAttribute("data-behind"));
  assert.deepEqual(behind, [false, false, true, true, false]);
});
