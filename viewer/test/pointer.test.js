import assert from "node:assert/strict";
import { test } from "node:test";
import { stepped } from "../src/pointer.js";

test("a number goes to the nearest step of its slider, and not beyond its ends", () => {
  const spec = { low: 1, high: 3, step: 0.5 };
  assert.deepEqual(
    [1.8, 2.2, 9, -9].map((number) => stepped(spec, number)),
    [2, 2, 3, 1],
  );
});
