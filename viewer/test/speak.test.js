import assert from "node:assert/strict";
import { test } from "node:test";
import { changedSince, numberText, outputText, statement, titleOf } from "../src/speak.js";
import { points, Z } from "./near.js";

const SPECS = {
  theta: { kind: "number", label: "turned by θ, °" },
  u: { kind: "number", label: "once round, u" },
  w: { kind: "number", label: "" },
  flip: { kind: "switch", label: "flip the end" },
  what: { kind: "choice", label: "between", options: ["points", "poses"] },
  axis: { kind: "points", names: "n" },
  points: { kind: "points", names: ["P", "Q"] },
};

test("a title has no unit, a number has it", () => {
  const titles = Object.entries(SPECS).map(([name, spec]) => titleOf(spec, name));
  const wanted = ["turned by θ", "once round, u", "w", "flip the end", "between", "n", "points"];
  assert.deepEqual(titles, wanted);
  assert.equal(numberText(SPECS.theta, -30), "\u221230°");
  assert.equal(numberText(SPECS.u, 0.1 + 0.2), "0.3");
  assert.equal(numberText({}, 2), "2");
});

test("each kind of input has its words", () => {
  const inputs = { theta: 30, u: 0.5, w: 1, flip: true, what: "poses", axis: Z, points: [] };
  assert.equal(
    statement(SPECS, Object.keys(SPECS), inputs),
    "turned by θ 30°, once round, u 0.5, w 1, flip the end: on, between: poses, n moved, points moved",
  );
  assert.equal(statement(SPECS, ["flip"], { flip: false }), "flip the end: off");
  assert.equal(statement(SPECS, [], {}), "");
});

test("points have changed if a coordinate has", () => {
  const start = { p: points("0,1 1,0"), u: 1 };
  assert.deepEqual(changedSince(start, { p: points("0,1 1,0"), u: 2 }), ["u"]);
  assert.deepEqual(changedSince(start, { p: points("0,1 1,0.5"), u: 1 }), ["p"]);
});

test("numbers, texts and matrices are written with their digits", () => {
  for (const [value, digits, unit, wanted] of [
    [-1.236, 2, "°", "−1.24°"],
    [-0.001, 2, "", "0.00"],
    [-123456.7891, 4, "", "−123,456.7891"],
    ["no", 2, "", "no"],
    [[1, 2000], 1, "°", "1.0, 2000.0°"],
    [points("1,-10.04 0,-0.04"), 1, "", "  1.0 −10.0\n  0.0   0.0"],
  ]) {
    assert.equal(outputText(value, { digits, unit }), wanted);
  }
});
