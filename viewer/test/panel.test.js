import assert from "node:assert/strict";
import { test } from "node:test";
import { bindPanel } from "../src/panel.js";
import { calm, figure, tell, tick } from "./dom.js";

const PANEL = `<form class="explorable-panel"><fieldset disabled>
  <input type="range" name="u" min="1" max="3" step="any">
  <input type="number" name="u-number" min="1" max="3" step="any">
  <button type="button" data-action="play" data-input="u">Play</button>
  <button type="button" data-action="step" data-input="u">Step</button>
  <input type="range" name="v" min="-1" max="1" step="any">
  <input type="number" name="v-number" min="-1" max="1" step="any">
  <button type="button" data-action="play" data-input="v">Play</button>
  <input name="of no figure">
  <input type="checkbox" name="on">
  <input type="radio" name="way" value="short"><input type="radio" name="way" value="long">
  <button type="button" data-action="add" data-input="points">Add</button>
  <button type="button" data-action="remove" data-input="points">Remove</button>
  <output name="length" data-digits="2" data-unit="°" data-loud="no"></output>
  <output name="fits" data-digits="2" data-unit="" data-loud="no"></output>
  <output name="matrix" data-digits="1" data-unit="" data-loud="no"></output>
  <figure data-chart="heights" data-over="u" data-x="1 3" data-y="-1 1">
    <svg viewBox="0 0 320 128"><path data-curve="one" d=""/><path data-curve="two" d=""/>
    <line data-mark="" x1="0" x2="0"/></svg>
    <div class="explorable-names"><span data-name="one">one</span><span data-name="two">two</span></div>
    <div class="explorable-marks"><span>P</span><span hidden>Q</span></div></figure>
  <button type="button" data-action="reset">Reset</button>
  <button type="button" data-action="link">Link</button>
  <a class="try" href="#explore-some-figure?u=2"><i>u</i> = 2</a>
</fieldset></form>`;
const SPECS = {
  u: { kind: "number", low: 1, high: 3, step: 0.01, stride: 0.25, plays: 4 },
  v: { kind: "number", low: -1, high: 1, step: 1, stride: 0.25, plays: 2 },
  on: { kind: "switch" },
  way: { kind: "choice", options: ["short", "long"] },
  points: { kind: "points", names: ["P", "Q", "R"], least: 2, most: 3 },
};
const START = {
  u: 1.5,
  v: 0,
  on: false,
  way: "short",
  points: [
    [1, 0, 0],
    [0, 1, 0],
  ],
};
const NONE = { outputs: {} };

/** A bound panel, its inputs, and what it has asked for. */
function bound(start = {}) {
  const element = figure(PANEL);
  const state = { inputs: { ...START, ...start }, asked: [], said: [] };
  const actions = {
    change(changes, spoken) {
      state.asked.push(changes);
      Object.assign(state.inputs, changes);
      if (spoken) state.said.push(spoken());
    },
    reset: () => state.asked.push("reset"),
    link: () => state.asked.push("link"),
    follow: ({ hash }) => state.asked.push(hash),
  };
  const panel = bindPanel(element, SPECS, () => state.inputs, actions);
  const find = (selector) => element.querySelector(selector);
  const press = (action) => find(`[data-action=${action}]`).click();
  const write = (name, value) => {
    find(`[name="${name}"]`).value = value;
    tell(find(`[name="${name}"]`), "input");
  };
  return { element, state, panel, find, press, write };
}

test("a panel is switched on once it is bound", () => {
  assert.ok(!bound().find("fieldset").disabled);
});

test("each slider moves its own input, also by the number beside it, within its bounds", () => {
  const { state, write } = bound();
  write("u", "2.5");
  write("v", "-0.5");
  write("u-number", "1.25");
  write("v-number", "7");
  write("v-number", "-7");
  write("u-number", "");
  write("of no figure", "1");
  assert.deepEqual(state.asked, [{ u: 2.5 }, { v: -0.5 }, { u: 1.25 }, { v: 1 }, { v: -1 }]);
});

test("a switch and a choice say what they are", () => {
  const { state, find } = bound();
  for (const selector of ["[name=on]", "[value=long]"]) {
    find(selector).checked = true;
    tell(find(selector), "input");
  }
  assert.deepEqual(state.asked, [{ on: true }, { way: "long" }]);
});

