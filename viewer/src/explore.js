/*
 * Lets the hand change a figure: reads its inputs, computes a state, shows it everywhere.
 * The names in the page are those of the inputs and outputs; `dataset.values` of the figure holds
 * all of their values after each state. A model may correct inputs: a state's `inputs` take their place.
 */
import { addHandles } from "./handles.js";
import { address, found, fromText, keep } from "./link.js";
import { bindPanel } from "./panel.js";
import { changedSince, statement } from "./speak.js";
import { trails } from "./trails.js";

const QUIET = 500;

/**
 * @param {HTMLElement} element the figure: a scene and a panel
 * @param live what `show` has returned for the scene
 * @param data as `rotedu.figures.explorable` describes the figure
 * @param {Object<string, function>} models states from inputs and constants, by name
 * @param {{values: object, tell: function}} [python] in a notebook: the values that Python has set, and
 *   a function that tells it what the hand has changed
 * @returns {{set: function}} sets inputs
 */
export function explore(element, live, data, models, python) {
  const model = models[data.model];
  const scene = element.querySelector(".scene");
  // The status line stands where the hint was.
  const hint = scene.querySelector(".scene-hint");
  const status = element.querySelector(".explorable-status");
  const alt = live.canvas.getAttribute("aria-label");
  let inputs = structuredClone({ ...data.start, ...python?.values });
  const ways = trails();
  let held = false;
  let moved = false;
  let refused = "";
  let timer;
  let spoken = null;
  let keptAt = -Infinity;

  /** Show a text to all, or say it to those who do not see the figure. */
  const write = (text, kind = "shown") => {
    status.innerHTML = `<span class="explorable-${kind}"></span>`;
    status.firstChild.textContent = text;
  };
  const store = () => {
    if (!python) keep(data, inputs);
  };
  /** Once the hand rests, say how things stand then: a model may have corrected an input. */
  const settle = () => {
    if (refused) return;
    // What showed only while the hand moved goes.
    if (moved) live.apply(model(inputs, data.constants, []));
    moved = false;
    const changed = changedSince(data.start, inputs);
    const name = `Changed: ${statement(data.inputs, changed, inputs)}. ${panel.outcome()}`;
    live.canvas.setAttribute("aria-label", changed.length ? name : alt);
    if (spoken) write(spoken(), "spoken");
    spoken = null;
    store();
  };
  /** A state that speaks of no trails forgets them. */
  const marks = ({ trails: places }) => (held && places ? ways.follow(places) : ways.clear());
  /** Show a state everywhere; a refusal keeps the last picture, pale. */
  const show = (state, drawn = false) => {
    refused = state.refused ?? "";
    write(refused && `${refused[0].toUpperCase()}${refused.slice(1)}.`);
    // The start needs no correction but for rounding, by which it would no longer be the start.
    if (!drawn) inputs = { ...inputs, ...state.inputs };
    scene.toggleAttribute("data-refused", Boolean(refused));
    if (refused) {
      hint?.remove();
      live.look();
    }
    // The scene has come as it is at the start.
    else if (drawn) live.look(state.views);
    else live.apply({ ...state, parts: { ...state.parts, ...marks(state) } });
    panel.show(inputs, state);
    if (refused) panel.withhold();
    handles.update(state.grips);
    const { outputs = { refused } } = state;
    element.dataset.values = JSON.stringify({ ...inputs, ...outputs });
    clearTimeout(timer);
    timer = setTimeout(settle, QUIET);
  };
  const set = (changes, drawn) => {
    inputs = { ...inputs, ...changes };
    try {
      show(model(inputs, data.constants, Object.keys(changes)), drawn);
    } catch (error) {
      if (error.name !== "DegenerateError") throw error;
      show({ refused: error.message });
    }
  };
  /** What the hand does, unlike what Python sets, is told to Python. */
  const change = (changes, said) => {
    hint?.remove();
    held = moved = true;
    set(changes);
    held = false;
    python?.tell(inputs);
    const what = said || (() => statement(data.inputs, Object.keys(changes), inputs));
    spoken = () => `${what()}. ${panel.outcome()}`;
    // Browsers refuse who writes too often.
    if (Date.now() - keptAt < QUIET) return;
    keptAt = Date.now();
    store();
  };
  /** Go to a state as a whole, by no way. */
  const jump = (values, said) => {
    hint?.remove();
    set({ ...data.start, ...values });
    python?.tell(inputs);
    spoken = said;
    store();
  };
  const reset = () => {
    jump({}, () => "Reset");
    live.reset();
  };
  /** Go where a link of the figure leads; in a page, its address says so. */
  const follow = ({ hash, textContent: words }) => {
    const wanted = fromText(hash, data);
    if (!python) history.pushState(null, "", hash);
    jump(wanted, () => `${words}. ${panel.outcome()}`);
  };
  /** Copy the address of this state; where that is refused, the reader can. */
  const link = async () => {
    hint?.remove();
    spoken = null;
    // A new address that the figure does not follow: it is there already.
    history.replaceState(history.state, "", address(data, inputs));
    try {
      await navigator.clipboard.writeText(location.href);
      write("Link copied. It opens the figure as it is set.");
    } catch {
      write("Copy this link to the figure as it is set: ");
      const field = document.createElement("input");
      Object.assign(field, { readOnly: true, value: location.href, ariaLabel: "Link" });
      status.append(field);
      field.focus();
      field.select();
    }
  };

  const handles = addHandles(scene, live, data.inputs, () => inputs, change);
  const panel = bindPanel(element, data.inputs, () => inputs, { change, reset, link, follow });
  const arrive = () => {
    const wanted = { ...data.start, ...(found(data) ?? inputs) };
    if (address(data, wanted) !== address(data, inputs)) set(wanted);
    store();
  };
  set({}, JSON.stringify(inputs) === JSON.stringify(data.start));
  // In a page, Python runs beside the figure.
  element.addEventListener("rotedu:set", ({ detail }) => set(detail));
  if (!python) {
    arrive();
    for (const kind of ["hashchange", "popstate"]) addEventListener(kind, arrive);
  }
  // A cell with this tag shows what its figure does, unless the reader has come to a state of it.
  if (element.closest(".tag_plays") && address(data, inputs) === address(data, data.start)) {
    panel.playOnce(set);
  }
  return { set };
}
