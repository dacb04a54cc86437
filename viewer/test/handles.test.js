import assert from "node:assert/strict";
import { test } from "node:test";
import { addHandles } from "../src/handles.js";
import { drag, figure, liveScene, tell } from "./dom.js";

const SPECS = {
  u: { kind: "number" },
  points: { kind: "points", names: ["P", "Q", "R"], reach: 1 },
  axis: { kind: "points", names: "n", reach: 1.5 },
  angle: { kind: "number", low: -180, high: 180, step: 5, label: "angle, °" },
  spoon: { kind: "poses", names: "the spoon" },
};
const ROUND = Array.from({ length: 73 }, (_, i) => {
  const angle = ((i * 5 - 180) * Math.PI) / 180;
  return [1.2 * Math.cos(angle), 0, 1.2 * Math.sin(angle)];
});
const GRIPS = { angle: { path: ROUND }, spoon: { at: [1, 0, 0], size: 0.5 } };
const START = {
  u: 0,
  points: [
    [0, -1, 0],
    [0.6, -0.8, 0],
  ],
  axis: [0, 0, 1],
  angle: 30,
  spoon: [1, 0, 0, 0],
};
const near = (mine, wanted, within = 1e-6) =>
  mine.forEach((x, i) => assert.ok(Math.abs(x - wanted[i]) < within, `${mine} is not ${wanted}`));

/** A scene with handles, its inputs, and what has been said. */
function scene(specs = SPECS) {
  const element = figure("").querySelector(".scene");
  const live = liveScene(element);
  const state = { inputs: structuredClone(START), said: [] };
  const change = (changes, spoken) => {
    Object.assign(state.inputs, changes);
    update();
    if (spoken) state.said.push(spoken());
  };
  const handles = addHandles(element, live, specs, () => state.inputs, change);
  const update = (grips) => {
    handles.update(grips);
    live.draw();
  };
  update();
  const handle = (name) => element.querySelector(`[data-handle="${name}"]`);
  return { element, live, state, handles: { update }, late: handles, handle };
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
  assert.equal(
    element.querySelector(".scene-hint").textContent,
    "Drag a ring to move what it holds",
  );
  assert.equal(element.querySelector("canvas + .scene-handles button").className, "scene-handle");
});

test("a scene says what can be dragged, and keeps its hint if nothing can", () => {
  for (const [name, hint] of [
    ["points", "Drag a ring to move what it holds"],
    ["angle", "Drag a ring along its path"],
    ["spoon", "Drag the spoon to turn it"],
  ]) {
    const { element, handles } = scene({ [name]: SPECS[name] });
    handles.update(GRIPS);
    assert.equal(element.querySelector(".scene-hint").textContent, hint);
  }
  const several = scene({ spoon: { kind: "poses", names: ["spoon 0", "spoon 1"] } });
  several.handles.update(GRIPS);
  assert.equal(several.element.querySelector(".scene-hint").textContent, "Drag a spoon to turn it");
  const { element } = scene({ u: { kind: "number" } });
  assert.equal(element.querySelector(".scene-hint").textContent, "");
});

test("a handle goes to another place together with the picture", () => {
  const { live, late, handle, state } = scene();
  late.update(GRIPS);
  const before = place(handle("angle"));
  state.inputs.angle = 60;
  late.update(GRIPS);
  near(place(handle("angle")), before);
  live.draw();
  near(place(handle("angle")), [65, 50 - 30 * Math.sin(Math.PI / 3)], 0.1);
});

