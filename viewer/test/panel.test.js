import assert from "node:assert/strict";
import { test } from "node:test";
import { Panel } from "../src/panel.js";
import { calm, figure, hold, readerOf, tell, tick } from "./dom.js";
import { near, points } from "./near.js";

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
  <label>length <output name="length" data-digits="2" data-unit="°" data-loud="no"></output></label>
  <label>fits <output name="fits" data-digits="2" data-unit="" data-loud="no"></output></label>
  <figure class="scene-handles" data-chart="heights" data-over="u" data-x="1 3" data-y="-1 1">
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
const START = { u: 1.5, v: 0, on: false, way: "short", points: points("1,0,0 0,1,0") };

/** A bound panel, its inputs, and what it has asked for. */
function bound(start = {}, specs = SPECS) {
  const element = figure(PANEL);
  const state = { inputs: { ...START, ...start }, asked: [], back: [], said: [] };
  const actions = {
    change(changes, spoken) {
      state.asked.push(changes);
      Object.assign(state.inputs, changes);
      if (spoken) state.said.push(spoken());
    },
    back(to, then) {
      state.back.push(to);
      Object.assign(state.inputs, to);
      then();
    },
    reset: () => state.asked.push("reset"),
    link: () => state.asked.push("link"),
    follow: ({ hash }) => state.asked.push(hash),
  };
  const panel = new Panel(element, specs, () => state.inputs, actions);
  const play = element.querySelector("[data-action=play]");
  return { element, state, panel, ...readerOf(element), play };
}

/** Where u was asked to go. */
const wayOf = ({ asked }) => asked.map(({ u }) => u);

test("each control moves its own input, within its bounds, once the panel is bound", () => {
  const { state, find, write } = bound();
  assert.ok(!find("fieldset").disabled);
  write("u", "2.5");
  write("v", "-0.5");
  write("u-number", "1.25");
  for (const value of ["7", "-7"]) write("v-number", value);
  write("u-number", "");
  write("of no figure", "1");
  for (const selector of ["[name=on]", "[value=long]"]) {
    find(selector).checked = true;
    tell(find(selector), "input");
  }
  const numbers = [{ u: 2.5 }, { v: -0.5 }, { u: 1.25 }, { v: 1 }, { v: -1 }];
  assert.deepEqual(state.asked, [...numbers, { on: true }, { way: "long" }]);
});

test("controls show the inputs, but not the field in which somebody writes", () => {
  const { panel, find } = bound();
  const values = { ...START, u: 1.234, v: -1, on: true, way: "long" };
  const shown = () => [
    ...["u", "u-number", "v", "v-number"].map((name) => find(`[name="${name}"]`).value),
    ...["[name=on]", "[value=short]", "[value=long]"].map((selector) => find(selector).checked),
  ];
  panel.show(values, {});
  assert.deepEqual(shown(), ["1.234", "1.23", "-1", "-1", true, false, true]);
  find("[name=u-number]").focus();
  panel.show({ ...values, u: 1, on: false, way: "short" }, {});
  assert.deepEqual(shown(), ["1", "1.23", "-1", "-1", false, true, false]);
});

test("numbers and texts are written, loud where it matters, and withheld where none holds", () => {
  const { panel, find } = bound();
  const shown = () => ["length", "fits"].map((name) => find(`output[name=${name}]`).textContent);
  const loud = () => find("output[name=fits]").classList.contains("explorable-loud");
  panel.show(START, { outputs: { length: -1.236, fits: "no" } });
  assert.deepEqual([...shown(), loud()], ["−1.24°", "no", true]);
  assert.equal(panel.outcome(), "length −1.24°, fits no");
  const node = find("output[name=fits]").firstChild;
  panel.show(START, { outputs: { fits: [1, 2] } });
  assert.equal(find("output[name=fits]").firstChild, node);
  assert.deepEqual([...shown(), loud()], ["−1.24°", "1.00, 2.00", false]);
  panel.withhold();
  assert.deepEqual(shown(), ["–", "– –"]);
});

test("a chart has its curves, names, marks and the place of its input, while it has a curve", () => {
  const { panel, find } = bound();
  const shown = (one, two) => {
    const charts = { heights: { one, two } };
    panel.show({ ...START, u: 2.5 }, { charts });
    return [
      ...["one", "two"].map((name) => find(`[data-curve=${name}]`).getAttribute("d") !== ""),
      ...["one", "two"].map((name) => !find(`[data-name=${name}]`).hidden),
      ...[...find(".explorable-marks").children].map(({ hidden }) => !hidden),
      !find("[data-chart]").hidden,
    ];
  };
  assert.deepEqual(shown(null, null), [false, false, false, false, true, false, false]);
  assert.deepEqual(shown(null, [0, 1]), [false, true, false, true, true, false, true]);
  assert.deepEqual(shown([0, 1], points("0,1 1,0")), Array(7).fill(true));
  const said = ["x1", "x2"].map((end) => find("[data-mark]").getAttribute(end));
  said.push(...["now", "text"].map((what) => find("svg").getAttribute(`aria-value${what}`)));
  assert.deepEqual(said, ["240", "240", "2.5", "u 2.5"]);
  const isCut = (far) => shown([0, far], null) && find("[data-curve=one]").matches("[data-cut]");
  assert.deepEqual([isCut(2), isCut(1)], [true, false]);
});

