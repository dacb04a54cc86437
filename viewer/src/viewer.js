/* Makes a scene of the page live. */
import { PerspectiveCamera, Scene, Vector3 } from "three";
import { clipping, fieldOfView, outermost, reach, spun, turned, widened } from "./camera.js";
import { createCanvas, createTools } from "./elements.js";
import { apart, isHidden, project } from "./labels.js";
import { scaleWidths, sortSeeThrough } from "./materials.js";
import { orbit } from "./orbit.js";
import { move } from "./parts.js";
import { read } from "./read.js";
import { draw, onRestored, prepare } from "./screen.js";
import { rowOf, stacked, toBox, toPicture, WHOLE } from "./stack.js";
import { pixels } from "./startup.js";
import { secondPicture } from "./view.js";

// How much larger a scene may become than it was at the start.
const MOVING = 1.5;

/**
 * Draw a scene, over its poster if it has one, and let the reader turn it.
 * @param {HTMLElement} element the scene on the page: labels, and a poster if there is one
 * @param {ArrayBuffer} file
 * @param {WebGL2RenderingContext} context shared by all scenes
 * @param {{width: number, height: number, alt: string}} made the size of the scene as it was made,
 *   and the text for those who cannot see it
 * @returns what moves the scene; of these, rest gives the scene's memory on the graphics card back and
 *   leaves its picture, wake undoes this, and remove ends all
 */
