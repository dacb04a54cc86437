/* A figure in a notebook: the scene of a widget, drawn by the viewer of the pages. */
/* global STYLES */
import katex from "katex";
import { openWebGL, status } from "./page.js";
import { element } from "./stage.js";
import { show } from "./viewer.js";

const NEAR = "50% 0%";
let context;

document.head.append(element("style", {}, STYLES));

/**
 * Show the figure of a model while it is near the screen, as anywidget asks for it.
 * @param {{model, el: HTMLElement}} view
 * @returns a function that removes the figure
 */
export function render({ model, el }) {
  const { labels, ...made } = model.get("scene");
  const scene = element(
    "div",
    {
      class: "scene",
      "data-state": "loading",
      // Else JupyterLab takes the keys before the canvas: twice 0 would restart the kernel.
      "data-lm-suppress-shortcuts": "true",
      style: `aspect-ratio: ${made.width} / ${made.height}`,
    },
    ...labels.map(createLabel),
  );
  el.classList.add("scene-in-notebook");
  el.replaceChildren(scene);

  const goLive = async () => {
    try {
      context ??= openWebGL(scene);
      const shown = await show(scene, arrayBuffer(model.get("gltf")), context, made);
      scene.dataset.state = "live";
      return shown;
    } catch (error) {
      scene.dataset.state = "failed";
      const line = status();
      scene.replaceWith(line);
      line.textContent = `This figure cannot be shown: ${error.message}. ${made.alt}`;
    }
  };
  let shown;
  const observer = new IntersectionObserver(
    async (entries) => {
      const { isIntersecting } = entries.at(-1);
      if (isIntersecting) shown ??= goLive();
      const figure = await shown;
      if (isIntersecting) figure?.wake();
      else figure?.rest();
    },
    // The notebook scrolls within a part of the page, for which browsers have a margin of its own.
    { rootMargin: NEAR, scrollMargin: NEAR },
  );
  observer.observe(scene);
  return async () => {
    observer.disconnect();
    (await shown)?.remove();
  };
}

/** Make a label; between dollar signs it is a formula. */
function createLabel({ text, color, position }) {
  const ink = element("span", { style: `color: ${color}` });
  if (text.startsWith("$") && text.endsWith("$")) {
    katex.render(text.replace(/^\$+|\$+$/g, ""), ink, { throwOnError: false });
  } else {
    ink.textContent = text;
  }
  return element("span", { class: "scene-label", "data-position": position.join(" ") }, ink);
}

function arrayBuffer({ buffer, byteOffset, byteLength }) {
  return buffer.slice(byteOffset, byteOffset + byteLength);
}