test("along a chart a number is dragged, and moved by keys", () => {
  const { find, state } = bound();
  const plot = find("svg");
  plot.getBoundingClientRect = () => ({ left: 10, top: 20, width: 100, height: 100 });
  hold(plot, [50, 90], [75.2, 10]);
  tell(plot, "pointerup");
  for (const [key, shiftKey] of [["ArrowRight"], ["ArrowDown", true], ["a"]]) {
    tell(plot, "keydown", { key, shiftKey });
  }
  near(wayOf(state), [2, 2.5, 2.51, 2.41]);
  assert.equal(plot.getAttribute("role"), "slider");
});

test("points are added and taken from the end, as long as there may be so many", () => {
  const { state, panel, find, press } = bound({ points: points("1,0,0 0.6,0.8,0") });
  const may = () => {
    panel.show(state.inputs, {});
    return ["add", "remove"].map((action) => !find(`[data-action=${action}]`).disabled);
  };
  assert.deepEqual(may(), [true, false]);
  press("add");
  assert.equal(state.inputs.points.length, 3);
  assert.deepEqual(may(), [false, true]);
  press("remove");
  assert.equal(state.inputs.points.length, 2);
  assert.deepEqual(state.said, ["Point added", "Point removed"]);
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
  near(wayOf(state), [1.75, 2, 2.25, 2.5, 2.75, 3]);
  assert.deepEqual(state.back, [{ u: 1 }]);
  // It may be as wide as another input says.
  const other = bound({ u: 1, w: 0.3 }, { ...SPECS, u: { ...SPECS.u, stride: "w" } });
  for (let i = 0; i < 3; i++) other.press("step");
  near(wayOf(other.state), [1.3, 1.6, 1.9]);
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
  const { state, play } = bound({ u: 2.5 });
  const shown = () => state.asked.splice(0).map(({ u }) => u);
  play.click();
  assert.equal(play.textContent, "Pause");
  tick(1000, 1500, 2500, 3000, 4100, 4200, 4300);
  near(shown(), [2.5, 2.75, 3, 3, 1, 1.05]);
  assert.deepEqual(state.back.splice(0), [{ u: 1 }]);
  play.click();
  assert.equal(play.textContent, "Play");
  tick(5000);
  play.click();
  tick(6000);
  near(shown(), [1.05]);
  // From the end it begins anew.
  const other = bound({ u: 3 });
  other.play.click();
  tick(0, 500);
  assert.deepEqual(other.state.back, [{ u: 1 }]);
  assert.deepEqual(other.state.asked, [{ u: 1 }, { u: 1.25 }]);
});

test("only one input plays", () => {
  const { element, state } = bound();
  const [first, second] = element.querySelectorAll("[data-action=play]");
  first.click();
  tick(0);
  second.click();
  assert.deepEqual([first.textContent, second.textContent], ["Play", "Pause"]);
  tick(0, 500);
  assert.deepEqual(state.asked, [{ u: 1.5 }, { v: 0 }, { v: 0.5 }]);
});

test("play stops where the hand takes something, and where the figure leaves the screen", () => {
  const moved = (top, bottom) => (panel) =>
    (panel.element.getBoundingClientRect = () => ({ top, bottom }));
  const grabs = (kind) => (panel) => {
    panel.element.insertAdjacentHTML("beforeend", '<button data-handle="point"></button>');
    tell(panel.element, kind);
    assert.equal(panel.play.textContent, "Pause");
    tell(panel.find("button[data-handle]"), kind);
  };
  for (const stop of [
    ({ write }) => write("v", "0.5"),
    ({ press }) => press("reset"),
    moved(-300, -1),
    moved(801, 900),
    grabs("pointerdown"),
    grabs("keydown"),
  ]) {
    const panel = bound();
    panel.play.click();
    tick(0);
    stop(panel);
    const { length } = panel.state.asked;
    tick(100, 200);
    assert.equal(panel.state.asked.length, length);
    assert.equal(panel.play.textContent, "Play");
  }
});

test("a slider plays by itself, once; who wants no motion has nothing to play", () => {
  const { state, panel, play } = bound();
  const seen = [];
  assert.ok(!play.hidden);
  panel.playOnce((changes) => seen.push(Object.assign(state.inputs, changes).u));
  assert.equal(play.textContent, "Pause");
  for (let time = 0; time < 9000; time += 500) tick(time);
  assert.deepEqual(seen, [1.5, 1.75, 2, 2.25, 2.5, 2.75, 3]);
  assert.deepEqual(state.back, [{ u: 1.5 }]);
  assert.equal(play.textContent, "Play");
  assert.deepEqual(state.asked, []);

  calm.matches = true;
  const still = bound();
  still.panel.playOnce(() => assert.fail());
  tick(0);
  assert.ok(still.play.hidden);
  calm.matches = false;
});
