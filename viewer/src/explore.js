/*
 * Lets the hand change a figure: reads its inputs, computes a state, shows it everywhere.
 * The names in the page are those of the inputs and outputs; `dataset.values` of the figure holds
 * all of their values after each state. A model may correct inputs: a state's `inputs` take their place.
 */
import { all, element as create, one } from "./elements.js";
import { addHandles } from "./handles.js";
import { Held } from "./held.js";
import { address, found, fromText, keep } from "./link.js";
import { Panel } from "./panel.js";
import { changedSince, statement } from "./speak.js";
import { trails } from "./trails.js";
import { beginning, between, duration, glide, isCalm } from "./travel.js";

/** @import { Inputs, Model, Models, Spec, State } from "./types.js" */

// How long a hand rests when it has come to an end, in milliseconds.
const QUIET = 500;
// What the hand takes hold of.
const HELD = "[data-handle], .scene-path, input";

/**
 * @param {HTMLElement} element the figure: a scene and a panel
 * @param {import("./viewer.js").View} view of the scene
 * @param {Spec} data
 * @param {Models} models
 * @param {{values: Inputs, tell: (inputs: Inputs) => void}} [python] in a notebook: the values that
 *   Python has set, and a function that tells it what the hand has changed
 * @returns {{set: (changes: Inputs) => void}} sets inputs
 */
export function explore(element, view, data, models, python) {
  const figure = new Exploration(element, view, data, models[data.model], python);
  figure.begin();
  return { set: (changes) => figure.set(changes) };
}

class Exploration {
  constructor(element, view, data, model, python) {
    this.element = element;
    this.view = view;
    this.python = python;
    /** @type {Spec} */
    this.data = data;
    /** @type {Model} */
    this.model = model;
    this.scene = one(element, ".scene");
    // The status line stands where the hint was.
    this.hint = this.scene.querySelector(".scene-hint");
    this.status = one(element, ".explorable-status");
    this.alt = view.canvas.getAttribute("aria-label");
    /** @type {Inputs} */
    this.inputs = structuredClone({ ...data.start, ...python?.values });
    this.ways = trails();
    // Whether a hand is moving something just now, or has done so since all was at rest.
    this.held = false;
    this.moved = false;
    this.refused = false;
    /** @type {{target: Inputs, stop: () => void, arrive: () => void} | null} where it is going */
    this.journey = null;
    /** @type {(() => string) | null} what to say when the hand rests */
    this.spoken = null;
    /** @type {ReturnType<typeof setTimeout> | undefined} */
    this.timer = undefined;
    const now = () => this.inputs;
    const change = (changes, said) => this.change(changes, said);
    this.grip = new Held(view);
    const hold = (names) => this.grip.take(names);
    this.handles = addHandles(this.scene, view, data.inputs, now, change, hold);
    this.panel = new Panel(element, data.inputs, now, this);
  }

  /** Show the figure as Python, the address or the history has it, and listen to them. */
  begin() {
    const { data, element, inputs, python } = this;
    this.set({}, JSON.stringify(inputs) === JSON.stringify(data.start));
    // In a page, Python runs beside the figure.
    element.addEventListener("rotedu:set", ({ detail }) => this.set(detail));
    for (const kind of ["pointerdown", "keydown", "wheel"]) {
      element.addEventListener(kind, ({ target }) => this.interrupt(target), { capture: true });
    }
    if (!python) {
      const wanted = this.wanted();
      if (!this.isAt(wanted)) this.set(wanted);
      this.store();
      for (const kind of ["hashchange", "popstate"]) addEventListener(kind, () => this.heed());
    }
    // A cell with this tag shows what its figure does, unless the reader has come to a state of it.
    if (element.closest(".tag_plays") && this.isAt(data.start)) {
      this.panel.playOnce((changes) => this.set(changes));
    }
  }

  isAt(inputs) {
    return address(this.data, this.inputs) === address(this.data, inputs);
  }

