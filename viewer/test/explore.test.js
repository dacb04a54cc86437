import assert from "node:assert/strict";
import { afterEach, beforeEach, mock, test } from "node:test";
import { explore } from "../src/explore.js";
import { calm, drag, figure, liveScene, readerOf, tell, tick } from "./dom.js";
import { near, points } from "./near.js";

const PANEL = `<p class="explorable-status" role="status"></p>
  <form class="explorable-panel"><fieldset disabled>
  <input type="range" name="u" min="0" max="1" step="any">
  <input type="range" name="v" min="0" max="2" step="any">
  <button type="button" data-action="play" data-input="u">Play</button>
  <button type="button" data-action="step" data-input="u">Step</button>
  <label><span>sum</span> <output name="sum" data-digits="2" data-unit="" data-loud="no"></output></label>
  <a class="try" href="#explore-some-figure?u=1">all of u</a>
  <button type="button" data-action="reset">Reset</button>
  <button type="button" data-action="link">Link</button></fieldset></form>`;
const NUMBER = { kind: "number", step: 0.01, stride: 0.1, plays: 0 };
const INPUTS = { u: { ...NUMBER, low: 0, high: 1 }, v: { ...NUMBER, low: 0, high: 2 } };
const START = { u: 0.25, v: 1 };
const stateOf = (u, v) => ({ parts: { ball: { at: [u, v, 0] } }, outputs: { sum: u + v } });
const HASH = "#explore-some-figure?";

beforeEach(() => {
  mock.timers.enable({ apis: ["setTimeout"] });
  history.replaceState(null, "", "/");
  // Most of what follows is about where a figure arrives.
  calm.matches = true;
});
afterEach(() => mock.timers.reset());

/** A figure with a model, or with what is given instead. */
function shown({ data = {}, model = ({ u, v }) => stateOf(u, v), python, past, around = "" } = {}) {
  if (past) history.replaceState(past, "");
  const element = figure(PANEL);
  element.parentElement.className = around;
  const scene = element.querySelector(".scene");
  const view = liveScene(scene);
  const figured = { name: "some-figure", inputs: INPUTS, start: START, constants: {}, ...data };
  const hand = explore(element, view, { ...figured, model: "add" }, { add: model }, python);
  const values = () => JSON.parse(element.dataset.values);
  const reader = readerOf(element);
  const status = () => reader.find(".explorable-status").textContent;
  const name = () => view.canvas.getAttribute("aria-label");
  return { scene, view, hand, ...reader, values, status, name };
}

/** Come to an address, or back to an earlier entry of the history. */
function go(kind, state, hash) {
  history.replaceState(state, "", hash);
  dispatchEvent(new Event(kind));
}

test("values are told at once; what the hand changes is computed, shown and told", () => {
  const { view, press, write, values, find } = shown();
  assert.deepEqual(values(), { ...START, sum: 1.25 });
  assert.equal(find("output").textContent, "1.25");
  // It is there already.
  assert.deepEqual(view.applied, []);
  write("v", "1.5");
  assert.deepEqual(view.applied, [stateOf(0.25, 1.5)]);
  assert.deepEqual(values(), { u: 0.25, v: 1.5, sum: 1.75 });
  assert.equal(find("output").textContent, "1.75");
  assert.equal(find(".scene-hint"), null);
  press("step");
  near([values().u], [0.3]);
});

test("a model is given the constants of its figure, and may correct inputs", () => {
  const model = ({ u, v }, { more }) => ({ ...stateOf(u, v + more), inputs: { v: 0.5 } });
  const { write, values } = shown({ data: { constants: { more: 0.125 } }, model });
  write("u", "0.5");
  assert.deepEqual(values(), { u: 0.5, v: 0.5, sum: 1.625 });
});

test("a geometry without an answer leaves the picture pale and says why; a bug is an error", () => {
  const model = ({ u, v }) => {
    if (u === 0) throw new RangeError("no");
    if (u < 1) return stateOf(u, v);
    throw Object.assign(new Error("p and q are antipodal"), { name: "DegenerateError" });
  };
  const { view, hand, scene, write, values, status, find } = shown({ model });
  write("u", "0.5");
  write("u", "1");
  assert.equal(status(), "P and q are antipodal.");
  assert.ok(scene.hasAttribute("data-refused"));
  assert.equal(find("output").textContent, "–");
  assert.deepEqual(values(), { u: 1, v: 1, refused: "p and q are antipodal" });
  assert.equal(view.applied.length, 1);
  write("u", "0.75");
  assert.equal(status(), "");
  assert.ok(!scene.hasAttribute("data-refused"));
  assert.deepEqual(values(), { u: 0.75, v: 1, sum: 1.75 });
  assert.throws(() => hand.set({ u: 0 }), RangeError);
});

