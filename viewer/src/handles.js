/*
 * Points that can be dragged over a sphere about the origin. Each has a button over the picture,
 * for mouse, finger and keys alike. An angle with a grip can be dragged round a circle, too; for keys
 * it has its slider.
 */
import { alongPlane, alongSphere } from "./drag.js";

const HINT = "Drag a ring to move its point";
const DEGREES = 180 / Math.PI;
const STEP = Math.PI / 90;
const STEPS = { Shift: 5, Alt: 0.1 };
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

/**
 * @param {HTMLElement} scene
 * @param live what `show` has returned
 * @param specs all inputs of the figure, of any kind
 * @param {function} now returns the present inputs
 * @param {function} change takes changed inputs and a function that says for those who cannot see
 *   them what has come of it
 */
export function addHandles(scene, live, specs, now, change) {
  const layer = document.createElement("div");
  layer.className = "scene-handles";
  live.canvas.after(layer);
  const groups = Object.entries(specs)
    .filter(([, { kind }]) => kind === "points")
    .map(([name, spec]) => ({ name, spec, handles: [] }));

  const hint = scene.querySelector(".scene-hint");
  const grips = Object.entries(specs)
    .filter(([, { grip }]) => grip)
    .map(([name, { grip, step }]) => {
      const at = () => [Math.cos(now()[name] / DEGREES), Math.sin(now()[name] / DEGREES), 0];
      const point = () => scaled(at(), grip);
      const put = ([x, y]) => change({ [name]: step * Math.round((Math.atan2(y, x) * DEGREES) / step) });
      const handle = createHandle(layer);
      handle.tabIndex = -1;
      handle.setAttribute("aria-hidden", "true");
      drag(handle, layer, live, point, put, alongPlane);
      return () => cover(handle, live, point(), true);
    });
  if ((groups.length || grips.length) && hint) hint.textContent = HINT;

  /** The points of an input as a list, also if it is only one. */
  const listed = (value) => (Array.isArray(value[0]) ? value : [value]);
  const coverAll = () => {
    for (const { name, spec, handles } of groups) {
      listed(now()[name]).forEach((point, i) => cover(handles[i], live, scaled(point, spec.reach)));
    }
    for (const coverGrip of grips) coverGrip();
  };

  const make = ({ name, spec, handles }, i) => {
    const handle = createHandle(layer);
    handle.dataset.handle = Array.isArray(spec.names) ? `${name}-${i}` : name;
    handle.setAttribute("aria-roledescription", "point");
    const point = () => scaled(listed(now()[name])[i], spec.reach);
    const put = (moved, spoken) => {
      const old = now()[name];
      const value = scaled(moved, 1 / spec.reach);
      const all = Array.isArray(old[0]) ? old.with(i, value) : value;
      change({ [name]: all }, spoken && (() => label(spec, i, listed(now()[name])[i])));
    };
    drag(handle, layer, live, point, put, alongSphere);
    handle.addEventListener("keydown", (event) => {
      const arrow = ARROWS[event.key];
      if (!arrow || event.ctrlKey || event.metaKey) return;
      event.preventDefault();
      event.stopPropagation();
      const size = (event.shiftKey ? STEPS.Shift : 1) * (event.altKey ? STEPS.Alt : 1);
      put(live.turned(point(), arrow, STEP * size), true);
    });
    handles[i] = handle;
  };

  const update = () => {
    for (const group of groups) {
      const points = listed(now()[group.name]);
      for (let i = group.handles.length; i < points.length; i++) make(group, i);
      for (const extra of group.handles.splice(points.length)) extra.remove();
      points.forEach((point, i) => {
        group.handles[i].setAttribute("aria-label", label(group.spec, i, point));
      });
    }
    coverAll();
  };
  live.onDraw(coverAll);
  return { update };
}

function createHandle(layer) {
  const handle = document.createElement("button");
  handle.type = "button";
  handle.className = "scene-handle";
  layer.append(handle);
  return handle;
}

/** Name and coordinates, as a screen reader says them. */
function label({ names }, i, point) {
  const name = Array.isArray(names) ? names[i] : names;
  return `${name} at ${point.map((x) => x.toFixed(2).replace("-", "\u2212")).join(", ")}`;
}

function scaled(point, factor) {
  return factor === 1 ? point : point.map((x) => x * factor);
}

/** Put a handle over its point; a point on the far side of a sphere cannot be caught. */
function cover(handle, live, point, onPlane = false) {
  const { left, top, riding } = live.project(point);
  handle.style.left = `${100 * left}%`;
  handle.style.top = `${100 * top}%`;
  const eye = live.eye();
  const facing = point.reduce((sum, x, i) => sum + x * (eye[i] - x), 0);
  handle.toggleAttribute("data-behind", !onPlane && facing < 0);
  handle.hidden = riding;
}

/** Let a pointer drag a handle along what the line of sight meets. */
function drag(handle, layer, live, point, put, meet) {
  let grip = null;
  const at = ({ clientX, clientY }) => {
    const { left, top, width, height } = layer.getBoundingClientRect();
    return [(clientX - left) / width, (clientY - top) / height];
  };
  handle.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    event.preventDefault();
    handle.focus({ preventScroll: true });
    handle.setPointerCapture(event.pointerId);
    const [x, y] = at(event);
    const { left, top } = live.project(point());
    // The point keeps its distance from the finger.
    grip = { dx: left - x, dy: top - y, radius: Math.hypot(...point()) };
  });
  handle.addEventListener("pointermove", (event) => {
    if (!grip) return;
    const [x, y] = at(event);
    const { eye, direction } = live.sight(x + grip.dx, y + grip.dy);
    put(meet(eye, direction, grip.radius), false);
  });
  for (const kind of ["pointerup", "pointercancel"]) {
    handle.addEventListener(kind, () => {
      if (grip) put(point(), true);
      grip = null;
    });
  }
}
