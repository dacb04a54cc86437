import assert from "node:assert/strict";
import { test } from "node:test";
import { explore } from "../src/explore.js";
import { drag, figure, liveScene, tell, tick } from "./dom.js";

const PANEL = `<p class="explorable-status" role="status"></p>
  <form class="explorable-panel"><fieldset disabled>
  <input type="range" name="u" min="0" max="1" step="any">
  <input type="range" name="v" min="0" max="2" step="any">
  <button type="button" data-action="play" data-input="u">Play</button>
  <button type="button" data-action="step" data-input="u">Step</button>
  <label><span>sum</span> <output name="sum" data-digits="2" data-unit="" data-loud="no"></output></label>
  <button type="button" data-action="reset">Reset</button>
  <button type="button" data-action="link">Link</button></fieldset></form>`;
const NUMBER = { kind: "number", step: 0.01, stride: 0.1, plays: 0 };
const INPUTS = { u: { ...NUMBER, low: 0, high: 1 }, v: { ...NUMBER, low: 0, high: 2 } };
const stateOf = (u, v) => ({
  parts: { ball: { at: [u, v, 0] } },
  labels: {},
  outputs: { sum: u + v },
  charts: {},
});
const START = { u: 0.25, v: 1 };

/** A figure with a model, or with what is given instead. */
function shown({
  data = {},
  models = { add: ({ u, v }) => stateOf(u, v) },
  python,
  past = null,
  around = "",
} = {}) {
  history.replaceState(past, "");
  const element = figure(PANEL);
  element.parentElement.className = around;
  const scene = element.querySelector(".scene");
  const live = liveScene(scene);
  const made = {
    name: "some-figure",
    inputs: INPUTS,
    start: START,
    model: "add",
    constants: {},
    ...data,
  };
  const hand = explore(element, live, made, models, python);
  const find = (selector) => element.querySelector(selector);
  const write = (name, value) => {
    find(`[name=${name}]`).value = value;
    tell(find(`[name=${name}]`), "input");
  };
  const values = () => JSON.parse(element.dataset.values);
  const status = () => find(".explorable-status").textContent;
  return { element, scene, live, hand, find, write, values, status };
}

test("a figure tells its values at once, and draws nothing that is there already", () => {
  const { live, values, find } = shown();
  assert.deepEqual(values(), { ...START, sum: 1.25 });
  assert.equal(find("output").textContent, "1.25");
  assert.deepEqual(live.applied, []);
});

test("what the hand changes is computed, shown and told", () => {
  const { live, write, values, find } = shown();
  write("v", "1.5");
  assert.deepEqual(live.applied, [stateOf(0.25, 1.5)]);
  assert.deepEqual(values(), { u: 0.25, v: 1.5, sum: 1.75 });
  assert.equal(find("output").textContent, "1.75");
  assert.equal(find(".scene-hint"), null);
  find("[data-action=step]").click();
  assert.ok(Math.abs(values().u - 0.3) < 1e-9);
});

test("a model is given the constants of its figure, and may correct inputs", () => {
  const add = ({ u, v }, { more }) => ({ ...stateOf(u, v + more), inputs: { v: 0.5 } });
  const data = { constants: { more: 0.125 } };
  const { write, values } = shown({ data, models: { add } });
  write("u", "0.5");
  assert.deepEqual(values(), { u: 0.5, v: 0.5, sum: 1.625 });
});

/** A model that refuses where u is 1. */
function refusing({ u, v }) {
  if (u === 1) throw Object.assign(new Error("p and q are antipodal"), { name: "DegenerateError" });
  return stateOf(u, v);
}

test("a geometry without an answer keeps the last picture, pale, and says why", () => {
  const { live, scene, write, values, status, find } = shown({ models: { add: refusing } });
  write("u", "0.5");
  write("u", "1");
  assert.equal(status(), "P and q are antipodal.");
  assert.ok(scene.hasAttribute("data-refused"));
  assert.equal(find("output").textContent, "–");
  assert.deepEqual(values(), { u: 1, v: 1, refused: "p and q are antipodal" });
  assert.equal(live.applied.length, 1);
  write("u", "0.75");
  assert.equal(status(), "");
  assert.ok(!scene.hasAttribute("data-refused"));
  assert.deepEqual(values(), { u: 0.75, v: 1, sum: 1.75 });
});

test("any other error is one", () => {
  const add = ({ u, v }) => {
    if (u === 1) throw new RangeError("no");
    return stateOf(u, v);
  };
  const { hand } = shown({ models: { add } });
  assert.throws(() => hand.set({ u: 1 }), RangeError);
});

