/*
 * What can be grabbed in a picture, by mouse, finger and keys alike: points that are dragged over a
 * sphere about the origin, also one that has turned, numbers along paths, and bodies that are turned.
 * Each has a button over the picture; a path can be grabbed anywhere, or in its place a body that turns
 * with the number.
 */
import { alongSphere, carried, isClosed, nearest, pointOf, rolling } from "./drag-geometry.js";
import { ALONG, drag, stepped } from "./pointer.js";
import { numberText, titleOf } from "./speak.js";

const HINTS = {
  points: () => "Drag a ring to move what it holds",
  number: () => "Drag a ring along its path",
  poses: ({ names }) =>
    `Drag ${Array.isArray(names) ? `a ${names[0].replace(/ \d+$/, "")}` : names} to turn it`,
};
const STEP = Math.PI / 90;
const STEPS = { Shift: 5, Alt: 0.1 };
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
// Turns of a body: about the axis to the right, the one that points up, the line of sight.
const TURNS = {
  ArrowLeft: [0, -1, 0],
  ArrowRight: [0, 1, 0],
  ArrowUp: [-1, 0, 0],
  ArrowDown: [1, 0, 0],
  ",": [0, 0, 1],
  ".": [0, 0, -1],
};
// A body turns by more at once than a point moves.
const TURN = 2.5 * STEP;
// Beyond the rim by no more than rounding, a point has not gone to the far side.
const RIM = -1e-3;
// How much of a path is searched to both sides of a finger: it can jump, but not to the next turn.
const REACH = 0.2;
// Share of the picture from its border to a handle.
const BORDER = 0.02;
const IDENTITY = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];
const SVG = "http://www.w3.org/2000/svg";

/**
 * @param {HTMLElement} scene
 * @param live what `show` has returned
 * @param specs all inputs of the figure, of any kind
 * @param {function} now returns the present inputs
 * @param {function} change takes changed inputs and a function that says for those who cannot see
 *   them what has come of it
 * @returns {{update: function}} takes the grips of a state, by input; handles go there with the picture
 */
export function addHandles(scene, live, specs, now, change) {
  const layer = document.createElement("div");
  layer.className = "scene-handles";
  live.canvas.after(layer);
  let grips = {};
  let made = [];

  const groups = Object.entries(specs).map(([name, spec]) => ({ name, spec, handles: [] }));
  const begin = { points: addPoint, poses: addBody, number: addPath };
  const context = { layer, live, now, change, grips: () => grips };
  const count = ({ name, spec }) => {
    if (spec.kind === "points") return listed(now()[name]).length;
    if (spec.kind === "poses") {
      // What is refused may have more bodies than the picture that stays.
      return grips[name]
        ? Math.min(...[now()[name], grips[name].at].map((all) => listed(all).length))
        : 0;
    }
    return spec.kind === "number" && grips[name] ? 1 : 0;
  };
  const update = (changed = {}) => {
    grips = { ...grips, ...changed };
    for (const group of groups) {
      const { spec, handles } = group;
      const wanted = count(group);
      for (let i = handles.length; i < wanted; i++) {
        handles[i] = begin[spec.kind](context, group, i);
        handles[i].cover();
      }
      for (const { remove } of handles.splice(wanted)) remove();
    }
    made = groups.flatMap(({ handles }) => handles);
    for (const { name } of made) name();
    sayHow();
  };
  const hint = scene.querySelector(".scene-hint");
  const sayHow = () => {
    const held = groups.filter(({ handles }) => handles.length).map(({ spec }) => spec);
    const kind = Object.keys(HINTS).find((kind) => held.some((spec) => spec.kind === kind));
    if (kind && hint) hint.textContent = HINTS[kind](held.find((spec) => spec.kind === kind));
  };
  live.onDraw(() => made.forEach(({ cover }) => cover()));
  return { update };
}

/** The values of an input as a list, also if it is only one. */
const listed = (value) => (Array.isArray(value[0]) ? value : [value]);

/** An input with another value in one place. */
const replaced = (old, i, value) => (Array.isArray(old[0]) ? old.with(i, value) : value);

