/* rotations.js computes and refuses what rotedu does, in the cases of `test_rotations_js.py`. */
import assert from "node:assert/strict";
import { test } from "node:test";
import * as rotations from "../rotedu/scenes/rotations.js";
import { answer, close, read } from "./cases.mjs";

const SEEN = {
  "": (value) => value,
  length: (value) => Math.hypot(...value),
  matrixFromEulerAngles: (angles) => rotations.matrixFromEulerAngles(...angles),
};
const { seed, cases } = await read("rotations");

test("every export is compared", () => {
  const compared = new Set(cases.map(({ name }) => name));
  assert.deepEqual(new Set(Object.keys(rotations)), compared.add("DegenerateError"));
});

test("each call gives what Python gives, or is refused as Python refuses it", () => {
  for (const { name, args, ...python } of cases) {
    const where = `ROTATIONS_SEED=${seed}: ${name}(${JSON.stringify(args)})`;
    const node = answer(() => rotations[name](...args));
    assert.equal(node.error, python.error, where);
    if (python.message) assert.equal(node.message, python.message, where);
    if (node.error) continue;
    const { value, seen, allowed } = python;
    close(SEEN[seen](node.value), value, () => allowed, where);
  }
});
