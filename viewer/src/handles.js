/*
 * What can be grabbed in a picture, by mouse, finger and keys alike: points that are dragged over a
 * sphere about the origin, also one that has turned, numbers along paths, and bodies that are turned.
 * Each has an element over the picture; a path can be grabbed anywhere, or in its place a body that turns
 * with the number.
 */
import { alongSphere, rolling, spun, turned } from "./drag-geometry.js";
import { element } from "./elements.js";
import { PathHandle } from "./path-handle.js";
import { drag, keys, put2d } from "./pointer.js";
import { outputText } from "./speak.js";
import { dot } from "./vectors.js";

/** @import { Grip, Inputs, Specs } from "./types.js" */

const STEP = Math.PI / 90;
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
const SAID = {
  point: "Arrow keys move the point, by larger steps with Shift, by smaller ones with Alt.",
  body: "Arrow keys, comma and full stop turn the body, by more with Shift, by less with Alt.",
};
// Beyond the rim by no more than rounding, a point has not gone to the far side.
const RIM = -1e-3;

/**
 * @param {HTMLElement} scene
 * @param {import("./viewer.js").View} view
 * @param {Specs} specs all inputs of the figure, of any kind
 * @param {() => Inputs} now returns the present inputs
 * @param {(changes: Inputs, said?: () => string) => void} change takes changed inputs and a function
 *   that says for those who cannot see them what has come of it
 * @param {(names: string[]) => void} hold takes the parts that the hand holds or could hold, or none
 * @returns {{update: (grips?: Record<string, Grip>) => void}} takes the grips of a state, by input;
 *   handles go there with the picture
 */
export function addHandles(scene, view, specs, now, change, hold) {
  const layer = element("div", { class: "scene-handles" });
  view.canvas.after(layer);
  const hint = scene.querySelector(".scene-hint");
  /** @type {Record<string, Grip>} */
  const grips = {};
  const kinds = { points: PointHandle, poses: BodyHandle, number: PathHandle };
  const groups = Object.entries(specs).map(([name, spec]) => ({
    hand: { layer, view, name, spec, now: () => now()[name], grip: () => grips[name], change },
    /** @type {(PointHandle | BodyHandle | PathHandle)[]} */
    handles: [],
  }));
  const update = (changed = {}) => {
    Object.assign(grips, changed);
    for (const { hand, handles } of groups) {
      const wanted = countOf(hand.spec, hand.now(), hand.grip());
      while (handles.length < wanted) {
        const handle = new kinds[hand.spec.kind](hand, handles.length);
        handle.cover();
        handles.push(handle);
      }
      for (const handle of handles.splice(wanted)) handle.remove();
      for (const handle of handles) handle.name();
    }
    if (hint) hint.textContent = hintFor(groups) || hint.textContent;
  };
  view.onDraw(() => {
    for (const { handles } of groups) for (const handle of handles) handle.cover();
  });
  const take = ({ target }) => hold(groups.flatMap((group) => holding(group, target)));
  for (const kind of ["pointerover", "focusin"]) layer.addEventListener(kind, take);
  for (const kind of ["pointerout", "focusout"]) layer.addEventListener(kind, () => hold([]));
  return { update };
}

/** What the hand can do with what is there to be grabbed, in one sentence. */
function hintFor(groups) {
  const held = groups.filter(({ handles }) => handles.length).map(({ hand }) => hand.spec);
  const has = (kind) => held.some((spec) => spec.kind === kind);
  const crank = groups.map(({ hand }) => hand.grip()).find((grip) => grip?.laps);
  const things = [];
  if (has("points")) things.push("a ring to move what it holds");
  else if (crank) things.push(`the ${crank.holds?.[0]} round`);
  else if (has("number")) things.push("a ring along its path");
  const bodies = held.find(({ kind }) => kind === "poses")?.names;
  if (bodies) {
    const body = Array.isArray(bodies) ? `a ${bodies[0].replace(/ \d+$/, "")}` : bodies;
    things.push(`${body} to turn it`);
  }
  if (things.length) return `Drag ${things.join(", or ")}`;
  return groups.some(({ hand }) => hand.spec.kind === "number") ? "Move the slider" : "";
}

/** The parts that one of the handles of an input holds. */
function holding({ hand, handles }, target) {
  const i = handles.findIndex((handle) => handle.button === target || handle.line === target);
  const { holds = [] } = hand.grip() ?? {};
  if (i < 0) return [];
  return Array.isArray(hand.spec.names) ? [holds[i]] : holds;
}

/** How many handles an input has. */
function countOf({ kind }, value, grip) {
  if (kind === "points") return listed(value).length;
  // What is refused may have more bodies than the picture that stays.
  if (kind === "poses" && grip) return Math.min(listed(value).length, listed(grip.at).length);
  return kind === "number" && grip ? 1 : 0;
}

/** The values of an input as a list, also if it is only one. */
const listed = (value) => (Array.isArray(value[0]) ? value : [value]);

