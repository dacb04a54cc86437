import assert from "node:assert/strict";
import { test } from "node:test";
import { beginning, between, duration, glide, slerp } from "../src/travel.js";
import { tick } from "./dom.js";
import { near, points } from "./near.js";

const SPECS = {
  u: { kind: "number", low: 0, high: 2, step: 0.01, plays: 4 },
  level: { kind: "number", low: 1, high: 4, step: 1, plays: 0 },
  way: { kind: "choice", options: ["short", "long"] },
  p: { kind: "points", names: "p", length: 1 },
  many: { kind: "points", names: ["P", "Q", "R"], least: 1 },
};
const FROM = { u: 0, level: 1, way: "short", p: [2, 0, 0], many: [[1, 0, 0]] };
const TO = { u: 2, level: 4, way: "long", p: [0, 4, 0], many: [[0, 0, 1]] };

test("numbers go evenly or in their steps, directions on the shortest arc, choices are made", () => {
  const third = between(SPECS, FROM, TO, 1 / 3);
  near([third.u], [2 / 3]);
  assert.deepEqual([third.level, third.way], [2, "long"]);
  const [cosine, sine] = [Math.cos(Math.PI / 6), Math.sin(Math.PI / 6)];
  near(third.p, [(8 / 3) * cosine, (8 / 3) * sine, 0]);
  near(third.many[0], [cosine, 0, sine]);
  assert.deepEqual(between(SPECS, FROM, TO, 1), TO);
  near(between(SPECS, FROM, TO, 0).p, FROM.p);
});

test("what has no shortest arc, or another number of points, jumps", () => {
  const back = { ...FROM, p: [-2, 0, 0], many: [...FROM.many, [0, 1, 0]] };
  const jumped = [0.49, 0.51].map((t) => between(SPECS, FROM, back, t).p);
  assert.deepEqual(jumped, [FROM.p, back.p]);
  assert.deepEqual(between(SPECS, FROM, back, 0.01).many, back.many);
  near(slerp([1, 0], [1, 0], 0.5), [1, 0]);
});

test("what plays begins anew where a choice changes what it plays", () => {
  const ended = { ...FROM, u: 2 };
  assert.equal(beginning(SPECS, ended, TO).u, 0);
  assert.equal(beginning(SPECS, ended, { ...TO, way: "short" }).u, 2);
  assert.equal(beginning(SPECS, ended, { ...TO, u: 0 }).u, 2);
  assert.equal(beginning(SPECS, { ...FROM, level: 4 }, TO).level, 4);
});

test("a way takes 600 to 900 milliseconds, slow at both ends", () => {
  const number = { u: SPECS.u };
  for (const [u, wanted] of points("0,600 0.5,750 2,900")) {
    near([duration(number, { u: 0 }, { u })], [wanted]);
  }
  const shown = [];
  glide(100, (t) => shown.push(t));
  tick(10, 35, 60, 120, 130);
  near(shown, [0, 5 / 32, 1 / 2, 1]);
  const stop = glide(100, () => assert.fail());
  stop();
  tick(140);
});
