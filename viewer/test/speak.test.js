import assert from "node:assert/strict";
import { test } from "node:test";
import { changedSince, numberText, statement, titleOf } from "../src/speak.js";

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
  assert.deepEqual(
    Object.entries(SPECS).map(([name, spec]) => titleOf(spec, name)),
    ["turned by θ", "once round, u", "w", "flip the end", "between", "n", "points"],
  );
  assert.equal(numberText(SPECS.theta, -30), "\u221230°");
  assert.equal(numberText(SPECS.u, 0.1 + 0.2), "0.3");
  assert.equal(numberText({}, 2), "2");
});

test("each kind of input has its words", () => {
  const inputs = {
    theta: 30,
    u: 0.5,
    w: 1,
    flip: true,
    what: "poses",
    axis: [0, 0, 1],
    points: [],
  };
  assert.equal(
    statement(SPECS, Object.keys(SPECS), inputs),
    "turned by θ 30°, once round, u 0.5, w 1, flip the end: on, between: poses, n moved, points moved",
  );
  assert.equal(statement(SPECS, ["flip"], { flip: false }), "flip the end: off");
  assert.equal(statement(SPECS, [], {}), "");
});

test("points have changed if a coordinate has", () => {
  const start = {
    p: [
      [0, 1],
      [1, 0],
    ],
    u: 1,
  };
  assert.deepEqual(
    changedSince(start, {
      p: [
        [0, 1],
        [1, 0],
      ],
      u: 2,
    }),
    ["u"],
  );
  assert.deepEqual(
    changedSince(start, {
      p: [
        [0, 1],
        [1, 0.5],
      ],
      u: 1,
    }),
    ["p"],
  );
});