test("controls show the inputs, but not the field in which somebody writes", () => {
  const { panel, find } = bound();
  const values = { ...START, u: 1.234, v: -1, on: true, way: "long" };
  panel.show(values, NONE);
  const shown = ["u", "u-number", "v", "v-number"].map((name) => find(`[name="${name}"]`).value);
  assert.deepEqual(shown, ["1.234", "1.23", "-1", "-1"]);
  assert.ok(find("[name=on]").checked);
  const ways = () => ["short", "long"].map((way) => find(`[value=${way}]`).checked);
  assert.deepEqual(ways(), [false, true]);
  find("[name=u-number]").focus();
  panel.show({ ...values, u: 1, on: false, way: "short" }, NONE);
  assert.equal(find("[name=u-number]").value, "1.23");
  assert.equal(find("[name=u]").value, "1");
  assert.ok(!find("[name=on]").checked);
  assert.deepEqual(ways(), [true, false]);
});

test("numbers, texts and matrices are written with their digits", () => {
  const { panel, find } = bound();
  const text = (name) => find(`output[name=${name}]`).textContent;
  const loud = () => find("output[name=fits]").classList.contains("explorable-loud");
  panel.show(START, {
    outputs: {
      length: -1.236,
      fits: "no",
      matrix: [
        [1, -10.04],
        [0, -0.04],
      ],
    },
  });
  assert.equal(text("length"), "−1.24°");
  assert.equal(text("fits"), "no");
  assert.ok(loud());
  assert.equal(text("matrix"), "  1.0 −10.0\n  0.0   0.0");
  panel.show(START, { outputs: { length: -0.001, fits: "yes", matrix: [1, 2] } });
  assert.equal(text("length"), "0.00°");
  assert.ok(!loud());
  assert.equal(text("matrix"), "1.0, 2.0");
  panel.withhold();
  assert.deepEqual(["length", "fits", "matrix"].map(text), ["–", "–", "– –"]);
});

test("what rises in a curve rises on the chart", () => {
  const { panel, find } = bound();
  const d = (curve) => find(`[data-curve=${curve}]`).getAttribute("d");
  panel.show(START, { outputs: {}, charts: { heights: { one: [-1, 0, 0.5], two: null } } });
  assert.equal(d("one"), "M0.0,128.0 160.0,64.0 320.0,32.0");
  assert.equal(d("two"), "");
});

test("a chart is there while it has a curve", () => {
  const { panel, find } = bound();
  const drawn = (heights) => panel.show(START, { outputs: {}, charts: { heights } });
  drawn({ one: null, two: null });
  assert.equal(find("[data-chart]").hidden, true);
  drawn({ two: [0, 1] });
  assert.equal(find("[data-chart]").hidden, false);
});

test("names stand beside the ends of curves, but apart, and without a curve there is none", () => {
  const { panel, find } = bound();
  const placed = (curves) => {
    panel.show(START, { outputs: {}, charts: { heights: curves } });
    return ["one", "two"]
      .map((name) => find(`[data-name=${name}]`))
      .map(({ hidden, style }) => (hidden ? null : style.top));
  };
  assert.deepEqual(placed({ one: [0, 0.5], two: [0, -0.5] }), ["25%", "75%"]);
  assert.deepEqual(placed({ one: [0, 0.5], two: [0, 0.52] }), ["37%", "24%"]);
  assert.deepEqual(
    placed({
      one: [
        [1, 1],
        [0, -1],
      ],
      two: [0, -3],
    }),
    ["87%", "100%"],
  );
  assert.deepEqual(placed({ two: null }), ["100%", null]);
});

test("each curve has its own path, in pieces of one width", () => {
  const { panel, find } = bound();
  const d = (curve) => find(`[data-curve=${curve}]`).getAttribute("d");
  const hidden = () => [...find(".explorable-marks").children].map((mark) => mark.hidden);
  panel.show(START, {
    outputs: {},
    charts: {
      heights: {
        two: [
          [-1, 0],
          [1, 0],
        ],
      },
    },
  });
  assert.equal(d("one"), "");
  assert.equal(d("two"), "M0.0,128.0 160.0,64.0M160.0,0.0 320.0,64.0");
  assert.deepEqual(hidden(), [false, false]);
  panel.show(START, { outputs: {}, charts: { heights: { two: [0, 0] } } });
  assert.deepEqual(hidden(), [false, true]);
});