test("reset and chips go to a state as a whole, and say so once the hand rests", () => {
  const { view, scene, find, press, write, values, status } = shown();
  const said = () => {
    assert.equal(status(), "");
    mock.timers.tick(500);
    return status();
  };
  write("v", "2");
  press("reset");
  assert.deepEqual(values(), { ...START, sum: 1.25 });
  assert.equal(view.resets, 1);
  assert.equal(said(), "Reset");
  press("reset");
  write("v", "0.5");
  assert.equal(said(), "v 0.5. sum 0.75");
  scene.scrollIntoView = mock.fn();
  find(".try").click();
  assert.equal(scene.scrollIntoView.mock.callCount(), 1);
  assert.deepEqual(values(), { u: 1, v: 1, sum: 2 });
  assert.equal(location.hash, `${HASH}u=1`);
  assert.equal(said(), "all of u. sum 2.00");
});

test("the address leads to the state, and the state follows the address", () => {
  const first = shown();
  first.write("u", "0.5");
  first.press("link");
  assert.equal(location.hash, `${HASH}u=0.5`);
  const { values } = shown();
  assert.deepEqual(values(), { u: 0.5, v: 1, sum: 1.5 });
  for (const hash of [`${HASH}v=0.5`, "#explore-another?v=0"]) {
    go("hashchange", null, hash);
    assert.deepEqual(values(), { u: 0.25, v: 0.5, sum: 0.75 });
  }
});

test("a link is copied, or else shown to be copied by hand; nothing talks over that", async () => {
  const copied = [];
  const clipboard = { writeText: async (text) => copied.push(text) };
  const { write, press, find, status } = shown();
  for (const [granted, words, inField] of [
    [clipboard, "Link copied. It opens the figure as it is set.", undefined],
    [undefined, "Copy this link to the figure as it is set: ", `http://localhost/${HASH}u=0.5`],
  ]) {
    const value = { clipboard: granted };
    Object.defineProperty(globalThis, "navigator", { value, configurable: true });
    write("u", "0.5");
    press("link");
    await Promise.resolve();
    mock.timers.tick(500);
    assert.equal(status(), words);
    const field = find(".explorable-status input");
    assert.equal(field?.value, inField);
    assert.equal(document.activeElement === field, Boolean(field));
  }
  assert.deepEqual(copied, [`http://localhost/${HASH}u=0.5`]);
});

test("the history keeps the state for Back and for a reload, until Reset", () => {
  const past = { another: "#explore-another?w=1" };
  const { press, write } = shown({ past });
  write("u", "0.5");
  write("u", "1");
  // The last change waits until the hand rests, the first does not.
  assert.deepEqual(history.state, { ...past, "some-figure": `${HASH}u=0.5` });
  mock.timers.tick(500);
  assert.deepEqual(history.state, { ...past, "some-figure": `${HASH}u=1` });
  assert.deepEqual(shown().values(), { u: 1, v: 1, sum: 2 });
  press("reset");
  assert.deepEqual(shown().values(), { ...START, sum: 1.25 });
});

test("an address wins over the history, and goes when it is no longer true", () => {
  location.hash = `${HASH}u=1`;
  const { values, write } = shown({ past: { "some-figure": `${HASH}v=2` } });
  assert.deepEqual(values(), { u: 1, v: 1, sum: 2 });
  assert.equal(location.hash, `${HASH}u=1`);
  write("v", "0.5");
  assert.equal(location.hash, "");
  assert.equal(shown().values().v, 0.5);
  location.hash = "#explore-another?u=1";
  shown().write("v", "1.5");
  assert.equal(location.hash, "#explore-another?u=1");
});

test("Back brings an earlier state back, also if the address stays", () => {
  const { write, values } = shown();
  write("u", "0.5");
  const past = history.state;
  write("u", "1");
  // A link to a section has no state: the figure stays, and so it is kept.
  for (const state of [past, null]) {
    go("popstate", state);
    assert.deepEqual(values(), { u: 0.5, v: 1, sum: 1.5 });
    assert.deepEqual(history.state, past);
  }
});

test("a change is told in a sentence, and the picture's name with it, once the hand rests", () => {
  const inputs = { u: { ...INPUTS.u, label: "turn, °" }, v: INPUTS.v };
  const { write, press, status, name, find } = shown({ data: { inputs } });
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
  press("reset");
  mock.timers.tick(500);
  assert.equal(name(), "A ball");
});

test("what a model shows only while the hand moves goes once it rests; so do ways", () => {
  const model = ({ u, v }, _, changed) => {
    const labels = { P: changed };
    return { ...stateOf(u, v), labels, ...(u < 1 && { trails: { way: [v, 0, 0] } }) };
  };
  const { view, write, hand } = shown({ model });
  hand.set({ v: 2 });
  mock.timers.tick(500);
  write("v", "1.5");
  write("v", "1.4");
  mock.timers.tick(1000);
  write("u", "1");
  const ways = view.applied.map(({ labels, parts: { way } }) => [
    labels.P.join(),
    way?.paths?.length ?? way?.hidden,
  ]);
  assert.deepEqual(ways, [
    ["v", undefined],
    ["v", true],
    ["v", 1],
    ["", undefined],
    ["u", true],
  ]);
});

test("what Python sets is not announced, but the picture's name follows", () => {
  const { hand, status, name } = shown();
  hand.set({ v: 2 });
  mock.timers.tick(500);
  assert.equal(status(), "");
  assert.equal(name(), "Changed: v 2. sum 2.25");
});

