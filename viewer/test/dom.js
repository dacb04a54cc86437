/* A page without a browser: what panels, handles and figures ask of one. Import it before them. */
import { Window } from "happy-dom";
import { spun, turned } from "../src/camera.js";

const window = new Window({ url: "http://localhost/" });
const { document, location, history } = window;
let ticks = [];
let listening = [];

/** Whether the reader wants no motion; to be set before a panel is bound. */
export const calm = { matches: false };
Object.assign(globalThis, {
  document,
  location,
  history,
  innerHeight: 800,
  matchMedia: (query) => (query === "(prefers-reduced-motion: reduce)" ? calm : {}),
  addEventListener(...listener) {
    listening.push(listener);
    window.addEventListener(...listener);
  },
  dispatchEvent: window.dispatchEvent.bind(window),
  Event: window.Event,
  requestAnimationFrame: (callback) => ticks.push(callback),
  cancelAnimationFrame: () => (ticks = []),
});

/** Draw the next frame at a time in milliseconds. */
export function tick(time) {
  const due = ticks;
  ticks = [];
  for (const callback of due) callback(time);
}

/** Tell an element of an event, with some properties. */
export function tell(element, type, properties = {}) {
  const event = Object.assign(
    new window.Event(type, { bubbles: true, cancelable: true }),
    properties,
  );
  element.dispatchEvent(event);
  return event;
}

/** Write a figure as a page has it: a scene and a panel. It is alone; no other hears of the window. */
export function figure(panel) {
  for (const listener of listening) window.removeEventListener(...listener);
  listening = [];
  document.body.innerHTML = `<div class="explorable"><div class="scene"><p class="scene-hint"></p></div>${panel}</div>`;
  return document.querySelector(".explorable");
}

/**
 * What `show` returns for a scene, seen from afar along y: the picture goes from -2 to 2, and is 100
 * pixels wide and high. `applied` holds the states, `draw` ends a frame.
 */
export function liveScene(scene) {
  const canvas = document.createElement("canvas");
  canvas.setAttribute("aria-label", "A ball");
  scene.append(canvas);
  const watchers = [];
  const live = {
    canvas,
    applied: [],
    looks: [],
    resets: 0,
    apply: (state) => live.applied.push(state),
    look: (views) => live.looks.push(views),
    onDraw: (watch) => watchers.push(watch),
    draw: () => watchers.forEach((watch) => watch()),
    project: ([x, , z]) => ({ left: 0.5 + x / 4, top: 0.5 - z / 4 }),
    sight: (left, top) => ({ eye: [4 * left - 2, -1e6, 2 - 4 * top], direction: [0, 1, 0] }),
    eye: () => [0, -1e6, 0],
    axes: () => [
      [1, 0, 0],
      [0, 0, 1],
      [0, -1, 0],
    ],
    spun: (pose, turn) => spun(pose, live.axes(), turn),
    turned: (point, arrow, angle) =>
      turned(
        point,
        [
          [1, 0, 0],
          [0, 0, 1],
        ],
        arrow,
        angle,
      ),
    reset: () => (live.resets += 1),
  };
  return live;
}

/** Drag a handle by some pixels. */
export function drag(handle, dx, dy) {
  const layer = handle.parentElement;
  layer.getBoundingClientRect = () => ({ left: 10, top: 20, width: 100, height: 100 });
  handle.setPointerCapture = () => {};
  tell(handle, "pointerdown", { button: 0, pointerId: 1, clientX: 50, clientY: 60 });
  tell(handle, "pointermove", { clientX: 50 + dx, clientY: 60 + dy });
  tell(handle, "pointerup");
}
