/*
 * Lets the hand change a figure: reads its inputs, computes a frame, shows it everywhere.
 * The names in the page are those of the inputs and outputs; `dataset.values` of the figure holds
 * all of their values after each frame. A model may correct inputs: a frame's `inputs` take their place.
 */
import { addHandles } from "./handles.js";
import { fromText, toText } from "./link.js";
import { bindPanel } from "./panel.js";

// Frames are stored with six digits.
const ROUNDING = 2e-6;
const SAME = 1e-12;
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
  const status = element.querySelector(".explorable-status");
  let inputs = structuredClone({ ...data.start, ...python?.values });
  if (data.frames) inputs = stored(data, inputs);
  let asked = null;
  let refused = "";
  let timer;

  /** The status line stands where the hint was. */
  const makeRoom = () => scene.querySelector(".scene-hint")?.remove();
  const write = (text) => {
    clearTimeout(timer);
    status.textContent = text;
  };
  /** Once the hand rests, say how things stand then: a model may have corrected an input. */
  const say = (text) => {
    clearTimeout(timer);
    timer = setTimeout(() => write(text()), QUIET);
  };
  const tell = (frame) => {
    panel.show(inputs, frame);
    finish(frame.outputs);
  };
  const show = (frame) => {
    refused = "";
    write("");
    inputs = { ...inputs, ...frame.inputs };
    live.apply(frame);
    tell(frame);
  };
  const finish = (outputs) => {
    scene.toggleAttribute("data-refused", Boolean(refused));
    handles.update(inputs);
    element.dataset.values = JSON.stringify({ ...inputs, ...outputs });
  };
  /** A geometry without an answer keeps the last one, pale. */
  const refuse = (error) => {
    refused = error.message;
    makeRoom();
    write(`${refused[0].toUpperCase()}${refused.slice(1)}.`);
    panel.show(inputs, { outputs: {}, charts: {} });
    panel.withhold();
    finish({ refused });
  };
  /** Ask Python for one frame at a time. */
  const ask = () => {
    if (asked) return;
    asked = inputs;
    python.ask(inputs);
  };
  const receive = ({ frame, refused: why }) => {
    const behind = asked !== inputs;
    asked = null;
    if (frame) show(frame);
    else refuse({ message: why });
    if (behind) ask();
  };
  const update = () => {
    if (!model && python) return ask();
    try {
      show(model ? model(inputs, data.constants) : storedFrame(data, inputs));
    } catch (error) {
      if (error.name !== "DegenerateError") throw error;
      refuse(error);
    }
  };
  const set = (changes) => {
    inputs = { ...inputs, ...scaled(data.inputs, changes) };
    if (data.frames) inputs = stored(data, inputs);
    update();
  };
  /** What the hand does, unlike what Python sets, is told to Python. */
  const change = (changes, spoken) => {
    makeRoom();
    set(changes);
    python?.tell(inputs);
    if (!refused && spoken) say(spoken);
  };
  const reset = () => {
    change(data.start);
    live.reset();
    say(() => "Reset");
  };
  const link = () => {
    makeRoom();
    // A new address that the figure does not follow: it is there already.
    history.replaceState(null, "", `#explore-${data.name}?${toText(inputs, data.start)}`);
    write("The address of this page now leads to this state.");
  };

  const handles = addHandles(scene, live, data.inputs, () => inputs, change);
  const panel = bindPanel(element, data.inputs, () => inputs, { change, reset, link });
  const follow = () => {
    const wanted = fromText(location.hash, data);
    if (wanted) set({ ...data.start, ...wanted });
  };
  // The scene has come as it is at the start.
  if (JSON.stringify(inputs) === JSON.stringify(data.start)) tell(data.frame);
  else update();
  if (!python) {
    follow();
    addEventListener("hashchange", follow);
  }
  return { set, receive };
}

/** Give points the length that they must have. */
function scaled(specs, changes) {
  const right = (point, length) => {
    const size = Math.hypot(...point);
    // What has the length already stays exactly as it is.
    if (!length || Math.abs(size - length) < SAME) return point;
    return point.map((x) => (x * length) / size);
  };
  return Object.fromEntries(
    Object.entries(changes).map(([name, value]) => {
      const { kind, length } = specs[name];
      if (kind !== "points") return [name, value];
      return [name, Array.isArray(value[0]) ? value.map((p) => right(p, length)) : right(value, length)];
    }),
  );
}

/** Tell whether a model computes what Python has stored with the figure. */
function reproduces(model, { name, model: called, constants, start, frame }) {
  const complain = (what) => {
    console.error(`${name}: the model ${called} ${what}; the figure only turns`);
    return false;
  };
  if (!model) return complain("is missing");
  const mine = model(structuredClone(start), constants);
  for (const kind of ["parts", "labels", "outputs", "charts"]) {
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