  /** The state that the address or the history speaks of; if of none, where the figure is or goes. */
  wanted() {
    const now = this.journey?.target ?? this.inputs;
    return { ...this.data.start, ...(found(this.data) ?? now) };
  }

  /** Follow the address or the history. */
  heed() {
    const wanted = this.wanted();
    if (this.journey || !this.isAt(wanted)) this.go(wanted);
    else this.store();
  }

  /** Keep the state with the page; a notebook keeps it itself. */
  store(inputs = this.inputs) {
    if (!this.python) keep(this.data, inputs);
  }

  /**
   * Set inputs.
   * @param {Inputs} changes
   * @param {boolean} [drawn] whether the scene shows this state already
   */
  set(changes, drawn = false) {
    this.stop();
    this.inputs = { ...this.inputs, ...changes };
    const { state, why = "" } = this.computed(this.inputs, Object.keys(changes));
    if (state) this.show(state, drawn);
    else this.refuse(why);
  }

  /**
   * The state of some inputs, or why there is none.
   * @param {Inputs} inputs
   * @param {string[]} changed
   * @returns {{state?: State, why?: string}}
   */
  computed(inputs, changed) {
    try {
      return { state: this.model(inputs, this.data.constants, changed) };
    } catch (error) {
      if (!(error instanceof Error) || error.name !== "DegenerateError") throw error;
      return { why: error.message };
    }
  }

  /**
   * Show a state everywhere.
   * @param {State} state
   */
  show(state, drawn) {
    this.refused = false;
    this.status.replaceChildren();
    this.scene.removeAttribute("data-refused");
    if (drawn) {
      // The start needs no correction but for rounding, by which it would no longer be the start.
      this.view.look(state.views);
    } else {
      this.inputs = { ...this.inputs, ...state.inputs };
      this.view.apply({ ...state, parts: { ...state.parts, ...this.waysOf(state) } });
    }
    if (this.held) this.grip.follow(state.parts);
    this.panel.show(this.inputs, state);
    this.note(state.outputs, state.grips);
  }

  /** Keep the last picture, pale, and say why there is no other. */
  refuse(why) {
    this.refused = true;
    this.write(`${why[0].toUpperCase()}${why.slice(1)}.`);
    this.scene.setAttribute("data-refused", "");
    this.hint?.remove();
    this.view.look();
    this.panel.show(this.inputs, {});
    this.panel.withhold();
    this.note({ refused: why });
  }

  /**
   * What shows the ways; a state that speaks of no trails forgets them.
   * @param {State} state
   */
  waysOf({ trails: places }) {
    return this.held && places ? this.ways.follow(places) : this.ways.clear();
  }

