/*
 * One WebGL context draws all scenes of a page and copies each picture into the canvas of a scene.
 * Browsers allow few contexts and may take one back at any time.
 */
import { LinearSRGBColorSpace, WebGLRenderer } from "three";

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

/** Draw a scene into its canvas. */
export function draw(scene, camera, canvas) {
  if (renderer.getContext().isContextLost()) return;
  const { width, height } = canvas;
  const shared = renderer.domElement;
  if (shared.width < width || shared.height < height) {
    renderer.setSize(Math.max(shared.width, width), Math.max(shared.height, height), false);
  }
  renderer.setViewport(0, 0, width, height);
  renderer.render(scene, camera);
  const paper = canvas.getContext("2d");
  paper.globalCompositeOperation = "copy";
  paper.drawImage(shared, 0, shared.height - height, width, height, 0, 0, width, height);
}
