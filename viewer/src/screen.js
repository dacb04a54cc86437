/*
 * One WebGL context draws all scenes of a page and copies each picture into the canvas of a scene.
 * Browsers allow few contexts and may take one back at any time.
 */
import { LinearSRGBColorSpace, WebGLRenderer } from "three";
import { WHOLE } from "./stack.js";

/** @type {WebGLRenderer} */
let renderer;
const restored = new Set();

/** Make the renderer once; where the browser can, compile without holding up the page. */
export async function prepare(context, scene, camera) {
  if (!renderer) {
    const { canvas } = context;
    renderer = new WebGLRenderer({ canvas, context });
    renderer.outputColorSpace = LinearSRGBColorSpace;
    // Asking for errors would mean waiting for the compiler.
    renderer.debug.checkShaderErrors = false;
    canvas.addEventListener("webglcontextrestored", () => restored.forEach((redraw) => redraw()));
    await pause();
  }
  if (context.getExtension("KHR_parallel_shader_compile")) {
    await renderer.compileAsync(scene, camera);
  }
}

/** Let the browser do other things before the next step. */
function pause() {
  return new Promise((resolve) => setTimeout(resolve));
}

/**
 * Call back when pictures must be drawn again.
 * @returns a function that ends this
 */
export function onRestored(redraw) {
  restored.add(redraw);
  return () => restored.delete(redraw);
}

/** Do something while some objects cannot be seen. */
export function without(objects, act) {
  const hidden = objects.filter(({ visible }) => visible);
  for (const object of hidden) object.visible = false;
  act();
  for (const object of hidden) object.visible = true;
}

/**
 * Draw a scene into its canvas, as a whole or in rows.
 * @param {import("./types.js").Row[]} [rows]
 * @param {(row: number) => import("./types.js").Drawn[]} [elsewhere] what belongs to other rows
 */
export function draw(scene, camera, canvas, rows = WHOLE, elsewhere = () => []) {
  if (renderer.getContext().isContextLost()) return;
  const { width, height } = canvas;
  const shared = renderer.domElement;
  if (shared.width < width || shared.height < height) {
    renderer.setSize(Math.max(shared.width, width), Math.max(shared.height, height), false);
  }
  renderer.clear();
  renderer.setScissorTest(true);
  for (const [i, { from, to }] of rows.entries()) {
    const [x, y, across, down] = to.map((value, k) => Math.round(value * (k % 2 ? height : width)));
    const above = height - y - down;
    renderer.setViewport(x, above, across, down);
    renderer.setScissor(x, above, across, down);
    const [left, top, wide, high] = from;
    const { aspect } = camera;
    camera.setViewOffset(aspect, 1, left * aspect, top, wide * aspect, high);
    without(elsewhere(i), () => renderer.render(scene, camera));
  }
  renderer.setScissorTest(false);
  camera.clearViewOffset();
  const paper = canvas.getContext("2d");
  paper.globalCompositeOperation = "copy";
  paper.drawImage(shared, 0, shared.height - height, width, height, 0, 0, width, height);
}