/** One of the points or bodies of an input. */
class Handle {
  constructor({ layer, view, name, spec, now, grip, change }, i, what) {
    this.layer = layer;
    this.view = view;
    this.spec = spec;
    this.now = now;
    this.grip = grip;
    this.i = i;
    // No button: a screen reader would keep the arrow keys to itself.
    this.button = element("div", {
      tabindex: "0",
      role: "application",
      class: "scene-handle",
      "data-handle": Array.isArray(spec.names) ? `${name}-${i}` : name,
      "aria-roledescription": what,
      "aria-description": SAID[what],
    });
    layer.append(this.button);
    /** Set the value, and say what it is then. */
    this.put = (value, spoken) => {
      const all = Array.isArray(now()[0]) ? now().with(i, value) : value;
      change({ [name]: all }, spoken ? () => this.said() : undefined);
    };
  }

  get value() {
    return listed(this.now())[this.i];
  }

  /** Name and coordinates, as a screen reader says them. */
  said() {
    const { names } = this.spec;
    const name = Array.isArray(names) ? names[this.i] : names;
    const coordinates = this.value.map((x) => outputText(x, { digits: 2, unit: "" }));
    return `${name} at ${coordinates.join(", ")}`;
  }

  name() {
    this.button.setAttribute("aria-label", this.said());
  }

  remove() {
    this.button.remove();
  }
}

/** A point of a sphere. */
class PointHandle extends Handle {
  constructor(hand, i) {
    super(hand, i, "point");
    const { button, layer, view } = this;
    this.isHeld = drag(button, layer, {
      grab: ({ share }) => {
        const { left, top } = view.rows.project(this.point());
        // The point keeps its distance from the finger.
        const shift = [left - share[0], top - share[1]];
        const far = this.spec.through && this.isFar();
        return { shift, radius: Math.hypot(...this.point()), far };
      },
      move: ({ shift, radius, far }, { share }) => {
        const place = [share[0] + shift[0], share[1] + shift[1]];
        const { eye, direction } = view.rows.sight(place[0], place[1], this.point());
        this.move(alongSphere(eye, direction, radius, far), false);
      },
      drop: () => this.move(this.point(), true),
    });
    keys(button, ARROWS, (arrow, size) =>
      this.move(turned(this.point(), view.aim.axes(), arrow, STEP * size), true),
    );
  }

  /** Where the point is in the scene. */
  point() {
    const { turn } = this.grip() ?? {};
    const point = turn ? turn.map((row) => dot(row, this.value)) : this.value;
    return scaled(point, this.spec.reach);
  }

  /** Bring the point to a place in the scene. */
  move(place, spoken) {
    const { turn } = this.grip() ?? {};
    const back = scaled(place, 1 / this.spec.reach);
    const column = (k) => turn.map((row) => row[k]);
    this.put(turn ? back.map((_, k) => dot(column(k), back)) : back, spoken);
  }

  isFar() {
    const point = this.point();
    return dot(point, this.view.aim.eye()) - dot(point, point) < RIM;
  }

  cover() {
    const { button, spec } = this;
    put2d(button, this.view.rows.project(this.point()));
    // What a ball hides on its far side cannot be caught, but what is held stays in hand.
    button.toggleAttribute("data-behind", this.isFar() && !spec.through && !this.isHeld());
    button.toggleAttribute("data-far", this.isFar());
  }
}

const scaled = (point, factor) => (factor === 1 ? point : point.map((x) => x * factor));

/** A body. */
class BodyHandle extends Handle {
  constructor(hand, i) {
    super(hand, i, "body");
    /** @type {number[]} where the hand has turned the body, and how it is shown since */
    this.hand = this.value;
    this.shown = "";
    const { button, layer } = this;
    button.classList.add("scene-body");
    layer.prepend(button);
    drag(button, layer, {
      grab: (place) => ({ last: this.within(place) }),
      move: (grip, place) => {
        const here = this.within(place);
        const by = rolling(grip.last, here);
        grip.last = here;
        this.turn(by, false);
      },
      drop: () => this.turn([0, 0, 0], true),
    });
    keys(button, TURNS, (axis, size) => {
      const by = axis.map((x) => x * TURN * size);
      this.turn(by, true);
    });
  }

  /** Turn on from where the hand is: a model may have held the body back, or let it fall into place. */
  turn(by, spoken) {
    const held = String(this.value) === this.shown;
    this.hand = spun(held ? this.hand : this.value, this.view.aim.axes(), by);
    this.put(this.hand, spoken);
    this.shown = String(this.value);
  }

  /** The middle of the body and its size in the picture. */
  disc() {
    const { at, size } = this.grip();
    const middle = listed(at)[this.i];
    const [right] = this.view.aim.axes();
    const rim = middle.map((x, k) => x + size * right[k]);
    const { left, top } = this.view.rows.project(middle);
    return { left, top, width: Math.abs(this.view.rows.project(rim, middle).left - left) };
  }

  /** A place in radii from the middle of the body. */
  within({ share, aspect }) {
    const { left, top, width } = this.disc();
    return [(share[0] - left) / width, (top - share[1]) / (width * aspect)];
  }

  cover() {
    const place = this.disc();
    put2d(this.button, place);
    this.button.style.width = `${200 * place.width}%`;
  }
}