/** A point of a sphere. */
function addPoint({ layer, live, now, change, grips }, { name, spec }, i) {
  const handle = createHandle(layer, Array.isArray(spec.names) ? `${name}-${i}` : name, "point");
  const value = () => listed(now()[name])[i];
  const turn = () => grips()[name]?.turn ?? IDENTITY;
  const point = () => scaled(transformed(turn(), value()), spec.reach);
  const isFar = () => {
    const eye = live.eye();
    return point().reduce((sum, x, k) => sum + x * (eye[k] - x), 0) < RIM;
  };
  const said = () => label(spec, i, value());
  const put = (moved, spoken) => {
    const back = scaled(transformed(transposed(turn()), moved), 1 / spec.reach);
    change({ [name]: replaced(now()[name], i, back) }, spoken && said);
  };
  const grabbed = drag(handle, layer, {
    grab(place) {
      const { left, top } = live.project(point());
      // The point keeps its distance from the finger.
      const shift = [left - place.share[0], top - place.share[1]];
      return { shift, radius: Math.hypot(...point()), far: spec.through && isFar() };
    },
    move({ shift, radius, far }, { share }) {
      const { eye, direction } = live.sight(share[0] + shift[0], share[1] + shift[1], point());
      put(alongSphere(eye, direction, radius, far), false);
    },
    drop: () => put(point(), true),
  });
  keys(handle, ARROWS, (arrow, size) => put(live.turned(point(), arrow, STEP * size), true));
  return {
    name: () => handle.setAttribute("aria-label", said()),
    cover() {
      const { left, top } = live.project(point());
      put2d(handle, left, top);
      // What a ball hides on its far side cannot be caught, but what is held stays in hand.
      handle.toggleAttribute("data-behind", isFar() && !spec.through && !grabbed());
      handle.toggleAttribute("data-far", isFar());
    },
    remove: () => handle.remove(),
  };
}

/** A body. */
function addBody({ layer, live, now, change, grips }, { name, spec }, i) {
  const handle = createHandle(layer, Array.isArray(spec.names) ? `${name}-${i}` : name, "body");
  handle.classList.add("scene-body");
  layer.prepend(handle);
  const value = () => listed(now()[name])[i];
  const said = () => label(spec, i, value());
  const turn = (by, spoken) =>
    change({ [name]: replaced(now()[name], i, live.spun(value(), by)) }, spoken && said);
  /** The middle of the body and its size in the picture. */
  const disc = () => {
    const { at, size } = grips()[name];
    const middle = listed(at)[i];
    const [right] = live.axes();
    const { left, top } = live.project(middle);
    const rim = live.project(
      middle.map((x, k) => x + size * right[k]),
      middle,
    );
    return { left, top, width: Math.abs(rim.left - left) };
  };
  /** A place in radii from the middle of the body. */
  const within = ({ share, aspect }) => {
    const { left, top, width } = disc();
    return [(share[0] - left) / width, (top - share[1]) / (width * aspect)];
  };
  drag(handle, layer, {
    grab: (place) => ({ last: within(place) }),
    move(grip, place) {
      const here = within(place);
      const by = rolling(grip.last, here);
      grip.last = here;
      turn(by, false);
    },
    drop: () => turn([0, 0, 0], true),
  });
  keys(handle, TURNS, (axis, size) =>
    turn(
      axis.map((x) => x * TURN * size),
      true,
    ),
  );
  return {
    name: () => handle.setAttribute("aria-label", said()),
    cover() {
      const { left, top, width } = disc();
      put2d(handle, left, top);
      handle.style.width = `${200 * width}%`;
    },
    remove: () => handle.remove(),
  };
}

