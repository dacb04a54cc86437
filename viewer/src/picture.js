/* Paints what a figure shows, labels and all, for places where it is not alive. */
import { all, element } from "./elements.js";

// Pixels per CSS pixel.
const DENSITY = 1.5;
// Black on white, whatever the theme: nobody knows where the picture will be seen.
const LOOKS = "--scene-ink: #000; --scene-paper: #fff; content-visibility: visible";

/**
 * Paint a live scene, and the pictures beside it.
 * @param {HTMLElement} scene
 * @param {string} styles of its labels, fonts included
 * @returns {Promise<{size: {width: number, height: number}, file: Blob}>} a PNG file, and the size at
 *   which the page shows it
 */
export async function takePicture(scene, styles) {
  const boxes = [scene, ...all(scene.parentElement ?? scene, ":scope > .scene-view")];
  const sides = boxes.map((box) => box.getBoundingClientRect());
  const left = Math.min(...sides.map((side) => side.left));
  const top = Math.min(...sides.map((side) => side.top));
  const width = Math.max(...sides.map((side) => side.right)) - left;
  const height = Math.max(...sides.map((side) => side.bottom)) - top;
  const density = Math.min(devicePixelRatio, DENSITY);
  const paper = element("canvas", { width: width * density, height: height * density });
  const brush = /** @type {CanvasRenderingContext2D} */ (paper.getContext("2d"));
  brush.fillStyle = "#fff";
  brush.fillRect(0, 0, paper.width, paper.height);
  brush.scale(density, density);
  for (const [i, box] of boxes.entries()) {
    const { clientWidth, clientHeight } = box;
    const [x, y] = [sides[i].left - left, sides[i].top - top];
    const canvas = box.querySelector("canvas");
    if (!canvas) continue;
    brush.drawImage(canvas, x, y, clientWidth, clientHeight);
    const labels = await paintLabels(box, styles, clientWidth, clientHeight);
    brush.drawImage(labels, x, y, clientWidth, clientHeight);
  }
  const file = await new Promise((resolve) => paper.toBlob(resolve, "image/png"));
  return { size: { width: Math.round(width), height: Math.round(height) }, file };
}

/** Let the browser typeset the labels once more, in a picture of their own. */
async function paintLabels(scene, styles, width, height) {
  const labels = [...scene.querySelectorAll(".scene-label")].map((label) => label.cloneNode(true));
  const { fontFamily } = getComputedStyle(scene);
  const style = `${LOOKS}; width: ${width}px; height: ${height}px; font-family: ${fontFamily}`;
  const copy = element(
    "div",
    { class: "scene-in-notebook" },
    element("style", {}, styles),
    element("div", { class: "scene", "data-state": "live", style }, ...labels),
  );
  const html = new XMLSerializer().serializeToString(copy);
  const svg = `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}">
    <foreignObject width="100%" height="100%">${html}</foreignObject></svg>`;
  const image = new Image();
  image.src = `data:image/svg+xml,${encodeURIComponent(svg)}`;
  await image.decode();
  return image;
}
