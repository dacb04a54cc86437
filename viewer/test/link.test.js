import assert from "node:assert/strict";
import { test } from "node:test";
import { fromText, toText } from "../src/link.js";

const FIGURE = {
  name: "some-figure",
  start: {
    u: 0.5,
    points: [
      [1, 0, 0],
      [0, 1, 0],
    ],
    one: [0, 0, 1],
    on: false,
    way: "short",
  },
  inputs: {
    u: { kind: "number", low: 0, high: 1 },
    points: { kind: "points", names: ["P", "Q", "R"], least: 2, most: 3 },
    one: { kind: "points", names: "N" },
    on: { kind: "switch" },
    way: { kind: "choice", options: ["short", "long"] },
  },
};

test("the address holds what differs from the start, and gives it back", () => {
  const state = {
    u: 0.25,
    points: [
      [1, 0, 0],
      [0, 0.6, -0.8],
      [0, 0, 1],
    ],
    one: [0, 0, 1],
    on: true,
    way: "long",
  };
  const text = toText(state, FIGURE.start);
  assert.ok(!text.includes("one="));
  const found = fromText(`#explore-some-figure?${text}`, FIGURE);
  assert.deepEqual({ ...FIGURE.start, ...found }, state);
  assert.equal(toText(FIGURE.start, FIGURE.start), "");
});

test("points from an address have their length, unless they may have any", () => {
  for (const [length, wanted] of [
    [2, [0, 1.2, 1.6]],
    [0, [0, 0.3, 0.4]],
  ]) {
    const inputs = { one: { kind: "points", names: "N", length } };
    const { one } = fromText("#explore-some-figure?one=0,0.3,0.4", { ...FIGURE, inputs });
    one.forEach((x, i) => assert.ok(Math.abs(x - wanted[i]) < 1e-12, `${one}`));
  }
});

test("an address may name the ends of what there is, and rounds", () => {
  const read = (text) => fromText(`#explore-some-figure?${text}`, FIGURE);
  assert.deepEqual(read("u=0"), { u: 0 });
  assert.deepEqual(read("u=1&on=false"), { u: 1, on: false });
  for (const points of ["1,0,0 0,1,0", "1,0,0 0,1,0 0,0,1"]) {
    assert.equal(read(`points=${points}`).points.join(" "), points);
  }
  assert.equal(toText({ ...FIGURE.start, u: 1 / 3 }, FIGURE.start), "u=0.33333");
});

test("without other bounds there are as many points as names", () => {
  const figure = { ...FIGURE, inputs: { points: { kind: "points", names: ["P", "Q"] } } };
  const read = (text) => fromText(`#explore-some-figure?points=${text}`, figure);
  assert.equal(read("1,0,0"), null);
  assert.equal(read("1,0,0 0,1,0 0,0,1"), null);
  assert.deepEqual(read("1,0,0 0,1,0"), {
    points: [
      [1, 0, 0],
      [0, 1, 0],
    ],
  });
});

test("an address that makes no sense changes nothing", () => {
  for (const text of [
    "u=2",
    "u=-1",
    "u=x",
    "way=round",
    "other=1",
    "one=0,0,0",
    "one=1,2",
    "one=1,0,0 0,1,0",
    "points=1,0,0",
    "points=1,0,0 0,1,0 0,0,1 1,1,0",
    "points=1,0,0 0,x,0",
    "points=1,0,0 0,1,0 0,0,0",
  ]) {
    assert.equal(fromText(`#explore-some-figure?${text}`, FIGURE), null, text);
  }
  assert.equal(fromText("#explore-another?u=0.1", FIGURE), null);
  assert.equal(fromText("#some-figure", FIGURE), null);
  assert.equal(fromText("#explore-some-figure", FIGURE), null);
});