  note(outputs, grips = {}) {
    this.handles.update(grips);
    this.element.dataset.values = JSON.stringify({ ...this.inputs, ...outputs });
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.settle(), QUIET);
  }

  /** Once the hand rests, say how things stand then: a model may have corrected an input. */
  settle() {
    const { data, inputs, moved, panel, view } = this;
    if (this.refused || this.journey) return;
    // What showed only while the hand moved goes.
    if (moved) view.apply(this.model(inputs, data.constants, []));
    this.moved = false;
    const changed = changedSince(data.start, inputs);
    const name = `Changed: ${statement(data.inputs, changed, inputs)}. ${panel.outcome()}`;
    view.canvas.setAttribute("aria-label", changed.length ? name : this.alt);
    if (this.spoken) this.write(this.spoken(), "spoken");
    this.spoken = null;
    this.store();
  }

  /** Show a text to all, or say it to those who do not see the figure. */
  write(text, kind = "shown") {
    this.status.replaceChildren(create("span", { class: `explorable-${kind}` }, text));
  }

  /** What the hand does, unlike what Python sets, is told to Python. */
  change(changes, said) {
    this.hint?.remove();
    this.held = this.moved = true;
    this.set(changes);
    this.held = false;
    this.python?.tell(this.inputs);
    const what = said ?? (() => statement(this.data.inputs, Object.keys(changes), this.inputs));
    // Browsers refuse who writes too often: what follows waits until the hand rests.
    if (!this.spoken) this.store();
    this.spoken = () => `${what()}. ${this.panel.outcome()}`;
  }

  /**
   * Go to a state by a way that the eye can follow, or at once for who wants no motion.
   * @param {Inputs} target all inputs
   * @param {() => void} [then] what to do there
   */
  go(target, then) {
    if (this.journey && address(this.data, target) === address(this.data, this.journey.target))
      return;
    this.stop();
    const arrive = () => {
      this.set(target);
      then?.();
      this.store();
    };
    if (isCalm() || this.isAt(target)) return arrive();
    this.store(target);
    const specs = this.data.inputs;
    const from = beginning(specs, this.inputs, target);
    const stop = glide(duration(specs, from, target), (t) => {
      if (t === 1 || !this.isInSight()) arrive();
      else this.pass(between(specs, from, target, t));
    });
    this.journey = { target, stop, arrive };
  }

  /** Show a state on the way; where there is none, the last picture waits. */
  pass(inputs) {
    const { state } = this.computed(inputs, Object.keys(inputs));
    if (!state) return;
    this.inputs = inputs;
    this.show(state, false);
  }

  /** Stay where the figure is. */
  stop() {
    this.journey?.stop();
    this.journey = null;
  }

  /** Who takes hold of something stops the way there; who does anything else but press ends it. */
  interrupt(target) {
    if (target.closest(HELD)) this.stop();
    else if (!target.closest("a, button")) this.journey?.arrive();
  }

  isInSight() {
    const { top, bottom } = this.element.getBoundingClientRect();
    return bottom >= 0 && top <= innerHeight;
  }

  /** Go to a state as a whole, and say so there. */
  lead(values, said) {
    this.hint?.remove();
    this.go({ ...this.data.start, ...values }, () => {
      this.python?.tell(this.inputs);
      this.spoken = said;
    });
  }

  /** Lead some inputs back, and go on from there. */
  back(changes, then) {
    this.go({ ...this.inputs, ...changes }, then);
  }

  /** Put inputs and view back. */
  reset() {
    this.lead({}, () => "Reset");
    this.view.reset();
  }

  /** Go where a link of the figure leads; in a page, its address says so. */
  follow({ hash, textContent: words }) {
    const wanted = fromText(hash, this.data);
    if (!this.python) history.pushState(null, "", hash);
    this.reveal();
    this.lead(wanted, () => `${words}. ${this.panel.outcome()}`);
  }

  /** Bring into sight what a link shows: the picture, and the numbers on which one that stays may lie. */
  reveal() {
    const behavior = isCalm() ? "instant" : "smooth";
    this.scene.scrollIntoView({ block: "nearest", behavior });
    const boxes = (kinds) => all(this.element, kinds).map((box) => box.getBoundingClientRect());
    const [status, panel] = boxes(".explorable-status, .explorable-panel");
    const above = boxes(".scene, .scene-view").filter(({ right }) => right > panel.left);
    const lowest = Math.max(...above.map(({ bottom }) => bottom));
    if (lowest > panel.top) scrollBy({ top: status.top - lowest, behavior });
  }

  /** Copy the address of this state; where that is refused, the reader can. */
  async link() {
    this.hint?.remove();
    this.spoken = null;
    // A new address that the figure does not follow: it is there already.
    history.replaceState(history.state, "", address(this.data, this.inputs));
    try {
      await navigator.clipboard.writeText(location.href);
      this.write("Link copied. It opens the figure as it is set.");
    } catch {
      this.write("Copy this link to the figure as it is set: ");
      const field = create("input", { readonly: "", value: location.href, "aria-label": "Link" });
      this.status.append(field);
      field.focus();
      field.select();
    }
  }
}