test("reset brings inputs and camera back, and says so once the hand rests", ({ mock }) => {
  mock.timers.enable({ apis: ["setTimeout"] });
  const { live, write, find, values, status } = shown();
  write("u", "1");
  find("[data-action=reset]").click();
  assert.deepEqual(values(), { ...START, sum: 1.25 });
  assert.equal(live.resets, 1);
  assert.equal(status(), "");
  mock.timers.tick(500);
  assert.equal(status(), "Reset");
  find("[data-action=reset]").click();
  write("u", "0.5");
  mock.timers.tick(500);
  assert.equal(status(), "u 0.5. sum 1.50");
});

test("the address leads to the state, and the state follows the address", () => {
  const { write, find } = shown();
  write("u", "0.5");
  find("[data-action=link]").click();
  assert.equal(location.hash, "#explore-some-figure?u=0.5");
  const { values } = shown();
  assert.deepEqual(values(), { u: 0.5, v: 1, sum: 1.5 });
  history.replaceState(null, "", "#explore-some-figure?v=0.5");
  dispatchEvent(new Event("hashchange"));
  assert.deepEqual(values(), { u: 0.25, v: 0.5, sum: 0.75 });
  history.replaceState(null, "", "#explore-another?v=0");
  dispatchEvent(new Event("hashchange"));
  assert.deepEqual(values(), { u: 0.25, v: 0.5, sum: 0.75 });
  history.replaceState(null, "", "/");
});

