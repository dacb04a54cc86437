import assert from "node:assert/strict";
import { test } from "node:test";
import { addHandles } from "../src/handles.js";
import { drag, figure, hold, liveScene, tell } from "./dom.js";
import { near, points, X, Z } from "./near.js";

const SPECS = {
  u: { kind: "number" },
  points: { kind: "points", names: ["P", "Q", "R"], reach: 1 },
  axis: { kind: "points", names: "n", reach: 1.5 },
  angle: { kind: "number", low: -180, high: 180, step: 5, label: "angle, °" },
  spoon: { kind: "poses", names: "the spoon" },
};
const radians = (degrees) => (degrees * Math.PI) / 180;
/** A circle in the picture, of radius 30 pixels, and places on it or within. */
const ROUND = Array.from({ length: 73 }, (_, i) => {
  const angle = radians(i * 5 - 180);
  return [1.2 * Math.cos(angle), 0, 1.2 * Math.sin(angle)];
});
const on = (degrees, radius = 30) => [
  50 + radius * Math.cos(radians(degrees)),
  50 - radius * Math.sin(radians(degrees)),
];
const GRIPS = { angle: { path: ROUND }, spoon: { at: X, size: 0.5 } };
const REST = [1, 0, 0, 0];
const START = { u: 0, points: points("0,-1,0 0.6,-0.8,0"), axis: Z, angle: 30, spoon: REST };

/** A scene with handles, its inputs, and what has been said. */
function scene(specs = SPECS, grips = undefined) {
  const element = figure("").querySelector(".scene");
  const view = liveScene(element);
  const state = { inputs: structuredClone(START), said: [] };
  const change = (changes, spoken) => {
    Object.assign(state.inputs, changes);
    update();
    if (spoken) state.said.push(spoken());
  };
  const handles = addHandles(element, view, specs, () => state.inputs, change);
  const update = (changed) => {
    handles.update(changed);
    view.draw();
  };
  update(grips);
  const handle = (name) => element.querySelector(`[data-handle="${name}"]`);
  /** Put the first point somewhere; whether it is behind the ball then. */
  const behind = (y) => {
    state.inputs.points[0] = [Math.sqrt(1 - y * y), y, 0];
    view.draw();
    return handle("points-0").hasAttribute("data-behind");
  };
  return { element, view, state, update, late: handles, handle, behind };
}

const only = (name) => scene({ [name]: SPECS[name] }, GRIPS);
const place = ({ style }) => [style.left, style.top].map(parseFloat);

test("each point has its handle, at its place and with its name", () => {
  const { element, handle } = scene();
  assert.equal(element.querySelectorAll("[data-handle]").length, 3);
  near(place(handle("points-0")), [50, 50]);
  near(place(handle("points-1")), [65, 50]);
  near(place(handle("axis")), [50, 12.5]);
  assert.equal(handle("points-1").getAttribute("aria-label"), "Q at 0.60, −0.80, 0.00");
  assert.equal(handle("axis").getAttribute("aria-label"), "n at 0.00, 0.00, 1.00");
  assert.equal(handle("axis").getAttribute("role"), "application");
  assert.equal(handle("axis").getAttribute("aria-roledescription"), "point");
  assert.ok(element.querySelector("canvas + .scene-handles"));
});

test("a scene says what can be dragged, and keeps its hint if nothing can", () => {
  const { points, angle, spoon, u } = SPECS;
  const several = { kind: "poses", names: ["spoon 0", "spoon 1"] };
  for (const [specs, hint] of [
    [{ points, angle }, "Drag a ring to move what it holds"],
    [{ angle, u }, "Drag a ring along its path"],
    [{ spoon }, "Drag the spoon to turn it"],
    [{ angle, spoon }, "Drag a ring along its path, or the spoon to turn it"],
    [{ spoon: several }, "Drag a spoon to turn it"],
    [{ u }, "Move the slider"],
  ]) {
    const { element } = scene(specs, GRIPS);
    assert.equal(element.querySelector(".scene-hint").textContent, hint);
  }
});

