/* The controls, numbers and charts below a figure, as `panel-html.js` writes them. */
import { bindChart } from "./chart.js";
import { playing } from "./play.js";
import { stepped } from "./pointer.js";
import { added } from "./points.js";
import { numberText, outputText } from "./speak.js";

// How many numbers matter where no figure says so.
const MAIN = 2;
const calm = matchMedia("(prefers-reduced-motion: reduce)");

/**
 * Bind the controls to the inputs.
 * @param {HTMLElement} element the figure
 * @param specs its inputs
 * @param {function} now returns the present inputs
 * @param {{change: function, reset: function, link: function, follow: function}} actions
 * @returns {{show: function, withhold: function, outcome: function, playOnce: function}} writes inputs and
 *   a state into the panel; puts a dash for each number that does not hold; says the numbers that matter;
 *   plays the first slider by itself, for who wants motion, by a function that sets inputs
 */
export function bindPanel(element, specs, now, { change, reset, link, follow }) {
  const form = element.querySelector(".explorable-panel");
  const all = (selector) => [...form.querySelectorAll(selector)];
  // Nothing is looked up while the hand moves.
  const controls = Object.entries(specs).map(([name, spec]) => ({
    name,
    spec,
    inputs: all(`input[name="${name}"]`),
    field: form.elements[`${name}-number`],
    digits: decimals(spec.step),
    buttons: all(`[data-input="${name}"]`),
  }));
  form.querySelector("fieldset").disabled = false;
  form.addEventListener("submit", (event) => event.preventDefault());

  const player = playing(element, specs, now, change);
  const scrub = (name, value) => {
    player.stop();
    change({ [name]: stepped(specs[name], value) });
  };
  const charts = new Map(
    all("[data-chart]").map((chart) => [chart.dataset.chart, bindChart(chart, specs, now, scrub)]),
  );
  form.addEventListener("input", ({ target }) => {
    const name = target.name.replace(/-number$/, "");
    const { kind, low, high } = specs[name] ?? {};
    if (kind === "number" && target.value === "") return;
    player.stop();
    if (kind === "number") change({ [name]: Math.min(high, Math.max(low, Number(target.value))) });
    else if (kind === "switch") change({ [name]: target.checked });
    else if (kind === "choice") change({ [name]: target.value });
  });
  // What was typed beyond the bounds was shown as the nearest bound.
  form.addEventListener("change", ({ target }) => {
    const held = controls.find(({ field }) => field && field === target);
    if (held) target.value = now()[held.name].toFixed(held.digits);
  });
  form.addEventListener("click", (event) => {
    const { target } = event;
    const chip = target.closest("a.try");
    // With a key held, a link opens elsewhere.
    if (chip && !(event.ctrlKey || event.metaKey || event.shiftKey)) {
      event.preventDefault();
      player.stop();
      follow(chip);
    }
    const { action, input } = target.dataset;
    const points = input && now()[input];
    if (action !== "play") player.stop();
    if (action === "play") player.toggle(target, input);
    else if (action === "step") player.step(input);
    else if (action === "add") change({ [input]: added(points) }, () => "Point added");
    else if (action === "remove") change({ [input]: points.slice(0, -1) }, () => "Point removed");
    else if (action === "reset") reset();
    else if (action === "link") link();
  });
  // Without motion there is nothing to play.
  const plays = all("[data-action=play]");
  for (const button of plays) button.hidden = calm.matches;
  // What the hand takes is not moved by anything else.
  for (const kind of ["pointerdown", "keydown"]) {
    element.addEventListener(
      kind,
      ({ target }) => target.closest("[data-handle]") && player.stop(),
    );
  }

  return {
    show(values, { outputs = {}, charts: drawn = {} }) {
      for (const { name, spec, inputs, field, digits, buttons } of controls) {
        const value = values[name];
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
      for (const [name, value] of Object.entries(outputs)) {
        // A form has properties of its own, such as length.
        const output = form.elements.namedItem(name);
        output.textContent = outputText(value, output.dataset);
        output.classList.toggle("explorable-loud", value === output.dataset.loud);
      }
      for (const [name, chart] of charts) chart.draw(drawn[name] ?? {}, values[chart.over]);
    },
    withhold() {
      for (const output of all("output"))
        output.textContent = output.textContent.replace(/\S+/g, "–");
    },
    outcome() {
      const large = all(".explorable-numbers output");
      const told = large.length ? large : all("output").slice(0, MAIN);
      return told.map((output) => output.parentElement.textContent).join(", ");
    },
    playOnce(set) {
      if (!calm.matches) player.toggle(plays[0], plays[0].dataset.input, set);
    },
  };
}

/** Decimals for a number with a smallest difference. */
function decimals(step) {
  return Math.max(0, Math.ceil(-Math.log10(step)));
}
