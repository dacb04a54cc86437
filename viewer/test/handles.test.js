import assert from "node:assert/strict";
import { test } from "node:test";
import { drag, figure, liveScene, tell } from "./dom.js";
import { addHandles } from "../src/handles.js";

const SPECS = {
  u: { kind: "number" },
  points: { kind: "points", names: ["P", "Q", "R"], reach: 1 },
  axis: { kind: "points", names: "n", reach: 1.5 },
  angle: { kind: "number", grip: 1.2, step: 5 },
};
const START = { u: 0, points: [[0, -1, 0], [0.6, -0.8, 0]], axis: [0, 0, 1], angle: 30 };
const near = (mine, wanted, within = 1e-6) =>
  mine.forEach((x, i) => assert.ok(Math.abs(x - wanted[i]) < within, `${mine} is not ${wanted}`));

/** A scene with handles, its inputs, and what has been said. */
function scene(specs = SPECS) {
  const element = figure("").querySelector(".scene");
  const live = liveScene(element);
  const state = { inputs: structuredClone(START), said: [] };
  const change = (changes, spoken) => {
    Object.assign(state.inputs, changes);
    handles.update();
    if (spoken) state.said.push(spoken());
  };
  const handles = addHandles(element, live, specs, () => state.inputs, change);
  handles.update();
  const handle = (name) => element.querySelector(`[data-handle="${name}"]`);
  const grip = () => element.querySelector("[aria-hidden=true].scene-handle");
  return { element, live, state, handles, handle, grip };
}

const place = ({ style }) => [style.left, style.top].map(parseFloat);

test("each point has its handle, at its place and with its name", () => {
  const { element, handle } = scene();
  assert.equal(element.querySelectorAll("[data-handle]").length, 3);
  near(place(handle("points-0")), [50, 50]);
  near(place(handle("points-1")), [65, 50]);
  near(place(handle("axis")), [50, 12.5]);
  assert.equal(handle("points-1").getAttribute("aria-label"), "Q at 0.60, −0.80, 0.00");
  assert.equal(handle("axis").getAttribute("aria-label"), "n at 0.00, 0.00, 1.00");
  assert.equal(handle("axis").type, "button");
  assert.equal(handle("axis").getAttribute("aria-roledescription"), "point");
  assert.equal(element.querySelector(".scene-hint").textContent, "Drag a ring to move its point");
  assert.equal(element.querySelector("canvas + .scene-handles button").className, "scene-handle");
});

test("a scene says so if there is a point or a grip, and keeps its hint without", () => {
  for (const name of ["points", "angle"]) {
    const { element } = scene({ [name]: SPECS[name] });
    assert.equal(element.querySelector(".scene-hint").textContent, "Drag a ring to move its point");
  }
  const { element } = scene({ u: { kind: "number" } });
  assert.equal(element.querySelector(".scene-hint").textContent, "");
});

test("a handle moves its own point, to where the pointer is", () => {
  for (const [i, other] of [[0, 1], [1, 0]]) {
    const { state, handle } = scene();
    const [left, top] = place(handle(`points-${i}`));
    drag(handle(`points-${i}`), 5, -10);
    near(place(handle(`points-${i}`)), [left + 5, top - 10], 1e-3);
    const [x, , z] = state.inputs.points[i];
    near([x, z], [(left + 5 - 50) / 25, 0.4]);
    near([Math.hypot(...state.inputs.points[i])], [1]);
    assert.deepEqual(state.inputs.points[other], START.points[other]);
    assert.deepEqual(state.inputs.axis, START.axis);
    assert.equal(state.said.length, 1);
    assert.equal(state.said[0], handle(`points-${i}`).getAttribute("aria-label"));
  }
});

test("a single point is no list, and its handle stands beyond it", () => {
  const { state, handle } = scene();
  drag(handle("axis"), 3, 20);
  near([state.inputs.axis[0], state.inputs.axis[2]], [0.12 / 1.5, 0.7 / 1.5]);
  near([Math.hypot(...state.inputs.axis)], [1]);
  assert.deepEqual(state.inputs.points, START.points);
});

test("only a held handle follows the pointer", () => {
  const { state, handle } = scene();
  tell(handle("points-0"), "pointermove", { clientX: 70, clientY: 60 });
  tell(handle("points-0"), "pointerup");
  tell(handle("points-0"), "pointerdown", { button: 2, pointerId: 1, clientX: 50, clientY: 60 });
  tell(handle("points-0"), "pointermove", { clientX: 70, clientY: 60 });
  drag(handle("points-0"), 0, 0);
  tell(handle("points-0"), "pointermove", { clientX: 70, clientY: 60 });
  near(state.inputs.points[0], START.points[0]);
  assert.equal(state.said.length, 1);
});

test("a pointer that is taken away lets go of its handle", () => {
  const { state, handle } = scene();
  drag(handle("points-0"), 0, 0);
  tell(handle("points-0"), "pointerdown", { button: 0, pointerId: 1, clientX: 50, clientY: 60 });
  tell(handle("points-0"), "pointercancel");
  tell(handle("points-0"), "pointermove", { clientX: 70, clientY: 60 });
  near(state.inputs.points[0], START.points[0]);
});