export async function show(element, file, context, { width, height, alt }) {
  const { objects, parts, surfaces, around, clouds, camera: pose } = await read(file);
  const scene = new Scene();
  scene.add(...objects);
  const camera = new PerspectiveCamera();
  camera.up.set(...pose.up);
  camera.position.set(...pose.position);
  const canvas = createCanvas(alt);
  const labels = labelsIn(element);
  const boxes = element.parentElement?.querySelectorAll(":scope > .scene-view") ?? [];
  const views = new Map(
    [...boxes].map((box) => {
      const picture = secondPicture(box, parts);
      return [box.dataset.view, { ...picture, labels: labelsIn(box) }];
    }),
  );
  const places = labels.flatMap(({ position }) => (position ? [position] : []));
  const ends = outermost([...clouds, ...places], pose.target);
  const { radius } = around;
  const distance = camera.position.distanceTo(new Vector3(...pose.target));
  camera.lookAt(...pose.target);
  camera.updateMatrixWorld();
  const atRest = axes(camera);
  const lensAtRest = lens(atPoster(camera, pose));

  const watchers = [];
  const stack = JSON.parse(element.dataset.stack ?? "{}");
  const middles = stack.rows?.map(({ from }) => middleOf(from, pose, distance, atRest));
  let fixed = WHOLE;
  let rows = WHOLE;
  let resting = false;
  /** The number of the row that shows what is near a point, wherever the camera has gone. */
  const rowAt = (point) => (fixed === WHOLE ? 0 : rowOf(stack.rows, project(lensAtRest, point)));
  let absent = [];
  /** Show the objects of one row only, or all again. */
  const only = (row) => {
    for (const object of absent) object.visible = true;
    const elsewhere = (object) => object.visible && rowAt(firstPoint(object)) !== row;
    absent = fixed === WHOLE || row === undefined ? [] : objects.filter(elsewhere);
    for (const object of absent) object.visible = false;
  };
  /** A row that shows what it showed at rest, in its middle and as large, wherever the camera has gone. */
  const followed = ({ from, to }, i) => {
    const [far, near] = [pose.target, middles[i]].map(
      (point) => -new Vector3(...point).applyMatrix4(camera.matrixWorldInverse).z,
    );
    const { left, top } = project(lens(camera), middles[i]);
    const [width, height] = from.slice(2).map((size) => (size * far) / near);
    return { from: [left - width / 2, top - height / 2, width, height], to };
  };
  /** Fit the lens to where the camera has gone and to the shape of the picture. */
  const aim = () => {
    camera.updateMatrixWorld();
    const { near, far } = clipping(camera.position.distanceTo(around.center), around.radius);
    // A stack consists of parts of the picture as it was made.
    const aspect = fixed === WHOLE ? canvas.width / canvas.height : pose.aspect;
    Object.assign(camera, { near, far, aspect });
    const angle = fieldOfView(pose.viewAngle, pose.aspect, aspect);
    const half = Math.tan((angle * Math.PI) / 360);
    const [now, before] = [axes(camera), atRest].map((directions) =>
      reach(ends, directions, distance, [half * aspect, half]),
    );
    camera.fov = widened(angle, now, before);
    camera.updateProjectionMatrix();
    rows = fixed === WHOLE ? WHOLE : fixed.map(followed);
  };
  const drawNow = () => {
    if (resting) return;
    for (const [eye, take, named, rowFor] of [
      ...[...views.values()].map((view) => [view.camera, view.draw, view.labels, () => WHOLE[0]]),
      [
        camera,
        (scene) => draw(scene, camera, canvas, rows, only),
        labels,
        (point) => rows[rowAt(point)],
      ],
    ]) {
      sortSeeThrough(objects, eye);
      take(scene);
      placeLabels(named, eye, surfaces, rowFor);
    }
    for (const watch of watchers) watch();
  };
  // biome-ignore lint/correctness/noUnusedVariables: ??= and its like read it, too.
  let asked = 0;
  const redraw = () => {
    asked ||= requestAnimationFrame(() => {
      asked = 0;
      drawNow();
    });
  };
  let fitted = "";
  const fit = () => {
    const size = pixels(element);
    const now = `${size.width} ${size.height}`;
    // The observer also calls at the start, and when the scene is folded away.
    if (resting || now === fitted || size.width === 0) return;
    fitted = now;
    Object.assign(canvas, size);
    measure(element, labels);
    for (const box of boxes) measure(box, views.get(box.dataset.view).labels);
    fixed = stacked(stack.rows, stack.aspect, canvas);
    const [{ from, to }] = fixed;
    const scales = [canvas.width / width, canvas.height / height].map(
      (x, i) => (x * to[i + 2]) / from[i + 2],
    );
    scaleWidths(objects, Math.min(...scales));
    aim();
    drawNow();
  };

  await prepare(context, scene, camera);
  const { controls, full } = orbit(camera, element, canvas, pose.target, pose.swing);
  fit();
  const poster = element.querySelector(".scene-poster");
  if (poster) poster.after(canvas);
  else element.prepend(canvas);
  const reset = () => controls.reset();
  const { tools, hint } = createTools({ reset, full });
  element.append(tools, hint);
  controls.addEventListener("change", () => {
    aim();
    redraw();
  });
  controls.addEventListener("start", () => hint.remove());
  canvas.addEventListener("keydown", () => hint.remove());
  const observer = new ResizeObserver(fit);
  observer.observe(element);
  const forget = onRestored(redraw);

  /** Set from where other pictures see the scene. */
  const look = (seen = {}) => {
    for (const [name, view] of Object.entries(seen)) views.get(name).look(view);
    redraw();
  };
  const rest = () => {
    resting = true;
    // The next frame makes anew what is disposed of.
    for (const { geometry, material } of objects) {
      geometry.dispose();
      material.dispose();
    }
  };
  const wake = () => {
    if (!resting) return;
    resting = false;
    fitted = "";
    fit();
  };
  const remove = () => {
    observer.disconnect();
    forget();
    rest();
  };

  const everywhere = [labels, ...[...views.values()].map((view) => view.labels)].flat();
  const named = new Map(everywhere.map((entry) => [entry.label.dataset.label, entry]));
  return {
    canvas,
    look,
    /** Show a state: move parts and labels, and look from elsewhere in other pictures. */
    apply({ parts: moved, labels: moving, views: seen }) {
      if (around.radius === radius) {
        // What moves may come nearer to the camera than anything did at the start.
        around.radius = MOVING * radius;
        aim();
      }
      look(seen);
      for (const [name, change] of Object.entries(moved)) move(parts.get(name), change);
      for (const [name, position] of Object.entries(moving)) named.get(name).position = position;
      redraw();
    },
    /** Call back after each picture. */
    onDraw: (watch) => watchers.push(watch),
    /** Where a point is in the picture, in the row that shows what is near another one. */
    project: (point, near = point) => toBox(rows[rowAt(near)], project(lens(camera), point)),
    /**
     * The line of sight through a place of the picture, given in fractions of its size, where it shows
     * what is near a point.
     */
    sight(left, top, near) {
      const [x, y] = toPicture(rows[rowAt(near)], left, top);
      const through = new Vector3(2 * x - 1, 1 - 2 * y, 0.5).unproject(camera);
      const direction = through.sub(camera.position).normalize();
      return { eye: camera.position.toArray(), direction: direction.toArray() };
    },
    eye: () => camera.position.toArray(),
    axes: () => axes(camera),
    spun: (pose, turn) => spun(pose, axes(camera), turn),
    turned: (point, arrow, angle) => turned(point, axes(camera), arrow, angle),
    reset,
    rest,
    wake,
    remove,
  };
}