test("an arrow stands in the middle of what a chart cuts off, at its edge", () => {
  const { panel, find } = bound();
  panel.show(START, { outputs: {}, charts: { heights: { one: [0, 2, 2, 0, -3] } } });
  const arrows = find("[data-curve=one]").getAttribute("d").split("M").slice(2);
  assert.deepEqual(arrows, [
    "116.0,7.0 120.0,0.0 124.0,7.0",
    "316.0,121.0 320.0,128.0 324.0,121.0",
  ]);
  const [, line] = find("[data-curve=one]").getAttribute("d").split("M");
  assert.equal(line, "0.0,64.0 80.0,-6.4 160.0,-6.4 240.0,64.0 320.0,134.4");

  // What only rounding puts beyond an edge is on it.
  panel.show(START, { outputs: {}, charts: { heights: { one: [-1 - 2e-16, 0, 1 + 3e-16] } } });
  assert.equal(find("[data-curve=one]").getAttribute("d").split("M").length, 2);
});

test("the mark of a chart stands at the value of its input", () => {
  const { panel, find } = bound();
  panel.show({ ...START, u: 2.5, v: 1 }, NONE);
  const mark = find("[data-mark]");
  assert.deepEqual([mark.getAttribute("x1"), mark.getAttribute("x2")], ["240", "240"]);
});

test("points are added in the widest gap and taken from the end, as long as there may be so many", () => {
  const { state, panel, find, press } = bound({
    points: [
      [1, 0, 0],
      [0.6, 0.8, 0],
    ],
  });
  const may = () => ["add", "remove"].map((action) => !find(`[data-action=${action}]`).disabled);
  panel.show(state.inputs, NONE);
  assert.deepEqual(may(), [true, false]);
  press("add");
  const [, added] = state.inputs.points;
  assert.equal(state.inputs.points.length, 3);
  assert.ok(Math.abs(Math.hypot(...added) - 1) < 1e-12);
  assert.ok(Math.abs(added[1] / added[0] - 0.5) < 1e-12);
  panel.show(state.inputs, NONE);
  assert.deepEqual(may(), [false, true]);
  press("remove");
  assert.deepEqual(state.inputs.points, [[1, 0, 0], added]);
  assert.deepEqual(state.said, ["Point added", "Point removed"]);
});

test("the widest gap may be the last", () => {
  const points = [
    [1, 0, 0],
    [0.8, 0.6, 0],
    [0, 1, 0],
    [-1, 0, 0],
  ];
  const { state, press } = bound({ points });
  press("add");
  assert.deepEqual(state.inputs.points.slice(0, 4), points);
  const close = [
    [1, 0, 0],
    [0.8, 0.6, 0],
    [0.6, 0.8, 0],
  ];
  const other = bound({ points: close.map(([x, y]) => [2 * x, 2 * y, 0]) });
  other.press("add");
  const [x, y] = other.state.inputs.points[3];
  assert.ok(Math.abs(Math.hypot(x, y) - 2) < 1e-12);
  assert.ok(Math.abs(y / x - 0.5) < 1e-12);
});

test("between opposite points a new one stands away from the others, or anywhere across", () => {
  const half = [
    [0.6, 0, 0.8],
    [0, 1, 0],
    [-0.6, 0, -0.8],
  ];
  const circle = bound({ points: half });
  circle.press("add");
  circle.state.inputs.points[3].forEach((x, k) => assert.ok(Math.abs(x - [0, -1, 0][k]) < 1e-12));
  const both = bound({
    points: [
      [0.6, 0, 0.8],
      [-0.6, 0, -0.8],
    ],
  });
  both.press("add");
  const [x, y, z] = both.state.inputs.points[1];
  assert.ok(Math.abs(Math.hypot(x, y, z) - 1) < 1e-12 && Math.abs(0.6 * x + 0.8 * z) < 1e-12);
});

test("buttons for the whole figure; the form itself does nothing", () => {
  const { state, find, press } = bound();
  press("reset");
  press("link");
  find("fieldset").click();
  assert.deepEqual(state.asked, ["reset", "link"]);
  assert.ok(tell(find("form"), "submit").defaultPrevented);
});

test("a chip is followed wherever it is pressed, but with a key held it is a link", () => {
  const { state, find } = bound();
  for (const selector of [".try", ".try i"]) {
    assert.ok(tell(find(selector), "click").defaultPrevented);
    assert.ok(!tell(find(selector), "click", { ctrlKey: true }).defaultPrevented);
  }
  assert.deepEqual(state.asked, Array(2).fill("#explore-some-figure?u=2"));
});

test("a step goes on to the next stride, and from the end to the beginning", () => {
  const { state, press } = bound({ u: 1.6 });
  for (let i = 0; i < 7; i++) press("step");
  const steps = state.asked.map(({ u }) => u);
  assert.deepEqual(steps, [1.75, 2, 2.25, 2.5, 2.75, 3, 1]);
});