test("a dragged point keeps its length; the status line says where it lies", () => {
  const inputs = { p: { kind: "points", names: ["P", "Q"], length: 2, reach: 1 } };
  const data = { inputs, start: { p: points("0,-2,0 0,0,2") } };
  const model = ({ p }) => ({ parts: {}, outputs: { sum: p[0][0] } });
  const { scene, values, status } = shown({ data, model });
  const handle = scene.querySelector("[data-handle=p-0]");
  drag(handle, [50, 50], [75, 50]);
  near(values().p, [1, -Math.sqrt(3), 0, 0, 0, 2], 1e-6);
  mock.timers.tick(500);
  assert.equal(status(), `${handle.getAttribute("aria-label")}. sum 1.00`);
});

test("in a notebook the figure starts where Python is, and tells it what the hand does", () => {
  const told = [];
  const python = { values: { u: 0.5, v: 1 }, tell: (inputs) => told.push(inputs) };
  const { hand, write, values, view } = shown({ python });
  assert.deepEqual(values(), { u: 0.5, v: 1, sum: 1.5 });
  assert.equal(view.applied.length, 1);
  hand.set({ u: 0.75 });
  assert.deepEqual(told, []);
  write("v", "0");
  assert.deepEqual(told, [{ u: 0.75, v: 0 }]);
  // The address of a notebook is not the figure's.
  go("hashchange", null, `${HASH}u=0.5`);
  assert.deepEqual(values(), { u: 0.75, v: 0, sum: 0.75 });
});

/** A chip leads from u = 0.25 to 1, in 900 ms; u is 0.625 half way. */
function onTheWay(given) {
  history.replaceState(null, "", "/");
  calm.matches = false;
  const panel = shown(given);
  panel.find(".try").click();
  tick(0, 450);
  near([panel.values().u], [0.625]);
  return panel;
}

test("chips and Reset move there; only the target is told, kept and said", () => {
  const told = [];
  const python = { values: START, tell: (inputs) => told.push(inputs) };
  const { values, press, status, view } = onTheWay({ python });
  // A slow frame is no rest.
  mock.timers.tick(1000);
  assert.deepEqual([status(), told], ["", []]);
  tick(899);
  assert.ok(values().u < 1);
  tick(900);
  assert.deepEqual(values(), { u: 1, v: 1, sum: 2 });
  assert.deepEqual(told, [{ u: 1, v: 1 }]);
  mock.timers.tick(500);
  assert.equal(status(), "all of u. sum 2.00");
  assert.equal(view.resets, 0);
  press("reset");
  tick(1000, 1450, 1900);
  assert.deepEqual(values(), { ...START, sum: 1.25 });
});

test("the history gets the target alone, and Back on the way leads back", () => {
  const { values } = onTheWay();
  const kept = { "some-figure": `${HASH}u=1` };
  assert.deepEqual(history.state, kept);
  tick(900);
  assert.deepEqual(history.state, kept);
  assert.equal(values().u, 1);
  const again = onTheWay();
  go("popstate", { "some-figure": HASH }, "/");
  // The browser tells the same twice.
  dispatchEvent(new Event("hashchange"));
  tick(500, 600);
  assert.ok(again.values().u > 0.25);
  tick(1400);
  assert.equal(again.values().u, 0.25);
});

test("who takes hold of something stops the way; who does anything else comes to its end", () => {
  for (const [taken, kind, wanted] of [
    ["[name=v]", "pointerdown", 0.625],
    ["[name=v]", "keydown", 0.625],
    [".scene", "pointerdown", 1],
    [".scene", "wheel", 1],
    [".try", "pointerdown", 0.625],
  ]) {
    const { find, values } = onTheWay();
    tell(find(taken), kind);
    near([values().u], [wanted]);
  }
  const { write, values } = onTheWay();
  write("v", "2");
  tick(900);
  near([values().u, values().v], [0.625, 2]);
});

test("out of sight a figure is there at once; a refused state on the way does not show", () => {
  const { view, values } = onTheWay();
  view.canvas.closest(".explorable").getBoundingClientRect = () => ({ top: 801, bottom: 900 });
  tick(500);
  assert.equal(values().u, 1);
  const model = ({ u, v }) => {
    if (u > 0.7 && u < 1) throw Object.assign(new Error("no"), { name: "DegenerateError" });
    return stateOf(u, v);
  };
  const other = onTheWay({ model });
  tick(700);
  assert.equal(other.status(), "");
  near([other.values().u], [0.625]);
  tick(900);
  assert.equal(other.values().u, 1);
});

test("a cell with the tag plays its figure for who comes to no state of it", () => {
  const inputs = { ...INPUTS, u: { ...INPUTS.u, plays: 1 } };
  for (const [around, hash, wanted] of [
    ["tag_plays", "", 0.35],
    ["cell", "", 0.25],
    ["tag_plays", `${HASH}u=0.5`, 0.5],
  ]) {
    history.replaceState(null, "", `/${hash}`);
    calm.matches = false;
    const { values } = shown({ data: { inputs }, around });
    tick(0, 100);
    assert.equal(values().u, wanted);
  }
});
