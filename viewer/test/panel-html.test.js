import assert from "node:assert/strict";
import { test } from "node:test";
import { panelHtml, roundHeights, written } from "../src/panel-html.js";
import { figure } from "./dom.js";
import { points } from "./near.js";

test("letters that stand for quantities look as in formulas", () => {
  assert.equal(
    written("a < *b* & *n̂* × *rᵢ₊₁* at a point *P₀*"),
    "a &lt; <i>b</i> &amp; <i>n̂</i> × <i>r<sub><i>i</i>+1</sub></i> at a point <i>P<sub>0</sub></i>",
  );
});

test("hairlines stand at round heights, or at the ends alone", () => {
  assert.deepEqual(roundHeights(0, 150), [0, 50, 100, 150]);
  assert.deepEqual(roundHeights(-6, 6), [-6, -3, 0, 3, 6]);
  assert.deepEqual(roundHeights(0, 7), [0, 7]);
});

const NUMBER = { kind: "number", low: 0, high: 2, step: 0.01, plays: 4, label: "", row: false };
const WRITTEN = { digits: 1, unit: "", loud: "no", where: "panel", color: "" };
const SPEC = {
  name: "some-figure",
  inputs: {
    u: { ...NUMBER, label: "turn, °", row: true },
    hidden: NUMBER,
    points: { kind: "points", names: ["P", "Q"], least: 2, most: 3 },
    on: { kind: "switch", label: 'the "other" <way>' },
    way: { kind: "choice", label: "way", options: ["short", "long"], words: ["short", "long"] },
  },
  start: { u: 0.5, hidden: 0, points: points("1,0,0 0,1,0"), on: true, way: "long" },
  outputs: [
    { ...WRITTEN, name: "length", label: "length", unit: "°", where: "picture", color: "#123456" },
    { ...WRITTEN, name: "fits", label: "it fits", loud: "yes" },
    { ...WRITTEN, name: "matrix", label: "M", where: "folded" },
  ],
  charts: [
    {
      ...{ name: "heights", label: "height", over: "u", x: [0, 2], y: [-1, 1], ticks: [] },
      ...{ colors: { one: "#654321" }, marks: ["P₀", "P₁", "P₂"], dashed: ["two"] },
    },
  ],
  tries: [
    ["further & on", { u: 2, way: "short" }],
    ["back", { u: 0 }],
  ],
};
const STATE = {
  outputs: { length: -1.25, fits: "yes", matrix: points("1,0 0,1") },
  charts: { heights: { one: points("0,1 0.5,0.25"), two: null } },
};

/** A panel in a page. */
const panel = () => figure(panelHtml(SPEC, STATE)).querySelector("form");

test("a panel stands in the order in which it is read", () => {
  const kinds = [...panel().querySelector("fieldset").children].map(({ className }) => className);
  assert.deepEqual(kinds, [
    "explorable-legend",
    "explorable-numbers",
    "explorable-buttons explorable-whole",
    "explorable-controls",
    "explorable-charts",
    "explorable-outputs",
    "explorable-more",
    "explorable-tries",
  ]);
  assert.ok(panel().querySelector("fieldset").disabled);
});

test("each input has its control, with its value at the start", () => {
  const form = panel();
  const slider = form.querySelector("[type=range]");
  const said = ["name", "min", "max", "step", "value"].map((key) => slider.getAttribute(key));
  assert.deepEqual(said, ["u", "0", "2", "0.01", "0.5"]);
  assert.equal(form.querySelectorAll("[type=range]").length, 1);
  assert.equal(form.querySelector(`label[for="${slider.id}"]`).textContent, "turn, °");
  assert.ok(form.querySelector("[name=on]").checked);
  assert.match(form.querySelector(".explorable-switch").textContent, /the "other" <way>/);
  const ways = [...form.querySelectorAll("[name=way]")].map(({ checked }) => checked);
  assert.deepEqual(ways, [false, true]);
  const actions = [...form.querySelectorAll("[data-input]")].map(({ dataset }) => dataset.action);
  assert.deepEqual(actions, ["play", "step", "add", "remove"]);
});

test("numbers are written with their digits and units, and what matters is loud", () => {
  const form = panel();
  const output = (name) => form.querySelector(`output[name=${name}]`);
  assert.equal(output("length").textContent, "−1.3°");
  assert.equal(output("length").parentElement.firstChild.style.color, "#123456");
  assert.equal(output("fits").className, "explorable-loud");
  assert.equal(output("matrix").textContent, "1.0 0.0\n0.0 1.0");
  assert.ok(output("matrix").closest("details"));
});

test("a chart has curves, names at their ends, marks for its pieces, and hairlines", () => {
  const chart = panel().querySelector("[data-chart]");
  const all = (selector) => [...chart.querySelectorAll(selector)];
  const d = all("path").map((path) => path.getAttribute("d"));
  assert.deepEqual(d, ["M0.0,64.0 160.0,0.0M160.0,32.0 320.0,48.0", ""]);
  assert.ok(chart.querySelector("[data-curve=two]").hasAttribute("data-dashed"));
  const names = all("[data-name]").map(({ hidden, style }) => hidden || style.top);
  assert.deepEqual(names, ["38%", true]);
  const marks = all(".explorable-marks span").map(({ hidden }) => hidden);
  assert.deepEqual(marks, [false, false, true]);
  const lines = all("[data-tick]").map(({ dataset }) => dataset.tick);
  assert.deepEqual(lines, ["-1", "-0.5", "0", "0.5", "1"]);
  assert.equal(chart.querySelector("[data-mark]").getAttribute("x1"), "80.0");
  assert.ok(!chart.hidden);
  const charts = { heights: { one: null, two: null } };
  const empty = figure(panelHtml(SPEC, { ...STATE, charts }));
  assert.ok(empty.querySelector("[data-chart]").hidden);
  const many = {
    heights: Object.fromEntries(["a", "b", "c", "d", "e"].map((name) => [name, null])),
  };
  const caption = figure(panelHtml(SPEC, { ...STATE, charts: many })).querySelector("figcaption");
  assert.equal(caption.textContent, "height a b c d e");
});

test("what to try is a sentence of links to states", () => {
  const tries = panel().querySelector(".explorable-tries");
  assert.equal(tries.textContent, "Try: further & on\u00a0· back");
  assert.equal(tries.querySelector("a").getAttribute("href"), "#explore-some-figure?u=2&way=short");
});