test("a handle moves its own point, to where the pointer is", () => {
  for (const [i, other] of [
    [0, 1],
    [1, 0],
  ]) {
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

test("a point of a turned sphere is moved as it is seen, and kept as it was before the turn", () => {
  const { state, handle, late, live } = scene();
  // U to W, W to -V, V to -U: a third of a turn.
  late.update({
    axis: {
      turn: [
        [0, -1, 0],
        [0, 0, -1],
        [1, 0, 0],
      ],
    },
  });
  live.draw();
  near(place(handle("axis")), [50, 50]);
  const [left, top] = place(handle("axis"));
  drag(handle("axis"), 3, 0);
  near(place(handle("axis")), [left + 3, top], 1e-3);
  const [u, v, w] = state.inputs.axis;
  near([u, v], [0, -0.12 / 1.5]);
  assert.ok(w > 0.99);
  assert.equal(handle("axis").getAttribute("aria-label"), "n at 0.00, −0.08, 1.00");
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
  for (const keys of [
    { key: "a" },
    { key: "ArrowUp", ctrlKey: true },
    { key: "ArrowUp", metaKey: true },
  ]) {
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

test("a point on the far side cannot be caught", () => {
  const { live, state, handle } = scene();
  assert.ok(!handle("points-0").hasAttribute("data-behind"));
  state.inputs.points[0] = [0, 1, 0];
  live.draw();
  assert.ok(handle("points-0").hasAttribute("data-behind"));
  assert.ok(!handle("points-1").hasAttribute("data-behind"));
});

test("where no ball hides it, a point is dragged on the far side", () => {
  const axis = { ...SPECS.axis, through: true };
  const { live, state, handle } = scene({ axis });
  live.eye = () => [0, -3, 0];
  state.inputs.axis = [0, 1, 0];
  live.draw();
  assert.ok(!handle("axis").hasAttribute("data-behind"));
  assert.ok(handle("axis").hasAttribute("data-far"));
  drag(handle("axis"), 5, 0);
  const [u, v, w] = state.inputs.axis;
  near([u, w], [0.2 / 1.5, 0]);
  assert.ok(v > 0.9);
  state.inputs.axis = [0, -1, 0];
  live.draw();
  assert.ok(!handle("axis").hasAttribute("data-far"));
});

test("a point at the rim can be caught, whatever rounding says, and one beyond it as long as it is held", () => {
  const { live, state, handle } = scene();
  live.eye = () => [0, -3, 0];
  const behind = (y) => {
    state.inputs.points[0] = [Math.sqrt(1 - y * y), y, 0];
    live.draw();
    return handle("points-0").hasAttribute("data-behind");
  };
  assert.deepEqual([-1 / 3, -1 / 3 + 1e-9, -1 / 3 + 1e-2].map(behind), [false, false, true]);
  behind(-1);
  drag(handle("points-0"), 0, 0);
  tell(handle("points-0"), "pointerdown", { button: 0, pointerId: 1, clientX: 50, clientY: 60 });
  assert.ok(!behind(0.5));
  tell(handle("points-0"), "pointerup");
  assert.ok(behind(0.5));
});

test("a handle whose point has left the picture waits at its border", () => {
  const { live, state, handle } = scene();
  live.project = ([x, , z]) => ({ left: 0.5 + x, top: 0.5 - z, riding: false });
  state.inputs.points[0] = [0.8, -0.6, 0];
  live.draw();
  assert.deepEqual(place(handle("points-0")), [98, 50]);
});

test("a near eye sees less than half of the sphere", () => {
  const { live, state, handle } = scene();
  live.eye = () => [0, -2, 0];
  for (const [y, behind] of [
    [-0.6, false],
    [-0.4, true],
  ]) {
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

test("a point at the rim stays in hand, and can be caught again", () => {
  const { live, state, handle } = scene();
  live.eye = () => [0, -4, 0];
  // Rounding puts a point of the rim a little behind it.
  const y = -1 / 4 + 1e-5;
  state.inputs.points[0] = [Math.sqrt(1 - y * y), y, 0];
  live.draw();
  assert.ok(!handle("points-0").hasAttribute("data-behind"));
  drag(handle("points-0"), 0, 0);
  tell(handle("points-0"), "pointerdown", { button: 0, pointerId: 1, clientX: 50, clientY: 60 });
  state.inputs.points[0] = [0, 1, 0];
  live.draw();
  assert.ok(!handle("points-0").hasAttribute("data-behind"));
  tell(handle("points-0"), "pointerup");
  assert.ok(handle("points-0").hasAttribute("data-behind"));
});

/** A scene with a number on a circle in the picture, and places on it. */
function circled() {
  const made = scene({ angle: SPECS.angle });
  made.handles.update(GRIPS);
  const on = (angle, radius = 30) =>
    [Math.cos, Math.sin].map((f, i) => (i ? -1 : 1) * radius * f((angle * Math.PI) / 180));
  return {
    ...made,
    on,
    ring: made.handle("angle"),
    path: made.element.querySelector(".scene-path"),
  };
}

test("a number has a ring on its path, which speaks", () => {
  const { ring, on } = circled();
  near(
    place(ring),
    on(30).map((x) => 50 + x),
    0.05,
  );
  const said = [
    "role",
    "aria-label",
    "aria-valuemin",
    "aria-valuemax",
    "aria-valuenow",
    "aria-valuetext",
  ];
  assert.deepEqual(
    said.map((name) => ring.getAttribute(name)),
    ["slider", "angle", "-180", "180", "30", "30°"],
  );
});

test("a ring is dragged along its path, in steps, and beyond the end of a closed one", () => {
  const { ring, state, on } = circled();
  ring.parentElement.getBoundingClientRect = () => ({ left: 0, top: 0, width: 100, height: 100 });
  ring.setPointerCapture = () => {};
  const go = (angles, radius = 30) => {
    const at = (angle) => on(angle, radius).map((x) => 50 + x);
    const [first, ...rest] = angles.map(at);
    tell(ring, "pointerdown", { button: 0, pointerId: 1, clientX: first[0], clientY: first[1] });
    for (const [x, y] of rest) tell(ring, "pointermove", { clientX: x, clientY: y });
    tell(ring, "pointerup");
  };
  go([30, 60, 92]);
  assert.equal(state.inputs.angle, 90);
  go([90, 130, 170, 200], 25);
  assert.equal(state.inputs.angle, -160);
});

test("a path is grabbed anywhere, and the number moves by as much as the finger", () => {
  const { path, state, on } = circled();
  path.parentElement.parentElement.getBoundingClientRect = () => ({
    left: 0,
    top: 0,
    width: 100,
    height: 100,
  });
  path.setPointerCapture = () => {};
  const [from, to] = [200, 240].map((angle) => on(angle).map((x) => 50 + x));
  tell(path, "pointerdown", { button: 0, pointerId: 1, clientX: from[0], clientY: from[1] });
  tell(path, "pointermove", { clientX: to[0], clientY: to[1] });
  tell(path, "pointerup");
  assert.equal(state.inputs.angle, 70);
});

test("a body that turns with a number is grabbed in place of the path, wherever it is seen", () => {
  const { handles, path, state, on } = circled();
  const spoke = on(30).map((x, i) => ((i ? -1 : 1) * x) / 25);
  handles.update({
    angle: {
      path: ROUND,
      body: [
        [0, 0, 0],
        [spoke[0], 0, spoke[1]],
      ],
    },
  });
  assert.equal(
    path.getAttribute("d"),
    `M50 50 ${on(30)
      .map((x) => Math.round(100 * (50 + x)) / 100)
      .join(" ")}`,
  );
  path.parentElement.parentElement.getBoundingClientRect = () => ({
    left: 0,
    top: 0,
    width: 100,
    height: 100,
  });
  path.setPointerCapture = () => {};
  const [from, to] = [
    [30, 15],
    [70, 15],
  ].map(([angle, radius]) => on(angle, radius).map((x) => 50 + x));
  tell(path, "pointerdown", { button: 0, pointerId: 1, clientX: from[0], clientY: from[1] });
  tell(path, "pointermove", { clientX: to[0], clientY: to[1] });
  tell(path, "pointerup");
  assert.equal(state.inputs.angle, 70);
});

test("keys move a number by its steps, within its bounds or round", () => {
  const { ring, state } = circled();
  tell(ring, "keydown", { key: "ArrowRight" });
  assert.equal(state.inputs.angle, 35);
  tell(ring, "keydown", { key: "ArrowDown", shiftKey: true });
  assert.equal(state.inputs.angle, 10);
  tell(ring, "keydown", { key: "ArrowLeft" });
  assert.equal(state.inputs.angle, 5);
  state.inputs.angle = 180;
  tell(ring, "keydown", { key: "ArrowUp" });
  assert.equal(state.inputs.angle, -175);
});

test("a path that is gone takes its ring along", () => {
  const { handles, ring } = circled();
  handles.update({ angle: { path: null } });
  assert.ok(ring.hidden);
});

test("a body turns under the finger, and a whole turn leads to the opposite quaternion", () => {
  const { handles, state, handle } = scene({ spoon: SPECS.spoon });
  handles.update(GRIPS);
  const body = handle("spoon");
  near(place(body), [75, 50]);
  assert.equal(body.style.width, "25%");
  body.parentElement.getBoundingClientRect = () => ({ left: 0, top: 0, width: 100, height: 100 });
  body.setPointerCapture = () => {};
  tell(body, "pointerdown", { button: 0, pointerId: 1, clientX: 75, clientY: 50 });
  tell(body, "pointermove", { clientX: 75 + 12.5 / 2, clientY: 50 });
  tell(body, "pointerup");
  // From the left to the right: about z, which points up in the picture, by asin(1/2).
  near(state.inputs.spoon, [Math.cos(Math.PI / 12), 0, 0, Math.sin(Math.PI / 12)]);
  assert.equal(state.said.at(-1), "the spoon at 0.97, 0.00, 0.00, 0.26");
  state.inputs.spoon = [1, 0, 0, 0];
  for (let i = 0; i < 72; i++) tell(body, "keydown", { key: "ArrowRight" });
  near(state.inputs.spoon, [-1, 0, 0, 0]);
});

test("where a picture is stacked, a body is measured in its own row", () => {
  const { live, handles, handle } = scene({ spoon: SPECS.spoon });
  // The row below would show what is near the rim of the body.
  const inRow = ([x, , z], below) => ({ left: 0.5 + x / 4 - (below ? 0.9 : 0), top: 0.5 - z / 4 });
  live.project = (point, near = point) => inRow(point, near[0] > 1.2);
  handles.update(GRIPS);
  assert.equal(handle("spoon").style.width, "25%");
});

test("a body that the picture does not show cannot be grabbed", () => {
  const { element, handles, state } = scene({ spoons: { kind: "poses", names: ["A", "B", "C"] } });
  const grabbed = () => element.querySelectorAll("[data-handle]").length;
  state.inputs.spoons = Array(3).fill([1, 0, 0, 0]);
  handles.update({
    spoons: {
      at: [
        [0, 0, 0],
        [1, 0, 0],
      ],
      size: 0.5,
    },
  });
  assert.equal(grabbed(), 2);
  state.inputs.spoons = [[1, 0, 0, 0]];
  handles.update();
  assert.equal(grabbed(), 1);
});
