/* The elements that a live scene adds to the page: a canvas, buttons and a hint. */

const KEYS = "scene-keys";
const KEYS_TEXT =
  "Arrow keys turn the figure, plus and minus zoom, Home resets the view," +
  " F fills the screen, C lights what the next colour of the caption means, Escape leaves.";
const HINTS = {
  mouse: "Drag to turn, Ctrl + wheel to zoom",
  fingers: "Swipe sideways to turn, two fingers to zoom",
};
const ICONS = {
  reset: "M3 12a9 9 0 1 0 3-6.7M3 3v5h5",
  full: "M4 9V4h5M15 4h5v5M20 15v5h-5M9 20H4v-5",
};

/**
 * What a selector finds in an element that surely has it.
 * @template {Element} [E=HTMLElement]
 * @param {ParentNode} within
 */
export function one(within, selector) {
  /** @type {E[]} */
  const [first] = all(within, selector);
  return first;
}

/**
 * All that a selector finds in an element.
 * @template {Element} [E=HTMLElement]
 * @param {ParentNode} within
 */
export function all(within, selector) {
  /** @type {NodeListOf<E>} */
  const found = within.querySelectorAll(selector);
  return [...found];
}

/**
 * @template {keyof HTMLElementTagNameMap} N
 * @param {N} name
 */
export function element(name, attributes, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

/**
 * Change the text of an element where it stands. A new node would let a browser match each rule with `:has()`
 * again, all over the page.
 */
export function rewrite(element, text) {
  if (element.firstChild) element.firstChild.data = text;
  else element.append(text);
}

function button(label, icon, action) {
  const made = element("button", { type: "button", title: label, "aria-label": label });
  made.innerHTML = `<svg viewBox="0 0 24 24" aria-hidden="true"><path d="${icon}"/></svg>`;
  made.addEventListener("click", action);
  return made;
}

/** Describe the keys, once on each page. */
function describeKeys() {
  if (!document.getElementById(KEYS)) {
    document.body.append(element("p", { id: KEYS, hidden: "" }, KEYS_TEXT));
  }
}

/** Make the canvas of a scene, without putting it into the page. */
export function createCanvas(alt) {
  describeKeys();
  return element("canvas", {
    class: "scene-canvas",
    tabindex: "0",
    role: "application",
    "aria-label": alt,
    "aria-describedby": KEYS,
  });
}

/** Make the canvas of a picture that is only looked at. */
export function createPicture(alt) {
  return element("canvas", { class: "scene-canvas", role: "img", "aria-label": alt });
}

/** Make the buttons and the hint; a panel has a Reset of its own, which also resets the view. */
export function createTools(scene, { reset, full }) {
  const tools = element("div", { class: "scene-tools" });
  if (!scene.closest(".explorable")) tools.append(button("Reset the view", ICONS.reset, reset));
  if (document.fullscreenEnabled) tools.append(button("Full screen", ICONS.full, full));
  const kind = matchMedia("(pointer: coarse)").matches ? "fingers" : "mouse";
  const hint = element("p", { class: "scene-hint", "aria-hidden": "true" }, HINTS[kind]);
  return { tools, hint };
}