test("a handle goes to another place together with the picture", () => {
  const { view, late, handle, state } = scene(SPECS, GRIPS);
  const before = place(handle("angle"));
  state.inputs.angle = 60;
  late.update(GRIPS);
  near(place(handle("angle")), before);
  view.draw();
  near(place(handle("angle")), on(60), 0.1);
});

test("a handle moves its own point, to where the pointer is", () => {
  for (const i of [0, 1]) {
    const { state, handle } = scene();
    const [left, top] = place(handle(`points-${i}`));
    // The finger need not hold it by its middle.
    drag(handle(`points-${i}`), [left + 2, top + 1], [left + 7, top - 9]);
    near(place(handle(`points-${i}`)), [left + 5, top - 10], 1e-3);
    near([Math.hypot(...state.inputs.points[i])], [1]);
    assert.deepEqual(state.inputs.points[1 - i], START.points[1 - i]);
    assert.deepEqual(state.inputs.axis, START.axis);
    assert.deepEqual(state.said, [handle(`points-${i}`).getAttribute("aria-label")]);
  }
});

test("a single point is no list, and its handle stands beyond it", () => {
  const { state, handle } = scene();
  drag(handle("axis"), [50, 12.5], [53, 32.5]);
  near([state.inputs.axis[0], state.inputs.axis[2]], [0.12 / 1.5, 0.7 / 1.5], 1e-6);
  near([Math.hypot(...state.inputs.axis)], [1]);
});

test("a point of a turned sphere is moved as it is seen, and kept as it was before the turn", () => {
  // U to W, W to -V, V to -U: a third of a turn.
  const { state, handle } = scene(SPECS, { axis: { turn: points("0,-1,0 0,0,-1 1,0,0") } });
  near(place(handle("axis")), [50, 50]);
  drag(handle("axis"), [50, 50], [53, 50]);
  near(place(handle("axis")), [53, 50], 1e-3);
  const [u, v, w] = state.inputs.axis;
  near([u, v], [0, -0.12 / 1.5], 1e-6);
  assert.ok(w > 0.99);
  assert.equal(handle("axis").getAttribute("aria-label"), "n at 0.00, −0.08, 1.00");
});

test("who presses a handle holds it, until the pointer is lifted or taken away", () => {
  const { state, handle } = scene();
  const button = handle("points-0");
  const calls = [];
  button.setPointerCapture = (id) => calls.push(id);
  button.focus = (options) => calls.push(options);
  const move = () => tell(button, "pointermove", { clientX: 80, clientY: 70 });
  tell(button, "pointerup");
  move();
  tell(button, "pointerdown", { button: 2, pointerId: 7, clientX: 60, clientY: 70 });
  move();
  assert.deepEqual(calls, []);
  for (const end of ["pointerup", "pointercancel"]) {
    hold(button, [50, 50]);
    tell(button, end);
    move();
  }
  near(state.inputs.points[0], START.points[0], 1e-6);
  assert.equal(state.said.length, 2);
  // The page does not move.
  assert.deepEqual(calls.slice(0, 2), [{ preventScroll: true }, 7]);
  assert.ok(tell(button, "pointerdown", { button: 0, clientX: 60, clientY: 70 }).defaultPrevented);
});

test("a held point follows the pointer over a page that scrolls", () => {
  const { state, handle } = scene();
  hold(handle("points-0"), [50, 50]);
  const layer = handle("points-0").parentElement;
  layer.getBoundingClientRect = () => ({ left: 5, top: 10, width: 100, height: 100 });
  tell(handle("points-0"), "pointermove", { clientX: 55, clientY: 60 });
  near(state.inputs.points[0], START.points[0], 1e-6);
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
    assert.ok(tell(handle("points-0"), "keydown", { key, ...keys }).defaultPrevented);
    const [cosine, sine] = [Math.cos(radians(degrees)), Math.sin(radians(degrees))];
    near(state.inputs.points, [[x * sine, -cosine, z * sine], START.points[1]]);
    assert.equal(state.said.length, 1);
  }
});

