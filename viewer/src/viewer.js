/* Makes a scene of the page live. */
import { Scene, Vector3 } from "three";
import { Aim } from "./aim.js";
import { all, createCanvas, createTools } from "./elements.js";
import { sortSeeThrough } from "./materials.js";
import { orbit } from "./orbit.js";
import { move } from "./parts.js";
import { Labels } from "./placed-labels.js";
import { read } from "./read.js";
import { draw, onRestored, prepare } from "./screen.js";
import { SecondPicture } from "./second-picture.js";
import { Rows } from "./stack.js";
import { pixels } from "./startup.js";
import { Stress } from "./stress.js";
import { heedWords, ignoreWords, nextColor } from "./words.js";

// How much larger a scene may become than it was at the start.
const MOVING = 1.5;

/**
 * Draw a scene, over its poster if it has one, and let the reader turn it.
 * @param {HTMLElement} element the scene on the page: labels, and a poster if there is one
 * @param {ArrayBuffer} file
 * @param {WebGL2RenderingContext} context shared by all scenes
 * @param {{width: number, height: number, alt: string}} made the size of the scene as it was made,
 *   and the text for those who cannot see it
 */
export async function show(element, file, context, made) {
  const view = new View(element, await read(file), made);
  await prepare(context, view.scene, view.aim.camera);
  view.begin();
  return view;
}

/** A live scene. */
export class View {
  /**
   * @param {HTMLElement} element
   * @param {Awaited<ReturnType<typeof read>>} scene
   * @param {{width: number, height: number, alt: string}} made
   */
  constructor(element, { objects, parts, surfaces, around, clouds, camera }, made) {
    this.element = element;
    this.objects = objects;
    this.parts = parts;
    this.surfaces = surfaces;
    this.scene = new Scene();
    this.scene.add(...objects);
    this.canvas = createCanvas(made.alt);
    this.labels = new Labels(element);
    const places = this.labels.entries.flatMap(({ position }) => (position ? [position] : []));
    this.aim = new Aim(camera, around, [...clouds, ...places]);
    this.rows = new Rows(JSON.parse(element.dataset.stack ?? "{}"), this.aim);
    const boxes = element.parentElement ? all(element.parentElement, ":scope > .scene-view") : [];
    this.views = new Map(boxes.map((box) => [box.dataset.view, new SecondPicture(box, parts)]));
    this.stress = new Stress(parts, [element, ...boxes]);
    const pictures = [this, ...this.views.values()];
    this.named = new Map(
      pictures.flatMap(({ labels }) => labels.entries.map((entry) => [entry.name, entry])),
    );
    /** @type {(() => void)[]} what to do after each picture */
    this.watchers = [];
    this.endings = [];
    this.frame = 0;
    this.fitted = "";
    this.resting = false;
  }

  /** Draw the first picture, put it over the poster, and listen to the reader. */
  begin() {
    const { aim, canvas, element } = this;
    const { controls, full, reset } = orbit(aim, element, canvas, () => nextColor(this));
    heedWords(this);
    this.reset = reset;
    this.fit();
    const poster = element.querySelector(".scene-poster");
    if (poster) poster.after(canvas);
    else element.prepend(canvas);
    const { tools, hint } = createTools(element, { reset: this.reset, full });
    element.append(tools, hint);
    controls.addEventListener("change", () => {
      this.turn();
      this.redraw();
    });
    controls.addEventListener("start", () => hint.remove());
    canvas.addEventListener("keydown", () => hint.remove());
    const observer = new ResizeObserver(() => this.fit());
    observer.observe(element);
    this.endings = [() => observer.disconnect(), onRestored(() => this.redraw())];
  }

  /** Fit pictures and labels to the size that the page gives them. */
  fit() {
    const { canvas, rows } = this;
    const size = pixels(this.element);
    const now = `${size.width} ${size.height}`;
    // The observer also calls at the start, and when the scene is folded away.
    if (this.resting || now === this.fitted || size.width === 0) return;
    this.fitted = now;
    Object.assign(canvas, size);
    for (const { labels } of [this, ...this.views.values()]) labels.measure();
    rows.fit(canvas);
    this.turn();
    this.draw();
  }

  /** Follow the camera. */
  turn() {
    const { aim, canvas, rows } = this;
    aim.fit(rows.isWhole ? canvas.width / canvas.height : aim.pose.aspect);
    rows.follow();
  }

  draw() {
    if (this.resting) return;
    const { aim, canvas, labels, objects, rows, scene, surfaces } = this;
    for (const view of this.views.values()) view.draw(this);
    sortSeeThrough(objects, aim.camera);
    const elsewhere = (row) => objects.filter((object) => rows.at(firstPoint(object)) !== row);
    draw(scene, aim.camera, canvas, rows.now, rows.isWhole ? undefined : elsewhere);
    labels.place(aim.camera, surfaces, (point) => rows.near(point));
    for (const watch of this.watchers) watch();
  }

  /** Draw with the next frame. */
  redraw() {
    this.frame ||= requestAnimationFrame(() => {
      this.frame = 0;
      this.draw();
    });
  }

  /**
   * Set from where other pictures see the scene.
   * @param {Record<string, import("./types.js").Sight>} seen
   */
  look(seen = {}) {
    for (const [name, sight] of Object.entries(seen)) entry(this.views, name).seen = sight;
    this.redraw();
  }

  /**
   * Show a state: move parts and labels, and look from elsewhere in other pictures.
   * @param {import("./types.js").State} state
   */
  apply({ parts, labels, views }) {
    if (this.aim.widen(MOVING)) this.turn();
    for (const [name, change] of Object.entries(parts)) move(entry(this.parts, name), change);
    for (const [name, point] of Object.entries(labels)) entry(this.named, name).position = point;
    this.look(views);
  }

  /** Let parts stand out or step back, by name. */
  light(bright, faint) {
    this.stress.light(bright, faint);
    this.redraw();
  }

  /** Let what has a colour stand out, or nothing. */
  mean(color) {
    if (color) this.stress.mean(color);
    else this.stress.light();
    this.redraw();
  }

  /** Call back after each picture. */
  onDraw(watch) {
    this.watchers.push(watch);
  }

  /** Give the scene's memory on the graphics card back, and leave its picture. */
  rest() {
    this.resting = true;
    // The next frame makes anew what is disposed of.
    for (const { geometry, material } of this.objects) {
      geometry.dispose();
      material.dispose();
    }
  }

  wake() {
    if (!this.resting) return;
    this.resting = false;
    this.fitted = "";
    this.fit();
  }

  remove() {
    for (const end of this.endings) end();
    ignoreWords(this);
    this.rest();
  }
}

/** What has a name; a state of another scene has others. */
function entry(named, name) {
  const found = named.get(name);
  if (!found) throw new Error(`the scene has no ${name}`);
  return found;
}

/** The first point of an object, where it is now. */
function firstPoint({ geometry, matrix }) {
  const { instanceStart, position } = geometry.attributes;
  return new Vector3()
    .fromBufferAttribute(instanceStart ?? position, 0)
    .applyMatrix4(matrix)
    .toArray();
}
