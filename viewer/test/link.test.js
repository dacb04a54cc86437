import assert from "node:assert/strict";
import { test } from "node:test";
import { fromText, toText } from "../src/link.js";
import { near, points } from "./near.js";

const FIGURE = {
  name: "some-figure",
  start: { u: 0.5, points: points("1,0,0 0,1,0"), one: [0, 0, 1], on: false, way: "short" },
  inputs: {
    u: { kind: "number", low: 0, high: 1 },
    points: { kind: "points", names: ["P", "Q", "R"], least: 2, most: 3 },
    one: { kind: "points", names: "N" },
    on: { kind: "switch" },
    way: { kind: "choice", options: ["short", "long"] },
  },
};
const read = (text, inputs = FIGURE.inputs) =>
  fromText(`#explore-some-figure?${text}`, { ...FIGURE, inputs });

test("the address holds what differs from the start, and gives it back", () => {
  const changed = { u: 0.25, points: points("1,0,0 0,0.6,-0.8 0,0,1"), on: true, way: "long" };
  const text = toText({ ...FIGURE.start, ...changed }, FIGURE.start);
  assert.deepEqual(read(text), changed);
  assert.equal(toText(FIGURE.start, FIGURE.start), "");
  assert.equal(toText({ ...FIGURE.start, u: 1 / 3 }, FIGURE.start), "u=0.33333");
});

test("points from an address have their length, unless they may have any", () => {
  const found = (length) =>
    read("one=0,0.3,0.4", { one: { kind: "points", names: "N", length } }).one;
  near(found(2), [0, 1.2, 1.6]);
  near(found(0), [0, 0.3, 0.4]);
});

test("an address may name the ends of what there is, and as many points as have names", () => {
  assert.deepEqual(read("u=0"), { u: 0 });
  assert.deepEqual(read("u=1&on=false"), { u: 1, on: false });
  for (const text of ["1,0,0 0,1,0", "1,0,0 0,1,0 0,0,1"]) {
    assert.deepEqual(read(`points=${text}`), { points: points(text) });
  }
  const inputs = { points: { kind: "points", names: ["P", "Q"] } };
  const two = "1,0,0 0,1,0";
  assert.deepEqual(read(`points=${two}`, inputs), { points: points(two) });
  for (const text of ["1,0,0", `${two} 0,0,1`]) assert.equal(read(`points=${text}`, inputs), null);
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
    assert.equal(read(text), null, text);
  }
  for (const hash of ["#explore-another?u=0.1", "#some-figure", "#explore-some-figure"]) {
    assert.equal(fromText(hash, FIGURE), null);
  }
});
