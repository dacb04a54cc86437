import assert from "node:assert/strict";
import { test } from "node:test";
import { isCut, nameTops, path } from "../src/chart.js";
import { points } from "./near.js";

const RANGE = [-1, 1];

test("what rises in a curve rises on the chart; pieces have one width", () => {
  assert.equal(path([-1, 0, 0.5], RANGE), "M0.0,128.0 160.0,64.0 320.0,32.0");
  assert.equal(path(points("-1,0 1,0"), RANGE), "M0.0,128.0 160.0,64.0M160.0,0.0 320.0,64.0");
  assert.equal(path(null, RANGE), "");
});

test("an arrow stands in the middle of what a chart cuts off, at its edge", () => {
  const [line, ...arrows] = path([0, 2, 2, 0, -3], RANGE).split("M").slice(1);
  assert.equal(line, "0.0,64.0 80.0,-6.4 160.0,-6.4 240.0,64.0 320.0,134.4");
  const wanted = ["116.0,7.0 120.0,0.0 124.0,7.0", "316.0,121.0 320.0,128.0 324.0,121.0"];
  assert.deepEqual(arrows, wanted);
  assert.ok(isCut([0, 2, 2, 0, -3], RANGE));
  // What only rounding puts beyond an edge is on it.
  assert.ok(!isCut([-1 - 2e-16, 0, 1 + 3e-16], RANGE));
  assert.equal(path([-1 - 2e-16, 0, 1 + 3e-16], RANGE).split("M").length, 2);
});

test("names stand beside the ends of curves, but apart, and without a curve there is none", () => {
  for (const [one, two, ...wanted] of [
    [[0, 0.5], [0, -0.5], "25%", "75%"],
    [[0, 0.5], [0, 0.52], "37%", "24%"],
    [points("1,1 0,-1"), [0, -3], "87%", "100%"],
    [[0, 0], null, "50%", undefined],
  ]) {
    const tops = nameTops({ one, two }, RANGE);
    assert.deepEqual([tops.one, tops.two], wanted);
  }
});
