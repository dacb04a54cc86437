/* A number that is dragged along a path in the picture, by a ring or anywhere on the path. */
import { carried, isClosed, nearest, pointOf } from "./drag-geometry.js";
import { element, one } from "./elements.js";
import { ALONG, drag, keys, put2d, stepped } from "./pointer.js";
import { numberText, titleOf } from "./speak.js";

const SVG =
  '<svg viewBox="0 0 100 100" preserveAspectRatio="none" aria-hidden="true">' +
  '<path class="scene-path"/></svg>';
// How much of a path is searched to both sides of a finger: it can jump, but not to the next turn.
const REACH = 0.2;
const HALF_A_LAP = 0.45;
// The path may cross itself, but the ring is in one place.
const AT_RING = 0.05;

export class PathHandle {
  constructor({ layer, view, name, spec, now, grip, change }) {
    this.view = view;
    this.spec = spec;
    this.now = now;
    /** @type {() => import("./types.js").Grip} */
    this.grip = grip;
    this.change = (value) => change({ [name]: stepped(spec, value) });
    this.button = element("button", {
      type: "button",
      class: "scene-handle",
      role: "slider",
      "data-handle": name,
      "aria-label": titleOf(spec, name),
      "aria-valuemin": spec.low,
      "aria-valuemax": spec.high,
    });
    layer.append(this.button);
    const ring = one(layer, ".scene-handle:not(.scene-body)");
    ring.insertAdjacentHTML("beforebegin", SVG);
    this.svg = /** @type {SVGElement} */ (ring.previousElementSibling);
    /** @type {SVGElement} */
    this.line = one(this.svg, "path");

    const move = (held, place) => this.follow(held, place);
    this.isHeld = drag(this.button, layer, { grab: (place) => this.grabRing(place), move });
    drag(this.line, layer, { grab: (place) => this.grab(place), move, focus: this.button });
    keys(this.button, ALONG, (way, size) =>
      this.put(now() + way * Math.max(spec.step, spec.step * size)),
    );
    keys(this.button, { Home: [spec.low], End: [spec.high] }, ([end]) => this.change(end));
  }

  path() {
    return this.grip().path ?? [];
  }

  /** How far along the path the number is. */
  share() {
    return (this.now() - this.spec.low) / (this.spec.high - this.spec.low);
  }

  /** How much of the path a finger may mean, to both sides: of many laps, never another one. */
  reach() {
    const { laps } = this.grip();
    return laps ? HALF_A_LAP / laps : REACH;
  }

  /** Set the number; a closed path goes on beyond its ends. */
  put(number) {
    const { low, high } = this.spec;
    const beyond = number < low || number > high;
    const laps = beyond && isClosed(this.path()) ? Math.floor((number - low) / (high - low)) : 0;
    this.change(number - laps * (high - low));
  }

  /** Where a path in the scene comes nearest to a place of the picture. */
  find(path, { share, aspect }, ...near) {
    const flat = path.map((point) => {
      const { left, top } = this.view.rows.project(point);
      return [left, top / aspect];
    });
    return nearest(flat, [share[0], share[1] / aspect], ...near).share;
  }

  grabRing(place) {
    const at = this.find(this.path(), place, this.share(), AT_RING) ?? this.share();
    return { way: null, at, value: 0 };
  }

  /** Grab the path, or what turns with the number: then the way of the point that is grabbed. */
  grab(place) {
    const { body } = this.grip();
    const point = body && pointOf(body, this.find(body, place));
    const way = point && carried(this.path(), point, this.share());
    const near = this.grip().laps ? [this.share(), this.reach()] : [];
    const at = way
      ? this.find(way, place, this.share(), REACH, true)
      : this.find(this.path(), place, ...near);
    // The value keeps its distance from the finger along the path.
    return { way, at, value: this.share() - at };
  }

  follow(held, place) {
    const { low, high } = this.spec;
    const way = held.way ?? this.path();
    held.at = this.find(way, place, held.at, this.reach(), isClosed(way));
    this.put(low + (held.at + held.value) * (high - low));
  }

  name() {
    this.button.setAttribute("aria-valuenow", this.now());
    this.button.setAttribute("aria-valuetext", numberText(this.spec, this.now()));
  }

  cover() {
    const { path, body } = this.grip();
    this.button.hidden = !path;
    this.svg.toggleAttribute("hidden", !path);
    this.svg.toggleAttribute("data-held", this.isHeld());
    if (!path) return;
    put2d(this.button, this.view.rows.project(pointOf(path, this.share())));
    const places = (body ?? path).map((point) => {
      const { left, top } = this.view.rows.project(point);
      return `${Math.round(1e4 * left) / 100} ${Math.round(1e4 * top) / 100}`;
    });
    this.line.setAttribute("d", `M${places.join(" ")}`);
  }

  remove() {
    this.button.remove();
    this.svg.remove();
  }
}
