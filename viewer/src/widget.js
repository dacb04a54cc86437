/* A figure in a notebook: the scene of a widget, drawn by the viewer of the pages. */
/* global STYLES */
import katex from "katex";
import { element } from "./elements.js";
import { explore } from "./explore.js";
import { panelHtml } from "./panel-html.js";
import { takePicture } from "./picture.js";
import { openWebGL, status } from "./startup.js";
import { show } from "./viewer.js";

const NEAR = "50% 0%";
// What JupyterLab and Notebook call an output: there the styles hide the picture of a live figure.
const OUTPUT = ".jp-OutputArea-child";
// How long the hand must rest before a saved notebook shows what it has done, in milliseconds.
const PAUSE = 1000;
// With each of these the hand leaves a figure for a while.
const TOUCHES = ["pointerup", "keyup", "wheel", "change"];
const pictured = new WeakSet();
const styles = STYLES;
let context;
let queue = Promise.resolve();

document.head.append(element("style", {}, styles));

// Else JupyterLab takes the keys of a figure: twice D would delete its cell. It asks the element with
// the focus first, and only the window hears of a key before it. Keys with Control or Command it may
// have, to save the notebook.
const share = ({ target, ctrlKey, metaKey }) => {
  if (!target.closest(".scene-in-notebook")) return;
  target.toggleAttribute("data-lm-suppress-shortcuts", !ctrlKey && !metaKey);
};
addEventListener("keydown", share, true);

/**
 * Show the figure of a model while it is near the screen.
 * @param {{model, el: HTMLElement}} view as anywidget gives it
 * @param {Object<string, function>} models what computes states, by name
 * @returns a function that removes the figure
 */
export function render({ model, el }, models) {
  const { labels, views, stack, ...made } = model.get("scene");
  const scene = element(
    "div",
    {
      class: "scene",
      "data-state": "loading",
      style: `--aspect: ${made.width} / ${made.height}; --scene-width: ${made.width / 16}rem; --stacked: ${stack.aspect}`,
      ...(stack.rows && { "data-stack": JSON.stringify(stack) }),
    },
    ...labels.map(createLabel),
  );
  el.classList.add("scene-in-notebook");
  const data = model.get("spec");
  const figure = data.name
    ? createExplorable([scene, ...views.map(createView)], data, models)
    : scene;
  el.replaceChildren(figure);

  const goLive = async () => {
    try {
      context ??= openWebGL(scene);
      const shown = await show(scene, arrayBuffer(model.get("gltf")), context, made);
      scene.dataset.state = "live";
      if (data.name) join(model, (python) => explore(figure, shown, data, models, python));
      return shown;
    } catch (error) {
      scene.dataset.state = "failed";
      const line = status();
      figure.replaceWith(line);
      line.textContent = `This figure cannot be shown: ${error.message}. ${made.alt}`;
    }
  };
  let shown;
  let isNear = false;
  const settle = async () => {
    if (isNear) shown ??= goLive();
    const drawn = await shown;
    if (isNear) drawn?.wake();
    else drawn?.rest();
  };
  /** Give Python a picture, also of a figure that nobody has scrolled to. */
  const handOver = async () => {
    await idle();
    // A folded figure has no size, one without a place in the page no picture after it.
    if (pictured.has(model) || !scene.clientWidth || !scene.closest(OUTPUT)) return;
    pictured.add(model);
    const drawn = await (shown ??= goLive());
    if (!drawn) return;
    drawn.wake();
    await new Promise(requestAnimationFrame);
    const { size, file } = await takePicture(scene, styles);
    const alt = drawn.canvas.getAttribute("aria-label");
    model.send({ picture: size, alt }, undefined, [await file.arrayBuffer()]);
    await settle();
  };
  const handOverInTurn = () => (queue = queue.then(handOver).catch(console.warn));
  let pause;
  /** The picture is out of date: hand over another one when the hand rests. */
  const changed = () => {
    clearTimeout(pause);
    pause = setTimeout(() => {
      pictured.delete(model);
      handOverInTurn();
    }, PAUSE);
  };
  for (const touch of TOUCHES) el.addEventListener(touch, changed, { passive: true });
  model.on("change:values", changed);
  const observer = new IntersectionObserver(
    (entries) => {
      isNear = entries.at(-1).isIntersecting;
      settle();
      handOverInTurn();
    },
    // The notebook scrolls within a part of the page, for which browsers have a margin of its own.
    { rootMargin: NEAR, scrollMargin: NEAR },
  );
  observer.observe(scene);
  return async () => {
    observer.disconnect();
    clearTimeout(pause);
    model.off("change:values", changed);
    for (const touch of TOUCHES) el.removeEventListener(touch, changed);
    (await shown)?.remove();
  };
}

/** Wait until the browser has nothing better to do. */
function idle() {
  return new Promise((resolve) => (globalThis.requestIdleCallback ?? setTimeout)(resolve));
}

/** Make the box of a second picture. */
function createView({ name, alt, without, width, height, labels }) {
  const data = { "data-view": name, "data-alt": alt, "data-without": JSON.stringify(without) };
  const style = `--aspect: ${width} / ${height}; --scene-width: ${width / 16}rem`;
  return element("div", { class: "scene-view", ...data, style }, ...labels.map(createLabel));
}

/** Put pictures and their panel into one box. */
function createExplorable(pictures, data, models) {
  const figure = element("div", { class: "explorable", "data-name": data.name }, ...pictures);
  const state = models[data.model](data.start, data.constants, []);
  figure.insertAdjacentHTML("beforeend", panelHtml(data, state));
  // Another page has the address of this state.
  figure.querySelector("[data-action=link]").remove();
  return figure;
}

/** Let values go to Python and back. */
function join(model, begin) {
  let told;
  const hand = begin({
    values: model.get("values"),
    tell(values) {
      told = values;
      model.set("values", values);
      model.save_changes();
    },
  });
  model.on("change:values", () => {
    if (model.get("values") !== told) hand.set(model.get("values"));
  });
}

/** Make a label; between dollar signs it is a formula. */
function createLabel({ name, text, color, position }) {
  const ink = element("span", { style: `color: ${color}` });
  if (text.startsWith("$") && text.endsWith("$")) {
    katex.render(text.replace(/^\$+|\$+$/g, ""), ink, { throwOnError: false });
  } else {
    ink.textContent = text;
  }
  const data = { "data-position": (position ?? []).join(" "), "data-label": name };
  return element("span", { class: "scene-label", "aria-hidden": "true", ...data }, ink);
}

function arrayBuffer({ buffer, byteOffset, byteLength }) {
  return buffer.slice(byteOffset, byteOffset + byteLength);
}
