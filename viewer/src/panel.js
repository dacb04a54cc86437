/* The controls, numbers and charts below a figure, as `panel-html.js` writes them. */
import { Chart } from "./chart.js";
import { all, one, rewrite } from "./elements.js";
import { playing } from "./play.js";
import { added } from "./points.js";
import { numberText, outputText } from "./speak.js";
import { isCalm } from "./travel.js";

// How many numbers matter where no figure says so.
const MAIN = 2;

export class Panel {
  /**
   * Bind the controls of a figure to its inputs.
   * @param {HTMLElement} element the figure
   * @param {import("./types.js").Specs} specs
   * @param {() => import("./types.js").Inputs} now returns the present inputs
   * @param {{change: function, back: function, reset: function, link: function, follow: function}}
   *   actions
   */
  constructor(element, specs, now, actions) {
    this.specs = specs;
    this.now = now;
    this.actions = actions;
    /** @type {HTMLFormElement} */
    this.form = one(element, ".explorable-panel");
    // Nothing is looked up while the hand moves.
    this.controls = Object.keys(specs).map((name) => this.controlOf(name));
    /** @type {HTMLOutputElement[]} */
    this.outputs = all(this.form, "output");
    const change = (changes) => actions.change(changes);
    this.player = playing(element, specs, now, change, (to, then) => actions.back(to, then));
    const scrub = (name, value) => {
      this.player.stop();
      actions.change({ [name]: value });
    };
    this.charts = all(this.form, "[data-chart]").map((box) => new Chart(box, specs, now, scrub));
    this.plays = all(this.form, "[data-action=play]");
    // Without motion there is nothing to play.
    for (const button of this.plays) button.hidden = isCalm();
    one(this.form, "fieldset").removeAttribute("disabled");
    this.listen(element);
  }

  controlOf(name) {
    /** @type {HTMLInputElement[]} */
    const inputs = all(this.form, `input[name="${name}"]`);
    /** @type {HTMLInputElement | null} */
    const field = this.form.querySelector(`input[name="${name}-number"]`);
    /** @type {HTMLButtonElement[]} */
    const buttons = all(this.form, `[data-input="${name}"]`);
    const spec = this.specs[name];
    const digits = spec.kind === "number" ? decimals(spec.step) : 0;
    return { name, spec, inputs, field, buttons, digits };
  }

  listen(element) {
    const { form, player } = this;
    form.addEventListener("submit", (event) => event.preventDefault());
    form.addEventListener("input", (event) =>
      this.read(/** @type {HTMLInputElement} */ (event.target)),
    );
    form.addEventListener("change", ({ target }) => this.leave(target));
    form.addEventListener("click", (event) => this.press(event, event.target));
    // What the hand takes is not moved by anything else.
    for (const kind of ["pointerdown", "keydown"]) {
      const stop = ({ target }) => target.closest("[data-handle], .scene-path") && player.stop();
      element.addEventListener(kind, stop, { capture: true });
    }
  }

  /** Take what a control says. */
  read({ name: written, value, checked }) {
    const name = written.replace(/-number$/, "");
    const spec = this.specs[name];
    if (!spec || (spec.kind === "number" && value === "")) return;
    this.player.stop();
    let said = spec.kind === "switch" ? checked : value;
    if (spec.kind === "number") said = Math.min(spec.high, Math.max(spec.low, Number(value)));
    this.actions.change({ [name]: said });
  }

  /** What was typed beyond the bounds was shown as the nearest bound. */
  leave(target) {
    const held = this.controls.find(({ field }) => field && field === target);
    if (held) target.value = this.now()[held.name].toFixed(held.digits);
  }

  /** Do what a button or a link says. */
  press(event, target) {
    const { actions, player } = this;
    const chip = target.closest("a.try");
    const { action, input } = target.dataset;
    if (action !== "play") player.stop();
    // With a key held, a link opens elsewhere.
    if (chip && !(event.ctrlKey || event.metaKey || event.shiftKey)) {
      event.preventDefault();
      actions.follow(chip);
    }
    const points = input && this.now()[input];
    if (action === "play") player.toggle(target, input);
    else if (action === "step") player.step(input);
    else if (action === "add") actions.change({ [input]: added(points) }, () => "Point added");
    else if (action === "remove")
      actions.change({ [input]: points.slice(0, -1) }, () => "Point removed");
    else if (action === "reset") actions.reset();
    else if (action === "link") actions.link();
  }

  /**
   * Write inputs and a state into the panel.
   * @param {import("./types.js").Inputs} values
   * @param {Partial<import("./types.js").State>} state
   */
  show(values, { outputs = {}, charts = {} }) {
    for (const control of this.controls) showInput(control, values[control.name]);
    for (const output of this.outputs) {
      const { name } = output;
      if (!(name in outputs)) continue;
      rewrite(output, outputText(outputs[name], output.dataset));
      output.classList.toggle("explorable-loud", outputs[name] === output.dataset.loud);
    }
    for (const chart of this.charts) chart.draw(charts[chart.name] ?? {}, values[chart.over]);
  }

  /** Put a dash for each number: none holds. */
  withhold() {
    for (const output of this.outputs) {
      rewrite(output, output.textContent.replace(/\S+/g, "–"));
    }
  }

  /** Say the numbers that matter. */
  outcome() {
    const large = all(this.form, ".explorable-numbers output");
    const told = large.length ? large : this.outputs.slice(0, MAIN);
    return told.map((output) => output.parentElement?.textContent).join(", ");
  }

  /** Play the first slider once, for who wants motion, by a function that sets inputs. */
  playOnce(set) {
    const [first] = this.plays;
    if (!isCalm()) this.player.toggle(first, first.dataset.input, set);
  }
}

/** Let the controls of an input say its value. */
function showInput({ spec, inputs, field, digits, buttons }, value) {
  for (const input of inputs) {
    if (spec.kind === "switch") input.checked = value;
    else if (spec.kind === "choice") input.checked = input.value === value;
    else input.value = value;
    if (input.type === "range") input.setAttribute("aria-valuetext", numberText(spec, value));
  }
  if (field && field !== document.activeElement) field.value = value.toFixed(digits);
  if (spec.most) {
    const [add, remove] = buttons;
    add.disabled = value.length >= spec.most;
    remove.disabled = value.length <= spec.least;
  }
}

/** Decimals for a number with a smallest difference. */
function decimals(step) {
  return Math.max(0, Math.ceil(-Math.log10(step)));
}