test("other keys, and those of the browser, are left alone; the scene hears no key of a handle", () => {
  const { element, state, handle } = scene();
  let heard = 0;
  element.addEventListener("keydown", () => (heard += 1));
  for (const [key, modifier] of [["a"], ["ArrowUp", "ctrlKey"], ["ArrowUp", "metaKey"]]) {
    const event = tell(handle("points-0"), "keydown", { key, [modifier]: true });
    assert.ok(!event.defaultPrevented);
  }
  assert.deepEqual(state.inputs, START);
  assert.equal(heard, 3);
  tell(handle("points-0"), "keydown", { key: "ArrowUp" });
  assert.equal(heard, 3);
});

test("a point on the far side cannot be caught; a near eye sees less than half of the sphere", () => {
  for (const eye of [100, 3, 2]) {
    const { view, handle, behind } = scene();
    view.aim.eye = () => [0, -eye, 0];
    // At the rim it can be caught, whatever rounding says.
    const edge = -1 / eye;
    const found = [-1, edge - 1e-2, edge + 1e-9, edge + 1e-2, 1].map(behind);
    assert.deepEqual(found, [false, false, false, true, true]);
    assert.ok(!handle("points-1").hasAttribute("data-behind"));
  }
});

test("beyond the rim a point stays in hand as long as it is held", () => {
  const { handle, behind } = scene();
  hold(handle("points-0"), [50, 50]);
  assert.ok(!behind(0.5));
  tell(handle("points-0"), "pointerup");
  assert.ok(behind(0.5));
});

test("where no ball hides it, a point is dragged on the far side", () => {
  const { view, state, handle } = scene({ axis: { ...SPECS.axis, through: true } });
  const far = () => ["data-behind", "data-far"].map((name) => handle("axis").hasAttribute(name));
  state.inputs.axis = [0, 1, 0];
  view.draw();
  assert.deepEqual(far(), [false, true]);
  drag(handle("axis"), [50, 50], [55, 50]);
  const [u, v, w] = state.inputs.axis;
  near([u, w], [0.2 / 1.5, 0], 1e-6);
  assert.ok(v > 0.9);
  state.inputs.axis = [0, -1, 0];
  view.draw();
  assert.deepEqual(far(), [false, false]);
});

test("a handle whose point has left the picture waits at its border", () => {
  const { view, state, handle } = scene();
  view.rows.project = ([x, , z]) => ({ left: 0.5 + x, top: 0.5 - z });
  state.inputs.points[0] = [0.8, -0.6, 0];
  view.draw();
  assert.deepEqual(place(handle("points-0")), [98, 50]);
});

test("handles come and go with their points", () => {
  const { state, update, element, handle } = scene();
  state.inputs.points = [...START.points, [0, 0, 1]];
  update();
  near(place(handle("points-2")), [50, 25]);
  state.inputs.points = START.points.slice(0, 1);
  update();
  assert.equal(element.querySelectorAll("[data-handle^=points]").length, 1);
});

test("a number has a ring on its path, which speaks", () => {
  const ring = only("angle").handle("angle");
  near(place(ring), on(30), 0.05);
  const names = ["label", "valuemin", "valuemax", "valuenow", "valuetext"];
  const said = names.map((name) => ring.getAttribute(`aria-${name}`));
  assert.deepEqual(said, ["angle", "-180", "180", "30", "30°"]);
  assert.equal(ring.getAttribute("role"), "slider");
});

test("a ring is dragged along its path, in steps, and beyond the end of a closed one", () => {
  const { state, handle } = only("angle");
  drag(handle("angle"), on(30), on(60), on(92));
  assert.equal(state.inputs.angle, 90);
  drag(handle("angle"), on(90, 25), on(130, 25), on(170, 25), on(200, 25));
  assert.equal(state.inputs.angle, -160);
});

test("a path is grabbed anywhere, and the number moves by as much as the finger", () => {
  const { element, state } = only("angle");
  drag(element.querySelector(".scene-path"), on(200), on(240));
  assert.equal(state.inputs.angle, 70);
});

