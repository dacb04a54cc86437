/* What models do with what the hand has changed, and what they show of it. */
import assert from "node:assert/strict";
import { test } from "node:test";
import * as models from "../rotedu/scenes/models.js";
import {
  combine,
  matrixFromEulerAngles,
  product,
  quaternionFromMatrix,
  quaternionMatrix,
  rotationMatrix,
} from "../rotedu/scenes/rotations.js";
import { difference, read } from "./cases.mjs";

const allowed = (value) => 2e-6 * Math.max(1, Math.abs(value));
const { figures } = await read("models");
const specOf = (model) => figures.find(({ spec }) => spec.model === model).spec;

test("every model belongs to a figure", () => {
  assert.deepEqual(new Set(Object.keys(models)), new Set(figures.map(({ spec }) => spec.model)));
});

test("a ring stays on the point that it holds", () => {
  const spec = specOf("controlPointsByHand");
  const points = [
    [1, 0, 0],
    [0, 1, 0],
    [0.2, -0.5, 0.8],
  ];
  const corrected = (one_circle) =>
    models.controlPointsByHand({ ...spec.start, points, one_circle }, spec.constants, []).inputs;
  const length = Math.hypot(0.2, 0.5);
  const there = [...points.slice(0, 2), [0.2 / length, -0.5 / length, 0]];
  assert.equal(difference(corrected(true).points, there, allowed), "");
  assert.deepEqual(corrected(false), {});
});

test("the arrows of Figure 1 grow one after another, and a second vector has its own", () => {
  const spec = specOf("figure1ByHand");
  const drawn = (inputs) => {
    const { parts } = models.figure1ByHand({ ...spec.start, ...inputs }, spec.constants, []);
    return ["", "other "].map((whose) =>
      [1, 2, 3].map((i) => parts[`${whose}term ${i}`]).map(({ hidden, to }) => !hidden && to),
    );
  };
  const [whole, none] = drawn({ drawn: 3 });
  assert.deepEqual(none, [false, false, false]);
  assert.deepEqual(drawn({ drawn: 0, around: 130 }), [none, none]);
  const [[first, second, third]] = drawn({ drawn: 1.5 });
  assert.deepEqual([first, third], [whole[0], false]);
  assert.equal(difference(second, combine(0.5, whole[0], 0.5, whole[1]), allowed), "");
  const [same, theirs] = drawn({ drawn: 3, around: 130 });
  assert.deepEqual(same, whole);
  assert.ok(theirs.every(Boolean));
});

test("who turns the spoon of Picture 4-b takes its rings along, by the nearest angles", () => {
  const spec = specOf("eulerAnglesByHand");
  const led = (inputs) =>
    models.eulerAnglesByHand({ ...spec.start, ...inputs }, spec.constants, ["spoon"]);
  const radians = (angles) => angles.map((angle) => (angle * Math.PI) / 180);
  const about = (angles, axis, degrees) => {
    const turn = rotationMatrix(axis, (degrees * Math.PI) / 180);
    return quaternionFromMatrix(product(turn, matrixFromEulerAngles(...radians(angles))));
  };
  const set = ([u, v, w]) => ({ u, v, w });
  for (const from of [
    [10, 20, 30],
    [10, 160, 30],
    [179, -40, -179],
    [-100, -130, 50],
  ]) {
    const spoon = about(from, [1, -2, 2], 2);
    const { inputs, outputs } = led({ ...set(from), spoon });
    const { u, v, w } = inputs;
    const there = matrixFromEulerAngles(...radians([u, v, w]));
    assert.equal(
      difference(there, quaternionMatrix(spoon), () => 1e-12),
      "",
    );
    assert.deepEqual(outputs.rings, [u, v, w]);
    [u, v, w].forEach((angle, i) => {
      assert.ok(Math.abs(angle) <= 180);
      assert.ok(Math.abs(((angle - from[i] + 540) % 360) - 180) < 4, `${[u, v, w]} from ${from}`);
    });
  }
  // Turned by hand and back, and at the lock, angles stay that fit; 1° aside they leap.
  assert.deepEqual(led({}).inputs, set([90, 90, 90]));
  const { u, v, w } = led({ spoon: about([90, 90, 90], [0, 1, 0], -1) }).inputs;
  assert.ok(Math.abs(v - 89) < 1e-6 && Math.abs(u - w) < 1e-6 && Math.abs(u % 180) < 1e-6);
  const rings = models.eulerAnglesByHand({ ...spec.start, u: 20 }, spec.constants, ["u"]).inputs;
  assert.deepEqual(Object.keys(rings), ["spoon"]);
  const wanted = quaternionFromMatrix(matrixFromEulerAngles(...radians([20, 90, 90])));
  assert.equal(
    difference(rings.spoon, wanted, () => 1e-12),
    "",
  );
});

test("a spoon follows what the hand has set last", () => {
  const spec = specOf("grabTheSpoon");
  const after = (inputs, changed) => {
    const given = { ...spec.start, ...inputs };
    return { ...given, ...models.grabTheSpoon(given, spec.constants, changed).inputs };
  };
  const pose = [0.5, 0.5, -0.5, 0.5];
  const turned = after({ spoon: pose }, ["spoon"]);
  assert.deepEqual([turned.way, turned.along, turned.left], ["by hand", 0, pose]);
  const begun = after({ ...turned, way: "home by nlerp" }, ["way"]);
  assert.equal(begun.along, 0);
  assert.equal(difference(begun.spoon, pose, allowed), "");
  const slid = after({ ...turned, along: 1 }, ["along"]);
  assert.equal(slid.way, "home by slerp");
  assert.equal(difference(slid.spoon, [1, 0, 0, 0], allowed), "");
  // All ways home begin where the hand has left the spoon.
  const other = after({ ...slid, way: "home by Euler angles" }, ["way"]);
  assert.equal(difference(other.spoon, pose, allowed), "");
});

test("a trail is drawn by hand alone, and the ways of opposites differ by the axis", () => {
  const spec = specOf("grabTheSpoon");
  const frame = (inputs) => models.grabTheSpoon({ ...spec.start, ...inputs }, spec.constants, []);
  assert.equal(frame({}).trails, undefined);
  const { trails } = frame({ way: "by hand", spoon: [0, 0.6, 0, 0.8] });
  assert.equal(
    difference(trails, { trail: [0.3, 0, 0.4], "opposite trail": [-0.3, 0, -0.4] }, allowed),
    "",
  );
});
