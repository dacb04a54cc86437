/* What book/conventions.md says about three.js, by running it. */
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { Euler, Matrix4, Object3D, PerspectiveCamera, Quaternion, Vector3 } from "three";
import { near, points } from "../viewer/test/near.js";

const page = await readFile(new URL("../book/conventions.md", import.meta.url), "utf8");
const row = page.split("\n").find((line) => line.startsWith("| three.js"));
const [, axes, order, angles, matrices, rotation] = row.split(" | ");
const [X, Y, Z] = points("1,0,0 0,1,0 0,0,1").map((axis) => new Vector3(...axis));
const about = (axis, angle) => new Matrix4().makeRotationAxis(axis, angle);
const close = (a, b) => near(a, b, 1e-14);

test("axes", () => {
  assert.equal(axes, "right-handed, Y up");
  assert.deepEqual(Object3D.DEFAULT_UP.toArray(), Y.toArray());
  // On the screen X leads right, Y up, and what is farther in front of the camera has a smaller z.
  const camera = new PerspectiveCamera();
  camera.updateMatrixWorld();
  const right = new Vector3(1, 0, -5).project(camera);
  const up = new Vector3(0, 1, -5).project(camera);
  assert.ok(right.x > 0 && up.y > 0 && Math.abs(right.z) < 1);
});

test("quaternion and what it does", () => {
  const q = new Quaternion().setFromAxisAngle(Z, Math.PI / 2);
  assert.equal(order, "(x, y, z, w)");
  close(q.toArray(), [0, 0, Math.SQRT1_2, Math.SQRT1_2]);
  assert.ok(rotation.startsWith("moves points"));
  close(X.clone().applyQuaternion(q).toArray(), Y.toArray());
});

test("Euler angles", () => {
  assert.equal(angles, "X, Y, Z by default, carried axes");
  const [a, b, c] = [0.3, 0.5, 0.7];
  const found = new Matrix4().makeRotationFromEuler(new Euler(a, b, c));
  close(found.elements, about(X, a).multiply(about(Y, b)).multiply(about(Z, c)).elements);
});

test("matrices", () => {
  assert.equal(matrices, "times a column; stored by columns");
  const moved = new Matrix4().makeTranslation(1, 2, 3);
  assert.deepEqual(moved.elements.slice(12, 15), [1, 2, 3]);
  assert.deepEqual(new Vector3().applyMatrix4(moved).toArray(), [1, 2, 3]);
  close(about(Z, 0.3).elements.slice(0, 2), [Math.cos(0.3), Math.sin(0.3)]);
});
