/*
 * Lets the hand change a figure: reads its inputs, computes a frame, shows it everywhere.
 * The names in the page are those of the inputs and outputs; `dataset.values` of the figure holds
 * all of their values after each frame. A model may correct inputs: a frame's `inputs` take their place.
 */
import { addHandles } from "./handles.js";
import { address, found, fromText, keep } from "./link.js";
import { bindPanel } from "./panel.js";
import { changedSince, statement } from "./speak.js";
import { trails } from "./trails.js";

// Frames are stored with six digits.
const ROUNDING = 2e-6;
const QUIET = 500;

/**
 * @param {HTMLElement} element the figure: a scene and a panel
 * @param live what `show` has returned for the scene
 * @param data as `rotedu.figures.explorable` describes the figure
 * @param {Object<string, function>} models frames from inputs and constants, by name
 * @param {{values: object, ask: function, tell: function}} [python] in a notebook: the values that
 *   Python has set, and functions that ask it for a frame and tell it what the hand has changed
 * @returns {{set: function, receive: function}} set inputs, or show what was asked for
 */
export function explore(element, live, data, models, python) {
  const model = data.model && models[data.model];
  if (data.model && !reproduces(model, data)) return { set() {}, receive() {} };

  const scene = element.querySelector(".scene");
  // The status line stands where the hint was.
  const hint = scene.querySelector(".scene-hint");
  const status = element.querySelector(".explorable-status");
  const alt = live.canvas.getAttribute("aria-label");
  let inputs = structuredClone({ ...data.start, ...python?.values });
  if (data.frames) inputs = stored(data, inputs);
  const ways = trails();
  let held = false;
  let moved = false;
  let asked = null;
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
    if (moved && model) live.apply(model(inputs, data.constants, []));
    moved = false;
    const changed = changedSince(data.start, inputs);
    const name = `Changed: ${statement(data.inputs, changed, inputs)}. ${panel.outcome()}`;
    live.canvas.setAttribute("aria-label", changed.length ? name : alt);
    if (spoken) write(spoken(), "spoken");
    spoken = null;
    store();
  };
  /** A frame that speaks of no trails forgets them. */
  const marks = ({ trails: places }) => (held && places ? ways.follow(places) : ways.clear());
  /** Show a frame everywhere; a refusal keeps the last picture, pale. */
  const show = (frame) => {
    refused = frame.refused ?? "";
    write(refused && `${refused[0].toUpperCase()}${refused.slice(1)}.`);
    inputs = { ...inputs, ...frame.inputs };
    scene.toggleAttribute("data-refused", Boolean(refused));
    if (refused) {
      hint?.remove();
      live.look();
    }
    // The scene has come as it is at the start.
    else if (frame !== data.frame) live.apply({ ...frame, parts: { ...frame.parts, ...marks(frame) } });
    else live.look(frame.views);
    panel.show(inputs, frame);
    if (refused) panel.withhold();
    handles.update(frame.grips);
    const { outputs = { refused } } = frame;
    element.dataset.values = JSON.stringify({ ...inputs, ...outputs });
    clearTimeout(timer);
    timer = setTimeout(settle, QUIET);
  };
  /** Ask Python for one frame at a time. */
  const ask = () => {
    if (asked) return;
    asked = inputs;
    python.ask(inputs);
  };
  const receive = ({ frame, refused }) => {
    const behind = asked !== inputs;
    asked = null;
    show(frame ?? { refused });
    if (behind) ask();
  };
  const set = (changes) => {
    inputs = { ...inputs, ...changes };
    if (data.frames) inputs = stored(data, inputs);
    if (!model) return python ? ask() : show(storedFrame(data, inputs));
    try {
      show(model(inputs, data.constants, Object.keys(changes)));
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
  if (JSON.stringify(inputs) === JSON.stringify(data.start)) show(data.frame);
  else set({});
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
  return { set, receive };
}

/** Tell whether a model computes what Python has stored with the figure. */
function reproduces(model, { name, model: called, constants, start, frame }) {
  const complain = (what) => {
    console.error(`${name}: the model ${called} ${what}; the figure only turns`);
    return false;
  };
  if (!model) return complain("is missing");
  const mine = model(structuredClone(start), constants, Object.keys(start));
  for (const kind of ["parts", "labels", "grips", "outputs", "charts", "views"]) {
    for (const [key, value] of Object.entries(mine[kind] ?? {})) {
      if (!agree(value, frame[kind][key])) return complain(`differs from Python in ${key}`);
    }
  }
  const missing = Object.keys(frame.outputs).find((key) => !(key in mine.outputs));
  return missing ? complain(`does not compute ${missing}`) : true;
}

/** Compare numbers, texts and what consists of them; Python may say more about a part. */
function agree(mine, stored) {
  if (typeof mine === "number") {
    return Math.abs(mine - stored) <= ROUNDING * Math.max(1, Math.abs(stored));
  }
  if (mine === null || typeof mine !== "object") return mine === stored;
  if (stored === null || typeof stored !== "object") return false;
  if (Array.isArray(mine) && mine.length !== stored.length) return false;
  return Object.entries(mine).every(([key, value]) => agree(value, stored[key]));
}

/** How many frames an input is beyond the first one. */
function framesUpTo({ low, high }, count, value) {
  return Math.round(((value - low) / (high - low)) * (count - 1));
}

/** The nearest inputs for which a frame is stored. */
function stored({ inputs, grid }, values) {
  const snapped = grid.map(([name, count]) => {
    const { low, high } = inputs[name];
    return [name, low + (framesUpTo(inputs[name], count, values[name]) / (count - 1)) * (high - low)];
  });
  return { ...values, ...Object.fromEntries(snapped) };
}

/** The frame that is stored for inputs. */
function storedFrame({ inputs, grid, frames }, values) {
  const index = grid.reduce(
    (before, [name, count]) => before * count + framesUpTo(inputs[name], count, values[name]),
    0,
  );
  return frames[index];
}