test("a link is copied, or else shown to be copied by hand", async () => {
  const copied = [];
  const clipboard = { writeText: async (text) => copied.push(text) };
  const { write, find, status } = shown();
  write("u", "0.5");
  for (const [granted, words, inField] of [
    [clipboard, "Link copied. It opens the figure as it is set.", undefined],
    [undefined, "Copy this link to the figure as it is set: ", location.href],
  ]) {
    Object.defineProperty(globalThis, "navigator", {
      value: { clipboard: granted },
      configurable: true,
    });
    find("[data-action=link]").click();
    await Promise.resolve();
    assert.equal(status(), words);
    const field = find(".explorable-status input");
    assert.equal(field?.value, inField && location.href);
    assert.equal(document.activeElement === field, Boolean(field));
  }
  assert.deepEqual(copied, [location.href]);
  assert.match(location.href, /#explore-some-figure\?u=0\.5$/);
  history.replaceState(null, "", "/");
});

test("what is said of a link is not talked over by what came before", async ({ mock }) => {
  mock.timers.enable({ apis: ["setTimeout"] });
  const { write, find, status } = shown();
  write("u", "0.5");
  find("[data-action=link]").click();
  await Promise.resolve();
  const said = status();
  assert.match(said, /link/i);
  mock.timers.tick(500);
  assert.equal(status(), said);
  history.replaceState(null, "", "/");
});

test("the history keeps the state for Back and for a reload, until Reset", () => {
  const { write, find } = shown();
  write("u", "0.5");
  write("v", "2");
  const reloaded = () => shown({ past: history.state }).values();
  // The last change waits until the hand rests, the first does not.
  assert.deepEqual(reloaded(), { u: 0.5, v: 1, sum: 1.5 });
  find("[data-action=reset]").click();
  assert.deepEqual(reloaded(), { ...START, sum: 1.25 });
  assert.deepEqual(shown().values(), { ...START, sum: 1.25 });
});

test("the history keeps what the hand leaves once it rests, of each figure", ({ mock }) => {
  mock.timers.enable({ apis: ["setTimeout"] });
  const past = { another: "#explore-another?w=1" };
  const { write } = shown({ past });
  for (const u of ["0.5", "0.75", "1"]) write("u", u);
  mock.timers.tick(500);
  assert.deepEqual(history.state, { ...past, "some-figure": "#explore-some-figure?u=1" });
});

test("an address wins over the history, and goes when it is no longer true", () => {
  history.replaceState(null, "", "/#explore-some-figure?u=1");
  const past = { "some-figure": "#explore-some-figure?v=2" };
  const { values, write } = shown({ past });
  assert.deepEqual(values(), { u: 1, v: 1, sum: 2 });
  assert.equal(location.hash, "#explore-some-figure?u=1");
  write("v", "0.5");
  assert.equal(location.hash, "");
  assert.deepEqual(shown({ past: history.state }).values().u, 1);
  history.replaceState(null, "", "/#explore-another?u=1");
  const other = shown();
  other.write("v", "0.5");
  assert.equal(location.hash, "#explore-another?u=1");
  history.replaceState(null, "", "/");
});

test("Back brings an earlier state back, also if the address stays", () => {
  const { write, values } = shown();
  write("u", "0.5");
  const past = history.state;
  write("u", "1");
  history.replaceState(past, "");
  dispatchEvent(new Event("popstate"));
  assert.deepEqual(values(), { u: 0.5, v: 1, sum: 1.5 });
  // A link to a section has no state: the figure stays, and so it is kept.
  history.replaceState(null, "");
  dispatchEvent(new Event("popstate"));
  assert.deepEqual(values(), { u: 0.5, v: 1, sum: 1.5 });
  assert.deepEqual(history.state, past);
});

test("a change is told in a sentence, and the picture's name with it, once the hand rests", ({
  mock,
}) => {
  mock.timers.enable({ apis: ["setTimeout"] });
  const inputs = { u: { ...INPUTS.u, label: "turn, °" }, v: INPUTS.v };
  const { write, status, live, find } = shown({ data: { inputs } });
  live.canvas.setAttribute("aria-label", "unheard");
  const name = () => live.canvas.getAttribute("aria-label");
  write("u", "0.5");
  write("u", "1");
  mock.timers.tick(499);
  assert.equal(status(), "");
  mock.timers.tick(1);
  assert.equal(status(), "turn 1°. sum 2.00");
  assert.equal(find(".explorable-spoken").textContent, status());
  write("v", "0.5");
  mock.timers.tick(500);
  assert.equal(status(), "v 0.5. sum 1.50");
  assert.equal(name(), "Changed: turn 1°, v 0.5. sum 1.50");
  find("[data-action=reset]").click();
  mock.timers.tick(500);
  assert.equal(name(), "A ball");
});

test("what a model shows only while the hand moves goes once it rests", ({ mock }) => {
  mock.timers.enable({ apis: ["setTimeout"] });
  const model = ({ u, v }, _, changed) => ({ ...stateOf(u, v), labels: { P: changed } });
  const { live, write, hand } = shown({ models: { add: model } });
  hand.set({ v: 2 });
  mock.timers.tick(500);
  write("v", "1.5");
  mock.timers.tick(500);
  mock.timers.tick(500);
  assert.deepEqual(
    live.applied.map(({ labels }) => labels.P),
    [["v"], ["v"], []],
  );
});

test("what Python sets is not announced, but the picture's name follows", ({ mock }) => {
  mock.timers.enable({ apis: ["setTimeout"] });
  const { hand, status, live } = shown();
  hand.set({ v: 2 });
  mock.timers.tick(500);
  assert.equal(status(), "");
  assert.equal(live.canvas.getAttribute("aria-label"), "Changed: v 2. sum 2.25");
});

const POINTS = {
  inputs: { p: { kind: "points", names: ["P", "Q"], length: 2, reach: 1 } },
  start: {
    p: [
      [0, -2, 0],
      [0, 0, 2],
    ],
  },
};
const pointed = ({ p }) => ({ parts: {}, labels: {}, outputs: { sum: p[0][0] }, charts: {} });

test("a dragged point keeps its length; the status line says where it lies", ({ mock }) => {
  mock.timers.enable({ apis: ["setTimeout"] });
  const { scene, values, status } = shown({ data: POINTS, models: { add: pointed } });
  const handle = scene.querySelector("[data-handle=p-0]");
  drag(handle, 25, 0);
  const [[x, y], q] = values().p;
  assert.ok(Math.abs(x - 1) < 1e-6 && Math.abs(y + Math.sqrt(3)) < 1e-6);
  assert.deepEqual(q, [0, 0, 2]);
  mock.timers.tick(500);
  assert.equal(status(), `${handle.getAttribute("aria-label")}. sum 1.00`);
});

/** Python in a notebook, which keeps what it is told. */
function notebook(values) {
  const python = { values, told: [] };
  python.tell = (inputs) => python.told.push(inputs);
  return python;
}

test("in a notebook the figure starts where Python is, and tells it what the hand does", () => {
  const python = notebook({ u: 0.5, v: 1 });
  const { hand, write, values, live } = shown({ python });
  assert.deepEqual(values(), { u: 0.5, v: 1, sum: 1.5 });
  assert.equal(live.applied.length, 1);
  hand.set({ u: 0.75 });
  assert.deepEqual(python.told, []);
  write("v", "0");
  assert.deepEqual(python.told, [{ u: 0.75, v: 0 }]);
  // The address of a notebook is not the figure's.
  history.replaceState(null, "", "#explore-some-figure?u=0.5");
  dispatchEvent(new Event("hashchange"));
  assert.deepEqual(values(), { u: 0.75, v: 0, sum: 0.75 });
  history.replaceState(null, "", "#");
});

test("a cell with the tag plays its figure for who comes to no state of it", () => {
  const plays = { ...INPUTS, u: { ...INPUTS.u, plays: 1 } };
  const played = (around, hash = "") => {
    location.hash = hash;
    const { values } = shown({ data: { inputs: plays }, around });
    for (const time of [0, 100]) tick(time);
    location.hash = "";
    return values().u;
  };
  assert.equal(played("tag_plays"), 0.35);
  assert.equal(played("cell"), 0.25);
  assert.equal(played("tag_plays", "#explore-some-figure?u=0.5"), 0.5);
});
