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
import { points, unit } from "../viewer/test/near.js";
import { close, read } from "./cases.mjs";

const { figures } = await read("models");

/** What a model returns for its start, with some other inputs, of which some have just changed. */
function stateOf(model, inputs, changed = []) {
  const { start, constants } = figures.find(({ spec }) => spec.model === model).spec;
  return models[model]({ ...start, ...inputs }, constants, changed);
}

test("every model belongs to a figure", () => {
  assert.deepEqual(new Set(Object.keys(models)), new Set(figures.map(({ spec }) => spec.model)));
});

test("a ring stays on the point that it holds", () => {
  const given = points("1,0,0 0,1,0 0.2,-0.5,0.8");
  const corrected = (one_circle) =>
    stateOf("controlPointsByHand", { points: given, one_circle }).inputs;
  const there = [...given.slice(0, 2), unit([0.2, -0.5, 0])];
  close(corrected(true).points, there);
  assert.deepEqual(corrected(false), {});
});

test("the arrows of Figure 1 grow one after another, and a second vector has its own", () => {
  const drawn = (inputs) => {
    const { parts } = stateOf("figure1ByHand", inputs);
    return ["", "other "].map((whose) =>
      [1, 2, 3].map((i) => parts[`${whose}term ${i}`]).map(({ hidden, to }) => !hidden && to),
    );
  };
  const [whole, none] = drawn({ drawn: 3 });
  assert.deepEqual(none, [false, false, false]);
  assert.deepEqual(drawn({ drawn: 0, around: 130 }), [none, none]);
  const [[first, second, third]] = drawn({ drawn: 1.5 });
  assert.deepEqual([first, third], [whole[0], false]);
  close(second, combine(0.5, whole[0], 0.5, whole[1]));
  const [same, theirs] = drawn({ drawn: 3, around: 130 });
  assert.deepEqual(same, whole);
  assert.ok(theirs.every(Boolean));
});

test("who turns the spoon of Picture 4-b takes its rings along, by the nearest angles", () => {
  const led = (inputs) => stateOf("eulerAnglesByHand", inputs, ["spoon"]);
  const radians = (angles) => angles.map((angle) => (angle * Math.PI) / 180);
  const about = (angles, axis, degrees) => {
    const turn = rotationMatrix(axis, (degrees * Math.PI) / 180);
    return quaternionFromMatrix(product(turn, matrixFromEulerAngles(...radians(angles))));
  };
  const set = ([u, v, w]) => ({ u, v, w });
  for (const from of points("10,20,30 10,160,30 179,-40,-179 -100,-130,50")) {
    const spoon = about(from, [1, -2, 2], 2);
    const { inputs, outputs } = led({ ...set(from), spoon });
    const { u, v, w } = inputs;
    const there = matrixFromEulerAngles(...radians([u, v, w]));
    close(there, quaternionMatrix(spoon), () => 1e-12);
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
  const rings = stateOf("eulerAnglesByHand", { u: 20 }, ["u"]).inputs;
  assert.deepEqual(Object.keys(rings), ["spoon"]);
  const wanted = quaternionFromMatrix(matrixFromEulerAngles(...radians([20, 90, 90])));
  close(rings.spoon, wanted, () => 1e-12);
});

test("a spoon follows what the hand has set last", () => {
  const { start } = figures.find(({ spec }) => spec.model === "grabTheSpoon").spec;
  const after = (inputs, changed) => {
    return { ...start, ...inputs, ...stateOf("grabTheSpoon", inputs, changed).inputs };
  };
  const pose = [0.5, 0.5, -0.5, 0.5];
  const turned = after({ spoon: pose }, ["spoon"]);
  assert.deepEqual([turned.way, turned.along, turned.left], ["by hand", 0, pose]);
  const begun = after({ ...turned, way: "home by nlerp" }, ["way"]);
  assert.equal(begun.along, 0);
  close(begun.spoon, pose);
  const slid = after({ ...turned, along: 1 }, ["along"]);
  assert.equal(slid.way, "home by slerp");
  close(slid.spoon, [1, 0, 0, 0]);
  // All ways home begin where the hand has left the spoon.
  const other = after({ ...slid, way: "home by Euler angles" }, ["way"]);
  close(other.spoon, pose);
});

test("a trail is drawn by hand alone, and the ways of opposites differ by the axis", () => {
  assert.equal(stateOf("grabTheSpoon").trails, undefined);
  const { trails } = stateOf("grabTheSpoon", { way: "by hand", spoon: [0, 0.6, 0, 0.8] });
  close(trails, { trail: [0.3, 0, 0.4], "opposite trail": [-0.3, 0, -0.4] });
});