test("a crank of many laps goes on by the lap that is in hand, from its knob and from its rim", () => {
  const { element, update, state, handle } = only("angle");
  const path = Array.from({ length: 241 }, (_, i) => {
    const [angle, radius] = [radians(i * 15 - 180), 1.2 + i / 20000];
    return [radius * Math.cos(angle), 0, radius * Math.sin(angle)];
  });
  // Ten laps from -180 to 180: a lap is 36.
  state.inputs.angle = 0;
  update({ angle: { path, laps: 10 } });
  drag(handle("angle"), on(180), on(260), on(340), on(60), on(140), on(180));
  assert.equal(state.inputs.angle, 35);
  drag(element.querySelector(".scene-path"), on(0), on(80), on(160));
  assert.equal(state.inputs.angle, 50);
});

test("a body that turns with a number is grabbed in place of the path, wherever it is seen", () => {
  const { element, update, state } = only("angle");
  const path = element.querySelector(".scene-path");
  const [x, y] = on(30).map((value) => (value - 50) / 25);
  update({ angle: { path: ROUND, body: points(`0,0,0 ${x},0,${-y}`) } });
  assert.equal(path.getAttribute("d"), "M50 50 75.98 35");
  drag(path, on(30, 15), on(70, 15));
  assert.equal(state.inputs.angle, 70);
});

test("keys move a number by its steps, within its bounds or round", () => {
  const { state, handle } = only("angle");
  for (const [from, key, shiftKey, to] of [
    [30, "ArrowRight", false, 35],
    [35, "ArrowDown", true, 10],
    [10, "ArrowLeft", false, 5],
    [180, "ArrowUp", false, -175],
  ]) {
    state.inputs.angle = from;
    tell(handle("angle"), "keydown", { key, shiftKey });
    assert.equal(state.inputs.angle, to);
  }
});

test("a path that is gone takes its ring along", () => {
  const { element, update, handle } = only("angle");
  update({ angle: { path: null } });
  assert.ok(handle("angle").hidden);
  assert.ok(element.querySelector(".scene-handles svg").hasAttribute("hidden"));
});

test("a body turns under the finger, and a whole turn leads to the opposite quaternion", () => {
  const { state, handle } = only("spoon");
  const body = handle("spoon");
  near(place(body), [75, 50]);
  assert.equal(body.style.width, "25%");
  drag(body, [75, 50], [75 + 12.5 * 0.5, 50], [75 + 12.5 * 0.6, 50]);
  // From the left to the right: about z, which points up in the picture, by asin(0.6).
  near(state.inputs.spoon, [Math.cos(Math.asin(0.6) / 2), 0, 0, Math.sin(Math.asin(0.6) / 2)]);
  assert.equal(state.said.at(-1), "the spoon at 0.95, 0.00, 0.00, 0.32");
  state.inputs.spoon = REST;
  for (let i = 0; i < 72; i++) tell(body, "keydown", { key: "ArrowRight" });
  near(state.inputs.spoon, [-1, 0, 0, 0]);
});

test("where a picture is stacked, a body is measured in its own row", () => {
  const { view, handle } = only("spoon");
  // The row below would show what is near the rim of the body.
  view.rows.project = ([x, , z], [near] = [x]) => ({
    left: 0.5 + x / 4 - (near > 1.2 ? 0.9 : 0),
    top: 0.5 - z / 4,
  });
  view.draw();
  assert.equal(handle("spoon").style.width, "25%");
});

test("a body that the picture does not show cannot be grabbed", () => {
  const { element, update, state } = scene({ spoons: { kind: "poses", names: ["A", "B", "C"] } });
  const grabbed = () => element.querySelectorAll("[data-handle]").length;
  state.inputs.spoons = Array(3).fill(REST);
  update({ spoons: { at: points("0,0,0 1,0,0"), size: 0.5 } });
  assert.equal(grabbed(), 2);
  state.inputs.spoons = [REST];
  update();
  assert.equal(grabbed(), 1);
});