/** A number along a path. */
function addPath({ layer, live, now, change, grips }, { name, spec }) {
  const { low, high, step } = spec;
  const handle = createHandle(layer, name, "");
  handle.setAttribute("role", "slider");
  handle.setAttribute("aria-label", titleOf(spec, name));
  handle.setAttribute("aria-valuemin", low);
  handle.setAttribute("aria-valuemax", high);
  const svg = document.createElementNS(SVG, "svg");
  const line = document.createElementNS(SVG, "path");
  line.setAttribute("class", "scene-path");
  svg.setAttribute("viewBox", "0 0 100 100");
  svg.setAttribute("preserveAspectRatio", "none");
  svg.setAttribute("aria-hidden", "true");
  svg.append(line);
  layer.querySelector(".scene-handle:not(.scene-body)").before(svg);

  const path = () => grips()[name].path;
  const share = () => (now()[name] - low) / (high - low);
  const put = (number) => {
    const beyond = number < low || number > high;
    const lap = high - low;
    const within =
      beyond && isClosed(path()) ? number - lap * Math.floor((number - low) / lap) : number;
    change({ [name]: stepped(spec, within) });
  };
  /** A path in the picture, in units of its width. */
  const flat = (points, aspect) =>
    points.map((point) => {
      const { left, top } = live.project(point);
      return [left, top / aspect];
    });
  const spot = ({ share, aspect }) => [share[0], share[1] / aspect];
  const hands = {
    grab(place) {
      const { body } = grips()[name];
      const find = (points, ...near) =>
        nearest(flat(points, place.aspect), spot(place), ...near).share;
      const way = body && carried(path(), pointOf(body, find(body)), share());
      const found = way ? find(way, share(), REACH, true) : find(path());
      // The value keeps its distance from the finger along the path.
      return { way, at: found, value: share() - found };
    },
    move(grip, place) {
      const way = grip.way ?? path();
      grip.at = nearest(flat(way, place.aspect), spot(place), grip.at, REACH, isClosed(way)).share;
      put(low + (grip.at + grip.value) * (high - low));
    },
  };
  drag(handle, layer, {
    ...hands,
    // The path may cross itself, but the ring is in one place.
    grab: (place) => ({
      at: nearest(flat(path(), place.aspect), spot(place), share(), 0.05).share ?? share(),
      value: 0,
    }),
  });
  drag(line, layer, { ...hands, focus: handle });
  keys(handle, ALONG, (way, size) => put(now()[name] + way * Math.max(step, step * size)));
  return {
    name() {
      handle.setAttribute("aria-valuenow", now()[name]);
      handle.setAttribute("aria-valuetext", numberText(spec, now()[name]));
    },
    cover() {
      const there = path();
      handle.hidden = !there;
      svg.toggleAttribute("hidden", !there);
      if (!there) return;
      const { left, top } = live.project(pointOf(there, share()));
      put2d(handle, left, top);
      const places = (grips()[name].body ?? there).map((point) => live.project(point));
      line.setAttribute(
        "d",
        `M${places.map((p) => `${round(100 * p.left)} ${round(100 * p.top)}`).join(" ")}`,
      );
    },
    remove() {
      handle.remove();
      svg.remove();
    },
  };
}

const round = (x) => Math.round(x * 100) / 100;

function createHandle(layer, name, what) {
  const handle = document.createElement("button");
  handle.type = "button";
  handle.className = "scene-handle";
  handle.dataset.handle = name;
  if (what) handle.setAttribute("aria-roledescription", what);
  layer.append(handle);
  return handle;
}

/** Name and coordinates, as a screen reader says them. */
function label({ names }, i, point) {
  const name = Array.isArray(names) ? names[i] : names;
  return `${name} at ${point.map((x) => x.toFixed(2).replace("-", "\u2212")).join(", ")}`;
}

const transformed = (matrix, point) =>
  matrix.map((row) => row.reduce((sum, x, k) => sum + x * point[k], 0));

const transposed = (matrix) => matrix.map((_, i) => matrix.map((row) => row[i]));

function scaled(point, factor) {
  return factor === 1 ? point : point.map((x) => x * factor);
}

/**
 * Put a handle to a place of the picture, in fractions of its size. What has left the picture can be
 * caught at its border.
 */
function put2d({ style }, ...place) {
  [style.left, style.top] = place.map((x) => `${100 * Math.min(1 - BORDER, Math.max(BORDER, x))}%`);
}

/** Let some keys move a handle, with others by larger and smaller steps. */
function keys(handle, ways, move) {
  handle.addEventListener("keydown", (event) => {
    const way = ways[event.key];
    if (!way || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    event.stopPropagation();
    move(way, (event.shiftKey ? STEPS.Shift : 1) * (event.altKey ? STEPS.Alt : 1));
  });
}