test("a step may be as wide as another input says", () => {
  const { stride } = SPECS.u;
  SPECS.u.stride = "w";
  const { state, press } = bound({ u: 1, w: 0.3 });
  for (let i = 0; i < 3; i++) press("step");
  SPECS.u.stride = stride;
  state.asked.forEach(({ u }, i) => assert.ok(Math.abs(u - (1.3 + 0.3 * i)) < 1e-9));
});

test("a field that is left says the number that the figure has", () => {
  const { find, write, state } = bound();
  const field = find("[name=u-number]");
  for (const [typed, held] of [
    ["7", "3.00"],
    ["-1", "1.00"],
    ["", "1.00"],
    ["2.5", "2.50"],
  ]) {
    write("u-number", typed);
    assert.equal(field.value, typed);
    tell(field, "change");
    assert.equal(field.value, held);
    assert.equal(state.inputs.u, Number(held));
  }
});

test("play goes on from here in its time, rests at the end, starts over, and stops", () => {
  const { state, find, press } = bound({ u: 2.5 });
  press("play");
  assert.equal(find("[data-action=play]").textContent, "Pause");
  for (const time of [1000, 1500, 2500, 3000, 4100, 4200]) tick(time);
  const near = (mine, wanted) =>
    assert.ok(Math.abs(mine - wanted) < 1e-9, `${mine}, not ${wanted}`);
  [2.5, 2.75, 3, 3, 1, 1.05].forEach((u, i) => near(state.asked[i].u, u));
  press("play");
  assert.equal(find("[data-action=play]").textContent, "Play");
  tick(5000);
  assert.equal(state.asked.length, 6);
  press("play");
  tick(6000);
  near(state.asked[6].u, 1.05);
});

test("only one input plays", () => {
  const { element, state } = bound();
  const [first, second] = element.querySelectorAll("[data-action=play]");
  first.click();
  tick(0);
  second.click();
  assert.deepEqual(
    [first, second].map(({ textContent }) => textContent),
    ["Play", "Pause"],
  );
  tick(0);
  tick(500);
  assert.deepEqual(state.asked, [{ u: 1.5 }, { v: 0 }, { v: 0.5 }]);
});

test("play begins anew from the end", () => {
  const { state, press } = bound({ u: 3 });
  press("play");
  tick(0);
  assert.deepEqual(state.asked, [{ u: 1 }]);
});

test("play stops where the hand moves something, and where the figure leaves the screen", () => {
  for (const stop of [
    ({ write }) => write("v", "0.5"),
    ({ press }) => press("reset"),
    ({ element }) => (element.getBoundingClientRect = () => ({ top: -300, bottom: -1 })),
    ({ element }) => (element.getBoundingClientRect = () => ({ top: 801, bottom: 900 })),
  ]) {
    const panel = bound();
    panel.press("play");
    tick(0);
    stop(panel);
    const { length } = panel.state.asked;
    tick(100);
    tick(200);
    assert.equal(panel.state.asked.length, length);
    assert.equal(panel.find("[data-action=play]").textContent, "Play");
  }
});

test("without motion there is nothing to play", () => {
  calm.matches = true;
  assert.ok(bound().find("[data-action=play]").hidden);
  calm.matches = false;
  assert.ok(!bound().find("[data-action=play]").hidden);
});

test("a slider plays by itself, once, and not for who wants no motion", () => {
  const { state, panel, find } = bound();
  const button = find("[data-action=play]");
  const seen = [];
  panel.playOnce(({ u }) => seen.push(u));
  assert.equal(button.textContent, "Pause");
  for (let time = 0; time < 9000; time += 500) tick(time);
  assert.deepEqual(seen.slice(0, 9), [1.5, 1.75, 2, 2.25, 2.5, 2.75, 3, 1, 1.25]);
  assert.deepEqual(seen.slice(-3), [1, 1.25, 1.5]);
  assert.equal(button.textContent, "Play");
  assert.deepEqual(state.asked, []);

  calm.matches = true;
  bound().panel.playOnce(() => assert.fail());
  tick(0);
  calm.matches = false;
});

test("what is grabbed no longer plays", () => {
  for (const kind of ["pointerdown", "keydown"]) {
    const { element, find } = bound();
    const button = find("[data-action=play]");
    element.insertAdjacentHTML("beforeend", '<button data-handle="point"></button>');
    button.click();
    tell(element, kind);
    assert.equal(button.textContent, "Pause");
    tell(find("[data-handle=point]"), kind);
    assert.equal(button.textContent, "Play");
  }
});