/** The labels over a picture; one that is absent for now has no position. */
function labelsIn(box) {
  return [...box.querySelectorAll(".scene-label")].map((label) => ({
    label,
    position: label.dataset.position ? label.dataset.position.split(" ").map(Number) : null,
    ...{ width: 0, height: 0, across: 0, down: 0 },
  }));
}

/** The point in the middle of a part of the picture, as far away as what the camera looks at. */
function middleOf(
  [left, top, width, height],
  { viewAngle, aspect, target },
  distance,
  [right, up],
) {
  const half = distance * Math.tan((viewAngle * Math.PI) / 360);
  const [x, y] = [(2 * left + width - 1) * half * aspect, (1 - 2 * top - height) * half];
  return target.map((value, i) => value + x * right[i] + y * up[i]);
}

/** A camera where another one is, which sees what the poster shows. */
function atPoster(camera, { viewAngle, aspect }) {
  const copy = Object.assign(camera.clone(), { fov: viewAngle, aspect });
  copy.updateProjectionMatrix();
  return copy;
}

/** The first point of an object, where it is now. */
function firstPoint({ geometry, matrix }) {
  const { instanceStart, position } = geometry.attributes;
  return new Vector3()
    .fromBufferAttribute(instanceStart ?? position, 0)
    .applyMatrix4(matrix)
    .toArray();
}

/** The matrix from the scene to the picture. */
function lens(camera) {
  return camera.projectionMatrix.clone().multiply(camera.matrixWorldInverse).elements;
}

/** The directions of a camera: right, up and back. */
function axes(camera) {
  const directions = [new Vector3(), new Vector3(), new Vector3()];
  camera.matrixWorld.extractBasis(...directions);
  return directions.map((direction) => direction.toArray());
}

/** Read how large labels and their picture are: seldom, because the browser has to lay out the page. */
function measure({ clientWidth: across, clientHeight: down }, labels) {
  for (const entry of labels) {
    const { offsetWidth: width, offsetHeight: height } = entry.label;
    Object.assign(entry, { width, height, across, down });
  }
}

function placeLabels(labels, camera, surfaces, rowFor) {
  const matrix = lens(camera);
  const eye = camera.position.toArray();
  const seen = [];
  for (const { label, position, width, height, across, down } of labels) {
    const { left, top, inside } = position
      ? toBox(rowFor(position), project(matrix, position))
      : {};
    const hidden = !inside || isHidden(surfaces, eye, position);
    label.toggleAttribute("data-behind", hidden);
    if (position) {
      label.style.setProperty("--x", `${100 * left}%`);
      label.style.setProperty("--y", `${100 * top}%`);
    }
    if (!hidden) seen.push({ label, x: left * across, y: top * down, width, height });
  }
  apart(seen).forEach(({ x, y }, i) => {
    const { style } = seen[i].label;
    style.setProperty("--dx", `${x}px`);
    style.setProperty("--dy", `${y}px`);
  });
}
