/* A figure in a notebook: the scene of a widget, drawn by the viewer of the pages. */
import katex from "katex";
import { element, one } from "./elements.js";
import { explore } from "./explore.js";
import { panelHtml } from "./panel-html.js";
import { takePicture } from "./picture.js";
import { openWebGL, status } from "./startup.js";
import { show } from "./viewer.js";

/** @import { Models } from "./types.js" */

const NEAR = "50% 0%";
// What JupyterLab and Notebook call an output: there the styles hide the picture of a live figure.
const OUTPUT = ".jp-OutputArea-child";
// How long the hand must rest before a saved notebook shows what it has done, in milliseconds.
const PAUSE = 1000;
// With each of these the hand leaves a figure for a while.
const TOUCHES = ["pointerup", "keyup", "wheel", "change"];
// What has a picture, however often it is shown.
const pictured = new WeakSet();
/** @type {WebGL2RenderingContext} */
let context;
/** @type {Promise<void>} one picture is handed over after the other */
let queue = Promise.resolve();

// Once only: build.js puts their text in place of the name.
const styles = STYLES;

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
 * @param {{model: any, el: HTMLElement}} place as anywidget gives it
 * @param {Models} models what computes states
 * @returns a function that removes the figure
 */
export function render({ model, el }, models) {
  const figure = new NotebookFigure(model, el, models);
  figure.begin();
  return () => figure.remove();
}

class NotebookFigure {
  constructor(model, el, models) {
    const { labels, views, stack, ...made } = model.get("scene");
    this.model = model;
    this.el = el;
    this.models = models;
    this.made = made;
    this.data = model.get("spec");
    this.scene = createScene(made, stack, labels);
    this.figure = this.data.name
      ? createExplorable([this.scene, ...views.map(createView)], this.data, models)
      : this.scene;
    el.classList.add("scene-in-notebook");
    el.replaceChildren(this.figure);
    /** @type {ReturnType<typeof this.goLive> | null} what is shown, once it has been near */
    this.shown = null;
    this.isNear = false;
    /** @type {ReturnType<typeof setTimeout> | undefined} */
    this.pause = undefined;
    this.changed = () => this.waitForRest();
    this.observer = new IntersectionObserver(
      (entries) => this.come(entries.at(-1)?.isIntersecting ?? false),
      // The notebook scrolls within a part of the page, for which browsers have a margin of its own.
      { rootMargin: NEAR, scrollMargin: NEAR },
    );
  }

  begin() {
    const { changed, el, model } = this;
    for (const touch of TOUCHES) el.addEventListener(touch, changed, { passive: true });
    model.on("change:values", changed);
    this.observer.observe(this.scene);
  }

  async goLive() {
    const { data, figure, made, model, models, scene } = this;
    try {
      context ??= openWebGL(scene);
      const view = await show(scene, arrayBuffer(model.get("gltf")), context, made);
      scene.dataset.state = "live";
      if (data.name) join(model, (python) => explore(figure, view, data, models, python));
      return view;
    } catch (error) {
      scene.dataset.state = "failed";
      const line = status();
      figure.replaceWith(line);
      const why = error instanceof Error ? error.message : error;
      line.textContent = `This figure cannot be shown: ${why}. ${made.alt}`;
    }
  }

  come(isNear) {
    this.isNear = isNear;
    this.settle();
    this.handOverInTurn();
  }

  async settle() {
    if (this.isNear) this.shown ??= this.goLive();
    const view = await this.shown;
    if (this.isNear) view?.wake();
    else view?.rest();
  }

  handOverInTurn() {
    queue = queue.then(() => this.handOver()).catch(console.warn);
  }

  /** Give Python a picture, also of a figure that nobody has scrolled to. */
  async handOver() {
    const { model, scene } = this;
    await idle();
    // A folded figure has no size, one without a place in the page no picture after it.
    if (pictured.has(model) || !scene.clientWidth || !scene.closest(OUTPUT)) return;
    pictured.add(model);
    const view = await (this.shown ??= this.goLive());
    if (!view) return;
    view.wake();
    await new Promise(requestAnimationFrame);
    const { size, file } = await takePicture(scene, styles);
    const alt = view.canvas.getAttribute("aria-label");
    model.send({ picture: size, alt }, undefined, [await file.arrayBuffer()]);
    await this.settle();
  }

  /** The picture is out of date: hand over another one when the hand rests. */
  waitForRest() {
    clearTimeout(this.pause);
    this.pause = setTimeout(() => {
      pictured.delete(this.model);
      this.handOverInTurn();
    }, PAUSE);
  }

  async remove() {
    const { changed, el, model } = this;
    this.observer.disconnect();
    clearTimeout(this.pause);
    model.off("change:values", changed);
    for (const touch of TOUCHES) el.removeEventListener(touch, changed);
    (await this.shown)?.remove();
  }
}

/** Wait until the browser has nothing better to do. */
function idle() {
  return new Promise((resolve) => (globalThis.requestIdleCallback ?? setTimeout)(resolve));
}

const sizeOf = ({ width, height }) =>
  `--aspect: ${width} / ${height}; --scene-width: ${width / 16}rem`;

function createScene(made, stack, labels) {
  const style = `${sizeOf(made)}; --stacked: ${stack.aspect}`;
  const rows = stack.rows && { "data-stack": JSON.stringify(stack) };
  const attributes = { class: "scene", "data-state": "loading", style, ...rows };
  return element("div", attributes, ...labels.map(createLabel));
}

/** Make the box of a second picture. */
function createView({ name, alt, without, labels, width, height }) {
  const data = { "data-view": name, "data-alt": alt, "data-without": JSON.stringify(without) };
  const attributes = { class: "scene-view", ...data, style: sizeOf({ width, height }) };
  return element("div", attributes, ...labels.map(createLabel));
}

/** Put pictures and their panel into one box. */
function createExplorable(pictures, data, models) {
  const figure = element("div", { class: "explorable", "data-name": data.name }, ...pictures);
  const state = models[data.model](data.start, data.constants, []);
  figure.insertAdjacentHTML("beforeend", panelHtml(data, state));
  // Another page has the address of this state.
  one(figure, "[data-action=link]").remove();
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
