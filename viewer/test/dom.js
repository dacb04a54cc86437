/* A page without a browser: what panels, handles and figures ask of one. Import it before them. */
import { Window } from "happy-dom";
import { X, Z } from "./near.js";

const window = new Window({ url: "http://localhost/" });
const { document, location, history } = window;
let ticks = new Map();
let asked = 0;
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
  requestAnimationFrame(callback) {
    ticks.set(++asked, callback);
    return asked;
  },
  cancelAnimationFrame: (frame) => ticks.delete(frame),
});

/** Draw the next frame at each of some times in milliseconds. */
export function tick(...times) {
  for (const time of times) {
    const due = ticks;
    ticks = new Map();
    for (const callback of due.values()) callback(time);
  }
}

/** Tell an element of an event, with some properties. */
export function tell(element, type, properties = {}) {
  const event = new window.Event(type, { bubbles: true, cancelable: true });
  element.dispatchEvent(Object.assign(event, properties));
  return event;
}

/** What a reader of a figure does: finds something, presses a button, writes into a field. */
export function readerOf(element) {
  const find = (selector) => element.querySelector(selector);
  const press = (action) => find(`[data-action=${action}]`).click();
  const write = (name, value) => {
    find(`[name="${name}"]`).value = value;
    tell(find(`[name="${name}"]`), "input");
  };
  return { find, press, write };
}

/** Write a figure as a page has it: a scene and a panel. It is alone; no other hears of the window. */
export function figure(panel) {
  for (const listener of listening) window.removeEventListener(...listener);
  listening = [];
  const scene = '<div class="scene"><p class="scene-hint"></p></div>';
  document.body.innerHTML = `<div class="explorable">${scene}${panel}</div>`;
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
  const view = {
    canvas,
    applied: [],
    resets: 0,
    apply: (state) => view.applied.push(state),
    look() {},
    onDraw: (watch) => watchers.push(watch),
    light: (...names) => view.lit.push(names),
    lit: [],
    stress: { helping: () => ["ground"] },
    draw: () => watchers.forEach((watch) => watch()),
    rows: {
      project: ([x, , z]) => ({ left: 0.5 + x / 4, top: 0.5 - z / 4 }),
      sight: (left, top) => ({ eye: [4 * left - 2, -1e6, 2 - 4 * top], direction: [0, 1, 0] }),
    },
    aim: { eye: () => [0, -1e6, 0], axes: () => [X, Z, [0, -1, 0]] },
    reset: () => (view.resets += 1),
  };
  return view;
}

/** Press a handle at a place of the picture, in pixels, and move to others; the page has it at 10, 20. */
export function hold(handle, ...places) {
  const layer = handle.closest(".scene-handles");
  layer.getBoundingClientRect = () => ({ left: 10, top: 20, width: 100, height: 100 });
  handle.setPointerCapture ??= () => {};
  places.forEach(([x, y], i) => {
    const place = { button: 0, pointerId: 7, clientX: 10 + x, clientY: 20 + y };
    tell(handle, i ? "pointermove" : "pointerdown", place);
  });
}

/** Drag a handle. */
export function drag(handle, ...places) {
  hold(handle, ...places);
  tell(handle, "pointerup");
}
