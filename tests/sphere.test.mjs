/* sphere.js computes and refuses what rotedu does, in the cases of `test_sphere_js.py`. */
import assert from "node:assert/strict";
import { test } from "node:test";
import * as sphere from "../rotedu/scenes/sphere.js";
import { answer, difference, read } from "./cases.mjs";

const SEEN = {
  "": (value) => value,
  length: (value) => Math.hypot(...value),
  matrixFromEulerAngles: (angles) => sphere.matrixFromEulerAngles(...angles),
};
const { seed, cases } = await read("sphere");

test("every export is compared", () => {
  const compared = new Set(cases.map(({ name }) => name));
  assert.deepEqual(new Set(Object.keys(sphere)), compared.add("DegenerateError"));
});

test("each call gives what Python gives, or is refused as Python refuses it", () => {
  for (const { name, args, ...python } of cases) {
    const where = `SPHERE_SEED=${seed}: ${name}(${JSON.stringify(args)})`;
    const node = answer(() => sphere[name](...args));
    assert.equal(node.error, python.error, where);
    if (python.message) assert.equal(node.message, python.message, where);
    if (node.error) continue;
    const { value, seen, allowed } = python;
    assert.equal(difference(SEEN[seen](node.value), value, () => allowed, where), "");
  }
});