test("arrow keys turn a point by two degrees, five times and a tenth of it", () => {
  for (const [key, [x, z], keys, degrees] of [
    ["ArrowRight", [1, 0], {}, 2],
    ["ArrowLeft", [-1, 0], {}, 2],
    ["ArrowUp", [0, 1], { shiftKey: true }, 10],
    ["ArrowDown", [0, -1], { altKey: true }, 0.2],
    ["ArrowDown", [0, -1], { altKey: true, shiftKey: true }, 1],
  ]) {
    const { state, handle } = scene();
    const event = tell(handle("points-0"), "keydown", { key, ...keys });
    assert.ok(event.defaultPrevented);
    const angle = (degrees * Math.PI) / 180;
    near(state.inputs.points[0], [x * Math.sin(angle), -Math.cos(angle), z * Math.sin(angle)]);
    assert.deepEqual(state.inputs.points[1], START.points[1]);
    assert.equal(state.said.length, 1);
  }
});

test("other keys, and those of the browser, are left alone", () => {
  const { state, handle } = scene();
  for (const keys of [{ key: "a" }, { key: "ArrowUp", ctrlKey: true }, { key: "ArrowUp", metaKey: true }]) {
    assert.ok(!tell(handle("points-0"), "keydown", keys).defaultPrevented);
  }
  assert.deepEqual(state.inputs, START);
});

test("the canvas does not hear the keys of a handle", () => {
  const { element, handle } = scene();
  let heard = 0;
  element.addEventListener("keydown", () => (heard += 1));
  tell(handle("points-0"), "keydown", { key: "ArrowUp" });
  assert.equal(heard, 0);
});

test("a point on the far side cannot be caught, and none while the reader rides along", () => {
  const { live, state, handle } = scene();
  assert.ok(!handle("points-0").hasAttribute("data-behind"));
  state.inputs.points[0] = [0, 1, 0];
  live.riding = true;
  live.draw();
  assert.ok(handle("points-0").hasAttribute("data-behind"));
  assert.ok(!handle("points-1").hasAttribute("data-behind"));
  assert.ok(handle("points-0").hidden);
  live.riding = false;
  live.draw();
  assert.ok(!handle("points-0").hidden);
});

test("a near eye sees less than half of the sphere", () => {
  const { live, state, handle } = scene();
  live.eye = () => [0, -2, 0];
  for (const [y, behind] of [[-0.6, false], [-0.4, true]]) {
    state.inputs.points[0] = [Math.sqrt(1 - y * y), y, 0];
    live.draw();
    assert.equal(handle("points-0").hasAttribute("data-behind"), behind);
  }
});

test("who presses a handle holds it, and the page does not move", () => {
  const { handle } = scene();
  const [held, focused] = [[], []];
  handle("points-0").setPointerCapture = (id) => held.push(id);
  handle("points-0").focus = (options) => focused.push(options);
  const place = { button: 0, pointerId: 7, clientX: 50, clientY: 60 };
  assert.ok(tell(handle("points-0"), "pointerdown", place).defaultPrevented);
  assert.deepEqual(held, [7]);
  assert.deepEqual(focused, [{ preventScroll: true }]);
});

test("a held point follows the pointer over a page that scrolls", () => {
  const { state, handle } = scene();
  drag(handle("points-0"), 0, 0);
  tell(handle("points-0"), "pointerdown", { button: 0, pointerId: 1, clientX: 50, clientY: 60 });
  const layer = handle("points-0").parentElement;
  layer.getBoundingClientRect = () => ({ left: 5, top: 10, width: 100, height: 100 });
  tell(handle("points-0"), "pointermove", { clientX: 45, clientY: 50 });
  near(state.inputs.points[0], START.points[0]);
});

test("handles come and go with their points", () => {
  const { state, handles, element, handle } = scene();
  state.inputs.points = [...START.points, [0, 0, 1]];
  handles.update();
  near(place(handle("points-2")), [50, 25]);
  state.inputs.points = START.points.slice(0, 1);
  handles.update();
  assert.equal(element.querySelectorAll("[data-handle^=points]").length, 1);
  near(place(handle("points-0")), [50, 50]);
});

test("an angle is dragged round its circle, in its steps, and not by keys", () => {
  const { live, state, grip } = scene({ angle: SPECS.angle });
  // From above: the picture shows x and y.
  live.project = ([x, y]) => ({ left: 0.5 + x / 4, top: 0.5 - y / 4, riding: false });
  live.sight = (left, top) => ({ eye: [4 * left - 2, 2 - 4 * top, 9], direction: [0, 0, -1] });
  live.draw();
  const radius = 1.2 * 25;
  near(place(grip()), [50 + radius * Math.cos(Math.PI / 6), 50 - radius / 2]);
  drag(grip(), -radius * Math.cos(Math.PI / 6), -radius / 2 + 1);
  assert.equal(state.inputs.angle, 90);
  assert.ok(!grip().hasAttribute("data-behind"));
  assert.equal(grip().tabIndex, -1);
});
